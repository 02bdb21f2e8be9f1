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
    const bool targets = viewer_.targets.unsaved(), edits = viewer_.rocks.unsaved();
    const bool lost = targets || edits;
    if (!records && !viewer_.engine.saving() && !lost && !byGlove) return true;
    const bool writes = records || viewer_.engine.saving();
    QMessageBox box(QMessageBox::Warning, tr("Close EdgeScan?"),
                    records            ? tr("A recording is being written.")
                    : writes           ? tr("A file is still being written.")
                    : targets && edits ? tr("Your targets and your edits of rocks are not stored.")
                    : targets          ? tr("Your targets are not stored.")
                    : edits            ? tr("Your edits of rocks are not stored.")
                                       : tr("This ends the program."),
                    QMessageBox::Cancel, this);
    box.setObjectName("close-question");
    box.setInformativeText(records  ? tr("Closing ends the recording. What was recorded so far remains in its file.")
                           : writes ? tr("Closing waits until it is complete.")
                           : lost   ? tr("The disk refused them. EdgeScan tries again as it closes; what it cannot write then is lost.")
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
