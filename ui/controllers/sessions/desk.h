// The state of the viewer: read from the controllers as one value, and restored.
#pragma once

#include "core/inspect/session_file/session_file.h"

#include <functional>
#include <optional>

class QUndoStack;
class QWidget;

namespace edgescan::ui {

class Comparing;
class Confidence;
class EdgesPanel;
class Files;
class LinkedViews;
class Live;
class MarkedEdges;
class Memory;
class NoticeBar;
class Rocks;
class ScanLook;
class Selection;
class Engine;
class Targets;
class Tuning;

/// All of them must outlive it.
struct Desk {
    QWidget& window; ///< with the switches of its menus as actions
    Engine& engine;
    Files& files;
    Tuning& tuning;
    EdgesPanel& panel;
    LinkedViews& views;
    Targets& targets;
    Selection& selection;
    Rocks& rocks;
    MarkedEdges& marked;
    Comparing& comparing;
    Confidence& confidence;
    ScanLook& look;
    Live& live;
    NoticeBar& notice;
    Memory& memory;
    QUndoStack& undo;
    std::function<std::map<std::string, std::string>()> layout;
    std::function<void(const std::map<std::string, std::string>&)> useLayout;
};

/// Empty if there is no state to restore: no picture, or a picture that comes from no file; for a sweep of a scanner, if it is not
/// recorded. GUI thread.
[[nodiscard]] std::optional<inspect::ViewerState> taken(const Desk& desk);
/// Restores the parts that need no scan: settings, switches, the layout of the window.
void layOut(const Desk& desk, const inspect::ViewerState& state);
/// Restores the rest on the scan on the screen, which must be the session's.
void layOutOnScan(const Desk& desk, const inspect::ViewerState& state);
/// True if this scan is on the screen.
[[nodiscard]] bool isShown(const Desk& desk, const inspect::SessionScan& scan);

} // namespace edgescan::ui
