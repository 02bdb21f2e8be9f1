// Every mode of the window at every size and in the language with the longest words: no widget is cut off, squeezed or covered. With
// EDGESCAN_LOOK=FOLDER the pictures are saved for inspection.
#include "core/scanner/emulator/emulator.h"
#include "core/scanner/emulator/telegram.h"
#include "tests/support/folders.h"
#include "tests/support/placements.h"
#include "tests/ui/whole_widgets.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/files/calibrating.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/hold_button.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/window/cab_mode.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QPainter>
#include <QScreen>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <vector>

using namespace edgescan;
using namespace edgescan::ui;

class ModesTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bell_, after_;
    Scan live_;

    struct Mode {
        const char* name;
        std::function<bool(WindowFixture&)> enter, leave;
    };

    static bool pressed(WindowFixture& on, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&on.window, static_cast<Qt::Key>(key), modifiers);
        return on.settled();
    }
    static bool nothing(WindowFixture&) { return true; }
    static QDialog* dialogOf(WindowFixture& on) {
        for (auto* dialog : on.window.findChildren<QDialog*>()) {
            if (dialog->isVisible()) return dialog;
        }
        return nullptr;
    }
    static bool closeDialogs(WindowFixture& on) {
        while (QDialog* dialog = dialogOf(on)) dialog->reject();
        return on.activate();
    }
    static bool trigger(WindowFixture& on, const char* name) {
        auto* action = on.window.findChild<QAction*>(name);
        if (action == nullptr) return false;
        action->trigger();
        return on.settled();
    }

    static std::vector<Mode> modes(const std::string& after) {
        return {
            {"plain", nothing, nothing},
            {"pin",
             [](WindowFixture& on) {
                 on.viewer.views.pin(on.picture().detection->edges->at(on.picture().detection->edges->size() / 2));
                 return eventually([&] { return on.viewer.targets.settled(); }) && eventually([&] {
                            return on.viewer.targets.around(on.viewer.targets.active()->cell).confidence.state ==
                                   ShownConfidence::State::Known;
                        });
             },
             nothing},
            {"why", [](WindowFixture& on) { return pressed(on, Qt::Key_W) && eventually([&] { return dialogOf(on) != nullptr; }); },
             closeDialogs},
            {"confidence",
             [](WindowFixture& on) {
                 return pressed(on, Qt::Key_W, Qt::ShiftModifier) && eventually([&] { return on.viewer.confidence.made() != nullptr; });
             },
             [](WindowFixture& on) { return pressed(on, Qt::Key_W, Qt::ShiftModifier); }},
            {"rocks",
             [](WindowFixture& on) {
                 return pressed(on, Qt::Key_K) && eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); }) &&
                        (on.viewer.views.pinByClick(inspect::exactly(on.viewer.rocks.picture()->study.rocks.front().cell)), true) &&
                        eventually([&] { return on.viewer.targets.settled(); });
             },
             [](WindowFixture& on) { return pressed(on, Qt::Key_K); }},
            {"compare",
             [after](WindowFixture& on) {
                 return pressed(on, Qt::Key_A, Qt::ShiftModifier) && on.open(after) &&
                        eventually([&] { return on.viewer.comparing.settled() && on.viewer.comparing.comparison(); });
             },
             nothing},
        };
    }

    static QImage pictureOf(WindowFixture& on) {
        QImage picture = on.window.screenshot().convertToFormat(QImage::Format_RGB32);
        QPainter painter(&picture);
        if (QDialog* dialog = dialogOf(on))
            painter.drawPixmap(dialog->mapToGlobal(QPoint()) - on.window.mapToGlobal(QPoint()), dialog->grab());
        return picture;
    }
    /// The title of the cloud says how much of it is drawn. Waits only once for a cloud that never rests, and not at every size.
    static bool atRest(WindowFixture& on) {
        static bool ever = true;
        ever = ever && eventually([&] { return on.viewer.views.cloud().atRest(); });
        return ever;
    }
    /// Faults, each with the mode in which it was found.
    static QStringList look(WindowFixture& on, const QString& where) {
        QStringList found;
        if (!atRest(on)) return {where + ": the cloud is never at rest"};
        for (int n = 0; n < 5; ++n) QApplication::processEvents(); // layouts that still wait
        for (const QString& fault : faultsIn(on.window)) found << where + ": " + fault;
        if (const QDialog* dialog = dialogOf(on)) {
            for (const QString& fault : faultsIn(*dialog)) found << where + ", dialog: " + fault;
        }
        const QString folder = qEnvironmentVariable("EDGESCAN_LOOK");
        if (!folder.isEmpty()) pictureOf(on).save(folder + "/" + where + ".png");
        return found;
    }
    /// False if the window needs more room than that.
    static bool resizedTo(WindowFixture& on, QSize size) {
        on.window.resize(size);
        return eventually([&] { return on.window.size() == size.expandedTo(on.window.minimumSizeHint()); }) && on.window.size() == size;
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        sim::SimulationSettings settings;
        settings.seed = 101;
        settings.lines = 300;
        settings.beams = 343;
        bell_ = (folder_ / "bell.json").string();
        Scan scan = sim::simulate(settings)->scan;
        QVERIFY(bool(files::saveScan(scan, bell_)));
        settings.afterBlast = true;
        after_ = (folder_ / "after.json").string();
        sim::SimulationSettings ofScanner;
        ofScanner.lines = 120;
        ofScanner.beams = 381;
        live_ = sim::simulate(ofScanner)->scan;
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, after_)));
    }
    void cleanup() { useLanguage("en"); }

    void nothingIsCutInAnyMode_data() {
        QTest::addColumn<QString>("language");
        for (const char* code : {"en", "fr"}) QTest::newRow(code) << QString(code);
    }
    void nothingIsCutInAnyMode() {
        QFETCH(QString, language);
        QVERIFY(useLanguage(language, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bell_) && on.activate());
        on.viewer.notice.hide();
        QStringList faults;
        for (const Mode& mode : modes(after_)) {
            QVERIFY2(mode.enter(on), mode.name);
            for (const QSize size :
                 {QSize(853, 533), QSize(1280, 800), QSize(1366, 768), QSize(1600, 900), QSize(1920, 1080), QSize(2560, 1440)}) {
                if (!resizedTo(on, size)) { // on a high screen panels are one above the other and need its height
                    QVERIFY2(size.height() < 800, qPrintable(QString("%1: %2 x %3").arg(mode.name).arg(size.width()).arg(size.height())));
                    continue;
                }
                faults << look(on, QString("%1-%2x%3-%4").arg(language).arg(size.width()).arg(size.height()).arg(mode.name));
            }
            QVERIFY2(mode.leave(on), mode.name);
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

    // The pixels of the screen itself: no strip of the page stays unpainted during a resize.
    void theStartPageHasNoHoles() {
        WindowFixture on;
        QVERIFY(on.show());
        StartPage* page = showStart(on.window, on.preferences);
        QTRY_VERIFY(page->isVisible());
        for (const QSize size : {QSize(1280, 800), QSize(1600, 900), QSize(1366, 768), QSize(1900, 1000)}) {
            QVERIFY(resizedTo(on, size));
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

    // Live, recording, rocks, the end of a sweep, notices, work that can be cancelled, a recording that is played: in a cab nothing is
    // larger than the screen, and Locked, the only way out, is on it.
    void noStateOfACabIsLargerThanTheScreen_data() {
        QTest::addColumn<QString>("language");
        for (const Language& language : kLanguages) QTest::newRow(language.code) << QString(language.code);
    }
    void noStateOfACabIsLargerThanTheScreen() {
        QFETCH(QString, language);
        QVERIFY(useLanguage(language, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 150;
        auto telegrams = scanner::telegramsOf(live_);
        QVERIFY(bool(telegrams));
        const auto emulated =
            scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
        QVERIFY(bool(emulated));
        scanner::SweepSettings sweep;
        sweep.expectedLines = live_.lines();
        sweep.degPerLine = 180.0 / live_.lines();
        sweep.firstLineDeg = -90;
        sweep.axis = Axis::Sweep;
        WindowFixture on;
        Live& live = on.viewer.live;
        const QString folder = QString::fromStdString((folder_ / ("cab-" + language.toStdString())).string());
        live.setRecordingFolder(folder);
        QVERIFY(on.showWith(bell_) && on.activate());
        on.window.cab().set(true);
        const auto recorded = [&] { return QDir(folder).entryList({"sweep_*.mcap"}); };
        const std::vector<std::pair<const char*, std::function<bool()>>> states{
            {"connected",
             [&] {
                 live.connectTo("127.0.0.1", (*emulated)->port(), sweep);
                 return eventually([&] { return live.grows(); });
             }},
            {"recording",
             [&] {
                 live.record(true);
                 return eventually([&] { return !live.scanner().health().recording.empty(); });
             }},
            {"rocks",
             [&] {
                 on.viewer.rocks.setShown(true);
                 return eventually([&] { return on.viewer.rocks.picture() != nullptr; });
             }},
            {"held at the end", [&] { return eventually([&] { return !live.scanner().following() && on.viewer.notice.isVisible(); }); }},
            {"notices",
             [&] {
                 for (const char* text : {"one", "two"})
                     on.viewer.notice.showNotice(NoticeBar::Kind::Warning,
                                                 QString(text) + QString(" /a/long/path/without/blanks").repeated(9));
                 on.viewer.notice.offer(QObject::tr("Does this look right?"), [] {});
                 return true;
             }},
            {"target",
             [&] {
                 on.viewer.views.pin(on.picture().detection->edges->front());
                 return eventually([&] { return on.viewer.targets.settled(); });
             }},
            {"work",
             [&] {
                 on.window.cab().frame().head().showWork(QString("Opening a file of a long name: stage, 40 % ").repeated(4));
                 return true;
             }},
            {"another picture", [&] { return on.open(bell_); }},
            {"stopped",
             [&] {
                 live.scanner().disconnectScanner();
                 return eventually([&] { return !live.scanner().recording() && recorded().size() == 1; });
             }},
            {"played",
             [&] {
                 on.viewer.rocks.setShown(false);
                 return eventually([&] { return live.scanner().recordingClosed(); }) &&
                        on.open(QDir(folder).filePath(recorded().front()).toStdString()) &&
                        eventually([&] { return live.timeline().isVisible(); });
             }},
        };
        QStringList faults;
        for (const auto& [name, enter] : states) {
            QVERIFY2(enter(), name);
            for (const QSize size : {QSize(1280, 800), QSize(1024, 768), QSize(853, 533)}) {
                // What folds on the way makes room for a smaller window.
                const bool shrunk = eventually([&] {
                    on.window.resize(size);
                    QApplication::processEvents();
                    return on.window.size() == size.expandedTo(on.window.minimumSizeHint());
                });
                QVERIFY2(shrunk, name);
                for (int n = 0; n < 5; ++n) QApplication::processEvents(); // layouts that still wait
                const QString where = QString("%1, %2 at %3 x %4: ").arg(language, name).arg(size.width()).arg(size.height());
                if (on.window.size() != size) faults << where + QString("it is %1 x %2").arg(on.window.width()).arg(on.window.height());
                const QWidget& locked = *on.window.cab().frame().head().locked();
                if (!locked.isVisible() || !on.window.rect().contains(QRect(locked.mapTo(&on.window, QPoint()), locked.size())))
                    faults << where + "Locked is off the screen";
                QStringList cut = faultsIn(on.window);
                for (int n = 0; n < 20 && !cut.isEmpty(); ++n) { // a number of the scanner may just have changed
                    QApplication::processEvents();
                    cut = faultsIn(on.window);
                }
                for (const QString& fault : cut) faults << where + fault;
                const QString pictures = qEnvironmentVariable("EDGESCAN_LOOK");
                if (!pictures.isEmpty())
                    pictureOf(on).save(
                        QString("%1/cab-%2-%3-%4.png").arg(pictures, language, QString(name).replace(' ', '-')).arg(size.width()));
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

    void nothingIsCutInACab_data() { nothingIsCutInAnyMode_data(); }
    void nothingIsCutInACab() {
        QFETCH(QString, language);
        QVERIFY(useLanguage(language, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        WindowFixture on;
        QVERIFY(on.showWith(bell_) && on.activate());
        on.window.cab().set(true);
        on.viewer.views.pin(on.picture().detection->edges->front());
        QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
        QStringList faults;
        for (const QSize size : {QSize(853, 533), QSize(1280, 800), QSize(1920, 1080)}) {
            QVERIFY(resizedTo(on, size));
            // No empty row below the visible switches.
            int lowest = 0;
            for (const auto* box : on.viewer.legend.findChildren<QCheckBox*>())
                lowest = std::max(lowest, box->isVisible() ? box->geometry().bottom() : 0);
            QVERIFY2(on.viewer.legend.height() - lowest < 36, qPrintable(QString::number(on.viewer.legend.height() - lowest)));
            faults << look(on, QString("%1-%2x%3-cab").arg(language).arg(size.width()).arg(size.height()));
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }
};

int modes_test(int argc, char** argv) { return runWindowTest<ModesTest>(argc, argv); }

#include "modes_test.moc"
