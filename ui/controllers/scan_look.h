// How the scan itself looks: the points of the cloud by range, height or line, and the window of the range image.
#pragma once

#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/newest.h"
#include "ui/panels/tuning/range_window.h"
#include "ui/views/cloud/cloud_colours.h"

#include <QObject>

#include <memory>
#include <optional>

namespace edgescan::ui {

class LinkedViews;
class Memory;
class ScalePlate;

/// GUI thread only; colours and histogram are made on a thread of its own. What it is given must outlive it.
class ScanLook : public QObject {
    Q_OBJECT
public:
    ScanLook(Engine& engine, LinkedViews& views, ScalePlate& plate, RangeWindow& window, Memory& memory);

    /// A new picture is on the screen.
    void followPicture();
    /// Kept in the memory.
    void setColourBy(ColourBy by);
    [[nodiscard]] ColourBy colourBy() const { return by_; }
    /// What is shown is of the cloud on the screen.
    [[nodiscard]] bool settled() const { return posted_ == answered_; }
    /// The window of the range image stays when another scan is opened.
    [[nodiscard]] bool rangeLocked() const { return window_.locked(); }
    /// Of the range image; empty: as the method scales the ranges.
    [[nodiscard]] const std::optional<RangeSpan>& rangeWindow() const;
    void setRangeWindow(const std::optional<RangeSpan>& window, bool locked);

signals:
    void colourByChanged(edgescan::ui::ColourBy by);
    /// Another lock or another colour: what a session keeps beside what the views tell.
    void changed();

private:
    struct Asked {
        int number = 0;
        std::shared_ptr<const Scan> scan;
        std::shared_ptr<const CloudGeometry> cloud;
        ColourBy by = ColourBy::Nothing;
        bool counted = false; ///< the histogram of this cloud is on the screen
    };
    struct Answer {
        int number = 0;
        std::shared_ptr<const CloudGeometry> of;
        std::optional<RangeHistogram> histogram; ///< empty: it is there already
        CloudColours colours;
    };
    void take(const Answer& answer);
    void showWindow();

    Engine& engine_;
    LinkedViews& views_;
    ScalePlate& plate_;
    RangeWindow& window_;
    Memory& memory_;
    ColourBy by_ = ColourBy::Nothing;
    std::shared_ptr<const CloudGeometry> asked_;   // that the newest question was about
    std::shared_ptr<const CloudGeometry> counted_; // that the histogram is of
    int posted_ = 0, answered_ = 0;
    Newest<Asked, Answer> worker_; // last
};

} // namespace edgescan::ui
