// Asks before the window closes, where closing loses something or may be an accident.
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QMessageBox>
#include <QPushButton>

namespace edgescan::ui {

void MainWindow::quit() {
    byHand_ = true;
    close();
    byHand_ = false;
}

void MainWindow::end() {
    viewer_.engine.works().cancelAll();
    viewer_.live.scanner().disconnectScanner();
    remember();
    QApplication::exit(0); // of all event loops: open questions end as if they were cancelled
}

bool MainWindow::mayClose(bool byHand) {
    const bool records = viewer_.live.scanner().recording();
    const bool byGlove = byHand && cab_->on(); // it may have meant the button that leaves cab mode
    if (!records && !viewer_.engine.saving() && !byGlove) return true;
    const bool writes = records || viewer_.engine.saving();
    QMessageBox box(QMessageBox::Warning, tr("Close EdgeScan?"),
                    records  ? tr("A recording is being written.")
                    : writes ? tr("A file is still being written.")
                             : tr("This ends the program."),
                    QMessageBox::Cancel, this);
    box.setObjectName("close-question");
    box.setInformativeText(records  ? tr("Closing ends the recording. What was recorded so far remains in its file.")
                           : writes ? tr("Closing waits until it is complete.")
                                    : tr("To leave cab mode only, cancel, then hold the button “Hold to leave” for one second."));
    QPushButton* end = box.addButton(records ? tr("End the Recording and Close") : tr("Close EdgeScan"), QMessageBox::DestructiveRole);
    end->setObjectName("end-and-close");
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == end;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose(byHand_ || event->spontaneous())) return event->ignore();
    viewer_.live.scanner().disconnectScanner();
    remember();
    QMainWindow::closeEvent(event);
}

} // namespace edgescan::ui
