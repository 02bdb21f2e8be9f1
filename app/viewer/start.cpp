// Looks at the window until everything that was asked for is shown.
#include "app/viewer/start.h"

#include "app/shared/exits.h"
#include "app/shared/outputs.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/window/main_window.h"

#include <QApplication>

namespace edgescan::viewer {
namespace {

constexpr int kLookMs = 50;
constexpr int kRestMs = 700;        // the cloud is still then
constexpr int kPatienceMs = 60'000; // without any change, where --quit-after names no time

/// Also before the event loop has started.
void end(int code) {
    QTimer::singleShot(0, QApplication::instance(), [code] { QApplication::exit(code); });
}

} // namespace

Start::Start(ui::MainWindow& window, const CommandLine& wanted, const ParsedCommandLine& understood)
    : window_(window), wanted_(wanted), understood_(understood),
      asked_(!wanted.files.empty() || wanted.demo || wanted.goOn || !wanted.session.empty() || understood.scanner) {
    const ui::Viewer& viewer = window.viewer();
    const auto refused = [this](const QString& sentence) { refuse(sentence.toStdString()); };
    connect(&viewer.engine, &ui::Engine::failed, this, refused);
    connect(&viewer.comparing, &ui::Comparing::refused, this, refused);
    connect(&window.sessions(), &ui::Sessions::refused, this, refused);
    connect(&viewer.engine, &ui::Engine::workProgressed, this,
            [this](const QString& stage, double fraction) { progress_ = stage.toStdString() + std::to_string(fraction); });
    connect(&window, &ui::MainWindow::pictureShown, this, [this] {
        if (std::exchange(first_, false)) pinAndCompare();
        if (const auto status = window_.viewer().live.scanner().status(); understood_.scanner && understood_.scanner->bridge && status)
            warnOfIdle(*status);
    });
    connect(&look_, &QTimer::timeout, this, &Start::look);
    if (asked_) look_.start(kLookMs);
    still_.start();
    if (wanted.quitAfter > 0) QTimer::singleShot(static_cast<int>(wanted.quitAfter * 1000), this, &Start::quit);
}

void Start::warnOfIdle(const files::LiveStatus& status) {
    if (status.lines == 0 || std::exchange(warned_, true)) return;
    for (const std::string& sentence : cli::idleMounting(understood_.mounting, wanted_.read.options.joint, status))
        cli::printError(sentence);
}

void Start::pinAndCompare() {
    for (const cli::TypedCell& place : understood_.pins) {
        const Scan& scan = *window_.viewer().engine.picture()->detection->scan;
        if (scan.rangeMm.contains(place.line, place.beam))
            window_.viewer().views.pin(window_.viewer().views.cellAt(place.line, place.beam));
        else
            refuse(Error{"the scan has no line " + std::to_string(place.line) + ", beam " + std::to_string(place.beam), "--pin",
                         "give a cell of its " + std::to_string(scan.lines()) + " lines and " + std::to_string(scan.beams()) + " beams"}
                       .sentence());
    }
    if (!wanted_.compare.empty()) window_.viewer().comparing.compareWith(ui::exactText(wanted_.compare));
}

void Start::look() {
    if (const auto now = state(); now != last_) {
        last_ = now;
        still_.restart();
    }
    if (const auto missing = this->missing()) {
        if (!wanted_.screenshot.empty() && wanted_.quitAfter <= 0 && still_.elapsed() > kPatienceMs) giveUp(*missing);
    } else if (const int shown = lines(); shown < wanted_.screenshotLines) {
        refuse(Error{"no picture was written: the scan has " + std::to_string(shown) + " lines", wanted_.screenshot,
                     "give --screenshot-lines fewer"}
                   .sentence());
    } else if (wanted_.screenshot.empty()) {
        look_.stop();
    } else if (still_.elapsed() > kRestMs) {
        saveScreenshot();
    }
}

void Start::refuse(const std::string& sentence) {
    if (refused_ || !look_.isActive()) return; // what fails later was not asked for by the command line
    refused_ = true;
    look_.stop();
    cli::printError(sentence);
    if (!wanted_.screenshot.empty()) end(cli::kRefused);
}

void Start::giveUp(const Error& missing) {
    look_.stop();
    cli::printError(wanted_.screenshot.empty() ? missing : Error{"no picture was written: " + missing.what, missing.where, missing.hint});
    end(cli::kRefused);
}

void Start::quit() {
    if (!asked_ || (!refused_ && !look_.isActive())) return end(cli::kDone);
    if (refused_) return end(cli::kRefused);
    if (const auto missing = this->missing()) return giveUp(*missing);
    if (!wanted_.screenshot.empty()) return saveScreenshot();
    end(cli::kDone);
}

void Start::saveScreenshot() {
    look_.stop();
    const Result<Done> written = window_.viewer().exports.saveScreenshot(window_.screenshot(), ui::exactText(wanted_.screenshot));
    if (!written) cli::printError(written.error());
    if (const std::string place = cli::placesText({wanted_.screenshot}); written && place.ends_with(")"))
        cli::printError("written to " + place + ".");
    end(written ? cli::kDone : cli::kRefused);
}

int Start::lines() const {
    const auto& picture = window_.viewer().engine.picture();
    const bool own = picture && (!understood_.scanner || picture->source.stream == window_.viewer().live.scanner().stream());
    return own ? picture->detection->scan->lines() : 0;
}

Start::State Start::state() const {
    const ui::Viewer& viewer = window_.viewer();
    return {lines(), viewer.engine.opening(), window_.sessions().restoring(), viewer.comparing.settled(), progress_};
}

std::optional<Error> Start::missing() const {
    ui::Viewer& viewer = window_.viewer();
    const char* const wait = "give --quit-after more seconds";
    if (const auto& scanner = understood_.scanner) {
        const std::string address = scanner->host + ":" + std::to_string(scanner->port);
        if (lines() == 0) return scanner::noLinesError(viewer.live.scanner().connection(), address);
        if (lines() < wanted_.screenshotLines) return Error{"only " + std::to_string(lines()) + " lines came", address, wait};
    } else {
        const std::string of = !wanted_.session.empty() ? wanted_.session : wanted_.files.empty() ? std::string() : wanted_.files.front();
        if (window_.sessions().restoring()) return Error{"the scan of this session is not shown yet", of, wait};
        if (viewer.engine.opening()) return Error{"it is still being read", of, wait};
        if (first_ || viewer.engine.behind()) return Error{"its edges are still being computed", of, wait};
        if (!viewer.tuning.settled() || !viewer.opening.settled()) return Error{"its edges are still being counted", of, wait};
    }
    if (!viewer.comparing.settled()) return Error{"the comparison is not complete yet", wanted_.compare, wait};
    return std::nullopt;
}

} // namespace edgescan::viewer
