// The rocks of the picture shown: their faces in all views, what pointing and clicking at one does, table, card, edits by hand.
#pragma once

#include "core/rocks/rock_settings.h"
#include "ui/rocks/rock_finder.h"
#include "ui/session/session.h"

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

/// GUI thread only. What it is given must outlive it.
class Rocks : public QObject {
    Q_OBJECT
public:
    Rocks(Session& session, LinkedViews& views, RocksPanel& panel, RockTable& table, NoticeBar& notice, Memory& memory, QUndoStack& undo);

    /// Nothing is worked out while they are not shown.
    void setShown(bool on);
    [[nodiscard]] bool shown() const { return on_; }
    /// What is on the screen; null while rocks are not shown, and before the first ones are known.
    [[nodiscard]] const std::shared_ptr<const RockPicture>& picture() const { return picture_; }
    /// What is on the screen was not made of the picture, the settings and the edits wanted last.
    [[nodiscard]] bool behind() const;

    void useSettings(const RockSettings& settings);
    [[nodiscard]] const RockSettings& settings() const { return settings_; }

    /// Cells: a rock is known by a cell of it, since its label changes with every setting. The last one is on the card.
    void select(std::vector<std::size_t> cells);
    [[nodiscard]] const std::vector<std::size_t>& selected() const { return selected_; }
    void jumpTo(std::uint32_t label);

    /// Edits by hand stay with the scan whatever is turned; each is one step of undo.
    [[nodiscard]] const std::vector<RockEdit>& edits() const { return edits_; }
    void setEdits(const std::vector<RockEdit>& edits);
    void mergeSelected();
    /// On: the next click on a rock splits off what was clicked.
    void setSplitting(bool on);
    [[nodiscard]] bool splitting() const { return splitting_; }
    void callSelected(bool rock);
    /// A rock becomes none, anything else a rock.
    void turnSelected();

    /// Asks where to; what is written follows from the ending of the file's name.
    void askExport();
    /// csv, json, png (labels), dxf, geojson (outlines), ply, obj (hulls). What is on the screen, while it is not behind().
    void exportTo(const QString& path);

signals:
    void shownChanged(bool on);
    /// Views, table and card show picture() now.
    void rocksShown();
    void splittingChanged(bool on);

private:
    void connectViews();
    void follow();
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
    [[nodiscard]] bool ofAnotherPicture() const;
    [[nodiscard]] QString remark() const;

    Session& session_;
    LinkedViews& views_;
    RocksPanel& panel_;
    RockTable& table_;
    NoticeBar& notice_;
    Memory& memory_;
    QUndoStack& undo_;
    bool on_ = false;
    bool splitting_ = false;
    RockSettings settings_;
    std::vector<RockEdit> edits_;
    std::uint64_t stream_ = 0; // that the edits and the selection belong to
    std::shared_ptr<const RockPicture> picture_;
    std::shared_ptr<const Detection> asked_; // last
    std::vector<std::size_t> selected_;
    QTimer nextOfSweep_; // a growing sweep is asked about once a second
    RockFinder finder_;
};

} // namespace edgescan::ui
