// The rocks of the picture shown: their faces in all views, what pointing and clicking at one does, table, card, edits by hand.
#pragma once

#include "core/rocks/selection/strokes.h"
#include "ui/controllers/rocks/rock_sidecar.h"
#include "ui/engine/linked_views/cell_drag.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/rocks/rock_finder.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class QUndoStack;

namespace edgescan::ui {

class LinkedViews;
class Memory;
class NoticeBar;
class RocksPanel;
class RockTable;

/// What the operator does with the mouse.
enum class RockTool : std::uint8_t {
    None,
    Split,  ///< a click splits off the piece that is outlined; the wheel takes a smaller or a larger one
    Join,   ///< a line joins what it crosses
    Cut,    ///< a line cuts what it crosses
    Region, ///< a line goes round the region of interest
};

/// What is of one scan and survives closing it.
struct RockByHand {
    std::vector<RockEdit> edits{};
    std::vector<RegionCorner> region{};
    bool operator==(const RockByHand&) const = default;
};

/// GUI thread only. What it is given must outlive it.
class Rocks : public QObject {
    Q_OBJECT
public:
    Rocks(Engine& engine, LinkedViews& views, RocksPanel& panel, RockTable& table, NoticeBar& notice, Memory& memory, QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    /// Nothing is worked out while they are not shown.
    void setShown(bool on);
    [[nodiscard]] bool shown() const { return on_; }
    /// What is on the screen; null while rocks are not shown, and before the first ones are known.
    [[nodiscard]] const std::shared_ptr<const RockPicture>& picture() const { return picture_; }
    /// What is on the screen was not made of the picture, the settings and the edits wanted last.
    [[nodiscard]] bool behind() const;

    void useSettings(const RockSettings& settings);
    [[nodiscard]] const RockSettings& settings() const { return settings_; }
    /// The same as one step of undo; a slider that moves on makes one with what it did before.
    void turn(const RockSettings& settings);
    /// Empty while they are not shown.
    [[nodiscard]] std::optional<RockPreset> part() const;
    /// Settings and edits, as steps of undo, once what lies beside the scan is read.
    void setPart(const std::optional<RockPreset>& part);

    /// Cells: a rock is known by a cell of it, since its label changes with every setting. The last one is on the card.
    void select(std::vector<std::size_t> cells);
    [[nodiscard]] const std::vector<std::size_t>& selected() const { return selected_; }
    void jumpTo(std::uint32_t label);

    /// Edits by hand stay with the scan whatever is turned; each is one step of undo.
    [[nodiscard]] const std::vector<RockEdit>& edits() const { return edits_; }
    [[nodiscard]] RockByHand byHand() const { return {edits_, settings_.region}; }
    void setByHand(const RockByHand& byHand);
    /// The file beside the scan that holds them; empty where there are none, or nowhere to keep them.
    [[nodiscard]] std::string keptIn() const { return byHand() == RockByHand{} ? std::string() : beside_.path(); }
    void mergeSelected();
    /// What the next click or drag does; afterwards none.
    void useTool(RockTool tool);
    [[nodiscard]] RockTool tool() const { return tool_; }
    void clearRegion();
    void callSelected(bool rock);
    /// A rock becomes none, anything else a rock.
    void turnSelected();

    /// Asks where to; what is written follows from the ending of the file's name.
    void askExport();
    /// csv, json, png (labels), dxf, geojson (outlines), ply, obj (hulls). What is on the screen, while it is not behind().
    void exportTo(const QString& path);

    /// All over the views anew: they showed another picture for a moment.
    void redraw() {
        if (on_) show();
    }

signals:
    void shownChanged(bool on);
    /// Settings or edits are others.
    void changed();
    /// Views, table and card show picture() now.
    void rocksShown();
    void toolChanged(edgescan::ui::RockTool tool);

private:
    void connectViews();
    void ask();
    void take(const std::shared_ptr<const RockPicture>& picture);
    void show();
    void showFaces();
    void showSelection();
    void forget();
    void point(std::optional<std::size_t> cell, const QObject* from);
    void click(std::size_t cell);
    void splitAt(std::size_t cell);
    void push(const QString& name, RockEdit edit);
    void pushByHand(const QString& name, RockByHand after);
    void takePreset(const RockPreset& preset);
    void takeStroke(const std::vector<QPoint>& cells);
    void takeRegion(const std::vector<QPoint>& cells);
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
    Memory& memory_;
    QUndoStack& undo_;
    bool on_ = false;
    RockTool tool_ = RockTool::None;
    CellDrag drag_;
    RocksBeside beside_;
    RockSettings settings_;
    std::vector<RockEdit> edits_;
    std::optional<RockPreset> restored_; // waits for what is beside the scan
    std::uint64_t stream_ = 0;           // that the edits and the selection belong to
    std::uint64_t besideStream_ = 0;     // that beside_ is about
    std::shared_ptr<const RockPicture> picture_;
    std::shared_ptr<const Detection> asked_; // last
    std::vector<std::size_t> selected_;
    // Of the tool that splits: the cell that is pointed at, and the piece round it that is outlined.
    std::shared_ptr<const RockPicture> familyPicture_;
    std::size_t familyCell_ = 0;
    RockFamily family_;
    std::size_t piece_ = 0; // of the family
    // Turning on without a pause is one step of undo: the number of the last one, what it turned, and when.
    int turn_ = 0;
    QString turned_;
    QElapsedTimer sinceTurn_;
    QTimer nextOfSweep_; // a growing sweep is asked about once a second
    RockFinder finder_;
};

} // namespace edgescan::ui
