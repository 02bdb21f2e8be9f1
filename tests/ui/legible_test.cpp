// Important texts are completely readable at every width and in every language: status line, tools, cards.
#include "core/edges/settings/method_traits.h"
#include "tests/support/folders.h"
#include "tests/support/placements.h"
#include "tests/ui/sized_window.h"
#include "ui/base/elided_label.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/theme.h"
#include "ui/window/tool_bar.h"

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QToolButton>
#include <QtTest>

#include <set>

using namespace edgescan;
using namespace edgescan::ui;

class LegibleTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bare_, placed_;

private slots:
    void initTestCase() {
        useTheme(*qApp);
        Scan scan = boxesToShow();
        bare_ = (folder_ / "bare.json").string();
        QVERIFY(bool(files::saveScan(scan, bare_)));
        Placement placement = *test::randomPlacement(3, 1, true);
        placement.outOfSpec = true;
        scan.placement = std::make_shared<const Placement>(placement);
        placed_ = (folder_ / "placed.json").string();
        QVERIFY(bool(files::saveScan(scan, placed_)));
    }

    void theStatusLineCoversNothingThatMustBeRead() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        auto* probe = on.window.findChild<QLabel*>("probe");
        const Scan& scan = *on.picture().detection->scan;
        const auto valid = std::ranges::find(scan.state.cells, CellState::Valid) - scan.state.cells.begin();
        const QPoint cell = on.viewer.views.placeOf(static_cast<std::size_t>(valid));
        for (const int width : {853, 1280, 1366, 1600, 1920}) {
            resizeTo(on.window, {width, 800});
            on.viewer.views.clearPin();
            emit on.viewer.views.gray().clicked(cell.y(), cell.x());
            QApplication::processEvents();
            const QString text = probe->text();
            QVERIFY2(
                QRegularExpression("E [0-9.]+  N [0-9.]+  RL -?[0-9.]+  x -?[0-9.]+  y -?[0-9.]+  z -?[0-9.]+ m").match(text).hasMatch(),
                qPrintable(QString::number(width) + ": " + text));
            QVERIFY2(text.contains("EDGE") || text.contains("not an edge"), qPrintable(text));
            QVERIFY2(!text.contains(QChar(0x2026)), qPrintable(QString::number(width) + ": " + text)); // parts are whole or absent
            QVERIFY2(probe->width() >= QFontMetrics(probe->font()).horizontalAdvance(text), qPrintable(text));
            // Complete, and without overlap.
            QList<QRect> places{QRect(probe->mapTo(&on.window, QPoint()), probe->size())};
            bool spec = false;
            for (const QLabel* label : on.viewer.statusLine.findChildren<QLabel*>()) {
                if (label == probe || !label->isVisible()) continue;
                spec = spec || label->text().contains("OUT OF SPEC");
                const QRect place(label->mapTo(&on.window, QPoint()), label->size());
                QVERIFY2(on.window.rect().contains(place), qPrintable(label->text()));
                QVERIFY2(label->width() >= QFontMetrics(label->font()).horizontalAdvance(label->text()), qPrintable(label->text()));
                for (const QRect& before : places) QVERIFY2(!place.intersects(before), qPrintable(label->text()));
                places << place;
            }
            QVERIFY2(spec, "OUT OF SPEC never goes");
        }
        resizeTo(on.window, {1900, 800});
        QVERIFY(on.window.findChild<QLabel*>("counts")->isVisible());
    }

    void thePoseAndChangedSettingsStayWhileATargetIsSelected() {
        Scan scan = boxesToShow();
        Placement placement = *test::randomPlacement(3, 1, true);
        placement.outOfSpec = false;
        scan.placement = std::make_shared<const Placement>(placement);
        const std::string path = (folder_ / "good_pose.json").string();
        QVERIFY(bool(files::saveScan(scan, path)));
        WindowFixture on;
        QVERIFY(on.showWith(path));
        edges::Settings changed;
        changed.minimumLength = 50;
        QVERIFY(on.use(changed));
        const auto valid = std::ranges::find(scan.state.cells, CellState::Valid) - scan.state.cells.begin();
        const QPoint cell = on.viewer.views.placeOf(static_cast<std::size_t>(valid));
        for (const int width : {1024, 1280, 1366}) {
            resizeTo(on.window, {width, 768});
            on.viewer.views.clearPin();
            emit on.viewer.views.gray().clicked(cell.y(), cell.x());
            QApplication::processEvents();
            const auto* settings = on.viewer.statusLine.findChild<QLabel*>("settings");
            QVERIFY2(settings->isVisible() && settings->text().contains("1 changed"), qPrintable(QString::number(width)));
            QVERIFY2(on.viewer.statusLine.findChild<QLabel*>("place")->isVisible(), qPrintable(QString::number(width)));
        }
    }

    // The text of each choice is whole in the panel of a small screen.
    void noChoiceOfASettingIsCut() {
        for (const char* code : {"fr", "es", "pt", "en"}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            EdgesPanel panel;
            panel.resize(268, 700);
            panel.setVisible(true);
            QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMs));
            std::set<QString> looked;
            for (auto* choice : panel.findChildren<QComboBox*>()) {
                if (!choice->objectName().startsWith("choice-")) continue;
                for (const edges::MethodTraits& method :
                     edges::methodTraits()) { // and open the advanced rows: each choice is in sight with one of them
                    edges::Settings settings;
                    settings.method = method.method;
                    panel.show(settings);
                    for (auto* fold : panel.findChildren<QToolButton*>()) {
                        if (fold->isCheckable() && !fold->isChecked() && fold->arrowType() == Qt::RightArrow) fold->click();
                    }
                    QApplication::processEvents();
                    if (choice->isVisible()) break;
                }
                if (!choice->isVisible()) continue; // it needs more than a method
                looked.insert(choice->objectName());
                QStyleOptionComboBox option;
                option.initFrom(choice);
                const QRect room = choice->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, choice);
                for (int n = 0; n < choice->count(); ++n) {
                    const int wide = choice->fontMetrics().horizontalAdvance(choice->itemText(n));
                    QVERIFY2(wide <= room.width(),
                             qPrintable(QString("%1: %2 px for %3").arg(code).arg(room.width()).arg(choice->itemText(n))));
                }
            }
            QVERIFY(looked.size() > 5);
        }
        QVERIFY(useLanguage("en"));
    }

    // Without a pose the whole text about the cell, with line and beam, is visible at 1280 px in every language: less important facts are
    // dropped.
    void theCellIsToldWholeOnASmallScreenInEveryLanguage() {
        for (const char* code : {"fr", "es", "pt", "en"}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(bare_));
            const Scan& scan = *on.picture().detection->scan;
            const auto valid = std::ranges::find(scan.state.cells, CellState::Valid) - scan.state.cells.begin();
            const QPoint cell = on.viewer.views.placeOf(static_cast<std::size_t>(valid));
            auto* probe = on.window.findChild<QLabel*>("probe");
            for (const int width : {1280, 1366, 1920}) {
                resizeTo(on.window, {width, 800});
                on.viewer.views.clearPin();
                emit on.viewer.views.gray().clicked(cell.y(), cell.x());
                QApplication::processEvents();
                QVERIFY2(!probe->text().contains("…"), qPrintable(QString("%1 %2: %3").arg(code).arg(width).arg(probe->text())));
                QCOMPARE(probe->toolTip(), on.viewer.statusLine.probeShown());
                QVERIFY(probe->width() >= QFontMetrics(probe->font()).horizontalAdvance(probe->text()));
                QVERIFY2(on.window.findChild<QLabel*>("counts")->isVisible(), code);
            }
        }
        useLanguage("en");
    }

    void everyToolHasItsButtonInEveryLanguage() {
        for (const char* code : {"fr", "es", "pt", "en"}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(bare_));
            int withWords = 0;
            for (const int width : {853, 1280, 1920, 2560}) {
                resizeTo(on.window, {width, 800});
                withWords = 0;
                for (const auto* button : on.viewer.tools.findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
                    if (button->objectName() == "qt_toolbar_ext_button") {
                        QVERIFY2(!button->isVisible(), qPrintable(QString("%1: there is no room at %2").arg(code).arg(width)));
                        continue;
                    }
                    QVERIFY2(button->isVisible() && button->width() >= button->sizeHint().width(), qPrintable(button->text()));
                    QVERIFY2(!button->icon().isNull() && !button->toolTip().isEmpty(), qPrintable(button->text()));
                    withWords += button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon ? 1 : 0;
                }
                QVERIFY2(withWords >= 2 || width < 1100, "Open and Connect are read where they have room next to the badge");
            }
            QVERIFY2(withWords > 10, "where there is room all are read");
        }
        useLanguage("en");
        WindowFixture on;
        QVERIFY(on.showWith(bare_) && on.activate());
        const auto pressed = [&](const char* text) {
            for (auto* button : on.viewer.tools.findChildren<QToolButton*>()) {
                if (button->text() == text) QTest::mouseClick(button, Qt::LeftButton);
            }
        };
        pressed("Rocks");
        QVERIFY(on.viewer.rocks.shown());
        auto* measure = on.window.findChild<QToolButton*>("tool-measure");
        QVERIFY(!measure->isChecked());
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        QVERIFY(measure->isChecked());
        pressed("Pin");
        QVERIFY(!measure->isChecked() && on.viewer.views.tool() == Tool::Pin);
    }

    // Three panels, one above the other, with the cards of a rock and a target: content that does not fit scrolls, and no widget is
    // squeezed or cut off.
    void cardsAreWholeWhateverRoomTheyHave() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_K);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); }));
        on.viewer.views.pin(on.viewer.views.cellAt(60, 80));
        QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
        for (const QSize size : {QSize(1280, 800), QSize(1366, 768), QSize(1920, 1080)}) {
            resizeTo(on.window, size);
            for (const QWidget* panel : {static_cast<QWidget*>(&on.viewer.rocksPanel), static_cast<QWidget*>(&on.viewer.targetsPanel)}) {
                if (!panel->isVisible()) continue;
                int labels = 0;
                for (const QLabel* label : panel->findChildren<QLabel*>()) {
                    if (!label->isVisible() || label->text().isEmpty() || !label->pixmap(Qt::ReturnByValue).isNull()) continue;
                    ++labels;
                    QVERIFY2(label->height() >= label->fontMetrics().height(), qPrintable(label->text()));
                }
                QVERIFY(labels > 2);
                QVERIFY2(panel->width() <= panel->parentWidget()->width(), "cut off at the right");
            }
        }
    }

    // From 1600 px on most names are read. A prompt moves no button; it has two lines, and its tool tip has all of it.
    void aPromptMovesNoButtonAndIsWhole() {
        for (const char* code : {"fr", "es", "pt", "en"}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(bare_));
            const auto* words = dynamic_cast<ElidedLabel*>(on.window.findChild<QLabel*>("tool-words"));
            QVERIFY(words != nullptr);
            const auto buttons = on.viewer.tools.findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
            for (const int width : {853, 1024, 1280, 1600, 1920, 2560}) {
                on.viewer.measures.stop();
                resizeTo(on.window, {width, 800});
                std::vector<QRect> places;
                for (const auto* button : buttons) places.push_back(button->geometry());
                for (const auto kind : {inspect::MeasureKind::Distance, inspect::MeasureKind::Throat}) {
                    on.viewer.measures.start(kind);
                    if (kind == inspect::MeasureKind::Throat) emit on.viewer.views.gray().clicked(30, 30);
                    QVERIFY(!words->text().isEmpty());
                    QApplication::processEvents();
                    for (std::size_t n = 0; n < places.size(); ++n)
                        QVERIFY2(buttons[static_cast<int>(n)]->geometry() == places[n], qPrintable(buttons[static_cast<int>(n)]->text()));
                    QCOMPARE(words->toolTip(), words->text());
                    if (width >= 1280)
                        QVERIFY2(words->shown() == words->text(),
                                 qPrintable(QString("%1 %2 %3: %4").arg(code).arg(width).arg(words->width()).arg(words->shown())));
                }
                const auto named = std::ranges::count_if(
                    buttons, [](const QToolButton* each) { return each->toolButtonStyle() == Qt::ToolButtonTextBesideIcon; });
                QVERIFY2(named >= (width >= 1920   ? 10
                                   : width >= 1600 ? 5
                                                   : 0),
                         qPrintable(QString("%1 %2: %3").arg(code).arg(width).arg(named)));
            }
        }
        useLanguage("en");
    }

    void noMeasuredValueIsCut() {
        TargetsPanel panel;
        panel.resize(250, 600);
        panel.showMeasures(
            {{"Ancho de garganta 1.608 m ± 0.024 m, un extremo está 1.25 m más cerca", QString(), false}, {"0.5 m", QString(), false}});
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMs));
        auto& list = *panel.findChild<QListWidget*>("measure-list");
        for (const int width : {250, 320, 600}) {
            panel.resize(width, 600);
            QTRY_VERIFY(panel.width() == width);
            const int line = list.fontMetrics().height();
            const QString text = list.item(0)->text();
            QTRY_VERIFY2(list.visualItemRect(list.item(0)).height() >=
                             list.fontMetrics().boundingRect(0, 0, list.viewport()->width() - 8, 999, Qt::TextWordWrap, text).height(),
                         qPrintable(QString::number(width)));
            QTRY_VERIFY(list.viewport()->height() >= list.visualItemRect(list.item(1)).bottom() && list.height() < 6 * line);
        }
    }

    // A list whose bar came with its height never came to rest: bar, other wrapping, other height, no bar (seen at 1280 x 800).
    void listsOfTargetsComeToRest() {
        struct Resizes : QObject {
            int count = 0;
            bool eventFilter(QObject* watched, QEvent* event) override {
                count += event->type() == QEvent::Resize ? 1 : 0;
                if (count > 1000) qFatal("the list does not come to rest");
                return QObject::eventFilter(watched, event);
            }
        };
        QScrollArea area;
        area.setWidgetResizable(true);
        auto* panel = new TargetsPanel;
        area.setWidget(panel);
        area.show();
        QVERIFY(QTest::qWaitForWindowExposed(&area, kPatienceMs));
        const std::vector<TargetLine> measures{
            {"Distance 5.456 m ± 0.036 m ▲ an end is 11.91 m in front of the surface under the line", QString(), false},
            {"Throat 0.845 m ± 0.043 m", QString(), false}};
        for (const int targets : {1, 2, 3, 5, 6, 12}) {
            std::vector<TargetLine> lines;
            for (int n = 1; n <= targets; ++n)
                lines.push_back({QString("%1  %2 m ± 0.019 m").arg(n).arg(4.911 + n), QString(), n == targets});
            panel->showTargets(lines);
            panel->showMeasures(measures);
            for (int width = 200; width < 420; width += 3) {
                Resizes resizes;
                for (auto* list : panel->findChildren<QListWidget*>()) list->viewport()->installEventFilter(&resizes);
                area.resize(width, 300 + width % 7 * 60);
                for (int round = 0; round < 5; ++round) QCoreApplication::processEvents();
                QVERIFY2(resizes.count < 40, qPrintable(QString("%1 targets, %2 px: %3").arg(targets).arg(width).arg(resizes.count)));
            }
        }
    }

    void tabsOfPanelsHaveTheirWholeNames() {
        for (const char* code : {"fr", "es", "pt", "en"}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(bare_) && on.activate());
            resizeTo(on.window, {1280, 800});
            on.viewer.rocks.setShown(true);
            on.viewer.views.pin(on.viewer.views.cellAt(60, 80));
            const auto bar = [&]() -> const QTabBar* {
                for (const auto* each : on.window.findChildren<QTabBar*>()) {
                    if (each->isVisible() && each->count() == 3) return each;
                }
                return nullptr;
            };
            QTRY_VERIFY(bar() != nullptr);
            const auto isWhole = [&](int tab) {
                return bar()->tabRect(tab).width() >= bar()->fontMetrics().horizontalAdvance(bar()->tabText(tab)) + 8;
            };
            for (int tab = 0; tab < 3; ++tab) QTRY_VERIFY2(isWhole(tab), qPrintable(code + (": " + bar()->tabText(tab))));
        }
        useLanguage("en");
    }
};

int legible_test(int argc, char** argv) { return runWindowTest<LegibleTest>(argc, argv); }

#include "legible_test.moc"
