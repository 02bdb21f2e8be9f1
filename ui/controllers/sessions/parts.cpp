// Parts of the state that belong to no single controller.
#include "ui/controllers/sessions/parts.h"

#include "ui/engine/linked_views/linked_views.h"
#include "ui/panels/keys/commands.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QAction>

namespace edgescan::ui {
namespace {

inspect::ViewPart viewOf(LinkedViews& views) {
    inspect::ViewPart view;
    const CameraPose pose = views.cloud().camera();
    view.camera = inspect::SessionCamera{pose.position, pose.focus, pose.up, pose.viewAngleDeg, pose.parallel};
    if (const ViewPort& port = *views.gray().viewPort(); !port.fitted())
        view.images = inspect::SessionImages{port.centre().x(), port.centre().y(), port.zoom()};
    return view;
}

void useView(LinkedViews& views, const inspect::ViewPart& view) {
    ViewPort& port = *views.gray().viewPort();
    if (view.images) {
        const QPointF centre(view.images->beam, view.images->line);
        port.zoomAt(centre, view.images->zoom / port.zoom());
        port.centreOn(centre);
    } else {
        port.fit();
    }
    if (view.camera) {
        const inspect::SessionCamera& camera = *view.camera;
        views.cloud().setCamera({camera.position, camera.focus, camera.up, camera.viewAngleDeg, camera.parallel});
    }
}

template <class Act>
void forSwitches(const QWidget& window, const Act& act) {
    for (QAction* action : window.actions()) {
        const QVariant key = action->property(kInSessions);
        if (key.isValid()) act(*action, key.toString().toStdString());
    }
}

} // namespace

StatePart viewPart(LinkedViews& views) {
    return {[&views](inspect::ViewerState& state) { state.view = viewOf(views); },
            [&views](const inspect::ViewerState& state) { useView(views, state.view); }, GivenBack::OnScan,
            [&views](const QObject& to, const std::function<void()>& changed) {
                changesOf(views, &LinkedViews::pinChanged, &LinkedViews::rangeWindowChanged)(to, changed);
                changesOf(views.cloud(), &CloudView::frameDrawn)(to, changed);
                changesOf(*views.gray().viewPort(), &ViewPort::changed)(to, changed);
            }};
}

void endSwitchesOfScan(QWidget& window) {
    forSwitches(window, [](QAction& action, const std::string&) {
        if (action.property(kOfScan).toBool() && action.isChecked()) action.trigger();
    });
}

StatePart switchesPart(QWidget& window) {
    const auto store = [&window](inspect::ViewerState& state) {
        forSwitches(window, [&](const QAction& action, const std::string& key) { state.switches[key] = action.isChecked(); });
    };
    const auto use = [&window](const inspect::ViewerState& state) {
        forSwitches(window, [&](QAction& action, const std::string& key) {
            const auto found = state.switches.find(key);
            if (found != state.switches.end() && found->second != action.isChecked()) action.trigger();
        });
    };
    return {store, use, GivenBack::BeforeScan, [&window](const QObject& to, const std::function<void()>& changed) {
                forSwitches(window, [&](QAction& action, const std::string&) { changesOf(action, &QAction::toggled)(to, changed); });
            }};
}

} // namespace edgescan::ui
