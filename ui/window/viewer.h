// The viewer without its window: views, panels and controllers, made and connected. Menus, cab mode and tests take what they need of it.
#pragma once

#include "ui/controllers/audit_trail.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/confidence.h"
#include "ui/controllers/explanation.h"
#include "ui/controllers/files/exports.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/files/opening.h"
#include "ui/controllers/layers.h"
#include "ui/controllers/live.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/saved_views.h"
#include "ui/controllers/scan_look.h"
#include "ui/controllers/scan_report.h"
#include "ui/controllers/sections.h"
#include "ui/controllers/targets/marked_edges.h"
#include "ui/controllers/targets/measures.h"
#include "ui/controllers/targets/selection.h"
#include "ui/controllers/targets/targets.h"
#include "ui/controllers/tuning.h"
#include "ui/engine/linked_views/linked_views.h"

#include <QUndoStack>

namespace edgescan::ui {

class ChangeLegend;
class CloudView;
class ConfidenceLegend;
class EdgeLegend;
class EdgesPanel;
class ImageView;
class LayersPanel;
class LivePanel;
class Preferences;
class NoticeBar;
class RockTable;
class RocksPanel;
class ScalePlate;
class StateBadge;
class StatusLine;
class TargetsPanel;
class Timeline;
class ToolBar;
class ViewCube;
class WarningButton;

/// GUI thread only.
struct Viewer {
    /// `preferences` must outlive it.
    explicit Viewer(Preferences& preferences);

    Preferences& preferences;
    Engine engine;
    QUndoStack undo;

    // Children of the window after the layout.
    ImageView &gray, &edges;
    CloudView& cloud;
    ScalePlate& scalePlate;
    ViewCube& viewCube;
    EdgesPanel& panel;
    LivePanel& livePanel;
    Timeline& timeline;
    RocksPanel& rocksPanel;
    RockTable& rockTable;
    TargetsPanel& targetsPanel;
    LayersPanel& layersPanel;
    ToolBar& tools;
    StateBadge& origin; ///< the source and time of the picture: always visible
    NoticeBar& notice;
    StatusLine& statusLine;
    WarningButton& warnings;
    EdgeLegend& legend;
    ChangeLegend& changeLegend;
    ConfidenceLegend& confidenceLegend;
    RangeWindow& rangeWindow;

    LinkedViews views;
    Files files;
    Opening opening;
    Exports exports;
    Tuning tuning;
    Live live;
    Explanation explanation;
    Rocks rocks;
    Targets targets;
    Measures measures;
    Selection selection;
    Sections sections;
    Comparing comparing;
    Layers layers;
    Confidence confidence;
    MarkedEdges markedEdges;
    ScanLook look;
    SavedViews savedViews;
    ScanReport report;
    AuditTrail audit;

private:
    void followPictures();
};

} // namespace edgescan::ui
