// The window's menus and keys. The shortcut sheet is made from the same actions, so it cannot lie.
#include "ui/main/main_window.h"

#include "core/base/version.h"
#include "core/report/report.h"
#include "ui/cloud/cloud_view.h"
#include "ui/image/image_view.h"
#include "ui/image/viewport.h"
#include "ui/panel/edges_panel.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QUndoStack>
#include <QVBoxLayout>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {

void MainWindow::buildMenus() {
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    buildScanMenu();
    buildEdgesMenu();
    buildHelpMenu();
}

QAction* MainWindow::addCommand(QMenu& menu, const QString& text, const QList<QKeySequence>& keys, const std::function<void()>& run) {
    QAction* action = menu.addAction(text);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, run);
    addAction(action); // keys also work in full screen, where the menu bar is hidden
    return action;
}

QAction* MainWindow::addSwitch(QMenu& menu, const QString& text, const QList<QKeySequence>& keys, bool on, const QString& memoryKey,
                               const std::function<void(bool)>& run) {
    QAction* action = menu.addAction(text);
    action->setShortcuts(keys);
    action->setCheckable(true);
    addAction(action);
    connect(action, &QAction::toggled, this, [this, memoryKey, run](bool checked) {
        run(checked);
        if (memoryKey.isEmpty()) return;
        memory_.keep(memoryKey, checked);
        rememberTimer_.start();
    });
    const bool wanted = memoryKey.isEmpty() ? on : memory_.flag(memoryKey, on);
    const QSignalBlocker quiet(action);
    action->setChecked(wanted);
    run(wanted); // also when it is what an action starts with
    return action;
}

void MainWindow::buildFileMenu() {
    QMenu& file = *menuBar()->addMenu(tr("&File"));
    addCommand(file, tr("&Open…"), {QKeySequence::Open}, [this] { askOpen(); });
    QMenu* recent = file.addMenu(tr("Open &Recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecentMenu(*recent); });
    addCommand(file, tr("Open &Demo Draw-Bell"), {}, [this] { openDemo(); });
    addLiveCommands(file);
    addCommand(file, tr("Re&load"), {QKeySequence(Qt::Key_F5)}, [this] {
        if (!openedPath_.isEmpty()) session_.open(openedPath_, openOptions_);
    });
    file.addSeparator();
    QMenu& exports = *file.addMenu(tr("&Export"));
    addCommand(exports, tr("&Edge Cloud…"), {QKeySequence("Ctrl+E")}, [this] { askExport(Session::Export::EdgeCloud); });
    addCommand(exports, tr("&Full Cloud…"), {}, [this] { askExport(Session::Export::FullCloud); });
    addCommand(exports, tr("Edge &Image…"), {}, [this] { askExport(Session::Export::EdgeImage); });
    addCommand(exports, tr("&Gray Image…"), {}, [this] { askExport(Session::Export::GrayImage); });
    addCommand(exports, tr("&Range Image…"), {}, [this] { askExport(Session::Export::RangeImage); });
    addCommand(file, tr("&Screenshot…"), {QKeySequence(Qt::Key_F12)}, [this] { saveScreenshot(); });
    addCommand(file, tr("&Copy as Command"), {}, [this] { copyCommand(); });
    file.addSeparator();
    addCommand(file, tr("&Quit"), {QKeySequence::Quit}, [this] { close(); });
}

void MainWindow::fillRecentMenu(QMenu& menu) {
    menu.clear();
    const QStringList files = memory_.recentFiles();
    for (const QString& path : files) {
        QAction* action = menu.addAction(QFileInfo(path).fileName() + "  -  " + QFileInfo(path).path());
        action->setEnabled(QFileInfo::exists(path));
        connect(action, &QAction::triggered, this, [this, path] { openFile(path); });
    }
    if (files.isEmpty()) menu.addAction(tr("No file yet"))->setEnabled(false);
    menu.addSeparator();
    menu.addAction(tr("Clear"), this, [this] {
        memory_.forgetRecentFiles();
        memory_.write();
    });
}

void MainWindow::buildEditMenu() {
    QMenu& edit = *menuBar()->addMenu(tr("&Edit"));
    QAction* undo = undo_->createUndoAction(this, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = undo_->createRedoAction(this, tr("&Redo"));
    redo->setShortcuts({QKeySequence("Ctrl+Y"), QKeySequence("Ctrl+Shift+Z")});
    undo->setObjectName(tr("Undo")); // the texts name the step
    redo->setObjectName(tr("Redo"));
    edit.addActions({undo, redo});
    addActions({undo, redo});
    edit.addSeparator();
    addCommand(edit, tr("&Copy Probe Values"), {QKeySequence::Copy}, [this] { copyProbe(); });
}

void MainWindow::buildViewMenu() {
    QMenu& view = *menuBar()->addMenu(tr("&View"));
    const auto key = [](int k) { return QList<QKeySequence>{QKeySequence(k)}; };
    const auto shifted = [](const char* digit) { return QList<QKeySequence>{QKeySequence(QString("Shift+") + digit)}; };
    addCommand(view, tr("From &Scanner"), key(Qt::Key_0), [this] { cloud_->viewFromScanner(); });
    addCommand(view, tr("&Front"), key(Qt::Key_1), [this] { cloud_->viewFront(); });
    addCommand(view, tr("&Back"), shifted("1"), [this] { cloud_->viewBack(); });
    addCommand(view, tr("&Right"), key(Qt::Key_3), [this] { cloud_->viewRight(); });
    addCommand(view, tr("&Left"), shifted("3"), [this] { cloud_->viewLeft(); });
    addCommand(view, tr("&Top"), key(Qt::Key_7), [this] { cloud_->viewTop(); });
    addCommand(view, tr("Botto&m"), shifted("7"), [this] { cloud_->viewBottom(); });
    addCommand(view, tr("&Isometric"), key(Qt::Key_9), [this] { cloud_->viewIsometric(); });
    addCommand(view, tr("R&eset View"), {QKeySequence(Qt::Key_R), QKeySequence(Qt::Key_Home)}, [this] {
        cloud_->resetView();
        viewPort_->fit();
        resetDisplayLevels();
    });
    addCommand(view, tr("Fl&y to Point under Cursor"), key(Qt::Key_F), [this] {
        if (hovered_) cloud_->flyTo(static_cast<qint64>(*hovered_));
    });
    view.addSeparator();
    QAction* parallel =
        addSwitch(view, tr("&Orthographic"), key(Qt::Key_5), false, "view/orthographic", [this](bool on) { cloud_->setParallel(on); });
    connect(cloud_, &CloudView::parallelChanged, parallel, &QAction::setChecked);
    addSwitch(view, tr("T&urntable"), key(Qt::Key_T), true, "view/turntable", [this](bool on) { cloud_->setTurntable(on); });
    addSwitch(view, tr("&Edge Points"), key(Qt::Key_E), true, "view/edge-points", [this](bool on) { cloud_->setEdgesVisible(on); });
    addSwitch(view, tr("&Dim Cloud under Edges"), key(Qt::Key_D), true, "view/dim-cloud", [this](bool on) { cloud_->setCloudDimmed(on); });
    addSwitch(view, tr("Depth S&hading"), key(Qt::Key_Q), true, "view/shading", [this](bool on) { cloud_->setShaded(on); });
    addSwitch(view, tr("Edges &over Range Image"), key(Qt::Key_O), false, "view/overlay", [this](bool on) {
        overlay_ = on;
        gray_->setOverlay(on && shown_ ? shown_->overlay : nullptr, 1.0);
    });
    addSwitch(view, tr("Edges &by Class"), key(Qt::Key_C), false, "view/edge-classes", [this](bool on) {
        cloud_->setEdgesByClass(on);
        showEdgeMap();
    });
    addSwitch(view, tr("&Colour-Blind Edge Colour"), {}, false, "view/colour-blind", [this](bool on) {
        cloud_->setEdgeColour(on ? kColourBlindEdge : QColor(0, 255, 0));
        panel_->setJumpColour(cloud_->edgeColour());
        showEdgeMap();
    });
    addSwitch(view, tr("True &Angle Aspect"), {}, false, "view/true-angles", [this](bool on) {
        trueAngles_ = on;
        applyAspect();
    });
    view.addSeparator();
    addCommand(view, tr("Point Size &+"), key(Qt::Key_BracketRight), [this] { cloud_->setPointSize(cloud_->pointSize() + 1); });
    addCommand(view, tr("Point Size &-"), key(Qt::Key_BracketLeft), [this] { cloud_->setPointSize(cloud_->pointSize() - 1); });
    QMenu& mouse = *view.addMenu(tr("&Mouse"));
    auto* presets = new QActionGroup(this);
    const bool cloudCompare = memory_.text("view/mouse") == "cloudcompare";
    for (const bool other : {false, true}) {
        QAction* action = mouse.addAction(other ? tr("&CloudCompare: right pans, middle zooms") : tr("&Default: middle pans, right zooms"));
        action->setCheckable(true);
        presets->addAction(action);
        connect(action, &QAction::toggled, this, [this, other](bool on) {
            if (!on) return;
            cloud_->setMousePreset(other ? MousePreset::CloudCompare : MousePreset::Default);
            memory_.keep("view/mouse", QString(other ? "cloudcompare" : "default"));
        });
        if (other == cloudCompare) action->setChecked(true);
    }
    mouse.addSeparator();
    addSwitch(mouse, tr("&Wheel the other way"), {}, false, "view/wheel-reversed", [this](bool on) { cloud_->setWheelReversed(on); });
    view.addSeparator();
    view.addAction(dock_->toggleViewAction());
    addCommand(view, tr("Reset &Layout"), {}, [this] { resetLayout(); });
    addCommand(view, tr("Full Scree&n"), key(Qt::Key_F11), [this] { isFullScreen() ? showNormal() : showFullScreen(); });
}

void MainWindow::buildScanMenu() {
    QMenu& scan = *menuBar()->addMenu(tr("&Scan"));
    addCommand(scan, tr("&Next File of Series"), {QKeySequence(Qt::Key_PageDown)}, [this] { stepInSeries(1); });
    addCommand(scan, tr("Pre&vious File of Series"), {QKeySequence(Qt::Key_PageUp)}, [this] { stepInSeries(-1); });
    addTimelineCommands(scan);
    straighten_ = scan.addAction(tr("&Straighten Beams"));
    straighten_->setObjectName("straighten-beams");
    straighten_->setCheckable(true);
    straighten_->setToolTip(
        tr("Correct the angles of beams that were interlaced from two passes, and of lines at which the stepper slipped"));
    connect(straighten_, &QAction::triggered, this, &MainWindow::straightenBeams);
    addCommand(scan, tr("&Properties…"), {}, [this] { showScanProperties(); });
}

void MainWindow::buildEdgesMenu() {
    QMenu& edges = *menuBar()->addMenu(tr("&Edges"));
    QMenu& presets = *edges.addMenu(tr("&Presets"));
    for (const Preset& preset : builtInPresets()) {
        QAction* action = addCommand(presets, QString::fromStdString(preset.name), {}, [this, preset] { usePreset(preset); });
        action->setToolTip(QString::fromStdString(preset.help));
    }
    presets.addSeparator();
    addCommand(presets, tr("&Open…"), {}, [this] { askOpenPreset(); });
    addCommand(presets, tr("&Save…"), {}, [this] { askSavePreset(); });
    QAction* lock = edges.addAction(tr("&Lock upper = 3 × lower"));
    lock->setCheckable(true);
    lock->setChecked(panel_->ratioLocked());
    connect(lock, &QAction::triggered, panel_, &EdgesPanel::setRatioLocked);
    connect(panel_, &EdgesPanel::ratioLockChanged, lock, &QAction::setChecked);
    addCommand(edges, tr("&Why Is This Cell an Edge, or None?"), {QKeySequence(Qt::Key_W)}, [this] { explainMarked(); });
    addCommand(edges, tr("&Reset to Preset"), {}, [this] { usePreset(panel_->preset()); });
}

void MainWindow::buildHelpMenu() {
    QMenu& help = *menuBar()->addMenu(tr("&Help"));
    addCommand(help, tr("&Keys and Mouse"), {QKeySequence(Qt::Key_F1), QKeySequence(Qt::Key_H), QKeySequence(Qt::Key_Question)},
               [this] { showShortcuts(); });
    addCommand(help, tr("&About EdgeScan"), {}, [this] { showAbout(); });
}

void MainWindow::showShortcuts() {
    QString rows;
    const auto row = [&](const QString& what, const QString& keys) {
        rows += "<tr><td>" + what.toHtmlEscaped() + "&nbsp;&nbsp;</td><td><b>" + keys.toHtmlEscaped() + "</b></td></tr>";
    };
    for (const QAction* action : actions()) {
        QStringList keys;
        for (const QKeySequence& sequence : action->shortcuts()) keys << sequence.toString(QKeySequence::NativeText);
        const QString name = action->objectName().isEmpty() ? action->text() : action->objectName();
        if (!keys.isEmpty()) row(QString(name).remove('&'), keys.join(", "));
    }
    const QString mouse = tr(
        "<h3>Mouse in the cloud</h3>Left drag turns, middle drag or Shift+left drag pans, right drag or wheel zooms, Ctrl+left drag rolls; "
        "double-click or middle click sets the centre of rotation; Alt+wheel point size, Ctrl+wheel near clip, Ctrl+Shift+wheel far clip."
        "<h3>Mouse in the images</h3>Left or middle drag pans, wheel zooms, right drag changes the display levels, double-click fits; "
        "a click sets the crosshair, Esc takes it away; a right click asks why a cell is an edge; Shift+drag draws a box.");
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Keys and mouse"));
    auto* text = new QTextBrowser;
    text->setHtml("<h3>" + tr("Keys") + "</h3><table>" + rows + "</table>" + mouse);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* column = new QVBoxLayout(&dialog);
    column->addWidget(text);
    column->addWidget(buttons);
    dialog.resize(560, 700);
    dialog.exec();
}

void MainWindow::showAbout() {
    QMessageBox::about(this, tr("About EdgeScan"),
                       tr("<h3>EdgeScan %1</h3>Finds the edges of rocks in a laser range scan and shows them in the cloud.<br>"
                          "What it shows is geometry from one viewpoint; it is no judgement of any rock.<br><br>Licence: BSD-3-Clause")
                           .arg(version()));
}

void MainWindow::showScanProperties() {
    if (!shown_) return;
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Scan"));
    auto* text = new QTextBrowser;
    text->setPlainText(QString::fromStdString(infoReport(*shown_->detection->scan).dump(2)));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* column = new QVBoxLayout(&dialog);
    column->addWidget(text);
    column->addWidget(buttons);
    dialog.resize(640, 600);
    dialog.exec();
}

} // namespace edgescan::ui
