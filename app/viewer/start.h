// The start from a command line, until what was asked for is on the screen or refused.
#pragma once

#include "app/viewer/wanted.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>
#include <string>

namespace edgescan::ui {
class MainWindow;
}

namespace edgescan::viewer {

/// Pins, compares and takes the screenshot as soon as the picture for it is on the screen. What is refused is one sentence on stderr. With
/// --screenshot or --quit-after the application always ends: with exit code 0 if everything was shown, else with 1 and the reason.
class Start : public QObject {
public:
    /// Both must outlive it. Create it before the scans of the command line are opened.
    Start(ui::MainWindow& window, const CommandLine& wanted, const ParsedCommandLine& understood);

private:
    void pinAndCompare();
    /// Of flags that a bridge has no use for, once.
    void warnOfIdle(const files::LiveStatus& status);
    void look();
    void refuse(const std::string& sentence);
    /// Exit code 1, because something is missing.
    void giveUp(const Error& missing);
    void quit();
    void saveScreenshot();
    /// Of the scan on the screen, where it is the one that was asked for.
    [[nodiscard]] int lines() const;
    /// What is not on the screen yet; empty: nothing.
    [[nodiscard]] std::optional<Error> missing() const;
    /// All that changes until then.
    struct State {
        int lines = 0;
        bool opening = false, restoring = false, compared = false;
        std::string progress;
        bool operator==(const State&) const = default;
    };
    [[nodiscard]] State state() const;

    ui::MainWindow& window_;
    const CommandLine& wanted_;
    const ParsedCommandLine& understood_;
    const bool asked_;  // for a scan
    bool first_ = true; // no picture was shown yet
    bool refused_ = false, warned_ = false;
    std::string progress_; // of the opening
    State last_;
    QElapsedTimer still_; // since the last change
    QTimer look_;
};

} // namespace edgescan::viewer
