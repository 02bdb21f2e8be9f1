// What lies on the desk: taken up as one value, and laid out again.
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

/// All of them outlive it.
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

/// Empty while there is nothing to come back to: no picture, or one of no file; of a sweep from a scanner, what is not being recorded. GUI
/// thread.
[[nodiscard]] std::optional<ViewerState> taken(const Desk& desk);
/// What needs no scan: settings, switches, the layout of the window.
void layOut(const Desk& desk, const ViewerState& state);
/// The rest, on the scan on the screen, which is the session's.
void layOutOnScan(const Desk& desk, const ViewerState& state);
/// That the scan on the screen is that one.
[[nodiscard]] bool isShown(const Desk& desk, const SessionScan& scan);

} // namespace edgescan::ui
