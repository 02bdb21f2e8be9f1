// How sure each edge is: worked out while nobody turns anything, shown in place of the plain edges and on the card of a target on an edge.
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

/// GUI thread only. What it is given must outlive it. Gives way to a comparison that is shown.
class Confidence : public QObject {
    Q_OBJECT
public:
    Confidence(Engine& engine, LinkedViews& views, Targets& targets, ConfidenceLegend& legend, Memory& memory);
    ~Confidence() override;

    /// A new picture is on the screen.
    void followPicture();
    void setOn(bool on);
    /// Edges surer than that are shown alone, percent.
    void setLeast(int percent);
    [[nodiscard]] int least() const;
    [[nodiscard]] bool on() const { return on_; }
    /// Of the picture on the screen; null until it is made, and while it is off.
    [[nodiscard]] const std::shared_ptr<const ConfidencePicture>& made() const { return made_; }
    /// A comparison takes the views, or gives them back.
    void giveWay(bool toAnother);
    /// Percent of the edge in this cell; empty where there is none or it is not known.
    [[nodiscard]] std::optional<int> at(std::size_t cell) const;

signals:
    /// Something else is known, or shown.
    void changed();

private:
    struct Asked {
        std::uint64_t number = 0;
        std::shared_ptr<const Picture> picture;
        std::shared_ptr<const EdgeConfidence> known; // null: to be worked out
        bool shown = false;                          // false: for a card alone, nothing is drawn
        int leastPercent = 0;
        EdgeColours colours;
    };
    struct Answer {
        std::uint64_t number = 0;
        std::shared_ptr<const EdgeConfidence> known; // null: given up
        std::shared_ptr<const ConfidencePicture> made;
    };
    [[nodiscard]] Answer workOut(const Asked& asked); // worker's thread
    void followCard();
    void begin();
    void ask();
    void take(const Answer& answer);
    void failed(const QString& what);
    void show();
    void tellCards();
    [[nodiscard]] bool possible() const;
    [[nodiscard]] bool needed() const;

    Engine& engine_;
    LinkedViews& views_;
    Targets& targets_;
    ConfidenceLegend& legend_;
    Memory& memory_;
    bool on_ = false, gaveWay_ = false;
    bool forCard_ = false; // the card is that of a cell with an edge
    bool underWay_ = false, failed_ = false;
    std::shared_ptr<const EdgeConfidence> known_; // of the picture on the screen, whoever asked for it
    std::shared_ptr<const ConfidencePicture> made_;
    std::shared_ptr<const EdgesInstead> shown_; // as it was given to the views
    QTimer quiet_;
    std::atomic<std::uint64_t> wanted_{0};
    Newest<Asked, Answer> worker_; // last: its thread uses all of the above
};

} // namespace edgescan::ui
