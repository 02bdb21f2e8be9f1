// The meaning of thresholds in the real window: typed depths, curves under the sliders, and why a cell is an edge.
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/explain/why.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/base/themes.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/panels/tuning/count_curve.h"
#include "ui/panels/tuning/edges_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSet>

using namespace edgescan;
using namespace edgescan::ui;

class ThresholdsTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;
    std::unique_ptr<WindowFixture> on_;
    MainWindow* window_ = nullptr;

    void use(const edges::Settings& settings) { QVERIFY(on_->use(settings)); }
    // Clicks the very cell and asks why, by the key.
    void askWhy(std::uint32_t cell) {
        window_->viewer().explanation.closeCard(); // while it is open, a click explains and pins nothing
        ImageView& view = window_->viewer().views.edges();
        const QPointF at = view.viewPort()->toPixel(QPointF(cell % 160 + 0.5, cell / 160 + 0.5), view.size());
        QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, at.toPoint());
        QVERIFY(on_->activate());
        QTest::keyClick(window_, Qt::Key_W);
        QVERIFY(eventually([&] {
            return window_->viewer().explanation.card() != nullptr && window_->viewer().explanation.card()->text().startsWith("line ");
        }));
    }
    // The first edge cell that has three ranges on either side, along its line and across.
    [[nodiscard]] static std::uint32_t edgeWithNeighbours(const edges::Detection& detection) {
        const Scan& scan = *detection.scan;
        for (const std::uint32_t cell : *detection.edges) {
            bool all = cell / 160 >= 3 && cell / 160 < 117 && cell % 160 >= 3 && cell % 160 < 157;
            for (int d = -3; all && d <= 3; ++d) {
                for (const int away : {d, d * 160})
                    all = all && scan.state[static_cast<std::size_t>(static_cast<int>(cell) + away)] == CellState::Valid;
            }
            if (all) return cell;
        }
        return detection.edges->front();
    }
    [[nodiscard]] QString meaning() const { return window_->viewer().panel.findChild<QLabel*>("meaning")->text(); }

private slots:
    void init() {
        const std::string path = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(120, 160, 3, 0.02), path)));
        on_ = std::make_unique<WindowFixture>();
        window_ = &on_->window;
        window_->resize(1500, 950);
        QVERIFY(on_->showWith(path));
    }
    void cleanup() { on_.reset(); }

    void theMeaningFollowsThresholdKernelAndWindow() {
        use(edges::findPreset("window")->settings);
        const edges::GrayScale scale = window_->viewer().engine.picture()->detection->gray->scale;
        QCOMPARE(meaning(), QString::fromStdString(edges::thresholdText(window_->viewer().engine.settings(), scale)));
        QVERIFY(meaning().startsWith("weak edge from a step of "));
        const QString before = meaning();
        edges::Settings wider = window_->viewer().engine.settings();
        wider.kernel = 7;
        use(wider);
        QVERIFY(meaning() != before);
        use(edges::Settings{});
        QVERIFY(!window_->viewer().panel.findChild<QLabel*>("meaning")->isVisible());
    }

    void aTypedDepthBecomesTheThreshold() {
        edges::Settings settings = edges::findPreset("window")->settings;
        settings.nearMm = 0;
        settings.farMm = 25500; // 100 mm per level; a straight step has three times the response
        use(settings);
        QDoubleSpinBox* box = window_->viewer().panel.row("lower")->number();
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, "0.5 m");
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(on_->settled());
        QCOMPARE(window_->viewer().engine.settings().lower, 15.0);
        box->selectAll();
        QTest::keyClicks(box, "22");
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(window_->viewer().engine.settings().lower, 22.0);
        box->selectAll();
        QTest::keyClicks(box, "5 %"); // has no single threshold in linear levels: refused, no change
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(window_->viewer().engine.settings().lower, 22.0);
    }

    // The name of a preset goes back with its values; a step names choices as the boxes do.
    void undoOfAPresetTakesItsNameBack() {
        Viewer& viewer = window_->viewer();
        const std::string usual = viewer.panel.preset().name;
        viewer.tuning.setParameter("sensitivity", 1.55);
        viewer.tuning.usePreset(*edges::findPreset("thesis"));
        QCOMPARE(viewer.panel.preset().name, std::string("thesis"));
        QVERIFY2(viewer.undo.undoText().contains("EdgeScan+ to Canny (thesis)"), qPrintable(viewer.undo.undoText()));
        viewer.undo.undo();
        QCOMPARE(viewer.panel.preset().name, usual);
        QCOMPARE(viewer.engine.settings().sensitivity, 1.55);
        viewer.undo.undo();
        QVERIFY(!viewer.panel.modified());
        viewer.undo.redo();
        viewer.undo.redo();
        QCOMPARE(viewer.panel.preset().name, std::string("thesis"));
        QVERIFY(!viewer.panel.modified());
    }

    // A field that has nothing to undo leaves the keys to the window; letters that are not entered are the field's own.
    void undoInAFieldUndoesWhatWasEntered() {
        use(edges::Settings{});
        QVERIFY(on_->activate());
        QDoubleSpinBox* box = window_->viewer().panel.row("sensitivity")->number();
        const auto strength = [&] { return window_->viewer().engine.settings().sensitivity; };
        const auto type = [&](const char* text) {
            box->selectAll();
            QTest::keyClicks(box, text);
        };
        const double first = strength();
        box->setFocus();
        QTRY_VERIFY(box->hasFocus());
        for (const char* text : {"2", "0.5"}) {
            type(text);
            QTest::keyClick(box, Qt::Key_Return);
            QVERIFY(on_->settled());
        }
        QCOMPARE(strength(), 0.5);
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(strength(), 2.0);
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(strength(), first);
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(strength(), 2.0);
        QVERIFY(on_->settled());
        type("7");
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(on_->settled());
        QCOMPARE(strength(), 2.0);
    }

    void whatCannotBeReadIsToldAndTheValueStays() {
        use(edges::findPreset("window")->settings);
        struct Typed {
            const char* key;
            const char* text;
            const char* refusal;
        };
        const auto type = [&](const Typed& typed) {
            QDoubleSpinBox* box = window_->viewer().panel.row(typed.key)->number();
            const double before = box->value();
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, typed.text);
            QTest::keyClick(box, Qt::Key_Return);
            QVERIFY2(
                eventually([&] { return window_->viewer().notice.isVisible() && window_->viewer().notice.text().contains(typed.refusal); }),
                qPrintable(QString(typed.text) + ": " + window_->viewer().notice.text()));
            QCOMPARE(box->value(), before);
            window_->viewer().notice.hide();
        };
        type({"lower", "abc", "Lower threshold: \"abc\" is not a number"});
        type({"lower", "2000 m", "Lower threshold: "});
        type({"lower", "30000", "30000 is outside 0 to 20000"});
        type({"far", "x", "Far: \"x\" is not a number and not auto"});
        use(edges::Settings{});
        type({"min-length", "2.5", "2.5 is not a whole number"});
        type({"crease", "400", "Crease angle: 400 is outside 15 to 90 degrees"});
        QDoubleSpinBox* box = window_->viewer().panel.row("crease")->number();
        box->selectAll();
        QTest::keyClicks(box, "44 degrees");
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(window_->viewer().engine.settings().creaseDeg, 44.0);
        QVERIFY(!window_->viewer().notice.isVisible());
    }

    void anAutomaticValueIsShownAsItIs() {
        sim::SimulationSettings loud;
        loud.lines = 150;
        loud.beams = 200;
        loud.noise = 12;
        const std::string path = (folder_ / "loud.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(loud)->scan, path)));
        use(edges::Settings{});
        window_->viewer().files.open({QString::fromStdString(path)});
        QVERIFY(on_->settled());
        QDoubleSpinBox* box = window_->viewer().panel.row("noise")->number();
        const double measured = window_->viewer().engine.picture()->detection->responses->noise.at(5.0);
        QVERIFY(measured > 35); // beyond the limit for typed values
        QVERIFY(std::abs(box->value() - measured) < 0.006);
        QVERIFY(std::isnan(window_->viewer().engine.settings().noiseMm));
        auto* automatic = window_->viewer().panel.findChild<QCheckBox*>("auto-noise");
        automatic->setChecked(false); // typed values are limited to 30
        QCOMPARE(window_->viewer().engine.settings().noiseMm, 30.0);
        QCOMPARE(box->value(), 30.0);
    }

    void anotherMethodKeepsTheMeaningOfTheThreshold() {
        use(edges::cannySettings());
        QComboBox* method = window_->viewer().panel.row("method")->choice();
        const auto choose = [&](const char* label) {
            method->setCurrentText(label);
            QVERIFY(on_->settled());
        };
        choose("Kirsch");
        const edges::Settings kirsch = window_->viewer().engine.settings();
        QVERIFY(std::abs(kirsch.lower / edges::stepGain(kirsch).straight - 4.0) < 0.1); // halfway between 2 and 6
        choose("EdgeScan+");
        choose("Canny (thesis)");
        QVERIFY(std::abs(window_->viewer().engine.settings().lower - 6.0) < 0.11);
    }

    void theCurveCountsWhatTheThresholdWouldGive() {
        use(edges::cannySettings());
        CountCurve* curve = window_->viewer().panel.curve("lower");
        QVERIFY(curve->isVisible());
        QVERIFY(!window_->viewer().panel.curve("sensitivity")->isVisible());
        QVERIFY(eventually([&] { return curve->curve().has_value(); }));
        const edges::EdgeCountCurve counts = *curve->curve();
        for (const std::size_t n : {counts.thresholds.size() / 4, counts.thresholds.size() / 2}) {
            edges::Settings at = window_->viewer().engine.settings();
            at.lower = counts.thresholds[n];
            use(at);
            QCOMPARE(window_->viewer().engine.picture()->detection->edges->size(), counts.edges[n]);
            QVERIFY(curve->curve().has_value()); // another threshold of the same curve
        }
        edges::Settings other = window_->viewer().engine.settings();
        other.kernel = 5;
        use(other);
        QVERIFY(!curve->curve().has_value());
        QVERIFY(eventually([&] { return curve->curve().has_value(); }));
    }

    // It was nearly level: it began at no edges, though the count at the smallest threshold is three times that at the largest.
    void theCurveUsesItsHeightAndNamesItsEnds() {
        use(edges::cannySettings());
        CountCurve* curve = window_->viewer().panel.curve("lower");
        QVERIFY(eventually([&] { return curve->curve().has_value(); }));
        const QRgb text = curve->palette().color(QPalette::WindowText).rgb();
        const QImage drawn = curve->grab().toImage();
        const auto heightAt = [&](int fromX, int toX) {
            for (int y = 16; y < drawn.height(); ++y) {
                for (int x = fromX; x < toX; ++x) {
                    if (drawn.pixel(x, y) == text) return y;
                }
            }
            return drawn.height();
        };
        QVERIFY2(heightAt(4, 30) < 26, qPrintable(QString::number(heightAt(4, 30))));
    }

    // A value that was changed has its way back next to it, without a double click that must be known.
    void aChangedValueHasItsWayBackNextToIt() {
        use(edges::Settings{});
        EdgesPanel& panel = window_->viewer().panel;
        for (const char* key : {"sensitivity", "method"}) {
            auto* reset = panel.findChild<QToolButton*>(QString("reset-") + key);
            QVERIFY(reset != nullptr && !reset->isVisible());
            const edges::Settings before = window_->viewer().engine.settings();
            if (QString(key) == "method")
                panel.row(key)->choice()->setCurrentIndex(panel.row(key)->choice()->currentIndex() + 1);
            else
                panel.row(key)->number()->setValue(2.5);
            QVERIFY(on_->settled());
            QVERIFY2(reset->isVisible(), key);
            QVERIFY2(reset->toolTip().startsWith("Back to "), qPrintable(reset->toolTip()));
            QTest::mouseClick(reset, Qt::LeftButton);
            QVERIFY(on_->settled());
            QVERIFY(!reset->isVisible());
            QCOMPARE(panel.row(key)->parameter().get(window_->viewer().engine.settings()), panel.row(key)->parameter().get(before));
        }
    }

    // An edge cell below the threshold: the plain sentence names the strong cell that it continues.
    void whyNamesTheStrongPlaceOfAWeakEdge() {
        edges::Settings settings;
        settings.sensitivity = 2.5;
        settings.classes = edges::kClassRock | edges::kClassSilhouette | edges::kClassVoidRim | edges::kClassBorder;
        use(settings);
        const edges::Detection& detection = *window_->viewer().engine.picture()->detection;
        std::optional<edges::Why> weak, strong, rim;
        for (const std::uint32_t cell : *detection.edges) {
            const edges::Why why = edges::whyCell(detection, cell);
            const bool ofRock = why.probe.kind == edges::DepthEdge::Jump || why.probe.kind == edges::DepthEdge::Convex ||
                                why.probe.kind == edges::DepthEdge::Concave;
            if (!ofRock) rim = why;
            if (ofRock && why.level == edges::StrengthLevel::Between && why.chain.size() > 1) weak = why;
            if (ofRock && why.level == edges::StrengthLevel::Above) strong = why;
            if (weak && strong && rim) break;
        }
        QVERIFY(weak && strong);
        const auto plainOf = [&](const edges::Why& why) {
            askWhy(why.probe.cell);
            return window_->viewer().explanation.card()->findChild<QLabel*>("why-plain")->text();
        };
        const QString ofWeak = plainOf(*weak);
        const edges::CellStrength& top = weak->chain.back();
        QVERIFY2(ofWeak.contains(QString("Its strength %1 is below the Edge strength 2.50")
                                     .arg(QString::fromStdString(edges::strengthNumber(weak->strength)))),
                 qPrintable(ofWeak));
        QVERIFY2(ofWeak.contains(QString("reaches %1 at line %2, beam %3")
                                     .arg(QString::fromStdString(edges::strengthNumber(top.strength)))
                                     .arg(top.line)
                                     .arg(top.beam)),
                 qPrintable(ofWeak));
        const QString ofStrong = plainOf(*strong);
        QVERIFY2(ofStrong.contains("is above the Edge strength 2.50"), qPrintable(ofStrong));
        if (rim) QVERIFY2(plainOf(*rim).contains("do not depend on Edge strength"), qPrintable(plainOf(*rim)));
    }

    // What a preset is for is in sight, not only under the pointer.
    // The card is open while the slider moves: it is of the picture on the screen.
    void whyFollowsTheSettings() {
        edges::Settings settings;
        use(settings);
        const edges::Detection& detection = *window_->viewer().engine.picture()->detection;
        askWhy(edgeWithNeighbours(detection));
        if (QTest::currentTestFailed()) return;
        const WhyCard& card = *window_->viewer().explanation.card();
        QTRY_VERIFY(card.verdict().startsWith("Edge: "));
        settings.sensitivity = edges::findParameter("sensitivity")->maximum;
        use(settings);
        QTRY_VERIFY2(!card.verdict().contains("1.00"), qPrintable(card.verdict()));
        QVERIFY(card.isVisible());
        use(edges::Settings{});
        QTRY_VERIFY2(card.verdict().startsWith("Edge: ") && card.verdict().contains("1.00"), qPrintable(card.verdict()));
        window_->viewer().explanation.closeCard();
    }

    void aPresetSaysWhatItIsFor() {
        const auto* purpose = window_->viewer().panel.findChild<QLabel*>("preset-purpose");
        QSet<QString> purposes;
        for (const edges::Preset& preset : edges::builtInPresets()) {
            window_->viewer().panel.setPreset(preset);
            QVERIFY(purpose->isVisible() && purpose->fontMetrics().horizontalAdvance(purpose->text()) <= purpose->width());
            QVERIFY(!window_->viewer().panel.findChild<QComboBox*>("presets")->toolTip().isEmpty());
            purposes << purpose->text();
        }
        QCOMPARE(purposes.size(), static_cast<int>(edges::builtInPresets().size()));
        window_->viewer().panel.setPreset(edges::builtInPresets().front());
    }

    void theCountUnderTheSliderIsThatOfThePicture() {
        edges::Settings between = edges::cannySettings(); // a threshold between two places of the slider
        between.method = edges::Method::Kirsch;
        between.lower = 58.5;
        use(between);
        CountCurve* curve = window_->viewer().panel.curve("lower");
        QVERIFY(eventually([&] { return curve->curve().has_value(); }));
        const auto edges = static_cast<qulonglong>(window_->viewer().engine.picture()->detection->edges->size());
        const QString words = QLocale(QLocale::English).toString(edges) + " edge cells";
        QVERIFY2(curve->accessibleDescription().startsWith(words), qPrintable(curve->accessibleDescription()));
        edges::Settings share = edges::cannySettings();
        share.method = edges::Method::LogRange;
        share.stepPercent = 4.0;
        use(share);
        QCOMPARE(window_->viewer().panel.findChild<QLabel*>("upper")->text(), QString("Strong from  12.5 % of range"));
    }

    void whyAnswersForTheCellClicked() {
        use(edges::cannySettings());
        const std::uint32_t cell = window_->viewer().engine.picture()->detection->edges->at(5);
        askWhy(cell);
        if (QTest::currentTestFailed()) return;
        const QString text = window_->viewer().explanation.card()->text();
        QVERIFY2(text.startsWith(QString("line %1, beam %2: range ").arg(cell / 160).arg(cell % 160)), qPrintable(text));
        QVERIFY2(text.contains("\nEdge: "), qPrintable(text));
    }

    // It said of a cell above the threshold, next to a stronger one, that the surface changes too little there.
    void theAnswerOfWhyAgreesWithItsVerdict() {
        edges::Settings settings;
        settings.minimumLength = 30;
        settings.sensitivity = 0.5;
        use(settings);
        const edges::Detection& detection = *window_->viewer().engine.picture()->detection;
        const std::vector<std::pair<QString, QString>> same{{"an edge is one cell wide", "an edge is one cell wide"},
                                                            {" does not exceed ", "too little"},
                                                            {" is below ", "too little"},
                                                            {"no chain of such cells", "no place of this change"},
                                                            {"fewer than the minimum length", "shorter than the minimum length"},
                                                            {"which is the nearer cell", "another cell of it"}};
        std::vector<int> asked(same.size(), 0);
        for (std::size_t k = 0; k < detection.mask->size(); ++k) {
            if (detection.scan->state[k] != CellState::Valid || (*detection.mask)[k] != 0 || k % 3 != 0) continue;
            const QString verdict = QString::fromStdString(edges::whyCell(detection, k).verdict);
            const auto found = std::ranges::find_if(same, [&](const auto& pair) { return verdict.contains(pair.first); });
            if (found == same.end() || asked[found - same.begin()]++ > 2) continue;
            window_->viewer().explanation.explain(inspect::exactly(k), Explanation::Subject::NearestEdge);
            const WhyCard& card = *window_->viewer().explanation.card();
            const QString place = QString("line %1, beam %2:").arg(k / 160).arg(k % 160);
            QTRY_VERIFY2(card.text().startsWith(place), qPrintable(card.text()));
            const auto* plain = card.findChild<QLabel*>("why-plain");
            QVERIFY2(plain->text().contains(found->second), qPrintable(plain->text() + " / " + card.verdict()));
        }
        QVERIFY2(std::ranges::count(asked, 0) <= 3, "most reasons were met");
        QVERIFY(asked[0] > 0 && asked[1] + asked[2] > 0);
        window_->viewer().explanation.closeCard();
        use(edges::Settings{});
    }

    // The card is as large for the next cell; and it has the words of the target's card.
    void whyHasOneSizeAndTheWordsOfTheTargetsCard() {
        use(edges::Settings{});
        const edges::Detection& detection = *window_->viewer().engine.picture()->detection;
        askWhy(edgeWithNeighbours(detection));
        if (QTest::currentTestFailed()) return;
        const WhyCard& card = *window_->viewer().explanation.card();
        const QSize size = card.size();
        const QPoint place = card.pos();
        const auto* close = card.findChild<QDialogButtonBox*>();
        const QPoint closing = close->mapToGlobal(QPoint(0, 0));
        const auto* plain = card.findChild<QLabel*>("why-plain");
        const auto* verdict = card.findChild<QLabel*>("why-verdict");
        QVERIFY(plain->font().bold() && !verdict->font().bold() && plain->y() < verdict->y());
        const auto& mask = detection.mask->cells;
        const auto flat = static_cast<std::size_t>(std::ranges::find(mask, 0) - mask.begin());
        window_->viewer().explanation.explain(inspect::exactly(flat), Explanation::Subject::Click);
        QCOMPARE(card.size(), size); // while it searches
        QTRY_VERIFY(card.verdict().startsWith("No edge: "));
        QCOMPARE(card.size(), size);
        QCOMPARE(card.pos(), place);
        QCOMPARE(close->mapToGlobal(QPoint(0, 0)), closing);
        for (const auto kind : {edges::DepthEdge::Jump, edges::DepthEdge::Convex, edges::DepthEdge::Concave}) {
            edges::Why why;
            why.probe.edge = true;
            why.probe.kind = kind;
            const std::string words = edges::whyNumbers(why, edges::Settings{});
            QVERIFY2(words.find(std::string("class ") + edges::edgeClassLabel(kind)) != words.npos, words.c_str());
        }
    }

    // On the card: the verdict, the points on both sides of a jump with their fitted lines, the numbers, in this order.
    void theVerdictComesFirstThenThePictureOfBothSides() {
        use(edges::Settings{});
        const edges::Detection& detection = *window_->viewer().engine.picture()->detection;
        const std::uint32_t cell = edgeWithNeighbours(detection);
        askWhy(cell);
        if (QTest::currentTestFailed()) return;
        const WhyCard& card = *window_->viewer().explanation.card();
        QVERIFY2(card.verdict().startsWith("Edge: ") && !card.verdict().contains('\n'), qPrintable(card.verdict()));
        QVERIFY2(card.verdict().contains("if you set ") || card.verdict().contains("this remains an edge at each "),
                 qPrintable(card.verdict()));
        const auto* verdict = card.findChild<QLabel*>("why-verdict");
        const edges::EdgeProfile& profile = card.picture().profile();
        // The answer alone first: it leaves most of the views free.
        auto* more = card.findChild<QPushButton*>("why-more");
        const QSize brief = card.size();
        QVERIFY(!verdict->isVisible() && !card.picture().isVisible() && more->text() == "More");
        QTest::mouseClick(more, Qt::LeftButton);
        QTRY_VERIFY2(card.height() > brief.height() + card.picture().height() && card.width() == brief.width(),
                     qPrintable(QString("%1 after %2").arg(card.height()).arg(brief.height())));
        QVERIFY(more->text() == "Less" && window_->frameGeometry().contains(card.frameGeometry()));
        QVERIFY(verdict->isVisible() && card.picture().isVisible() && verdict->geometry().bottom() < card.picture().geometry().top());
        QVERIFY(profile.sides[0] && profile.sides[1]);
        const auto own = std::ranges::find(profile.points, 0, &edges::ProfilePoint::side);
        QVERIFY(own != profile.points.end() && own->cell == cell && own->acrossM == 0.0 && own->awayM == 0.0);
        // The picture is drawn: lines in their colour, points in the colour of text.
        const QImage drawn = const_cast<ProfileView&>(card.picture()).grab().toImage();
        const QColor accent = themeInUse().accent;
        QVERIFY(countPixels(drawn, [&](QRgb p) { return p == accent.rgb(); }) > 40);
        // One point far behind is marked at the border, and the step remains as high, but for a second line of words.
        const auto highOf = [&](const edges::EdgeProfile& shown) {
            ProfileView view;
            view.resize(420, 130);
            view.show(shown);
            const QImage image = view.grab().toImage();
            int top = image.height(), bottom = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    if (image.pixel(x, y) != accent.rgb()) continue;
                    top = std::min(top, y);
                    bottom = std::max(bottom, y);
                }
            }
            return bottom - top;
        };
        edges::EdgeProfile step; // of 0.2 m
        for (int n = -12; n <= 12; ++n) step.points.push_back({0, n < 0 ? -1 : n > 0 ? 1 : 0, 0.02 * n, n > 0 ? 0.2 : 0.0});
        step.sides = {edges::ProfileLine{-0.12, 0.0, -0.02, 0.0, 6}, edges::ProfileLine{0.02, 0.2, 0.12, 0.2, 6}};
        const int high = highOf(step);
        QVERIFY(high > 20);
        step.points[15].awayM = 13.0;
        QVERIFY2(highOf(step) > high * 3 / 4, qPrintable(QString("%1 of %2 px").arg(highOf(step)).arg(high)));
        // A cell that is not an edge has a verdict that says so.
        const auto none = std::ranges::find(detection.mask->cells, 0) - detection.mask->cells.begin();
        askWhy(static_cast<std::uint32_t>(none));
        QTRY_VERIFY2(card.verdict().startsWith("No edge: "), qPrintable(card.verdict()));
    }

    // After a click on a cell next to the intended edge, one more click reaches this edge.
    void theEdgeBesideTheCellIsAButtonAway() {
        use(edges::Settings{});
        const edges::Detection& detection = *window_->viewer().engine.picture()->detection;
        const auto& mask = detection.mask->cells;
        std::size_t next = 1;
        while (next < mask.size() && (mask[next] != 0 || mask[next - 1] == 0 || next % 160 == 0)) ++next;
        QVERIFY(next < mask.size());
        ViewPort& port = *window_->viewer().views.edges().viewPort(); // zoomed in, the drawn edge no longer covers the cell next to it
        port.zoomAt(QPointF(static_cast<double>(next % 160), static_cast<double>(next / 160)), 20.0 / port.cellSize().width());
        askWhy(static_cast<std::uint32_t>(next));
        if (QTest::currentTestFailed()) return;
        const WhyCard& card = *window_->viewer().explanation.card();
        auto* button = card.findChild<QPushButton*>("why-nearest-edge");
        QTRY_VERIFY(button->isVisible() && card.verdict().startsWith("No edge: "));
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY2(card.verdict().startsWith("Edge: "), qPrintable(card.verdict()));
        QVERIFY(!button->isVisible());
    }

    void theCardTellsWhatWasMeasuredAndFramesTheChain() {
        use(edges::Settings{});
        const std::uint32_t cell = window_->viewer().engine.picture()->detection->edges->at(5);
        askWhy(cell);
        if (QTest::currentTestFailed()) return;
        const QString text = window_->viewer().explanation.card()->text();
        for (const char* words :
             {"class jump", "Step in depth: ", " m to line ", "limit ", "Range noise used: sigma ", "Chain: ", "Edge strength"})
            QVERIFY2(text.contains(words), qPrintable(text));
        QVERIFY2(!text.contains("ensitivity"), qPrintable(text));
        QVERIFY2(!text.contains(" mm"), qPrintable(text)); // one unit on the card
        for (ImageView* each : {&window_->viewer().views.gray(), &window_->viewer().views.edges()}) {
            const EdgeTrail& trail = each->trail();
            QVERIFY(trail.cells.size() >= 4);
            QVERIFY(std::ranges::count(trail.cells, QPoint(static_cast<int>(cell % 160), static_cast<int>(cell / 160))) == 1);
            const auto& marks = each->marks().targets;
            const edges::Why why = edges::whyCell(*window_->viewer().engine.picture()->detection, cell);
            const auto top = static_cast<std::size_t>(why.chainTop->line * 160 + why.chainTop->beam);
            QVERIFY(top == cell || std::ranges::count_if(marks, [top](const TargetMark& mark) {
                                       return mark.cell == top && mark.tag == "strongest" && !mark.isTarget;
                                   }) == 1);
            // The frames are drawn at the cells, but not where they would cover them.
            const auto sky = [each] {
                const QImage drawn = each->grab().toImage();
                int pixels = 0;
                for (int y = 0; y < drawn.height(); ++y) {
                    for (int x = 0; x < drawn.width(); ++x) {
                        const QColor c = drawn.pixelColor(x, y);
                        pixels += std::abs(c.red() - 86) < 30 && std::abs(c.green() - 180) < 30 && std::abs(c.blue() - 233) < 30 ? 1 : 0;
                    }
                }
                return pixels;
            };
            ViewPort& port = *each->viewPort();
            const QPointF at(cell % 160 + 0.5, cell / 160 + 0.5);
            port.zoomAt(at, 3.0 / port.zoom());
            port.centreOn(at);
            QCOMPARE(sky(), 0);
            port.zoomAt(at, 4.0);
            QVERIFY2(sky() > 40, qPrintable(QString::number(sky())));
            port.fit();
        }
        if (qEnvironmentVariableIsSet("EDGESCAN_KEEP_PICTURES")) window_->grab().save("why_chain.png");
        edges::Settings other;
        other.creaseDeg = 60; // another picture
        use(other);
        QVERIFY(window_->viewer().views.edges().trail().cells.empty());
    }
};

int thresholds_test(int argc, char** argv) { return runWindowTest<ThresholdsTest>(argc, argv); }

#include "thresholds_test.moc"
