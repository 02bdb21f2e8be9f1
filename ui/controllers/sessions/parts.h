// The viewer's state part by part: who has each, and what says that it changed.
#pragma once

#include "core/inspect/session_file/viewer_state.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <vector>

class QWidget;

namespace edgescan::ui {

class Comparing;
class Confidence;
class LinkedViews;
class SavedViews;
class ScanLook;

/// When a session gives a part back: settings, switches and the layout of the window need no scan, the others need that of the session.
enum class GivenBack : std::uint8_t { BeforeScan, OnScan, Both };

/// All that it names outlives it.
struct StatePart {
    std::function<void(inspect::ViewerState& state)> store;
    std::function<void(const inspect::ViewerState& state)> use;
    GivenBack when = GivenBack::OnScan;
    std::function<void(const QObject& to, const std::function<void()>& changed)> follow{};
};

/// Calls `changed` at each of these signals, as long as `to` lives.
template <class Sender, class... Signals>
[[nodiscard]] auto changesOf(Sender& sender, Signals... changes) {
    return [&sender, changes...](const QObject& to, const std::function<void()>& changed) {
        (QObject::connect(&sender, changes, &to, [changed] { changed(); }), ...);
    };
}

/// What a controller has by part() and takes by setPart().
template <class Controller, class Value, class... Signals>
[[nodiscard]] StatePart partOf(Controller& controller, Value inspect::ViewerState::*value, GivenBack when, Signals... changes) {
    return {[&controller, value](inspect::ViewerState& state) { state.*value = controller.part(); },
            [&controller, value](const inspect::ViewerState& state) { controller.setPart(state.*value); }, when,
            changesOf(controller, changes...)};
}

/// Camera, and what part of the images is seen.
[[nodiscard]] StatePart viewPart(LinkedViews& views);
/// The switches of menus, which are actions of the window.
[[nodiscard]] StatePart switchesPart(QWidget& window);
/// For another scan: those that belong to one scan go off.
void endSwitchesOfScan(QWidget& window);
/// How the views look where a menu has no switch for it. Numbers with a point, whatever the language; what is missing or cannot be
/// understood stays as it is.
[[nodiscard]] std::vector<StatePart> looksParts(ScanLook& look, LinkedViews& views, SavedViews& saved, Confidence& confidence,
                                                Comparing& comparing);

} // namespace edgescan::ui
