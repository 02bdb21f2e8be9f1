// How the scan itself looks: the points of the cloud by range, height or line, and the window of the range image.
#pragma once

#include "ui/cloud/cloud_colours.h"
#include "ui/panel/range_window.h"
#include "ui/session/newest.h"
#include "ui/session/session.h"

#include <QObject>

namespace edgescan::ui {

class LinkedViews;
class Memory;
class ScalePlate;

/// GUI thread only; colours and histogram are made on a thread of its own. What it is given must outlive it.
class ScanLook : public QObject {
    Q_OBJECT
public:
    ScanLook(Session& session, LinkedViews& views, ScalePlate& plate, RangeWindow& window, Memory& memory);

    void setColourBy(ColourBy by);
    [[nodiscard]] ColourBy colourBy() const { return by_; }
    /// What is shown is of the cloud on the screen.
    [[nodiscard]] bool settled() const { return posted_ == answered_; }

private:
    struct Asked {
        int number = 0;
        std::shared_ptr<const Scan> scan;
        std::shared_ptr<const CloudGeometry> cloud;
        ColourBy by = ColourBy::Nothing;
    };
    struct Answer {
        int number = 0;
        RangeHistogram histogram;
        CloudColours colours;
    };
    void follow();
    void ask();
    void take(const Answer& answer);
    void showWindow();

    Session& session_;
    LinkedViews& views_;
    ScalePlate& plate_;
    RangeWindow& window_;
    Memory& memory_;
    ColourBy by_ = ColourBy::Nothing;
    std::shared_ptr<const CloudGeometry> asked_; // that the newest question was about
    int posted_ = 0, answered_ = 0;
    Newest<Asked, Answer> worker_; // last
};

} // namespace edgescan::ui
