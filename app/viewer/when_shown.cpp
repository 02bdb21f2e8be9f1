// Waits for the first picture by its signal.
#include "app/viewer/when_shown.h"

#include "app/shared/exits.h"
#include "ui/base/shown_text.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QTimer>

#include <memory>

namespace edgescan::viewer {

void pinWhenShown(ui::MainWindow& window, const std::vector<PinnedPlace>& places) {
    auto once = std::make_shared<QMetaObject::Connection>();
    *once = QObject::connect(&window, &ui::MainWindow::pictureShown, &window, [&window, places, once] {
        QObject::disconnect(*once);
        for (const PinnedPlace& place : places) {
            const Scan& scan = *window.viewer().engine.picture()->detection->scan;
            if (scan.rangeMm.contains(place.line, place.beam))
                window.viewer().views.pin(window.viewer().views.cellAt(place.line, place.beam));
            else
                cli::printError(
                    Error{"the scan has no line " + std::to_string(place.line) + ", beam " + std::to_string(place.beam), "--pin",
                          "give a cell of its " + std::to_string(scan.lines()) + " lines and " + std::to_string(scan.beams()) + " beams"});
        }
    });
}

void compareWhenShown(ui::MainWindow& window, const QString& before) {
    auto once = std::make_shared<QMetaObject::Connection>();
    *once = QObject::connect(&window, &ui::MainWindow::pictureShown, &window, [&window, before, once] {
        QObject::disconnect(*once);
        window.viewer().comparing.compareWith(before);
    });
}

// Takes the screenshot at once if the scan was refused.
void screenshotWhenShown(ui::MainWindow& window, const WantedPicture& wanted) {
    constexpr int kRestMs = 700;
    const auto write = [&window, wanted] {
        while (!window.viewer().comparing.settled()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        const Result<Done> written = window.viewer().exports.saveScreenshot(window.screenshot(), ui::exactText(wanted.path));
        if (!written) cli::printError(written.error());
        const bool compared = wanted.before.empty() || window.viewer().comparing.pictureA();
        if (!compared) cli::printError(Error{"the earlier scan could not be opened", wanted.before, "the picture says why"});
        QApplication::exit(written && compared ? 0 : 1);
    };
    QObject::connect(&window, &ui::MainWindow::pictureShown, &window, [&window, write, wanted] {
        const int shown = window.viewer().engine.picture()->detection->scan->lines();
        if (shown >= wanted.lines) {
            QTimer::singleShot(kRestMs, &window, write);
        } else if (!wanted.live) { // a file has no further lines
            cli::printError(Error{"no picture was written: the scan has " + std::to_string(shown) + " lines", wanted.path,
                                  "give --screenshot-lines fewer"});
            QApplication::exit(1);
        }
    });
    QObject::connect(&window.viewer().engine, &ui::Engine::failed, &window, [](const QString& sentence) {
        cli::printError(sentence.toStdString());
        QApplication::exit(1);
    });
}

} // namespace edgescan::viewer
