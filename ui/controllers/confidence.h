// Edge confidence: computed while the operator changes nothing, shown instead of the plain edges and on the card of a target on an edge.
#pragma once

#include "ui/engine/worker_bridge/newest.h"
#include "ui/panels/confidence/confidence_picture.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>
#include <optional>

namespace edgescan::ui {

class ConfidenceLegend;
class LinkedViews;
class Memory;
class Engine;
class Targets;
struct EdgesInstead;

/// GUI thread only. The objects passed to it must outlive it. Hidden while a comparison is shown.
class Confidence : public QObject {
    Q_OBJECT
public:
    Confidence(Engine& engine, LinkedViews& views, Targets& targets, ConfidenceLegend& legend, Memory& memory);
    ~Confidence() override;

    /// A new picture is on the screen.
    void followPicture();
    void setOn(bool on);
    /// Only edges with at least this confidence are shown, percent.
    void setLeast(int percent);
    [[nodiscard]] int least() const;
    [[nodiscard]] bool on() const { return on_; }
    /// For the picture on the screen; null until it is computed, and while it is off.
    [[nodiscard]] const std::shared_ptr<const ConfidencePicture>& made() const { return made_; }
    /// true: a comparison uses the views; false: it has released them.
    void hideForComparison(bool toAnother);
    /// Confidence of the edge at this cell, percent; empty if the cell is not an edge or the value is unknown.
    [[nodiscard]] std::optional<int> at(std::size_t cell) const;

signals:
    /// The known values or the shown picture changed.
    void changed();

private:
    struct Asked {
        std::uint64_t number = 0;
        std::shared_ptr<const Picture> picture;
        std::shared_ptr<const edges::EdgeConfidence> known; // null: must be computed
        bool shown = false;                                 // false: only a card needs it, nothing is drawn
        int leastPercent = 0;
        EdgeColours colours;
    };
    struct Answer {
        std::uint64_t number = 0;
        std::shared_ptr<const edges::EdgeConfidence> known; // null: cancelled
        std::shared_ptr<const ConfidencePicture> made;
    };
    [[nodiscard]] Answer workOut(const Asked& asked); // worker's thread
    void followCard();
    void begin();
    void ask();
    void take(const Answer& answer);
    void failed(const QString& what);
    void show();
    void updateCards();
    [[nodiscard]] bool possible() const;
    [[nodiscard]] bool needed() const;

    Engine& engine_;
    LinkedViews& views_;
    Targets& targets_;
    ConfidenceLegend& legend_;
    Memory& memory_;
    bool on_ = false, hiddenForComparison_ = false;
    bool forCard_ = false; // the card shows a cell with an edge
    bool running_ = false, failed_ = false;
    std::shared_ptr<const edges::EdgeConfidence> known_; // of the picture on the screen, for views and cards
    std::shared_ptr<const ConfidencePicture> made_;
    std::shared_ptr<const EdgesInstead> shown_; // as passed to the views
    QTimer quiet_;
    std::atomic<std::uint64_t> wanted_{0};
    Newest<Asked, Answer> worker_; // last member: its thread uses the members above
};

} // namespace edgescan::ui
