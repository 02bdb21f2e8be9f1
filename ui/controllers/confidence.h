// Edge confidence: computed while the operator changes nothing, shown instead of the plain edges and on the card of a target on an edge.
#pragma once

#include "ui/engine/worker_bridge/derived.h"
#include "ui/panels/confidence/confidence_picture.h"

#include <QObject>

#include <memory>
#include <optional>

namespace edgescan::ui {

class ConfidenceLegend;
class LinkedViews;
class Preferences;
class Engine;
class Targets;

/// GUI thread only. The objects passed to it must outlive it. Hidden while a comparison is shown.
class Confidence : public QObject {
    Q_OBJECT
public:
    Confidence(Engine& engine, LinkedViews& views, Targets& targets, ConfidenceLegend& legend, Preferences& preferences);

    /// A new picture is on the screen.
    void followPicture();
    void setOn(bool on);
    /// Only edges with at least this confidence are shown, percent.
    void setLeast(int percent);
    [[nodiscard]] int least() const;
    [[nodiscard]] bool on() const { return on_; }
    /// For the picture on the screen; null until it is computed, and while it is off.
    [[nodiscard]] const std::shared_ptr<const ConfidencePicture>& made() const { return made_; }
    /// Confidence of the edge at this cell, percent; empty if the cell is not an edge or the value is unknown.
    [[nodiscard]] std::optional<int> at(std::size_t cell) const;

signals:
    /// The known values or the shown picture changed.
    void changed();

private:
    struct Drawing {
        std::shared_ptr<const Picture> picture;
        std::shared_ptr<const edges::EdgeConfidence> known;
        int leastPercent = 0;
        EdgeColours colours;
    };
    [[nodiscard]] std::shared_ptr<const edges::EdgeConfidence> workOut(const Picture& picture, const Asker& asker); // pool's thread
    void followCard();
    void begin();
    void draw();
    void failed(const QString& what);
    void show();
    void updateCards();
    [[nodiscard]] bool possible() const;
    [[nodiscard]] bool needed() const;

    Engine& engine_;
    LinkedViews& views_;
    Targets& targets_;
    ConfidenceLegend& legend_;
    Preferences& preferences_;
    bool on_ = false;
    bool forCard_ = false; // the card shows a cell with an edge
    bool failed_ = false;
    std::shared_ptr<const edges::EdgeConfidence> known_; // of the picture on the screen, for views and cards
    std::shared_ptr<const ConfidencePicture> made_;
    Derived<std::shared_ptr<const Picture>, edges::EdgeConfidence> confidence_;
    Derived<Drawing, ConfidencePicture> drawn_; // last
};

} // namespace edgescan::ui
