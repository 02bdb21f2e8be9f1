// The window in its modes x sizes x languages x states of a scanner, on the desk and in a cab: no widget is cut off, squeezed or covered,
// nothing is larger than the screen, and the cloud has its share. Every pair of two of them is tested; with EDGESCAN_EVERY_STATE=1 the
// whole product. With EDGESCAN_LOOK=FOLDER the pictures are saved for inspection.
#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "tests/support/folders.h"
#include "tests/support/placements.h"
#include "tests/ui/sized_window.h"
#include "tests/ui/whole_widgets.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/elided_label.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QMenuBar>
#include <QPainter>
#include <QScreen>
#include <QtTest>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <vector>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

constexpr std::array kSizes{QSize(853, 533),  QSize(1024, 768),  QSize(1280, 800), QSize(1366, 768),
                            QSize(1600, 900), QSize(1920, 1080), QSize(2560, 1440)};
constexpr double kCloudShare = 0.22;   // of the width, on the desk
constexpr double kFreeInCab = 0.66;    // of the cloud's pixels
constexpr double kFreeUnderNote = 0.4; // of the height below the head of a cab: next to the strips of a scanner and of the legend

/// A window, a scanner that sends to it, and where the test is in the product.
struct Desk {
    std::string after; ///< a later scan of the same place
    QString recordings;
    scanner::SweepSettings sweep;
    std::unique_ptr<scanner::EmulatedScanner> emulated;
    WindowFixture on;
    bool cab = false;
};

struct State {
    const char* name;
    std::function<bool(Desk&)> enter;
    std::function<bool(Desk&)> leave = [](Desk&) { return true; };
};

bool stay(Desk&) { return true; }

bool pressed(Desk& desk, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&desk.on.window, static_cast<Qt::Key>(key), modifiers);
    return desk.on.settled();
}

QDialog* dialogOf(const QWidget& window) {
    for (auto* dialog : window.findChildren<QDialog*>()) {
        if (dialog->isVisible()) return dialog;
    }
    return nullptr;
}

bool pinEdge(Desk& desk) {
    WindowFixture& on = desk.on;
    on.viewer.views.pin(on.picture().detection->edges->at(on.picture().detection->edges->size() / 2));
    return eventually([&] { return on.viewer.targets.settled() && on.viewer.targets.active() != nullptr; });
}

bool showRocks(Desk& desk) {
    desk.on.viewer.rocks.setShown(true);
    return eventually([&] { return desk.on.viewer.rocks.picture() != nullptr; });
}

bool hideRocks(Desk& desk) {
    desk.on.viewer.rocks.setShown(false);
    return desk.on.settled();
}

bool showNotices(Desk& desk) {
    NoticeBar& notice = desk.on.viewer.notice;
    for (const char* text : {"one", "two"})
        notice.showNotice(NoticeBar::Kind::Warning, QString(text) + QString(" /a/long/path/without/blanks").repeated(9));
    notice.offer(QObject::tr("Does this look right?"), [] {});
    return true;
}

bool showWork(Desk& desk) {
    const QString title = "Opening a file of a long name", stage = "reading its lines and beams";
    desk.on.window.cab().frame().head().showWork(title + ": " + stage + ", 40 %");
    desk.on.viewer.statusLine.showWork(title, stage, 0.4);
    return desk.cab || eventually([&] { return desk.on.window.findChild<QWidget*>("cancel-work")->isVisible(); });
}

bool endWork(Desk& desk) {
    desk.on.window.cab().frame().head().showWork(QString());
    desk.on.viewer.statusLine.endWork();
    return true;
}

bool pressTune(Desk& desk) {
    QTest::mouseClick(desk.on.window.findChild<QToolButton*>("cab-tune"), Qt::LeftButton);
    return desk.on.settled();
}

/// In their order: each adds to what is on the screen.
std::vector<State> modes(bool cab, bool live) {
    std::vector<State> all{
        {"plain", stay},
        {"notices", showNotices,
         [](Desk& desk) {
             desk.on.viewer.notice.hide();
             return true;
         }},
        {"work", showWork, endWork},
        {"pin", pinEdge},
        {"rocks", showRocks, hideRocks},
    };
    if (cab) all.push_back({"tune", pressTune, pressTune});
    if (cab || live) return all;
    all.push_back({"why",
                   [](Desk& desk) {
                       return pinEdge(desk) && pressed(desk, Qt::Key_W) && eventually([&] { return dialogOf(desk.on.window) != nullptr; });
                   },
                   [](Desk& desk) {
                       while (QDialog* dialog = dialogOf(desk.on.window)) dialog->reject();
                       return desk.on.activate();
                   }});
    all.push_back({"confidence",
                   [](Desk& desk) {
                       return pressed(desk, Qt::Key_W, Qt::ShiftModifier) &&
                              eventually([&] { return desk.on.viewer.confidence.made() != nullptr; });
                   },
                   [](Desk& desk) { return pressed(desk, Qt::Key_W, Qt::ShiftModifier); }});
    all.push_back({"compare", [](Desk& desk) {
                       return pressed(desk, Qt::Key_A, Qt::ShiftModifier) && desk.on.open(desk.after) && eventually([&] {
                                  return desk.on.viewer.comparing.settled() && desk.on.viewer.comparing.comparison() != nullptr;
                              });
                   }});
    all.push_back({"images large", [](Desk& desk) { return pressed(desk, Qt::Key_M, Qt::ControlModifier); },
                   [](Desk& desk) { return pressed(desk, Qt::Key_M, Qt::ControlModifier); }});
    return all;
}

bool connectTo(Desk& desk) {
    desk.on.viewer.live.connectTo("127.0.0.1", desk.emulated->port(), desk.sweep);
    return eventually([&] { return desk.on.viewer.live.grows() && desk.on.picture().detection->edges->size() > 0; });
}

bool record(Desk& desk) {
    Live& live = desk.on.viewer.live;
    if (!connectTo(desk)) return false;
    live.record(true);
    return eventually([&] { return !live.scanner().health().recording.empty(); });
}

bool held(Desk& desk) {
    return record(desk) && eventually([&] { return !desk.on.viewer.live.scanner().following() && desk.on.viewer.notice.isVisible(); });
}

QStringList recorded(const Desk& desk) { return QDir(desk.recordings).entryList({"sweep_*.mcap"}); }

bool stopped(Desk& desk) {
    if (!held(desk)) return false;
    desk.on.viewer.live.scanner().disconnectScanner();
    return eventually([&] { return !desk.on.viewer.live.scanner().recording() && recorded(desk).size() == 1; });
}

struct LiveState {
    const char* name;
    double linesPerSecond; ///< of the scanner
    bool (*enter)(Desk&);
};
const std::vector<LiveState> kLive{
    {"growing", 4, connectTo},
    {"recording", 4, record},
    {"held", 300, held},
    {"another picture", 300, [](Desk& desk) { return record(desk) && desk.on.open(desk.after); }},
    {"stopped", 300, stopped},
    {"lost", 300,
     [](Desk& desk) {
         if (!connectTo(desk)) return false;
         desk.emulated.reset();
         return eventually([&] { return desk.on.viewer.live.scanner().health().liveness == files::Liveness::Lost; });
     }},
    {"played", 300,
     [](Desk& desk) {
         return stopped(desk) && eventually([&] { return desk.on.viewer.live.scanner().recordingClosed(); }) &&
                desk.on.open(QDir(desk.recordings).filePath(recorded(desk).front()).toStdString()) &&
                eventually([&] { return desk.on.viewer.live.timeline().isVisible(); });
     }},
};

QImage pictureOf(WindowFixture& on) {
    QImage picture = on.window.screenshot().convertToFormat(QImage::Format_RGB32);
    QPainter painter(&picture);
    if (QDialog* dialog = dialogOf(on.window))
        painter.drawPixmap(dialog->mapToGlobal(QPoint()) - on.window.mapToGlobal(QPoint()), dialog->grab());
    return picture;
}

/// The innermost widgets that demand more than half of a width.
QString demanding(const QWidget& window, int width) {
    QStringList names;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const int least = std::max(widget->minimumWidth(), widget->minimumSizeHint().width());
        const bool hidden = !widget->isVisible() || widget->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
        if (!hidden && least > width / 2 && widget->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly).isEmpty())
            names << QString("%1 %2 (%3)").arg(widget->metaObject()->className(), widget->objectName()).arg(least);
    }
    return names.join(", ");
}

/// What a finger presses, but for the fields inside of boxes; a swipe moves a scroll bar.
QStringList tooSmallForGloves(const MainWindow& window) {
    QStringList faults;
    for (const QWidget* each : window.findChildren<QWidget*>()) {
        const bool pressed = qobject_cast<const QAbstractButton*>(each) != nullptr || qobject_cast<const QComboBox*>(each) != nullptr ||
                             qobject_cast<const QAbstractSpinBox*>(each) != nullptr ||
                             qobject_cast<const QAbstractSlider*>(each) != nullptr;
        if (!pressed || !each->isVisible() || each->window() != &window || qobject_cast<const QScrollBar*>(each) != nullptr) continue;
        if (each->width() < kGlovePx || each->height() < kGlovePx)
            faults << QString("%1 \"%2\" is %3 x %4")
                          .arg(each->metaObject()->className(), each->objectName())
                          .arg(each->width())
                          .arg(each->height());
    }
    return faults;
}

QStringList faultsNow(Desk& desk, QSize size) {
    MainWindow& window = desk.on.window;
    QStringList faults;
    if (window.size() != size)
        faults << QString("it is %1 x %2; %3").arg(window.width()).arg(window.height()).arg(demanding(window, size.width()));
    if (desk.cab) {
        faults << tooSmallForGloves(window);
        if (window.menuBar()->isVisible()) faults << "the menu bar is there";
        const QWidget& leave = *window.cab().frame().head().leave();
        if (!leave.isVisible() || !window.rect().contains(QRect(leave.mapTo(&window, QPoint()), leave.size())))
            faults << "Hold to leave is off the screen";
    } else if (const int wide = desk.on.viewer.cloud.width();
               window.places().share() != Share::Images && wide < kCloudShare * window.width() - 1) {
        faults << QString("the cloud is %1 wide").arg(wide);
    }
    // No empty row below the visible switches.
    int lowest = 0;
    for (const auto* box : desk.on.viewer.legend.findChildren<QCheckBox*>())
        lowest = std::max(lowest, box->isVisible() ? box->geometry().bottom() : 0);
    if (desk.cab && lowest > 0 && desk.on.viewer.legend.height() - lowest >= 36) faults << "the legend has an empty row";
    faults << faultsIn(window);
    const auto* corner = window.findChild<QWidget*>("cab-corner");
    const auto* overlay = desk.on.viewer.cloud.findChild<CloudOverlay*>();
    if (desk.cab && corner->isVisible() && overlay->warning().intersects(corner->geometry()))
        faults << "the small picture covers a warning";
    if (const QDialog* dialog = dialogOf(window)) {
        for (const QString& fault : faultsIn(*dialog)) faults << "dialog: " + fault;
    }
    return faults;
}

/// The part of the cloud that no plate, text or tag covers.
double freeShareOf(const CloudView& cloud) {
    const auto* overlay = cloud.findChild<CloudOverlay*>();
    QRegion covered;
    for (const auto* each : cloud.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (each != overlay && each->isVisible()) covered += each->geometry();
    }
    covered += overlay->label();
    for (const QRectF& tag : overlay->tags()) covered += tag.toAlignedRect();
    double pixels = 0.0;
    for (const QRect& part : covered& cloud.rect()) pixels += static_cast<double>(part.width()) * part.height();
    return 1.0 - pixels / (static_cast<double>(cloud.width()) * cloud.height());
}

/// Faults, each with the state in which it was found.
QStringList faultsAt(Desk& desk, QSize size, const QString& where) {
    MainWindow& window = desk.on.window;
    QStringList faults{"not looked at"};
    // What folds on the way makes room for a smaller window, layouts wait, and a number of the scanner may just have changed.
    for (int n = 0; n < 40 && !faults.isEmpty(); ++n) {
        window.resize(size);
        for (int events = 0; events < 5; ++events) QApplication::processEvents();
        faults = faultsNow(desk, size);
    }
    const QString folder = qEnvironmentVariable("EDGESCAN_LOOK");
    if (!folder.isEmpty()) pictureOf(desk.on).save(folder + "/" + QString(where).replace(' ', '-') + ".png");
    for (QString& fault : faults) fault = where + ": " + fault;
    return faults;
}

} // namespace

class ModesTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bell_, after_;
    Scan live_;

    [[nodiscard]] std::unique_ptr<Desk> deskOf(const QString& row, double linesPerSecond) {
        auto desk = std::make_unique<Desk>();
        desk->after = after_;
        desk->recordings = QString::fromStdString((folder_ / row.toStdString()).string());
        desk->sweep.expectedLines = live_.lines();
        desk->sweep.degPerLine = 180.0 / live_.lines();
        desk->sweep.firstLineDeg = -90;
        desk->sweep.axis = Axis::Sweep;
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = linesPerSecond;
        auto telegrams = scanner::telegramsOf(live_);
        if (!telegrams) return nullptr;
        auto emulated =
            scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
        if (!emulated) return nullptr;
        desk->emulated = std::move(*emulated);
        desk->on.viewer.live.setRecordingFolder(desk->recordings);
        return desk;
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        sim::SimulationSettings settings;
        settings.seed = 101;
        settings.lines = 150;
        settings.beams = 172;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, bell_)));
        settings.afterBlast = true;
        after_ = (folder_ / "after.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, after_)));
        sim::SimulationSettings ofScanner;
        ofScanner.lines = 120;
        ofScanner.beams = 381;
        live_ = sim::simulate(ofScanner)->scan;
    }
    void cleanup() {
        useLanguage("en");
        useTheme(*qApp, false); // a cab leaves its large widgets
    }

    void everythingFits_data() {
        QTest::addColumn<int>("language");
        QTest::addColumn<bool>("cab");
        QTest::addColumn<int>("live"); // -1: no scanner
        const bool every = qEnvironmentVariableIsSet("EDGESCAN_EVERY_STATE");
        const int languages = static_cast<int>(std::size(kLanguages));
        for (int language = 0; language < languages; ++language) {
            for (const bool cab : {false, true}) {
                for (int live = -1; live < static_cast<int>(kLive.size()); ++live) {
                    if (!every && live >= 0 && (live + 2 * (cab ? 1 : 0)) % languages != language) continue;
                    const QString name = QString("%1-%2-%3")
                                             .arg(kLanguages[language].code, cab ? "cab" : "desk",
                                                  live < 0 ? "file" : kLive[static_cast<std::size_t>(live)].name);
                    QTest::newRow(qPrintable(QString(name).replace(' ', '-'))) << language << cab << live;
                }
            }
        }
    }
    void everythingFits() {
        QFETCH(int, language);
        QFETCH(bool, cab);
        QFETCH(int, live);
        QVERIFY(useLanguage(kLanguages[language].code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        const QString row = QTest::currentDataTag();
        const LiveState* state = live < 0 ? nullptr : &kLive[static_cast<std::size_t>(live)];
        const auto desk = deskOf(row, state == nullptr ? 0.0 : state->linesPerSecond);
        QVERIFY(desk != nullptr);
        desk->on.window.resize(1280, 800);
        QVERIFY(desk->on.showWith(bell_) && desk->on.activate());
        desk->on.viewer.notice.hide();
        desk->cab = cab;
        desk->on.window.cab().set(cab);
        QVERIFY(state == nullptr || state->enter(*desk));
        QStringList faults;
        int number = 0;
        for (const State& mode : modes(cab, state != nullptr)) {
            QVERIFY2(mode.enter(*desk), mode.name);
            for (std::size_t n = 0; n < kSizes.size(); ++n) {
                // The languages share the sizes of a mode.
                const bool here = qEnvironmentVariableIsSet("EDGESCAN_EVERY_STATE") ||
                                  (static_cast<int>(n) + language + number) % static_cast<int>(std::size(kLanguages)) == 0;
                const QString where = QString("%1-%2-%3x%4").arg(row, mode.name).arg(kSizes[n].width()).arg(kSizes[n].height());
                if (here) faults << faultsAt(*desk, kSizes[n], where);
            }
            QVERIFY2(mode.leave(*desk), mode.name);
            ++number;
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

    // In a cab texts, tags, plates, legend and the picture in the corner leave most of the cloud free, live too.
    void theCloudIsReadableInACab_data() {
        QTest::addColumn<int>("language");
        QTest::addColumn<bool>("live");
        for (int language = 0; language < static_cast<int>(std::size(kLanguages)); ++language) {
            for (const bool live : {false, true}) {
                if (live != (language % 2 == 1) && !qEnvironmentVariableIsSet("EDGESCAN_EVERY_STATE")) continue;
                QTest::newRow(qPrintable(QString("%1-%2").arg(kLanguages[language].code, live ? "live" : "file"))) << language << live;
            }
        }
    }
    void theCloudIsReadableInACab() {
        QFETCH(int, language);
        QFETCH(bool, live);
        QVERIFY(useLanguage(kLanguages[language].code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        const auto desk = deskOf(QString("readable-") + QTest::currentDataTag(), 40);
        QVERIFY(desk != nullptr);
        WindowFixture& on = desk->on;
        QVERIFY(on.showWith(bell_) && on.activate());
        desk->cab = true;
        on.window.cab().set(true);
        QVERIFY(!live || connectTo(*desk));
        QStringList crowded;
        for (const bool rocks : {false, true}) {
            QVERIFY(rocks ? showRocks(*desk) : hideRocks(*desk));
            for (const bool pin : {false, true}) {
                if (pin) {
                    QVERIFY(pinEdge(*desk));
                } else {
                    on.viewer.views.clearPin();
                }
                for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
                    on.window.resize(size);
                    CloudView& cloud = on.viewer.cloud;
                    const QString where =
                        QString("%1%2 at %3").arg(rocks ? "rocks" : "edges", pin ? " and a target" : "").arg(size.width());
                    double free = 0.0;
                    for (int n = 0; n < 40 && (n < 5 || free < kFreeInCab); ++n) { // what folds waits for a frame
                        QVERIFY(eventually([&] { return on.window.size() == size; }));
                        on.viewer.notice.hide(); // the end of a sweep may have one
                        (void)cloud.grabFrame(CloudView::Points::All);
                        cloud.findChild<CloudOverlay*>()->repaint();
                        QApplication::processEvents();
                        free = freeShareOf(cloud);
                    }
                    if (free < kFreeInCab) crowded << QString("%1: %2").arg(where).arg(free, 0, 'f', 3);
                    if (qEnvironmentVariableIsSet("EDGESCAN_LOOK")) {
                        qInfo("free: %s %.3f", qPrintable(where), free);
                        const QString name =
                            QString("%1/readable-%2-%3.png").arg(qEnvironmentVariable("EDGESCAN_LOOK"), QTest::currentDataTag(), where);
                        pictureOf(on).save(name.simplified().replace(' ', '-'));
                    }
                }
            }
        }
        QVERIFY2(crowded.isEmpty(), qPrintable(crowded.join('\n')));
    }

    // Live on a low screen: the strip and a note leave the cloud most of the height of the views, and each badge has its whole words.
    void aNoteLeavesMostOfALowCloud_data() {
        QTest::addColumn<int>("language");
        QTest::addColumn<int>("live");
        for (int language = 0; language < static_cast<int>(std::size(kLanguages)); ++language) {
            for (int live = 0; live < static_cast<int>(kLive.size()); ++live) {
                const bool ofLanguage = live == 2 || live == language + 2; // 2: held, with the longest note
                if (language > 0 && !ofLanguage && !qEnvironmentVariableIsSet("EDGESCAN_EVERY_STATE")) continue;
                QTest::newRow(qPrintable(QString("%1-%2").arg(kLanguages[language].code, kLive[static_cast<std::size_t>(live)].name)))
                    << language << live;
            }
        }
    }
    void aNoteLeavesMostOfALowCloud() {
        QFETCH(int, language);
        QFETCH(int, live);
        QVERIFY(useLanguage(kLanguages[language].code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        const LiveState& state = kLive[static_cast<std::size_t>(live)];
        const auto desk = deskOf(QString("low-") + QTest::currentDataTag(), state.linesPerSecond);
        QVERIFY(desk != nullptr);
        WindowFixture& on = desk->on;
        QVERIFY(on.showWith(bell_) && on.activate());
        on.window.cab().set(true);
        QVERIFY(state.enter(*desk));
        resizeTo(on.window, {853, 480});
        on.viewer.livePanel.findChild<QTimer*>("live-empty-row")->setInterval(1);
        const NoticeBar& notice = on.viewer.notice;
        if (state.enter == held) { // what the operator can do is read without a tap
            const auto* line = static_cast<const ElidedLabel*>(notice.findChild<QLabel*>("notice-line"));
            QTRY_VERIFY2(line->shown().startsWith(Live::tr("Held. Follow shows the next ones, until Hold.")), qPrintable(line->shown()));
        }
        const auto placeOf = [&](const QWidget& each) { return QRect(each.mapTo(&on.window, QPoint()), each.size()); };
        for (const bool action : {false, true}) {
            on.viewer.notice.showNotice(NoticeBar::Kind::Warning, QString("A note of several words, which has two lines. ").repeated(2));
            if (action) on.viewer.notice.offer(QObject::tr("Does this look right?"), [] {});
            const int views = on.window.cab().frame().height() - on.window.cab().frame().head().height();
            int free = 0;
            const auto isFree = [&] {
                free = placeOf(on.viewer.cloud).bottom() - placeOf(notice).bottom();
                return notice.isVisible() && free >= kFreeUnderNote * views;
            };
            QApplication::processEvents();
            const bool fits = eventually(isFree);
            if (qEnvironmentVariableIsSet("EDGESCAN_LOOK"))
                pictureOf(on).save(QString("%1/low-%2-%3.png")
                                       .arg(qEnvironmentVariable("EDGESCAN_LOOK"), QString(QTest::currentDataTag()).replace(' ', '-'))
                                       .arg(action));
            QVERIFY2(fits, qPrintable(QString("%1 of %2, button %3").arg(free).arg(views).arg(action)));
            const QString badge = on.window.findChild<StateBadge*>("cab-origin")->lines().join(' ');
            QVERIFY2(!badge.contains(QChar(0x2026)), qPrintable(badge));
            const auto* close = notice.findChild<QToolButton*>("notice-close");
            const auto buttons = notice.findChildren<QToolButton*>();
            QVERIFY2(
                notice.height() < 2 * close->height() ||
                    std::ranges::any_of(buttons, [&](auto* each) { return each != close && each->isVisible() && each->y() == close->y(); }),
                "Close is alone");
        }
    }

    // The pixels of the screen itself: no strip of the page stays unpainted during a resize.
    void theStartPageHasNoHoles() {
        WindowFixture on;
        QVERIFY(on.show());
        StartPage* page = showStart(on.window, on.preferences);
        QTRY_VERIFY(page->isVisible());
        for (const QSize size : {QSize(1280, 800), QSize(1600, 900), QSize(1366, 768), QSize(1900, 1000)}) {
            on.window.resize(size);
            QTRY_COMPARE(on.window.size(), size);
            const QPoint corner = page->mapToGlobal(QPoint());
            int worst = 0;
            const auto painted = [&] {
                const QImage seen = on.window.screen()->grabWindow(0, corner.x(), corner.y(), page->width(), page->height()).toImage();
                worst = 0;
                for (int x = 0; x < seen.width(); ++x) {
                    int black = 0;
                    for (int y = 0; y < seen.height(); ++y) black += (seen.pixel(x, y) & RGB_MASK) == 0 ? 1 : 0;
                    worst = std::max(worst, black);
                }
                return worst < 20;
            };
            QTRY_VERIFY2(painted(), qPrintable(QString("%1 black pixels in a column at %2").arg(worst).arg(size.width())));
        }
    }
};

int modes_test(int argc, char** argv) { return runWindowTest<ModesTest>(argc, argv); }

#include "modes_test.moc"
