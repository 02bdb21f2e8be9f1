// How sure each edge is: worked out while nobody turns anything, shown in place of the plain edges.
#pragma once

#include "ui/confidence/confidence_picture.h"
#include "ui/session/newest.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>
#include <optional>

namespace edgescan::ui {

class ConfidenceLegend;
class LinkedViews;
class Memory;
class Session;
struct EdgesInstead;

/// GUI thread only. What it is given must outlive it. Gives way to a comparison that is shown.
class Confidence : public QObject {
    Q_OBJECT
public:
    Confidence(Session& session, LinkedViews& views, ConfidenceLegend& legend, Memory& memory);
    ~Confidence() override;

    void setOn(bool on);
    /// Edges surer than that are shown alone, percent.
    void setLeast(int percent);
    [[nodiscard]] int least() const;
    [[nodiscard]] bool on() const { return on_; }
    /// Of the picture on the screen; null until it is known, and while it is off.
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
        int leastPercent = 0;
        EdgeColours colours;
    };
    struct Answer {
        std::uint64_t number = 0;
        std::shared_ptr<const ConfidencePicture> made; // null: given up
    };
    [[nodiscard]] Answer workOut(const Asked& asked); // worker's thread
    void follow();
    void ask();
    void take(const Answer& answer);
    void show();

    Session& session_;
    LinkedViews& views_;
    ConfidenceLegend& legend_;
    Memory& memory_;
    bool on_ = false, gaveWay_ = false;
    std::shared_ptr<const ConfidencePicture> made_;
    std::shared_ptr<const EdgesInstead> shown_; // as it was given to the views
    QTimer quiet_;
    std::atomic<std::uint64_t> wanted_{0};
    std::shared_ptr<const ConfidencePicture> last_; // worker's thread only
    Newest<Asked, Answer> worker_;                  // last: its thread uses all of the above
};

} // namespace edgescan::ui
