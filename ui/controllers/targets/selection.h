// One selection of cells for both images, the cloud and exports; and the hidden cells of the scan.
#pragma once

#include "core/inspect/measure/near_side.h"
#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/views/cloud/point_pick.h"

#include <QObject>
#include <QPolygonF>

#include <memory>
#include <optional>

class QMenu;
class QUndoStack;

namespace edgescan::ui {

class LinkedViews;
class NoticeBar;
class Rocks;
class Engine;

/// GUI thread only. The objects passed to it must outlive it.
class Selection : public QObject {
    Q_OBJECT
public:
    Selection(Engine& engine, LinkedViews& views, Rocks& rocks, NoticeBar& notice, QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    [[nodiscard]] const inspect::CellSet& cells() const { return state_.selected; }
    [[nodiscard]] const inspect::CellSet& hidden() const { return state_.hidden; }
    /// Each of these functions is one undo step.
    void select(inspect::CellSet cells);
    void selectChainAt(std::size_t cell);
    void selectRockAt(std::size_t cell);
    void hideSelected();
    /// Hides everything except the selection.
    void isolateSelected();
    void showAll();
    [[nodiscard]] inspect::SelectionPart part() const { return {inspect::runsOf(state_.selected), inspect::runsOf(state_.hidden)}; }
    void setPart(const inspect::SelectionPart& part);
    /// Also hides nearer and farther cells, metres.
    void hideBeyond(double nearM, double farM);
    /// The same with the range of a cell as one of the limits.
    void hideFartherThan(std::optional<std::size_t> cell);
    void hideNearerThan(std::optional<std::size_t> cell);
    /// Asks for both limits.
    void askRangeGate();
    /// Also hides cells outside the box around the selection, along the axes of the scan's frame.
    void clipToSelected();
    /// Zooms all views to the selection.
    void zoomTo();

    /// "1,234 cells selected, 1,200 points, 56 of them edges"; empty without a selection.
    [[nodiscard]] QString words() const;

signals:
    void changed();
    void exportRequested();

private:
    struct State {
        inspect::CellSet selected, hidden;
        bool operator==(const State&) const = default;
    };
    struct Question { // about the cloud
        std::shared_ptr<const CloudGeometry> cloud;
        ScreenView view;
        QPolygonF corners;
        Qt::KeyboardModifiers modifiers;
    };
    void combine(inspect::CellSet cells, Qt::KeyboardModifiers modifiers);
    void change(const QString& what, State after);
    void use(const State& state);
    void show();
    void addToMenu(QMenu& menu, const inspect::ClickedCell& click);
    [[nodiscard]] bool needSelection();
    void reportGrowth();
    void hideToo(const QString& what, const inspect::CellSet& cells);
    [[nodiscard]] std::optional<double> rangeAt(std::optional<std::size_t> cell);

    Engine& engine_;
    LinkedViews& views_;
    Rocks& rocks_;
    NoticeBar& notice_;
    QUndoStack& undo_;
    std::uint64_t stream_ = 0;
    std::shared_ptr<const Scan> shownOn_; // the views drop the selection with every new scan
    State state_;
    Derived<Question, inspect::CellSet> inside_; // last
};

} // namespace edgescan::ui
