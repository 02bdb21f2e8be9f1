// Picks the cells of a measurement, click by click.
#pragma once

#include "core/inspect/measure/near_side.h"
#include "core/inspect/measure/notebook.h"
#include "core/inspect/measure/throat.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

class LinkedViews;
class NoticeBar;
class Targets;

/// GUI thread only. The objects passed to it must outlive it.
class Measures : public QObject {
    Q_OBJECT
public:
    Measures(LinkedViews& views, Targets& targets, NoticeBar& notice);

    /// From now on clicks pick cells for this measurement, until stop().
    void start(inspect::MeasureKind kind);
    /// The same with the first cell already picked.
    void startAt(std::size_t cell);
    void stop();
    /// Empty while no measurement is active.
    [[nodiscard]] std::optional<inspect::MeasureKind> kind() const { return kind_; }
    [[nodiscard]] const std::vector<inspect::ClickedCell>& picked() const { return picked_; }
    /// Removes the last picked cell; false: there was none.
    bool removeLastPick();
    /// What is picked, and which click comes next.
    void show();

signals:
    /// Another kind of measurement is active, or the tool was left.
    void kindChanged();
    /// A text that names the next cell to click; empty: none.
    void asked(const QString& words);

private:
    using Throat = std::optional<inspect::Throat>; // empty: no free way
    struct ThroatAsked {
        std::shared_ptr<const Picture> of;
        std::vector<std::uint32_t> clicked;
        bool afterAClick; ///< one click, and the click on rock before it does not count
    };
    void pick(const inspect::ClickedCell& click);
    [[nodiscard]] QString lastClickWords() const;
    [[nodiscard]] bool askThrough(const inspect::ClickedCell& click);
    void keepPicked();
    void finishThroat(const ThroatAsked& asked, const Throat& found);
    [[nodiscard]] bool isOnScreen(const Picture& of) const;
    void warnOfClick();
    void keep(inspect::MeasureKind kind, std::vector<std::uint32_t> cells, std::vector<std::uint32_t> clicked);

    LinkedViews& views_;
    Targets& targets_;
    NoticeBar& notice_;
    std::optional<inspect::MeasureKind> kind_;
    std::vector<inspect::ClickedCell> picked_;
    std::optional<inspect::StoredMeasure> newThroat_; // until its card is known
    Derived<ThroatAsked, Throat> throats_;            // last
};

} // namespace edgescan::ui
