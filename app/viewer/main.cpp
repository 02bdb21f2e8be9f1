// edgescan: the viewer.
#include "app/shared/host_port.h"
#include "app/shared/interrupt.h"
#include "app/shared/mounting.h"
#include "app/shared/options.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/base/number_text.h"
#include "core/base/version.h"
#include "ui/cloud/cloud_view.h"
#include "ui/cloud/gl_check.h"
#include "ui/language/languages.h"
#include "ui/main/cab_mode.h"
#include "ui/main/main_window.h"
#include "ui/main/start.h"
#include "ui/main/theme.h"
#include "ui/session/memory.h"
#include "ui/sitting/sittings.h"

#include <QApplication>
#include <QIcon>
#include <QTimer>

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>

namespace {

using namespace edgescan;

struct Wanted {
    std::vector<std::string> files;
    cli::MethodFlags method;
    cli::ReadFlags read;
    bool demo = false;
    bool cab = false;
    std::string live;
    cli::Mounting mounting;
    bool noSettings = false;
    std::string language;
    std::vector<std::string> pins; // "LINE,BEAM"
    std::string compare;
    std::string session;
    bool goOn = false;
    std::string screenshot;
    int screenshotLines = 1;
    double quitAfter = 0.0;
};

void addFlags(CLI::App& app, Wanted& wanted) {
    app.set_version_flag("--version", version());
    app.add_option("FILE", wanted.files, "Scans; the first is shown, Page Down goes to the next");
    app.add_flag("--demo", wanted.demo, "Open the demo draw-bell");
    app.add_option("--live", wanted.live, "Connect to a live scanner, HOST or HOST:PORT; nothing but reads and a subscription is sent");
    cli::addMountingFlags(app, wanted.mounting, "Live sweep (with --line-start, --line-step, --axis and --calibration)");
    app.add_flag("--no-settings", wanted.noSettings, "Neither read nor write what the viewer remembers");
    std::vector<std::string> languages;
    for (const ui::Language& language : ui::kLanguages) languages.emplace_back(language.code);
    app.add_option("--language", wanted.language, "Language of the window; else the one chosen in it, or that of the system")
        ->check(CLI::IsMember(languages));
    app.add_flag("--cab", wanted.cab, "Start in cab mode: large tools and numbers, for gloves; hold Locked to leave it");
    app.add_option("--pin", wanted.pins, "Pin this cell of the first scan, LINE,BEAM; may be given several times")->take_all();
    app.add_option("--compare", wanted.compare, "Compare the first scan with this earlier one");
    app.add_option("--session", wanted.session, "Open this session, or the picture of the window that carries one");
    app.add_flag("--continue", wanted.goOn, "Go on where the viewer was, after a crash too");
    app.add_option("--screenshot", wanted.screenshot, "Write the window to this PNG once the scan is on screen, and quit");
    cli::addNumber(app, "--screenshot-lines", wanted.screenshotLines, {1, 1e6}, "Only once so many lines are there");
    cli::addNumber(app, "--quit-after", wanted.quitAfter, {0, 1e6}, "Quit after so many seconds");
    cli::addMethodFlags(app, wanted.method);
    cli::addReadFlags(app, wanted.read);
    cli::addPages(app, {"edgescan", "shows the edges of rocks in a laser scan", {"edgescan --demo"}});
}

Result<SweepSettings> sweepOf(const Wanted& wanted) {
    const ReadingOptions options = cli::readingOptions(wanted.read);
    cli::Mounting mounting = wanted.mounting;
    mounting.axis = options.axis;
    mounting.lineStepDeg = options.lineStepDeg;
    mounting.firstLineDeg = options.lineStartDeg;
    mounting.calibration = options.calibration;
    return cli::sweepOf(mounting);
}

struct PinnedPlace {
    int line = 0, beam = 0;
};
Result<std::vector<PinnedPlace>> pinsOf(const std::vector<std::string>& typed) {
    std::vector<PinnedPlace> places;
    for (const std::string& text : typed) {
        const std::size_t comma = text.find(',');
        const double line = numberOf(text.substr(0, comma)).value_or(-1.0);
        const double beam = comma == std::string::npos ? -1.0 : numberOf(text.substr(comma + 1)).value_or(-1.0);
        const auto isIndex = [](double n) { return n >= 0 && n < 1e9 && n == static_cast<int>(n); };
        if (!isIndex(line) || !isIndex(beam)) return Error{"\"" + text + "\" is no cell", "--pin", "give LINE,BEAM such as 525,593"};
        places.push_back({static_cast<int>(line), static_cast<int>(beam)});
    }
    return places;
}

// On the first picture; the last one has the card.
void pinWhenShown(ui::MainWindow& window, const std::vector<PinnedPlace>& places) {
    auto once = std::make_shared<QMetaObject::Connection>();
    *once = QObject::connect(&window, &ui::MainWindow::pictureShown, &window, [&window, places, once] {
        QObject::disconnect(*once);
        for (const PinnedPlace& place : places) {
            const Scan& scan = *window.session().picture()->detection->scan;
            if (scan.rangeMm.contains(place.line, place.beam))
                window.views().pin(window.views().cellAt(place.line, place.beam));
            else
                cli::complain(
                    Error{"the scan has no line " + std::to_string(place.line) + ", beam " + std::to_string(place.beam), "--pin",
                          "give a cell of its " + std::to_string(scan.lines()) + " lines and " + std::to_string(scan.beams()) + " beams"});
        }
    });
}

void compareWhenShown(ui::MainWindow& window, const QString& before) {
    auto once = std::make_shared<QMetaObject::Connection>();
    *once = QObject::connect(&window, &ui::MainWindow::pictureShown, &window, [&window, before, once] {
        QObject::disconnect(*once);
        window.comparing().compareWith(before);
    });
}

// Once the first picture is shown and the cloud has come to rest, or at once when the scan was refused.
void screenshotWhenShown(ui::MainWindow& window, const std::string& path, int lines, bool live) {
    constexpr int kRestMs = 700;
    const auto write = [&window, path] {
        while (!window.comparing().settled()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        const Result<Done> written = window.exports().saveScreenshot(window.screenshot(), QString::fromStdString(path));
        if (!written) cli::complain(written.error());
        QApplication::exit(written ? 0 : 1);
    };
    QObject::connect(&window, &ui::MainWindow::pictureShown, &window, [&window, write, lines, live, path] {
        const int shown = window.session().picture()->detection->scan->lines();
        if (shown >= lines) {
            QTimer::singleShot(kRestMs, &window, write);
        } else if (!live) { // it will have no more
            cli::complain(
                Error{"no picture was written: the scan has " + std::to_string(shown) + " lines", path, "give --screenshot-lines fewer"});
            QApplication::exit(1);
        }
    });
    QObject::connect(&window.session(), &ui::Session::failed, &window, [](const QString& sentence) {
        cli::complain(sentence.toStdString());
        QApplication::exit(1);
    });
}

// As asked with --quit-after; a screenshot that was asked for too is not there, or the window would be gone already.
void quitInTime(const std::string& screenshot) {
    if (!screenshot.empty())
        cli::complain(Error{"no picture was written: the scan was not on screen in time", screenshot, "give --quit-after more seconds"});
    QApplication::exit(screenshot.empty() ? 0 : 1);
}

// Qt holds names as Unicode: of any other bytes it would ask the system for another file.
std::optional<Error> nameThatIsNone(const Wanted& wanted) {
    std::vector<std::string> names = wanted.files;
    names.push_back(wanted.screenshot);
    names.push_back(wanted.compare);
    names.push_back(wanted.session);
    names.push_back(wanted.read.options.pose);
    names.push_back(wanted.read.options.calibration);
    for (const std::string& name : names) {
        if (QString::fromStdString(name).toStdString() != name)
            return Error{"the window cannot open a name that is no UTF-8", name, "rename the file, or use edgescan-cli"};
    }
    return std::nullopt;
}

int runViewer(QApplication& application, Wanted& wanted, const std::vector<PinnedPlace>& pins, const std::optional<Settings>& settings,
              const std::optional<cli::HostPort>& scanner, const SweepSettings& sweep) {
    ui::Memory memory(wanted.noSettings ? QString() : ui::Memory::usualPath());
    ui::useLanguage(wanted.language.empty() ? memory.text("language") : QString::fromStdString(wanted.language));
    ui::MainWindow window(memory);
    if (settings) {
        if (const auto preset = cli::presetOf(wanted.method)) window.tuning().startWith(*preset, *settings);
    }
    if (wanted.cab) window.cab().set(true);
    window.show();
    if (!pins.empty()) pinWhenShown(window, pins);
    if (!wanted.compare.empty()) compareWhenShown(window, QString::fromStdString(wanted.compare));
    if (!wanted.screenshot.empty()) screenshotWhenShown(window, wanted.screenshot, wanted.screenshotLines, !wanted.live.empty());
    if (wanted.quitAfter > 0)
        QTimer::singleShot(static_cast<int>(wanted.quitAfter * 1000), &application, [&wanted] { quitInTime(wanted.screenshot); });
    QStringList files;
    for (const std::string& file : wanted.files) files << QString::fromStdString(file);
    if (!wanted.session.empty())
        window.sittings().openSession(QString::fromStdString(wanted.session));
    else if (wanted.goOn)
        window.sittings().goOn();
    else if (!files.isEmpty())
        window.sittings().open(files, cli::readingOptions(wanted.read));
    else if (wanted.demo)
        window.files().openDemo();
    else if (!scanner) {
        window.sittings().offerToGoOn();
        ui::showStart(window, memory);
    }
    if (scanner) window.live().connectTo(QString::fromStdString(scanner->host), scanner->port, sweep);
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
    Wanted wanted;
    cli::surviveFileLimit();
    CLI::App app{"EdgeScan: the edges of rocks in a laser range scan"};
    addFlags(app, wanted);
    // Before QApplication is made.
    QSurfaceFormat::setDefaultFormat(ui::CloudView::surfaceFormat());
    QApplication::setApplicationName("EdgeScan");
    QApplication::setApplicationVersion(version());
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
    std::vector<char*> qtArguments{argv[0]};
    cli::setProgramName("edgescan");
    if (const auto ended = cli::parsed(app, argc, argv)) return *ended;
    if (const auto none = nameThatIsNone(wanted)) {
        cli::complain(*none);
        return 1;
    }
    if (!wanted.screenshot.empty() && wanted.files.empty() && !wanted.demo && wanted.live.empty() && wanted.session.empty() &&
        !wanted.goOn) {
        cli::complain(Error{"there is no scan to show", "--screenshot", "give a file, --demo or --live"});
        return 2;
    }
    if (wanted.demo && !wanted.files.empty()) {
        cli::complain(Error{"the demo is a scan of its own and takes no file or folder", wanted.files.front(),
                            "leave out --demo to open it, or the name to open the demo"});
        return 2;
    }
    std::optional<cli::HostPort> scanner;
    SweepSettings sweep;
    if (!wanted.live.empty()) {
        const Result<cli::HostPort> typed = cli::hostPort(wanted.live);
        if (!typed) {
            cli::complain(typed.error());
            return 2;
        }
        scanner = *typed;
        const Result<SweepSettings> said = sweepOf(wanted);
        if (!said) {
            cli::complain(said.error());
            return 1;
        }
        sweep = *said;
    }
    const auto pins = pinsOf(wanted.pins);
    if (!pins) {
        cli::complain(pins.error());
        return 2;
    }
    std::optional<Settings> settings;
    if (cli::anyTyped(wanted.method)) {
        const Result<Settings> typed = cli::settingsOf(wanted.method);
        if (!typed) {
            cli::complain(typed.error());
            return 2;
        }
        settings = *typed;
    }
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        cli::complain("there is no display to show a window on; log in to a desktop, or use edgescan-cli.");
        return 1;
    }
    int qtArgc = 1;
    QApplication application(qtArgc, qtArguments.data());
    ui::useTheme(application);
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256, 512}) icon.addFile(QString(":/icons/edgescan-%1.png").arg(size));
    QApplication::setWindowIcon(icon);
    QGuiApplication::setDesktopFileName("edgescan"); // where windows get their icon from the desktop entry
    if (const ui::GlCheck gl = ui::checkGl(); !gl.available) {
        cli::complain(gl.reason.toStdString());
        return 1;
    }
    return runViewer(application, wanted, *pins, settings, scanner, sweep);
}
