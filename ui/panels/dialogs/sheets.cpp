// Dialogs that only show information.
#include "ui/panels/dialogs/sheets.h"

#include "core/base/version.h"
#include "ui/base/shown_text.h"
#include "ui/panels/dialogs/scan_properties.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace edgescan::ui {
namespace {

QString words(const char* text) { return QObject::tr(text); }

void showSheet(QWidget* parent, const QString& title, QTextBrowser* browser, QSize size) {
    QDialog dialog(parent);
    dialog.setWindowTitle(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* column = new QVBoxLayout(&dialog);
    column->addWidget(browser);
    column->addWidget(buttons);
    dialog.resize(size);
    dialog.exec();
}

} // namespace

void showShortcuts(QWidget* parent, const QList<QAction*>& actions) {
    QString rows;
    for (const QAction* action : actions) {
        QStringList keys;
        for (const QKeySequence& sequence : action->shortcuts()) keys << sequence.toString(QKeySequence::NativeText);
        if (keys.isEmpty()) continue;
        QString name = action->property(kPlainName).isValid() ? action->property(kPlainName).toString() : action->text();
        rows +=
            "<tr><td>" + name.remove('&').toHtmlEscaped() + "&nbsp;&nbsp;</td><td><b>" + keys.join(", ").toHtmlEscaped() + "</b></td></tr>";
    }
    const QString mouse = words(
        "<h3>Mouse in the cloud</h3>Left drag turns, middle drag or Shift+left drag pans, right drag or wheel zooms, Ctrl+left drag rolls; "
        "double-click or middle click sets the centre of rotation; Alt+wheel point size, Ctrl+wheel near clip, Ctrl+Shift+wheel far clip."
        "<h3>Mouse in the images</h3>Left or middle drag pans, wheel zooms, right drag changes the display levels, double-click fits; "
        "a click sets the crosshair, Esc takes it away; a right click asks why a cell is an edge; Shift+drag draws a box.");
    auto* browser = new QTextBrowser;
    browser->setHtml("<h3>" + words("Keys") + "</h3><table>" + rows + "</table>" + mouse);
    showSheet(parent, words("Keys and mouse"), browser, {560, 700});
}

void showScanProperties(QWidget* parent, const Scan& scan) {
    auto* browser = new QTextBrowser;
    browser->setObjectName("scan-properties");
    browser->setHtml(scanProperties(scan));
    showSheet(parent, words("Scan"), browser, {640, 600});
}

void showAbout(QWidget* parent, const QString& renderer) {
    QMessageBox box(parent);
    box.setWindowTitle(words("About EdgeScan"));
    box.setTextFormat(Qt::RichText);
    box.setText(words("<h3>EdgeScan %1</h3>Finds the edges of rocks in a laser range scan and shows them in the cloud.<br>"
                      "It shows geometry from one viewpoint. It does not judge any rock.<br><br>Licence: BSD-3-Clause<br>Drawn by %2")
                    .arg(version(), renderer.toHtmlEscaped()));
    box.setStandardButtons(QMessageBox::Ok);
    box.exec();
}

} // namespace edgescan::ui
