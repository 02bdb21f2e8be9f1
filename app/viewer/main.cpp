// edgescan: the viewer.
#include "app/shared/host_port.h"
#include "app/shared/options.h"
#include "core/base/version.h"
#include "ui/cloud/cloud_view.h"
#include "ui/cloud/gl_check.h"
#include "ui/main/main_window.h"
#include "ui/main/theme.h"
#include "ui/session/memory.h"

#include <QApplication>
#include <QIcon>
#include <QTimer>

#include <CLI/CLI.hpp>

#include <iostream>
#include <optional>

namespace {

using namespace edgescan;

struct Wanted {
    std::vector<std::string> files;
    cli::MethodFlags method;
    cli::ReadFlags read;
    bool demo = false;
    std::string live;
    int expectedLines = 0;
    std::optional<double> ticksPerDeg;
    bool noSettings = false;
    std::string screenshot;
    int screenshotLines = 1;
    double quitAfter = 0.0;
};

void addFlags(CLI::App& app, Wanted& wanted) {
    app.set_version_flag("--version", version());
    app.add_option("FILE", wanted.files, "Scans; the first is shown, Page Down goes to the next");
    app.add_flag("--demo", wanted.demo, "Open the demo draw-bell");
    app.add_option("--live", wanted.live, "Connect to a live scanner, HOST or HOST:PORT; nothing but reads and a subscription is sent");
    const char* sweep = "Live sweep (with --line-start, --line-step and --axis)";
    app.add_option("--expected-lines", wanted.expectedLines, "Lines of a whole sweep; 0 = not known")->capture_default_str()->group(sweep);
    app.add_option("--ticks-per-degree", wanted.ticksPerDeg, "Encoder counts per degree, where there is an encoder")->group(sweep);
    app.add_flag("--no-settings", wanted.noSettings, "Neither read nor write what the viewer remembers");
    app.add_option("--screenshot", wanted.screenshot, "Write the window to this PNG once the scan is on screen, and quit");
    app.add_option("--screenshot-lines", wanted.screenshotLines, "Only once so many lines are there")->capture_default_str();
    app.add_option("--quit-after", wanted.quitAfter, "Quit after so many seconds");
    cli::addMethodFlags(app, wanted.method);
    cli::addReadFlags(app, wanted.read);
}

SweepSettings sweepOf(const Wanted& wanted) {
    const ReadingOptions options = cli::readingOptions(wanted.read);
    SweepSettings sweep;
    sweep.expectedLines = wanted.expectedLines;
    sweep.ticksPerDeg = wanted.ticksPerDeg;
    if (options.lineStepDeg) sweep.degPerLine = options.lineStepDeg;
    if (options.lineStartDeg) sweep.firstLineDeg = *options.lineStartDeg;
    if (options.axis) sweep.axis = *options.axis;
    return sweep;
}

// Once the first picture is shown and the cloud has come to rest, or at once when the scan was refused.
void screenshotWhenShown(ui::MainWindow& window, const std::string& path, int lines) {
    constexpr int kRestMs = 700;
    const auto write = [&window, path] {
        const Result<Done> written = ui::savePng(window.screenshot(), QString::fromStdString(path));
        if (!written) std::cerr << "edgescan: " << written.error().sentence() << '\n';
        QApplication::exit(written ? 0 : 1);
    };
    QObject::connect(&window, &ui::MainWindow::pictureShown, &window, [&window, write, lines] {
        if (window.session().picture()->detection->scan->lines() >= lines) QTimer::singleShot(kRestMs, &window, write);
    });
    QObject::connect(&window.session(), &ui::Session::failed, &window, [](const QString& sentence) {
        std::cerr << "edgescan: " << sentence.toStdString() << '\n';
        QApplication::exit(1);
    });
}

int runViewer(QApplication& application, Wanted& wanted, const std::optional<Settings>& settings,
              const std::optional<cli::HostPort>& scanner) {
    ui::Memory memory(wanted.noSettings ? QString() : ui::Memory::usualPath());
    ui::MainWindow window(memory);
    if (settings) {
        if (const auto preset = cli::presetOf(wanted.method)) window.tuning().startWith(*preset, *settings);
    }
    window.show();
    if (!wanted.screenshot.empty()) screenshotWhenShown(window, wanted.screenshot, wanted.screenshotLines);
    if (wanted.quitAfter > 0) QTimer::singleShot(static_cast<int>(wanted.quitAfter * 1000), &application, &QApplication::quit);
    QStringList files;
    for (const std::string& file : wanted.files) files << QString::fromStdString(file);
    if (!files.isEmpty())
        window.files().open(files, cli::readingOptions(wanted.read));
    else if (wanted.demo)
        window.files().openDemo();
    if (scanner) window.live().connectTo(QString::fromStdString(scanner->host), scanner->port, sweepOf(wanted));
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
    Wanted wanted;
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
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    if (!wanted.screenshot.empty() && wanted.files.empty() && !wanted.demo && wanted.live.empty()) {
        std::cerr << "edgescan: --screenshot: there is no scan to show; give a file, --demo or --live.\n";
        return 2;
    }
    std::optional<cli::HostPort> scanner;
    if (!wanted.live.empty()) {
        const Result<cli::HostPort> typed = cli::hostPort(wanted.live);
        if (!typed) {
            std::cerr << "edgescan: " << typed.error().sentence() << '\n';
            return 2;
        }
        scanner = *typed;
    }
    std::optional<Settings> settings;
    if (cli::anyTyped(wanted.method)) {
        const Result<Settings> typed = cli::settingsOf(wanted.method);
        if (!typed) {
            std::cerr << "edgescan: " << typed.error().sentence() << '\n';
            return 2;
        }
        settings = *typed;
    }
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        std::cerr << "edgescan: there is no display to show a window on; log in to a desktop, or use edgescan-cli.\n";
        return 1;
    }
    int qtArgc = 1;
    QApplication application(qtArgc, qtArguments.data());
    ui::useTheme(application);
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) icon.addFile(QString(":/icons/edgescan-%1.png").arg(size));
    QApplication::setWindowIcon(icon);
    if (const ui::GlCheck gl = ui::checkGl(); !gl.available) {
        std::cerr << "edgescan: " << gl.reason.toStdString() << '\n';
        return 1;
    }
    return runViewer(application, wanted, settings, scanner);
}
