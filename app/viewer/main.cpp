// edgescan: the viewer.
#include "app/shared/exits.h"
#include "app/shared/usage.h"
#include "app/viewer/start.h"
#include "app/viewer/wanted.h"
#include "core/base/version.h"
#include "ui/base/language/languages.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/live/live_panel.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/gl_check.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"
#include "ui/window/view_choices.h"

#include <QApplication>
#include <QIcon>
#include <QProcess>
#include <QTimer>

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <vector>

namespace {

using namespace edgescan;
using namespace edgescan::viewer;

constexpr int kBetweenLooksMs = 200; // for a signal

/// Of the construction of QApplication, which ends the program with qFatal() where no window can be shown; what Qt says before that is
/// covered by the sentence.
void sayNoWindow(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type != QtFatalMsg) return;
    const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
    const bool isNamed = !platform.isEmpty() && platform != "xcb";
    cli::printError(isNamed ? Error{"no window can be shown on the platform \"" + platform.toStdString() + "\"", "QT_QPA_PLATFORM",
                                    "set it to xcb, or start edgescan without it"}
                            : Error{"there is no display to show a window on", "DISPLAY", "log in to a desktop, or use edgescan-cli"});
    std::_Exit(cli::kRefused);
}

// Opens the scans and files of the command line.
void openWanted(ui::MainWindow& window, ui::Preferences& preferences, const CommandLine& wanted, const ParsedCommandLine& understood) {
    if ((wanted.demo || !wanted.files.empty()) && wanted.screenshot.empty()) ui::offerTour(window, preferences);
    QStringList files;
    for (const std::string& file : wanted.files) files << ui::exactText(file);
    if (!wanted.session.empty())
        window.sessions().openSession(ui::exactText(wanted.session));
    else if (wanted.goOn)
        window.sessions().continueLast();
    else if (!files.isEmpty())
        window.sessions().open(files, cli::readingOptions(wanted.read));
    else if (wanted.demo)
        window.viewer().files.openDemo();
    else if (!understood.scanner) {
        window.sessions().offerToContinue();
        ui::showStart(window, preferences);
    }
    if (const auto& scanner = understood.scanner) {
        const std::string host = scanner->bridge ? "ws://" + scanner::addressText(scanner->host, scanner->port) : scanner->host;
        const ReadingOptions options = cli::readingOptions(wanted.read);
        window.viewer().live.panel().setKeepRepeated(options.keepRepeated);
        window.viewer().live.connectTo(QString::fromStdString(host), scanner->port, understood.sweep, options.topic, options.joint);
    }
}

int runViewer(const CommandLine& wanted, const ParsedCommandLine& understood) {
    ui::Preferences preferences(wanted.noSettings ? QString() : ui::Preferences::usualPath());
    ui::useLanguage(wanted.language.empty() ? preferences.text("language") : QString::fromStdString(wanted.language));
    cli::catchInterrupt();
    ui::MainWindow window(preferences);
    if (understood.settings) {
        if (const auto preset = cli::presetOf(wanted.method)) window.viewer().tuning.startWith(*preset, *understood.settings);
    }
    if (const auto refusal = preferences.refusal()) {
        cli::printError(*refusal);
        window.viewer().notice.showError(*refusal);
    }
    if (wanted.cab) window.cab().set(true);
    window.show();
    const Start start(window, wanted, understood);
    QTimer looks; // at Ctrl+C and a log-out
    QObject::connect(&looks, &QTimer::timeout, &window, [&window] {
        if (cli::interrupted()) window.end();
    });
    looks.start(kBetweenLooksMs);
    openWanted(window, preferences, wanted, understood);
    const int code = QApplication::exec();
    if (qApp->property(ui::kStartsAgain).isValid())
        qApp->setProperty(ui::kStartsAgain, window.viewer().engine.picture() != nullptr ? QStringList("--continue") : QStringList());
    return code;
}

} // namespace

int main(int argc, char** argv) {
    cli::setProgramName("edgescan");
    CommandLine wanted;
    cli::surviveFileLimit();
    CLI::App app{"EdgeScan: the edges of rocks in a laser range scan"};
    addFlags(app, wanted);
    // Must run before QApplication is constructed.
    QSurfaceFormat::setDefaultFormat(ui::CloudView::surfaceFormat());
    QApplication::setApplicationName("EdgeScan");
    QApplication::setApplicationVersion(version());
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough); // 1.5 is not enlarged to 2
#endif
    std::vector<char*> qtArguments{argv[0]};
    if (const auto other = commandOfOtherProgram(argc, argv)) {
        cli::printError(other->error);
        return other->code;
    }
    if (const auto ended = cli::parsed(app, argc, argv)) return *ended;
    ParsedCommandLine understood;
    if (const auto refusal = parse(wanted, understood)) {
        cli::printError(refusal->error);
        return refusal->code;
    }
    int qtArgc = 1;
    qInstallMessageHandler(&sayNoWindow);
    QApplication application(qtArgc, qtArguments.data());
    qInstallMessageHandler(nullptr);
    ui::useTheme(application);
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256, 512}) icon.addFile(QString(":/icons/edgescan-%1.png").arg(size));
    QApplication::setWindowIcon(icon);
    QGuiApplication::setDesktopFileName("edgescan"); // names the desktop entry from which the desktop takes the window's icon
    if (const ui::GlCheck gl = ui::checkGl(); !gl.available) {
        cli::printError(gl.reason.toStdString());
        return 1;
    }
    const int code = runViewer(wanted, understood);
    // With what was on the screen: the window has stored it.
    if (const QVariant again = application.property(ui::kStartsAgain); again.isValid())
        QProcess::startDetached(qEnvironmentVariable("APPIMAGE", QCoreApplication::applicationFilePath()), again.toStringList());
    return code;
}
