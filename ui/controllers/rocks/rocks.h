// The rocks of the shown picture: their faces in all views, pointing and clicking, table, card, the operator's edits.
#pragma once

#include "core/inspect/measure/near_side.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/selection/strokes.h"
#include "ui/controllers/rocks/rock_sidecar.h"
#include "ui/engine/linked_views/cell_drag.h"
#include "ui/engine/linked_views/pointer_tip.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/rocks/rock_finder.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QMenu;
class QUndoCommand;
class QUndoStack;

namespace edgescan::ui {

/// Name of the submenu of a rock in the menu of a cell.
inline constexpr const char* kRockMenu = "rock-menu";

class LinkedViews;
class Preferences;
class NoticeBar;
class RocksPanel;
class RockTable;

/// The tool of the mouse.
enum class RockTool : std::uint8_t {
    None,
    Split,  ///< a click splits off the outlined segment; the wheel chooses a smaller or a larger one
    Join,   ///< a line joins the rocks that it crosses; a click joins a rock to the selected one
    Cut,    ///< a line cuts the rocks that it crosses
    Region, ///< a line encloses the region of interest
};

/// What the tool waits for; empty: no tool.
[[nodiscard]] QString promptOf(RockTool tool);

/// The part that belongs to one scan and is stored when the scan is closed.
struct OperatorEdits {
    std::vector<rocks::Edit> edits{};
    std::vector<rocks::RegionCorner> region{};
    bool operator==(const OperatorEdits&) const = default;
};

/// GUI thread only. The objects passed to it must outlive it.
class Rocks : public QObject {
    Q_OBJECT
public:
    Rocks(Engine& engine, LinkedViews& views, RocksPanel& panel, RockTable& table, NoticeBar& notice, Preferences& preferences,
          QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    /// Off: rocks are not computed.
    void setShown(bool on);
    /// To the default value, as an undo step; empty: all settings but the region. Only while rocks are shown.
    void reset(const QString& parameter);
    [[nodiscard]] bool shown() const { return on_; }
    /// The rocks on the screen; null while rocks are off and before the first result.
    [[nodiscard]] const std::shared_ptr<const RockPicture>& picture() const { return picture_; }
    /// Panel, table and outlines again, in the words for mouse or gloves.
    void show();
    /// True if the shown rocks do not belong to the current picture, settings and edits.
    [[nodiscard]] bool behind() const;

    void useSettings(const rocks::RockSettings& settings);
    [[nodiscard]] const rocks::RockSettings& settings() const { return settings_; }
    /// The same as one undo step; consecutive changes by a slider are merged into one step.
    void change(const rocks::RockSettings& settings);
    /// Empty while they are not shown.
    [[nodiscard]] std::optional<rocks::Preset> part() const;
    /// Restores settings and edits as undo steps, after the scan's sidecar was read.
    void setPart(const std::optional<rocks::Preset>& part);

    /// Selects rocks by cells: labels change with every setting, so a rock is identified by one of its cells. The card shows the last one.
    void select(std::vector<std::size_t> cells);
    /// The rock of the chosen target, also after another choice; without one nothing.
    void selectPinned();
    /// `targets`: by cell, with their numbers, for the card. Table and files have the names of `pinned`.
    void setTargets(const RockNames& targets, const std::vector<inspect::PinnedTarget>& pinned);
    /// The cell of the rock that a click means: just behind the outline of a rock it means the rock. Empty: no rock.
    [[nodiscard]] std::optional<std::size_t> rockCellAt(const inspect::ClickedCell& click) const;
    [[nodiscard]] const std::vector<std::size_t>& selected() const { return selected_; }
    /// The cell of the rock that a command is for: the last one that was selected, else the pinned one.
    [[nodiscard]] std::optional<std::size_t> chosen() const { return selected_.empty() ? pinned_ : std::optional(selected_.back()); }
    /// Selects the rock and turns the views to it.
    void lookAt(std::uint32_t label);
    /// Looks at the rock with the largest visible width b, or at the next smaller one than the selected. Shows rocks first if they are off.
    void lookAtLargest();
    void lookAtNextSmaller();

    /// The operator's edits stay with the scan when settings change; each is one undo step.
    [[nodiscard]] const std::vector<rocks::Edit>& edits() const { return edits_; }
    /// The disk refused the newest ones.
    [[nodiscard]] bool unsaved() const { return sidecar_.failing(); }
    [[nodiscard]] OperatorEdits operatorEdits() const { return {edits_, settings_.region}; }
    void setOperatorEdits(const OperatorEdits& byHand);
    /// The sidecar file with the edits; empty without edits or if it cannot be stored.
    [[nodiscard]] std::string editsFile() const { return operatorEdits() == OperatorEdits{} ? std::string() : sidecar_.path(); }
    /// With fewer than two selected rocks it sets the tool Join.
    void mergeSelected();
    /// One selected rock is merged with those that may be the same rock (Rock::maybeOneWith); otherwise mergeSelected().
    void mergeOffered();
    /// Sets the tool for the next click or drag; afterwards no tool is set.
    void useTool(RockTool tool);
    [[nodiscard]] RockTool tool() const { return tool_; }
    void clearRegion();
    void callChosen(bool rock);
    /// Changes a rock to "not a rock", other regions to "rock".
    void toggleChosen();

    /// Asks for a path; the extension determines the content.
    /// Of what the table lists; `all`: of all rocks in the order of their numbers.
    void askExport(bool all = false);
    /// csv, json, png (labels), dxf, geojson (outlines), ply, obj (hulls), by whenKnown().
    void exportTo(const QString& path, bool all = false);
    /// Calls `write` now, or while behind() as soon as the rocks of this scan are known; if that will not be, a notice names `path`.
    void whenKnown(const QString& path, std::function<void()> write);

signals:
    void shownChanged(bool on);
    /// Settings or edits changed.
    void changed();
    /// Views, table and card now show picture().
    void rocksShown();
    void toolChanged(edgescan::ui::RockTool tool);
    void selectionChanged();
    /// Of the selected rock.
    void nameRequested();
    void sectionRequested();

private:
    void connectViews();
    void ask();
    void storePicture(const std::shared_ptr<const RockPicture>& picture);
    void showFaces();
    void showSelection();
    void showCard();
    void forget();
    /// Rocks, or what they depend on, are being computed or read.
    [[nodiscard]] bool working() const;
    void writeWaiting();
    void refuseWaiting();
    void point(std::optional<std::size_t> cell, const QObject* from);
    void addToMenu(QMenu& menu, const inspect::ClickedCell& click);
    void followPin(std::optional<std::size_t> cell);
    [[nodiscard]] bool pinnedOnRock() const;
    void click(const inspect::ClickedCell& click);
    void splitAt(std::size_t cell);
    /// The first edit is what the operator did, or `kind`. `merged`: selected rocks that become one; undo selects all of them again.
    void push(const QString& name, std::vector<rocks::Edit> added, const std::vector<std::size_t>& merged = {});
    void merge(const std::vector<std::uint32_t>& cells);
    void pushEdits(const QString& name, std::vector<rocks::Edit> edits, rocks::EditKind kind, const std::vector<std::size_t>& merged = {});
    void pushOperatorEdits(const QString& name, OperatorEdits after, const std::vector<std::size_t>& merged = {});
    void judgeEdit();
    void adopt(const rocks::Preset& mine, const rocks::Preset& theirs); // of another window
    void applyPreset(const rocks::Preset& preset);
    struct CutAsked {
        std::shared_ptr<const RockPicture> of;
        rocks::CutLine line;
        std::uint64_t stream = 0;
        std::optional<std::uint32_t> chosen; ///< a cell of the rock on the card
    };
    [[nodiscard]] bool completesCut(std::vector<QPoint>& cells);
    void applyStroke(std::vector<QPoint> cells);
    void applyCut(const CutAsked& asked, const std::vector<rocks::Edit>& cut);
    [[nodiscard]] RockNames names() const;
    void applyJoin(const rocks::CutLine& stroke);
    void applyRegion(const std::vector<QPoint>& cells);
    void choosePieceAt(std::size_t cell);
    void showPiece(const QObject* from);
    void stepPiece(int by);
    [[nodiscard]] bool ofAnotherPicture() const;
    [[nodiscard]] QString remark() const;

    Engine& engine_;
    LinkedViews& views_;
    RocksPanel& panel_;
    RockTable& table_;
    NoticeBar& notice_;
    Preferences& preferences_;
    QUndoStack& undo_;
    bool on_ = false;
    RockTool tool_ = RockTool::None;
    CellDrag drag_;
    PointerTip tip_;
    RockSidecar sidecar_;
    rocks::RockSettings settings_;
    std::vector<rocks::Edit> edits_;
    std::optional<rocks::Preset> restored_; // waits until the sidecar was read
    std::uint64_t stream_ = 0;              // of the picture
    std::string key_;                       // scanKey() of the edits
    bool sidecarAsked_ = false;             // it follows that scan
    std::shared_ptr<const RockPicture> picture_;
    std::shared_ptr<const edges::Detection> asked_; // the newest request
    std::vector<std::size_t> selected_;
    RockNames targets_;
    std::vector<inspect::PinnedTarget> pinnedTargets_;
    bool largestWanted_ = false; // as soon as the rocks are known
    std::optional<std::size_t> pinned_;
    std::optional<QPoint> cutFrom_; // the first click of a line of two
    // For the split tool: the cell under the mouse, and the outlined segment around it.
    std::shared_ptr<const RockPicture> familyPicture_;
    std::size_t familyCell_ = 0;
    rocks::WheelPieces family_;
    std::size_t piece_ = 0; // index in the family
    rocks::EditKind judgedKind_ = rocks::EditKind::Part;
    std::shared_ptr<const RockPicture> judgedFrom_; // the rocks before the newest edit, until those after it are known
    QUndoCommand* newestEdit_ = nullptr;            // of the undo stack, while it is there
    // Turning on without a pause is one step of undo: the number of the last one, what it turned, and when.
    int turn_ = 0;
    QString turned_;
    QElapsedTimer sinceTurn_;
    QTimer nextOfSweep_; // a growing sweep is processed once a second
    struct Waiting {
        QString path;
        std::function<void()> write;
        std::unique_ptr<Works::Running> shown; ///< Cancel removes it from the list
    };
    std::vector<Waiting> waiting_; // files with rocks that are being computed
    RockFinder finder_;
    Derived<CutAsked, std::vector<rocks::Edit>> cutter_; // last
};

} // namespace edgescan::ui
