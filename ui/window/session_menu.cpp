// Commands of sessions, and the stored layout.
#include "ui/window/session_menu.h"

#include "ui/base/pane.h"
#include "ui/controllers/sessions/session_in_picture.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/window/cab_mode.h"
#include "ui/window/docks.h"
#include "ui/window/main_window.h"
#include "ui/window/pane_places.h"

#include <QFileInfo>
#include <QSplitter>

#include <algorithm>

namespace edgescan::ui {

namespace {

const char* const kOfCab = "cab"; // the views of a cab, in place of a layout

/// In the order in which a session gives them back.
std::vector<StatePart> partsOf(MainWindow& w) {
    using enum GivenBack;
    LinkedViews& views = w.viewer().views;
    std::vector<StatePart> parts{
        partOf(w.viewer().tuning, &inspect::ViewerState::tuning, BeforeScan),
        partOf(w.viewer().targets, &inspect::ViewerState::targets, OnScan),
        partOf(w.viewer().selection, &inspect::ViewerState::selection, OnScan, &Selection::changed),
        partOf(w.viewer().markedEdges, &inspect::ViewerState::marks, OnScan, &MarkedEdges::changed),
        partOf(w.viewer().rocks, &inspect::ViewerState::rocks, OnScan, &Rocks::changed, &Rocks::shownChanged, &Rocks::rocksShown),
        viewPart(views),
        switchesPart(w),
    };
    const std::vector<StatePart> looks =
        looksParts(w.viewer().look, views, w.viewer().savedViews, w.viewer().confidence, w.viewer().comparing);
    parts.insert(parts.end(), looks.begin(), looks.end());
    parts.push_back(
        partOf(w.viewer().comparing, &inspect::ViewerState::earlier, OnScan, &Comparing::pictureAChanged, &Comparing::rowsChanged));
    parts.push_back(partOf(w.viewer().layers, &inspect::ViewerState::layers, OnScan, &Layers::changed));
    parts.push_back({[&w](inspect::ViewerState& state) { state.layout = w.layoutKept(); },
                     [&w](const inspect::ViewerState& state) { w.useLayout(state.layout); }, BeforeScan,
                     changesOf(w.cab(), &CabMode::viewsChanged)});
    return parts;
}

} // namespace

std::unique_ptr<Sessions> sessionsOf(MainWindow& w, Preferences& preferences) {
    auto sessions = std::make_unique<Sessions>(w.viewer().engine, w.viewer().files, w.viewer().live, w.viewer().notice, preferences,
                                               w.viewer().undo, partsOf(w));
    w.viewer().exports.setCarried([made = sessions.get()](const QImage& image, const QString& path) {
        return withSession(image, made->textFor(QFileInfo(path).absolutePath()));
    });
    QObject::connect(sessions.get(), &Sessions::scanArrives, &w, [&w] {
        endSwitchesOfScan(w);
        w.viewer().rockTable.showAll();
    });
    return sessions;
}

std::vector<Command> sessionCommands(MainWindow& w) {
    return {command("Open Sess&ion…", "", [&w] { w.sessions().ask(); }),
            command("&Save Session As…", "Ctrl+Shift+S", [&w] { w.sessions().askSaveAs(); }),
            command("Go on with the &Last Session", "", [&w] { w.sessions().continueLast(); })};
}

std::map<std::string, std::string> MainWindow::layoutKept() const {
    const auto text = [](const QByteArray& bytes) { return bytes.toBase64().toStdString(); };
    if (cab_->on()) return {{kOfCab, text(QByteArray::fromStdString(cab_->viewsKept()))}}; // docks and splitters are those of the desk
    if (docks_->locked()) return {};
    const QByteArray alone = maximised_ == nullptr ? QByteArray() : maximised_->content()->objectName().toUtf8();
    return {{"docks", text(saveState())},
            {"views", text(splitter_->saveState())},
            {"pictures", text(images_->saveState())},
            {"large", text(places_->text().toUtf8())},
            {"panel", text(QByteArray::number(docks_->draggedWidth()))},
            {"images", text(imagesDragged_ ? "dragged" : "follow")},
            {"alone", text(alone)}};
}

void MainWindow::useLayout(const std::map<std::string, std::string>& layout) {
    const auto bytes = [&layout](const char* name) {
        const auto found = layout.find(name);
        return found == layout.end() ? QByteArray() : QByteArray::fromBase64(QByteArray::fromStdString(found->second));
    };
    if (cab_->on()) return cab_->useViews(QString::fromUtf8(bytes(kOfCab)));
    if (layout.empty() || layout.contains(kOfCab)) return;
    restoreState(bytes("docks"));
    docks_->wantOpen();
    docks_->setDraggedWidth(bytes("panel").toInt());
    places_->use(QString::fromUtf8(bytes("large")));
    splitter_->restoreState(bytes("views"));
    images_->restoreState(bytes("pictures"));
    images_->setOrientation(Qt::Vertical);                                       // a state of an earlier version may have another one
    imagesDragged_ = !layout.contains("images") || bytes("images") == "dragged"; // sessions of earlier versions do not say it
    const QByteArray alone = bytes("alone");
    const auto found = std::ranges::find_if(panes_, [&alone](const Pane* pane) { return pane->content()->objectName().toUtf8() == alone; });
    showAlone(found == panes_.end() ? nullptr : (*found)->content());
}

} // namespace edgescan::ui
