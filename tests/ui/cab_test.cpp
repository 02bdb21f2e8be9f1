// Cab mode in the real window: everything is large enough for gloves and works with one hand, without modifiers or hover; fingers rotate,
// move, zoom and open menus.
#include "core/edges/explain/cell_values.h"
#include "tests/support/scans.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/sized_window.h"
#include "ui/base/elided_label.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/base/scrolled.h"
#include "ui/base/touch.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"
#include "ui/window/tool_bar.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCommandLinkButton>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <functional>

using namespace edgescan;
using namespace edgescan::ui;

class CabTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;
    QTouchDevice* touch_ = nullptr;

    static void press(MainWindow& window, const char* name) { QTest::mouseClick(tool(window, name), Qt::LeftButton); }
    // The first cell with a range that the cloud shows near its middle.
    static QPoint pointOnCloud(const CloudView& cloud) {
        for (int r = 0; r < 200; r += 4) {
            for (const QPoint by : {QPoint(r, 0), QPoint(-r, 0), QPoint(0, r), QPoint(0, -r)}) {
                const QPoint at = cloud.rect().center() + by;
                if (cloud.cellAt(at)) return at;
            }
        }
        qFatal("the cloud is empty");
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        scan_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(200, 240, 3, 0.02), scan_)));
        touch_ = QTest::createTouchDevice();
    }
    void cleanup() { useTheme(*qApp); }

    void theCornerCoversNoWords() {
        WindowFixture on;
        QVERIFY(on.show());
        on.window.resize(1280, 775);
        on.window.cab().set(true);
        QVERIFY2(!on.window.cab().corner().isVisible(), "without a scan there is nothing to show in it");
        QVERIFY(on.open(scan_));
        QTRY_VERIFY(on.window.cab().corner().isVisible());
        // A note of the view ends where the corner picture begins.
        on.viewer.views.setAsked(QString("a prompt of many words ").repeated(5));
        const auto* overlay = on.viewer.views.cloud().findChild<CloudOverlay*>();
        QTRY_VERIFY(!overlay->label().isEmpty() && overlay->label().right() < on.window.cab().corner().x());
        // The picture's text fits below it in every font.
        CornerPicture& corner = on.window.cab().corner();
        corner.setWords("⇄ Image de distances");
        const int pictureAt = 4 * corner.width() / 5; // 200 x 240 cells: the maximum height
        const QRect words = corner.fontMetrics().boundingRect(0, 0, corner.width() - 16, 1 << 14, Qt::TextWordWrap, corner.text());
        QVERIFY2(corner.height() >= words.height() + std::min(pictureAt, corner.parentWidget()->height() * 2 / 5),
                 qPrintable(QString("%1 of %2").arg(corner.height()).arg(words.height())));
        QVERIFY(tapEntry(on.window, "cab-images", SmallEntry));
        QVERIFY(!on.window.cab().corner().isVisible());
        on.window.cab().set(false);
    }

    // A note is next to the picture in the corner, or below it, in every language.
    void noNoteCoversTheCorner() {
        for (const Language& language : kLanguages) {
            QVERIFY(useLanguage(language.code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(true);
            QTRY_VERIFY(on.window.cab().corner().isVisible());
            for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 775)}) {
                resizeTo(on.window, size);
                for (const bool swapped : {false, true}) {
                    QAbstractButton* corner = swapped ? on.window.findChild<CornerPicture*>("cab-back") : &on.window.cab().corner();
                    if (swapped) QVERIFY(tapEntry(on.window, "cab-images", RangeEntry));
                    QTRY_VERIFY(corner->isVisible());
                    for (const bool unfolded : {false, true}) {
                        NoticeBar& notice = on.viewer.notice;
                        notice.showNotice(NoticeBar::Kind::Warning, QString("a note of several words ").repeated(8));
                        notice.offer(QObject::tr("Give it…"), [] {});
                        notice.unfold(unfolded);
                        const auto on_ = [&](const QWidget& each) { return QRect(each.mapTo(&on.window, QPoint()), each.size()); };
                        QTRY_VERIFY2(!on_(notice).intersects(on_(*corner)),
                                     qPrintable(QString("%1 at %2, unfolded %3").arg(language.code).arg(size.width()).arg(unfolded)));
                        notice.hide();
                    }
                    if (swapped) QVERIFY(tapEntry(on.window, "cab-images", CloudEntry));
                }
            }
        }
        useLanguage("en");
    }

    // Prompts and hints name what a finger does.
    void noPromptNamesAMouse() {
        const QRegularExpression mouse("\\b(click|clic|cliqu|clique)", QRegularExpression::CaseInsensitiveOption);
        for (const Language& language : kLanguages) {
            QVERIFY(useLanguage(language.code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.viewer.rocks.setShown(true);
            QVERIFY(eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); }));
            on.viewer.measures.start(inspect::MeasureKind::Distance);
            QVERIFY2(on.viewer.tools.shown().contains(mouse), qPrintable(on.viewer.tools.shown()));
            on.window.cab().set(true);
            QStringList texts{on.viewer.tools.shown()};
            for (const inspect::MeasureTraits& each : inspect::measureTraits()) {
                if (!each.inViews) continue;
                on.viewer.measures.start(each.kind);
                texts << on.viewer.tools.shown();
            }
            on.viewer.measures.stop();
            for (const RockTool each : {RockTool::Split, RockTool::Join, RockTool::Cut, RockTool::Region}) {
                on.viewer.rocks.useTool(each);
                texts << on.viewer.tools.shown();
            }
            on.viewer.rocks.useTool(RockTool::None);
            on.viewer.views.clearPin();
            on.viewer.views.pointAt(std::nullopt);
            on.viewer.explanation.explainMarked();
            texts << on.viewer.notice.text();
            on.viewer.sections.throughRock();
            texts << on.viewer.notice.text();
            for (const auto* each : on.window.cab().frame().findChildren<QLabel*>())
                texts << (each->isVisible() ? each->text() : QString());
            for (const QString& text : texts) QVERIFY2(!text.contains(mouse), qPrintable(language.code + (": " + text)));
            QVERIFY2(language.code != QLatin1String("en") || texts.front().endsWith("tap one end"), qPrintable(texts.front()));
            on.viewer.measures.start(inspect::MeasureKind::Distance);
            on.window.cab().set(false);
            QVERIFY2(on.viewer.tools.shown().contains(mouse), qPrintable(on.viewer.tools.shown()));
        }
        useLanguage("en");
    }

    // What looks at a rock or a region meanwhile leaves the images whole on the desk.
    void theImagesAreWholeAfterTheCab() {
        Share share = Share::Balanced;
        for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 775), QSize(1600, 900)}) {
            for (const char* large : {"", "gray", "edges"}) {
                share = share == Share::Images ? Share::Balanced : Share::Images; // every pair of two of the three
                WindowFixture on;
                on.window.resize(size);
                QVERIFY(on.showWith(scan_));
                on.viewer.notice.hide();
                on.window.places().setShare(share);
                on.window.places().use(large);
                on.viewer.rocks.setShown(true);
                QVERIFY(eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); }));
                const ViewPort& port = *on.viewer.gray.viewPort();
                QTRY_VERIFY(port.fitted());
                QApplication::processEvents();
                for (const bool swaps : {false, true}) {
                    on.window.cab().set(true);
                    if (swaps) QTest::mouseClick(&on.window.cab().corner(), Qt::LeftButton);
                    on.viewer.rocks.lookAtLargest();
                    on.window.cab().set(false);
                    QTRY_COMPARE(on.window.size(), size);
                    const QString where = QString("%1, share %2, large %3").arg(size.width()).arg(static_cast<int>(share)).arg(large);
                    const auto whole = [&] {
                        for (const ImageView* view : {&on.viewer.gray, &on.viewer.edges}) {
                            const QPointF from = port.toPixel({0, 0}, view->size());
                            const QPointF to =
                                port.toPixel({1.0 * port.imageSize().width(), 1.0 * port.imageSize().height()}, view->size());
                            if (view->isVisible() && !QRectF(view->rect()).adjusted(-2, -2, 2, 2).contains(QRectF(from, to))) return false;
                        }
                        return true;
                    };
                    QTRY_VERIFY2(whole(), qPrintable(where));
                }
            }
        }
    }

    // The distance is whole in each language, also on the lowest screens, and the last row of the card can be scrolled into sight.
    void theDistanceIsInSight() {
        for (const Language& language : kLanguages) {
            QVERIFY(useTexts(language.code));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(true);
            for (const QSize size : {QSize(853, 460), QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
                resizeTo(on.window, size);
                on.viewer.views.pin(std::nullopt);
                on.viewer.views.pin(on.picture().detection->edges->at(on.picture().detection->edges->size() / 2));
                QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
                auto* distance = on.viewer.targetsPanel.card().findChild<QLabel*>("target-distance");
                const auto whole = [](const QWidget& each) { return each.visibleRegion().boundingRect() == each.rect(); };
                QTRY_VERIFY2(whole(*distance) && distance->width() >= distance->sizeHint().width(),
                             qPrintable(QString("%1 at %2 x %3").arg(language.code).arg(size.width()).arg(size.height())));
                auto* last = on.viewer.targetsPanel.card().findChild<QLabel*>("edge");
                scrollTo(*last);
                QTRY_VERIFY(whole(*last));
            }
            on.window.cab().set(false);
        }
        useLanguage("en");
    }

    // A cab has no keyboard, and nothing is dropped on its window.
    void theStartPageNamesNoKeys() {
        WindowFixture on;
        QVERIFY(on.show());
        const auto* page = showStart(on.window, on.preferences);
        const auto words = [page] {
            QString all;
            for (const auto* each : page->findChildren<QCommandLinkButton*>()) all += each->description() + '\n';
            return all;
        };
        QVERIFY2(words().contains("Ctrl+O") && words().contains("Ctrl+L"), qPrintable(words()));
        on.window.cab().set(true);
        QVERIFY2(!words().contains("Ctrl") && !words().contains("drop") && words().contains("ws://ROBOT"), qPrintable(words()));
        on.window.cab().set(false);
    }

    // The tool bar, which has the prompts, is hidden: the views show what a tool waits for, and Pin is on only while a touch pins.
    void thePromptOfAToolIsInTheViews() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        const ImageView& gray = on.viewer.views.gray();
        on.viewer.measures.start(inspect::MeasureKind::Throat);
        QVERIFY2(gray.note().contains("Throat Width"), qPrintable(gray.note()));
        on.viewer.measures.stop();
        QCOMPARE(gray.note(), QString());
        on.viewer.rocks.setShown(true);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() != nullptr; }));
        const auto* pin = tool(on.window, "cab-pin");
        QVERIFY(!pin->isChecked()); // a tap chooses a rock
        on.viewer.rocks.useTool(RockTool::Join);
        QVERIFY2(gray.note().contains("Merge"), qPrintable(gray.note()));
        QVERIFY(!pin->isChecked());
        QTest::mouseClick(tool(on.window, "cab-pin"), Qt::LeftButton);
        QVERIFY(on.viewer.rocks.tool() == RockTool::None && pin->isChecked() && gray.note().isEmpty());
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        on.window.cab().set(false);
        QCOMPARE(gray.note(), QString()); // the tool bar has it
    }

    // The start page is below the head, whichever comes first: Open, Connect and the way out stay free, and the page has the rest.
    void theStartPageLeavesTheHeadFree() {
        for (const bool cabFirst : {false, true}) {
            WindowFixture on;
            on.window.cab().set(cabFirst);
            QVERIFY(on.show());
            StartPage* page = showStart(on.window, on.preferences);
            on.window.cab().set(true);
            const QWidget& head = on.window.cab().frame().head();
            for (const QSize size : {QSize(1280, 800), QSize(1024, 768), QSize(853, 533), QSize(853, 460)}) {
                resizeTo(on.window, size);
                QTRY_COMPARE(page->y(), head.mapTo(&on.window, QPoint(0, head.height())).y());
                QTRY_COMPARE(page->geometry().bottom(), on.window.rect().bottom());
                QTRY_COMPARE(page->width(), on.window.width());
                for (const auto* each : page->findChildren<QAbstractButton*>()) {
                    if (each->isVisible()) QVERIFY2(each->height() >= kGlovePx, qPrintable(each->objectName()));
                }
                QVERIFY(!page->findChild<QWidget*>("start-cab")->isVisible());
            }
            on.window.cab().set(false);
            QTRY_VERIFY(page->findChild<QWidget*>("start-cab")->isVisible());
            QTRY_VERIFY(page->geometry().bottom() < on.viewer.statusLine.mapTo(&on.window, QPoint()).y());
        }
    }

    // Every dialog that a command opens, except Qt's file dialogs, which have their own sizes.
    void dialogsAreLargeEnoughForGlovesToo() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, QSize(1280, 800));
        on.viewer.views.pin(on.viewer.views.cellAt(100, 120));
        on.viewer.comparing.keep();
        on.viewer.rocks.setShown(true);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() != nullptr; }));
        on.viewer.selection.select({100, 101, 102});
        on.viewer.markedEdges.mark(on.viewer.views.cellAt(100, 120), true);
        QSet<QString> dialogs;
        QStringList small;
        bool asked = false;
        const auto measure = [&] {
            for (QWidget* top : QApplication::topLevelWidgets()) {
                auto* dialog = qobject_cast<QDialog*>(top);
                if (dialog == nullptr || !dialog->isVisible()) continue;
                asked = true;
                if (qobject_cast<QFileDialog*>(dialog) == nullptr) {
                    dialogs << dialog->windowTitle();
                    for (const QWidget* each : dialog->findChildren<QWidget*>()) {
                        const bool pressed =
                            qobject_cast<const QAbstractButton*>(each) != nullptr || qobject_cast<const QComboBox*>(each) != nullptr ||
                            qobject_cast<const QAbstractSpinBox*>(each) != nullptr || qobject_cast<const QLineEdit*>(each) != nullptr;
                        const bool isPart = qobject_cast<QAbstractSpinBox*>(each->parentWidget()) != nullptr ||
                                            qobject_cast<QComboBox*>(each->parentWidget()) != nullptr ||
                                            qobject_cast<QLineEdit*>(each->parentWidget()) != nullptr ||
                                            each->objectName().startsWith("qt_");
                        if (!pressed || isPart || !each->isVisible()) continue;
                        if (each->width() < kGlovePx || each->height() < kGlovePx)
                            small << QString("%1: %2 \"%3\" %4 x %5")
                                         .arg(dialog->windowTitle(), each->metaObject()->className(), each->objectName())
                                         .arg(each->width())
                                         .arg(each->height());
                    }
                }
                dialog->reject();
            }
            if (QWidget* popup = QApplication::activePopupWidget()) {
                asked = true;
                popup->close();
            }
        };
        for (QAction* action : on.window.actions()) {
            const QString text = QString(action->text()).remove('&');
            const bool asks = text.endsWith("…") || text.startsWith("Why") || text.startsWith("Does This") || text.startsWith("Keys") ||
                              text.startsWith("About");
            if (!asks || !action->isEnabled() || text.startsWith("Connect") || text.startsWith("Name This")) // in the field of the card
                continue;
            QTimer look; // works also during the dialog's own event loop
            look.setInterval(50);
            connect(&look, &QTimer::timeout, this, measure);
            look.start();
            asked = false;
            action->trigger();
            const bool any = eventually([&] { // a dialog that is not modal
                measure();
                return asked;
            });
            QVERIFY2(any, qPrintable(text));
        }
        qInfo("%d dialogs measured", static_cast<int>(dialogs.size()));
        QVERIFY2(dialogs.size() >= 8, qPrintable(QStringList(dialogs.values()).join(", ")));
        small.removeDuplicates();
        QVERIFY2(small.isEmpty(), qPrintable(small.join("\n")));
    }

    void theMenuHasRowsForGlovesAndAllThatTheMenuBarHas() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        press(on.window, "cab-menu");
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu != nullptr);
        QList<QAction*> entries = menu->actions();
        QCOMPARE(entries.takeFirst()->objectName(), QString("close-menu"));
        QCOMPARE(entries.mid(entries.size() - on.window.menuBar()->actions().size()), on.window.menuBar()->actions());
        for (QAction* entry : menu->actions()) QVERIFY(entry->isSeparator() || menu->actionGeometry(entry).height() >= kGlovePx);
        menu->close();
        press(on.window, "cab-measure");
        menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu != nullptr);
        QVERIFY(menu->actionGeometry(menu->actions()[1]).height() >= kGlovePx);
        // The first entry closes it and does nothing else; so does a tap next to it.
        QVERIFY(menu->testAttribute(Qt::WA_NoMouseReplay));
        QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(menu->actions().front()).center());
        QTRY_VERIFY(!menu->isVisible());
        for (QMenu* each : on.window.menuBar()->findChildren<QMenu*>()) { // no text is cut: Fusion takes 0.79 of the height for the mark
            each->ensurePolished();
            for (QAction* entry : each->actions()) {
                const QRect row = each->actionGeometry(entry);
                const int text = each->fontMetrics().size(Qt::TextSingleLine | Qt::TextShowMnemonic, entry->text()).width();
                QVERIFY2(entry->isSeparator() || !entry->isVisible() || row.width() >= text + 0.79 * row.height() + 10,
                         qPrintable(QString("%1: %2 for %3").arg(entry->text()).arg(row.width()).arg(text)));
            }
        }
        QVERIFY(!on.viewer.measures.kind());
        press(on.window, "cab-measure");
        QTRY_VERIFY(menu->isVisible());
        QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(menu->actions()[1]).center());
        QTRY_VERIFY(on.viewer.measures.kind() == inspect::MeasureKind::Distance);
        QVERIFY(tool(on.window, "cab-measure")->isChecked() && !tool(on.window, "cab-pin")->isChecked());
        press(on.window, "cab-pin");
        QVERIFY(!on.viewer.measures.kind());
    }

    // What a small screen has no button for is in Menu, in every language.
    void everyCommandOfTheHeadIsThereOnASmallScreen() {
        for (const Language& language : kLanguages) {
            QVERIFY(useLanguage(language.code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(true);
            for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 775)}) {
                resizeTo(on.window, size);
                press(on.window, "cab-menu");
                auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
                QVERIFY(menu != nullptr);
                QStringList texts;
                for (const QAction* each : menu->actions()) texts << each->text();
                menu->close();
                const CabHead& head = on.window.cab().frame().head();
                const auto isReached = [&](const QWidget& button, const QString& text) {
                    return button.isVisible() || texts.contains(text);
                };
                const QByteArray where = texts.join(", ").toUtf8();
                for (const QToolButton* each : {head.open(), head.connectScanner()}) QVERIFY2(isReached(*each, each->text()), where);
                QVERIFY2(isReached(*head.clock(), head.clock()->text().simplified()), where);
            }
            on.window.cab().set(false);
        }
        useLanguage("en");
    }

    // Another badge, a warning, and a running work move no button of the head.
    void noButtonOfTheHeadMoves() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        CabHead& head = on.window.cab().frame().head();
        auto* badge = on.window.findChild<StateBadge*>("cab-origin");
        for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 775)}) {
            resizeTo(on.window, size);
            const auto places = [&] {
                QApplication::processEvents();
                QVector<QRect> all;
                for (const QWidget* each :
                     std::initializer_list<const QWidget*>{head.menu(), head.open(), head.connectScanner(), badge, head.leave()})
                    all << (each->isVisible() ? each->geometry() : QRect());
                return all;
            };
            const QVector<QRect> before = places();
            badge->showState(StateBadge::Sign::Waiting, "HELD · 2026-11-24 09:09:09 UTC");
            QCOMPARE(places(), before);
            // The time is whole on every screen, and the name is shortened at its end.
            for (const QString name : {"HELD", "FILE a-scan-with-a-name-that-is-longer-than-the-badge"}) {
                const QString time = "2026-11-24 09:09:09 UTC";
                badge->showState(StateBadge::Sign::Waiting, name + " · " + time);
                QStringList lines = badge->linesIn(badge->width() - 40);
                const QString first = lines.takeFirst();
                QVERIFY2(name.startsWith(QString(first).remove("…")), qPrintable(first));
                QVERIFY2(lines.join(' ') == time && lines.size() <= 2, qPrintable(lines.join('|')));
            }
            badge->showState(StateBadge::Sign::File,
                             QString::fromUtf8("FILE demo of a draw-bell before …the blast · 2026-11-24 09:09:09 UTC"));
            // Too little of a name is left out: it is the title next to the badge.
            const QString shown = badge->linesIn(badge->width() - 40).front();
            QVERIFY2(size.width() < 1280 ? shown == "FILE" : shown.size() > 14 && shown.count(QString::fromUtf8("…")) == 1,
                     qPrintable(shown));
            QCOMPARE(places(), before);
            head.showWork("Finding rocks: growing, 34 %");
            QCOMPARE(places(), before);
            head.warnings()->setVisible(!head.warnings()->isVisible());
            QCOMPARE(places(), before);
            head.showWork(QString());
            QCOMPARE(places(), before);
        }
        on.window.cab().set(false);
    }

    // An arrow at the rim points to a target that the view does not show; the switch of the edges has their colour.
    void whatIsOutsideOfTheViewIsPointedTo() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        CloudView& cloud = on.viewer.views.cloud();
        const auto cell = cloud.cellAt(pointOnCloud(cloud));
        QVERIFY(cell);
        on.viewer.views.pin(*cell);
        const auto* overlay = cloud.findChild<CloudOverlay*>();
        QVERIFY(eventually([&] { return overlay->marks().ring.has_value(); }));
        QVERIFY(!overlay->arrow());
        CameraPose pose = cloud.camera();
        const Eigen::Vector3d aside = 40.0 * pose.halfHeight() * cloud.width() / cloud.height() * pose.right();
        pose.position += aside;
        pose.focus += aside;
        cloud.setCamera(pose);
        QVERIFY(overlay->arrow().has_value());
        const QLineF arrow = *overlay->arrow();
        QVERIFY(overlay->rect().contains(arrow.p2().toPoint()) && arrow.p2().x() < 20 && arrow.dx() < 0);
        // Turned away until it is behind the camera, with the sensor: the shorter way back. A tap on the arrow goes there.
        CameraPose behind = cloud.camera();
        const Eigen::Vector3d place = cloud.geometryOfCloud()->point(*cell).cast<double>();
        behind.position = place + 100.0 * behind.forward() - 10.0 * behind.right();
        behind.focus = behind.position + behind.forward();
        cloud.setCamera(behind);
        QVERIFY(overlay->arrow().has_value());
        QVERIFY(overlay->arrow()->dx() > 0 && std::abs(overlay->arrow()->dy()) < overlay->arrow()->dx());
        QTRY_VERIFY(cloud.atRest());
        QTest::mouseClick(&cloud, Qt::LeftButton, Qt::NoModifier, overlay->arrow()->center().toPoint());
        QVERIFY(!overlay->arrow());
        QVERIFY(cloud.pixelOf(*cell) && cloud.rect().contains(cloud.pixelOf(*cell)->toPoint()));
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        // That to a measurement is there too.
        inspect::StoredMeasure measure;
        measure.cells = {static_cast<std::uint32_t>(*cell), static_cast<std::uint32_t>(*cell) + 1};
        on.viewer.targets.keepMeasure(measure);
        QVERIFY(!overlay->arrow());
        cloud.setCamera(behind);
        QVERIFY(overlay->arrow().has_value());
        QVERIFY(!on.viewer.legend.findChild<QCheckBox*>("legend-edges")->icon().isNull());
        on.window.cab().set(false);
        QVERIFY(on.viewer.legend.findChild<QCheckBox*>("legend-edges")->icon().isNull());
    }

    void onlyASecondOnItsButtonLeavesIt() {
        const QString ini = QString::fromStdString((folder_ / "cab.ini").string());
        WindowFixture on(ini);
        QVERIFY(on.showWith(scan_));
        const int before = on.viewer.views.gray().width();
        auto* action = on.window.findChild<QAction*>("cab-mode");
        QVERIFY(action != nullptr && !action->isChecked());
        action->trigger();
        QVERIFY(on.window.cab().on() && action->isChecked());
        QVERIFY(!action->isEnabled()); // cab mode cannot be left by a tap in the menu
        QVERIFY(on.preferences.flag("view/cab", false));
        QToolButton* leave = tool(on.window, "cab-leave");
        QTest::mouseClick(leave, Qt::LeftButton);
        QVERIFY(on.window.cab().on());
        QVERIFY2(on.viewer.notice.text().contains("one second"), qPrintable(on.viewer.notice.text()));
        QElapsedTimer held;
        held.start();
        QTest::mousePress(leave, Qt::LeftButton);
        QTRY_VERIFY(!on.window.cab().on());
        QVERIFY2(held.elapsed() >= kHoldMs, qPrintable(QString::number(held.elapsed())));
        QTest::mouseRelease(leave, Qt::LeftButton);
        QVERIFY(action->isEnabled() && !action->isChecked());
        QVERIFY(!on.preferences.flag("view/cab", true));
        QTRY_VERIFY(on.window.menuBar()->isVisible() && on.viewer.views.gray().isVisible());
        QTRY_VERIFY(std::abs(on.viewer.views.gray().width() - before) <= 4);
        QVERIFY(on.window.findChild<QDockWidget*>("dock-edges")->isVisible());
    }

    void nothingIsLeftOverTheCloudAndNothingComesUnasked() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        QDialog section(&on.window); // as the window of a section
        section.show();
        QVERIFY(!on.viewer.live.panel().isVisible());
        on.window.cab().set(true);
        QVERIFY(!section.isVisible());
        on.window.cab().set(false);
        QVERIFY2(!on.viewer.live.panel().isVisible(), "no scanner was asked for");
    }

    void theOutlineGoesToTheNextTarget() {
        WindowFixture on;
        QVERIFY(on.showWith(test::savedBell(folder_ / "bell.json")));
        on.viewer.rocks.setShown(true);
        QTRY_VERIFY(on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind());
        const auto& rocks = on.viewer.rocks.picture()->study.rocks;
        QVERIFY(rocks.size() >= 2);
        on.viewer.views.pin(rocks[0].cell);
        on.viewer.views.pin(rocks[1].cell);
        on.window.cab().set(true);
        // The card of what was chosen last is there, and it alone is marked.
        QVERIFY(on.viewer.targetsPanel.card().isVisible());
        on.viewer.rocks.lookAt(rocks[1].label);
        QVERIFY(on.viewer.rocksPanel.card().isVisible() && !on.viewer.targetsPanel.card().isVisible());
        QVERIFY(std::ranges::none_of(on.viewer.views.marks().targets, &TargetMark::active));
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(2));
        on.viewer.views.pin(rocks[1].cell);
        const auto second = on.viewer.views.cloud().outline();
        QVERIFY(second && on.viewer.targetsPanel.card().isVisible());
        QListWidget& list = *on.viewer.targetsPanel.targets();
        scrollTo(list);
        list.scrollToItem(list.item(0));
        QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, list.visualItemRect(list.item(0)).center());
        QTRY_VERIFY(on.viewer.targets.active() != nullptr && on.viewer.targets.active()->number == 1);
        const auto first = on.viewer.views.cloud().outline();
        QVERIFY(first && *first != *second);
        QVERIFY(on.viewer.rocks.picture()->labelAt(first->front()) == rocks[0].label);
    }

    void itIsRememberedAndTheLayoutOfBeforeComesBack() {
        const QString ini = QString::fromStdString((folder_ / "again.ini").string());
        {
            WindowFixture on(ini);
            QVERIFY(on.showWith(scan_));
            on.window.findChild<QAction*>("cab-mode")->trigger();
            on.window.close();
        }
        WindowFixture again(ini);
        QVERIFY(again.showWith(scan_));
        QVERIFY(again.window.cab().on());
        QVERIFY(!again.window.findChild<QDockWidget*>("dock-edges")->isVisible());
        again.window.cab().set(false);
        QTRY_VERIFY(again.window.findChild<QDockWidget*>("dock-edges")->isVisible());
    }

    // Also for widgets that were hidden in cab mode or are shown for the first time after it.
    void theThemeOfTheDeskComesBackCompletely() {
        const auto sizesAfter = [this](const std::function<void(MainWindow&)>& cabOfBefore) {
            WindowFixture on;
            on.window.resize(1280, 800);
            cabOfBefore(on.window);
            if (!on.showWith(scan_)) return QStringList();
            on.window.cab().set(false);
            if (!eventually([&] { return on.viewer.panel.isVisible(); })) return QStringList();
            QApplication::processEvents();
            QStringList sizes;
            for (const QWidget* each : on.viewer.panel.findChildren<QWidget*>()) {
                const auto* label = qobject_cast<const QLabel*>(each);
                const bool seen = label == nullptr ? !each->objectName().isEmpty() : !label->text().isEmpty();
                if (each->isVisible() && seen)
                    sizes << QString("%1 %2: %3 x %4, hint %5 x %6")
                                 .arg(each->metaObject()->className(), each->objectName())
                                 .arg(each->width())
                                 .arg(each->height())
                                 .arg(each->sizeHint().width())
                                 .arg(each->sizeHint().height());
            }
            return sizes;
        };
        const QStringList onlyDesk = sizesAfter([](MainWindow&) {});
        QVERIFY(onlyDesk.size() > 20);
        const QStringList fromCab = sizesAfter([](MainWindow& window) { window.cab().set(true); });
        QCOMPARE(fromCab.size(), onlyDesk.size());
        QStringList others;
        for (int n = 0; n < fromCab.size(); ++n) {
            if (fromCab[n] != onlyDesk[n]) others << fromCab[n] + ", not " + onlyDesk[n];
        }
        QVERIFY2(others.isEmpty(), qPrintable(others.join('\n')));
    }

    void theTwoNumbersAreLargeAndTheBadgeIsThere() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        const auto* distance = on.viewer.targetsPanel.card().findChild<QLabel*>("target-distance");
        const int usual = QFontInfo(distance->font()).pixelSize();
        on.window.cab().set(true);
        QVERIFY(on.window.findChild<StateBadge*>("cab-origin")->isVisible());
        QCOMPARE(on.window.findChild<StateBadge*>("cab-origin")->accessibleName(), on.viewer.origin.accessibleName());
        CloudView& cloud = on.viewer.views.cloud();
        QTest::mouseClick(&cloud, Qt::LeftButton, Qt::NoModifier, pointOnCloud(cloud)); // a tap, as most screens report it
        QTRY_COMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        QTRY_VERIFY(distance->isVisible() && on.viewer.targets.settled());
        const inspect::CellTarget& known = on.viewer.targets.known().targets.begin()->second;
        QTRY_COMPARE(distance->text(), QString("%1 m").arg(known.distanceM, 0, 'f', 3));
        QVERIFY(QFontInfo(distance->font()).pixelSize() >= usual * 13 / 10);
        press(on.window, "cab-rocks");
        QTRY_VERIFY(on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind());
        for (const QDockWidget* dock : on.window.findChildren<QDockWidget*>()) QVERIFY(dock->isHidden());
        press(on.window, "cab-rocks");
        // The undo button is visible, and works.
        QToolButton* undo = tool(on.window, "cab-undo");
        QVERIFY(undo->isVisible() && undo->isEnabled());
        QTest::mouseClick(undo, Qt::LeftButton);
        QTRY_VERIFY(on.viewer.targets.notebook().targets.empty());
        QTRY_VERIFY(on.viewer.targetsPanel.findChild<QLabel*>("targets-asked")->isVisible());
        on.window.cab().set(false);
        QCOMPARE(QFontInfo(distance->font()).pixelSize(), usual);
    }

    void theLargestRockIsThreeTouchesAway() {
        WindowFixture on;
        QVERIFY(on.showWith(test::savedBell(folder_ / "bell.json")));
        resizeTo(on.window, {1280, 800});
        on.window.cab().set(true);
        QVERIFY(tool(on.window, "cab-rocks")->findChild<QLabel*>("menu-sign") == nullptr); // a switch
        press(on.window, "cab-rocks");
        QTRY_VERIFY(on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind());
        for (const char* name : {"cab-menu", "cab-measure", "cab-rock", "cab-compare", "cab-images"})
            QVERIFY2(tool(on.window, name)->findChild<QLabel*>("menu-sign")->isVisible(), name);
        QVERIFY(!on.window.findChild<QAction*>("rocks-largest")->isShortcutVisibleInContextMenu());
        press(on.window, "cab-rocks");
        QVERIFY2(!on.viewer.rocks.shown() && !tool(on.window, "cab-rocks")->isChecked(), "a lit button switches off");
        press(on.window, "cab-rocks");
        QTRY_VERIFY(on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind());
        press(on.window, "cab-rock");
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu != nullptr);
        QAction* largest = on.window.findChild<QAction*>("rocks-largest");
        QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(largest).center());
        const RockCard& card = on.viewer.rocksPanel.card();
        const auto& rocks = on.viewer.rocks.picture()->study.rocks;
        const rocks::Rock& rock = std::ranges::max(rocks, {}, &rocks::Rock::shortestCaliperM);
        const auto* spans = card.findChild<QLabel*>("rock-spans");
        QTRY_COMPARE(spans->text(), QString("%1 × %2 m").arg(rock.longestCaliperM, 0, 'f', 2).arg(rock.shortestCaliperM, 0, 'f', 2));
        QTRY_VERIFY(spans->visibleRegion().boundingRect() == spans->rect());
        QVERIFY2(card.text().contains(QString("%1 m").arg(rock.distanceM, 0, 'f', 2)), qPrintable(card.text()));
        QVERIFY(on.viewer.targets.notebook().empty());
        // With Pin, a touch elsewhere is about the place that was touched.
        press(on.window, "cab-pin");
        CloudView& cloud = on.viewer.views.cloud();
        cloud.viewFromScanner();
        std::optional<QPoint> other;
        for (int n = 0; n < 1600 && !other; ++n) {
            const QPoint at(cloud.width() * (n % 40) / 40, cloud.height() * (n / 40 + 20) / 80);
            const auto cell = cloud.cellAt(at);
            if (cell && on.viewer.rocks.picture()->labelAt(*cell) != rock.label) other = at;
        }
        QVERIFY(other);
        QTest::mouseClick(&cloud, Qt::LeftButton, Qt::NoModifier, *other);
        QTRY_COMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        QTRY_VERIFY(on.viewer.targetsPanel.card().isVisible() && !card.isVisible());
        on.viewer.rocks.lookAtLargest();
        QTRY_VERIFY(card.isVisible());
    }

    // In two lines, before "More" is needed.
    void theNoteOfLeavingIsWhole() {
        for (const Language& language : kLanguages) {
            QVERIFY(useLanguage(language.code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(true);
            for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
                resizeTo(on.window, size);
                press(on.window, "cab-leave"); // too short
                const auto* line = static_cast<const ElidedLabel*>(on.viewer.notice.findChild<QLabel*>("notice-line"));
                QTRY_VERIFY(on.viewer.notice.isVisible() && line->height() >= line->heightForWidth(line->width()));
                QTRY_VERIFY2(!line->shown().endsWith("…"),
                             qPrintable(QString("%1 %2: %3").arg(language.code).arg(size.width()).arg(line->shown())));
                on.viewer.notice.hide();
            }
        }
        useLanguage("en");
    }

    // Until a target, a rock or another measurement is chosen.
    void aMeasurementIsInSight() {
        WindowFixture on;
        QVERIFY(on.showWith(test::savedBell(folder_ / "bell.json")));
        on.window.cab().set(true);
        resizeTo(on.window, {853, 480});
        TargetsPanel& panel = on.viewer.targetsPanel;
        const auto measure = [&](std::uint32_t from, std::uint32_t to) {
            inspect::StoredMeasure made;
            made.cells = {from, to};
            on.viewer.targets.keepMeasure(made);
        };
        const std::uint32_t a = 60 * 286 + 60, b = 100 * 286 + 120, c = 120 * 286 + 90;
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        QTRY_VERIFY2(panel.findChild<QLabel*>("targets-asked")->text().startsWith("Distance"), "without a target or a rock");
        measure(a, b);
        on.viewer.views.pin(b);
        QTRY_VERIFY(panel.card().isVisible());
        measure(b, c);
        QTRY_VERIFY(on.viewer.targets.settled() && on.viewer.targets.chosenMeasure() == std::size_t(1) && !panel.card().isVisible());
        const MeasureWords known = on.viewer.targets.wordsOf(on.viewer.targets.notebook().measures.back());
        const QListWidget& list = *panel.measures();
        QTRY_VERIFY2(list.item(1)->text().contains(known.value), qPrintable(list.item(1)->text()));
        QTRY_VERIFY2(list.visibleRegion().boundingRect().height() >= kGlovePx, "the chosen measurement is in sight");
        // One thing is marked in every view: the target or the measurement.
        const auto marked = [&](std::size_t targets, std::size_t ends) {
            const CellMarks& marks = on.viewer.views.cloud().marks();
            QVERIFY(marks == on.viewer.views.gray().marks());
            QCOMPARE(std::ranges::count_if(marks.targets, &TargetMark::active), static_cast<std::ptrdiff_t>(targets));
            QCOMPARE(std::ranges::count_if(marks.measures, &MeasureMark::active), static_cast<std::ptrdiff_t>(ends > 0 ? 1 : 0));
            QCOMPARE(on.window.cab().corner().marked().cells.size(), static_cast<int>(targets + ends));
            QCOMPARE(on.viewer.views.pinned().has_value(), targets > 0);
        };
        marked(0, 2);
        on.viewer.views.pin(b);
        marked(1, 0);
        on.viewer.targets.chooseMeasure(0);
        marked(0, 2);
        on.viewer.targets.removeMeasure(0);
        marked(0, 0);
        on.viewer.undo.undo();
        QCOMPARE(on.viewer.targets.chosenMeasure(), std::optional<std::size_t>(0)); // what came back is chosen
        on.viewer.rocks.lookAtLargest();
        QTRY_VERIFY(on.viewer.rocksPanel.card().isVisible());
        measure(c, a);
        QTRY_VERIFY(panel.isVisible() && list.isVisible() && !on.viewer.rocksPanel.card().isVisible());
    }

    void aNoteLeavesTheCornerPictureFree() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        for (const QSize size : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080)}) {
            resizeTo(on.window, size);
            on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "A note that is as long as most of those that are shown in a cab.");
            const auto placeOf = [](const QWidget& of) { return QRect(of.mapToGlobal(QPoint(0, 0)), of.size()); };
            QTRY_VERIFY2(!placeOf(on.viewer.notice).intersects(placeOf(on.window.cab().corner())),
                         qPrintable(QString::number(size.width())));
            QVERIFY(on.viewer.notice.height() < on.viewer.views.cloud().height() / 3);
            on.viewer.notice.hide();
        }
    }

    void aButtonOfASliderRepeatsWhileItIsHeldAndIsOneStepOfUndo() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        auto *less = on.viewer.panel.findChild<QToolButton*>("less-sensitivity"),
             *more = on.viewer.panel.findChild<QToolButton*>("more-sensitivity");
        QVERIFY(!more->isVisible());
        on.window.cab().set(true);
        press(on.window, "cab-tune");
        const QScrollBar& bar = *on.viewer.panel.findChild<QScrollArea*>()->verticalScrollBar();
        QTRY_VERIFY2(bar.value() > 0 && more->visibleRegion().boundingRect() == more->rect(), "what is changed most is in sight");
        const edges::Settings before = on.viewer.engine.settings();
        QTest::mouseClick(more, Qt::LeftButton);
        QVERIFY(on.viewer.engine.settings().sensitivity > before.sensitivity);
        QCOMPARE(on.viewer.undo.count(), 1);
        const double one = on.viewer.engine.settings().sensitivity;
        QTest::mousePress(less, Qt::LeftButton);
        QTRY_VERIFY(on.viewer.engine.settings().sensitivity < one - 3.5 * (one - before.sensitivity));
        QTest::mouseRelease(less, Qt::LeftButton);
        QCOMPARE(on.viewer.undo.count(), 2);
        QVERIFY(on.settled());
        press(on.window, "cab-undo");
        QCOMPARE(on.viewer.engine.settings().sensitivity, one);
        press(on.window, "cab-tune");
        QVERIFY(!more->isVisible() && on.viewer.targetsPanel.isVisible());
        on.window.cab().set(false);
        QTRY_VERIFY(on.viewer.panel.isVisible() && !more->isVisible());
    }

    void oneFingerTurnsTwoMoveAndZoom() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {1280, 800});
        CloudView& cloud = on.viewer.views.cloud();
        const QPoint a = cloud.rect().center();
        const CameraPose start = cloud.camera();
        QTest::touchEvent(&cloud, touch_).press(0, a, &cloud);
        for (int n = 1; n <= 5; ++n) QTest::touchEvent(&cloud, touch_).move(0, a + QPoint(12 * n, 0), &cloud);
        QTest::touchEvent(&cloud, touch_).release(0, a + QPoint(60, 0), &cloud);
        QTRY_VERIFY((cloud.camera().forward() - start.forward()).norm() > 0.05);
        QVERIFY(on.viewer.targets.notebook().targets.empty()); // not a tap

        const CameraPose turned = cloud.camera();
        const QPoint left = a - QPoint(60, 0);
        const QPoint right = a + QPoint(60, 0);
        // Fingers move apart: closer, without rotation.
        QTest::touchEvent(&cloud, touch_).press(0, left, &cloud).press(1, right, &cloud);
        for (int n = 1; n <= 4; ++n)
            QTest::touchEvent(&cloud, touch_).move(0, left - QPoint(15 * n, 0), &cloud).move(1, right + QPoint(15 * n, 0), &cloud);
        QTest::touchEvent(&cloud, touch_).release(0, left - QPoint(60, 0), &cloud).release(1, right + QPoint(60, 0), &cloud);
        QTRY_VERIFY((cloud.camera().position - turned.position).norm() > 0.1);
        QVERIFY((cloud.camera().forward() - turned.forward()).norm() < 1e-6);
        QVERIFY((cloud.camera().position - turned.position).dot(turned.forward()) > 0.1);

        // Fingers move together: the picture moves with them.
        const CameraPose near = cloud.camera();
        QTest::touchEvent(&cloud, touch_).press(0, left, &cloud).press(1, right, &cloud);
        for (int n = 1; n <= 4; ++n)
            QTest::touchEvent(&cloud, touch_).move(0, left + QPoint(0, 10 * n), &cloud).move(1, right + QPoint(0, 10 * n), &cloud);
        QTest::touchEvent(&cloud, touch_).release(0, left + QPoint(0, 40), &cloud).release(1, right + QPoint(0, 40), &cloud);
        const Eigen::Vector3d by = cloud.camera().position - near.position;
        QVERIFY2(by.dot(near.up) > 0.01, "the picture went down, the camera up");
        QVERIFY(std::abs(by.dot(near.forward())) < 0.2 * by.norm());
        QVERIFY(on.viewer.targets.notebook().targets.empty());
    }

    void twoFingersZoomAnImageRoundTheirMiddle() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        ImageView& gray = on.viewer.views.gray(); // touch works outside cab mode too
        const QPoint middle = gray.rect().center() + QPoint(20, 10);
        const double zoom = gray.viewPort()->zoom();
        const QPointF cell = gray.viewPort()->toCell(middle, gray.size());
        QTest::touchEvent(&gray, touch_).press(0, middle - QPoint(20, 0), &gray).press(1, middle + QPoint(20, 0), &gray);
        QTest::touchEvent(&gray, touch_).move(0, middle - QPoint(30, 0), &gray).move(1, middle + QPoint(30, 0), &gray);
        QTest::touchEvent(&gray, touch_).move(0, middle - QPoint(40, 0), &gray).move(1, middle + QPoint(40, 0), &gray);
        QTest::touchEvent(&gray, touch_).release(0, middle - QPoint(40, 0), &gray).release(1, middle + QPoint(40, 0), &gray);
        QVERIFY(std::abs(gray.viewPort()->zoom() / zoom - 2.0) < 0.05);
        QVERIFY(QLineF(gray.viewPort()->toCell(middle, gray.size()), cell).length() < 1.0);
    }

    void aTapPinsAndAFingerThatRestsAsks() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        CloudView& cloud = on.viewer.views.cloud();
        const QPoint at = pointOnCloud(cloud);
        QTest::touchEvent(&cloud, touch_).press(0, at, &cloud);
        QTest::touchEvent(&cloud, touch_).release(0, at, &cloud);
        QTRY_COMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));

        bool asked = false, low = false;
        const auto look = [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (menu == nullptr) return;
            asked = menu->objectName() == "cell-menu";
            for (QAction* entry : menu->actions()) low = low || (!entry->isSeparator() && menu->actionGeometry(entry).height() < kGlovePx);
            menu->close();
        };
        QTimer looks;
        connect(&looks, &QTimer::timeout, this, look);
        looks.start(20);
        QTest::touchEvent(&cloud, touch_).press(0, at, &cloud);
        QTRY_VERIFY(asked);
        QTest::touchEvent(&cloud, touch_).release(0, at, &cloud);
        QVERIFY(!low);
        // A finger on the legend switches what it is on.
        QCheckBox* edges = on.viewer.legend.findChild<QCheckBox*>("legend-edges");
        const QPoint onSwitch(10, edges->height() / 2);
        QTest::touchEvent(&on.window, touch_).press(0, onSwitch, edges);
        QTest::touchEvent(&on.window, touch_).release(0, onSwitch, edges);
        QTRY_VERIFY(!edges->isChecked());
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        edges->setChecked(true);
        const auto* scale = on.window.findChild<QWidget*>("scale-plate");
        QTRY_VERIFY(scale->isVisible());
        QTest::mouseClick(on.window.windowHandle(), Qt::LeftButton, Qt::NoModifier, scale->mapTo(&on.window, scale->rect().center()));
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        // The same with a screen that reports touches as a mouse.
        asked = false;
        QTest::mousePress(&cloud, Qt::LeftButton, Qt::NoModifier, at);
        QTRY_VERIFY(asked);
        QTest::mouseRelease(&cloud, Qt::LeftButton, Qt::NoModifier, at);
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1)); // opening the menu sets no target
    }

    void aTapSwapsCloudAndImage() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        CornerPicture& corner = on.window.cab().corner();
        QVERIFY(corner.isVisible() && corner.width() >= kGlovePx && !on.viewer.views.gray().isVisible());
        QTest::mouseClick(&corner, Qt::LeftButton);
        QTRY_VERIFY(on.viewer.views.gray().isVisible() && !on.viewer.views.cloud().isVisible());
        auto* back = on.window.findChild<CornerPicture*>("cab-back");
        QVERIFY(back->isVisible() && back->height() >= kGlovePx);
        // A second tap at the place of the button, on the button that came there or on the image, is of the same finger.
        const auto tap = [&](QPoint at) { QTest::mouseClick(on.window.windowHandle(), Qt::LeftButton, Qt::NoModifier, at); };
        QTRY_VERIFY(on.viewer.views.gray().width() > on.window.width() / 2); // laid out
        const QPoint onBack = back->mapTo(&on.window, back->rect().center());
        tap(onBack);
        QVERIFY(on.viewer.views.gray().isVisible());
        QTRY_VERIFY((tap(onBack), on.viewer.views.cloud().isVisible() && !on.viewer.views.gray().isVisible())); // later it is one
        tap(onBack);
        QVERIFY(on.viewer.views.cloud().isVisible() && on.viewer.targets.notebook().empty());
        QVERIFY(tapEntry(on.window, "cab-images", EdgesEntry));
        QTRY_VERIFY(on.viewer.views.edges().isVisible() && !on.viewer.views.cloud().isVisible());
        QVERIFY(tapEntry(on.window, "cab-images", RangeEntry));
        QTRY_VERIFY(on.viewer.views.gray().isVisible() && !on.viewer.views.edges().isVisible());
        // The scanner's view is a view of the cloud.
        press(on.window, "cab-zoom-in");
        QVERIFY(!on.viewer.gray.viewPort()->fitted());
        press(on.window, "cab-fit");
        QVERIFY(on.viewer.gray.viewPort()->fitted());
        press(on.window, "cab-scanner");
        QTRY_VERIFY(on.viewer.views.cloud().isVisible() && !on.viewer.views.gray().isVisible());
        QVERIFY(tapEntry(on.window, "cab-images", EdgesEntry));
        QTRY_VERIFY(on.viewer.views.edges().isVisible());
        on.window.cab().set(false); // cab mode can be left from there too
        QTRY_VERIFY(on.viewer.views.cloud().isVisible() && on.viewer.views.gray().isVisible());
        QVERIFY(!back->isVisible() && !corner.isVisible());
    }
};

int cab_test(int argc, char** argv) { return runWindowTest<CabTest>(argc, argv); }
#include "cab_test.moc"
