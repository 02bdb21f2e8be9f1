// The display of the scan itself: cloud colours by range, height, line or intensity, and the window of the range image.
#pragma once

#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/tuning/range_window.h"
#include "ui/views/cloud/cloud_colours.h"

#include <QObject>

#include <memory>
#include <optional>

namespace edgescan::ui {

class LinkedViews;
class Preferences;
class ScalePlate;

/// GUI thread only; colours and histogram are computed off the GUI thread. The objects passed to it must outlive it.
class ScanLook : public QObject {
    Q_OBJECT
public:
    ScanLook(Engine& engine, LinkedViews& views, ScalePlate& plate, RangeWindow& window, Preferences& preferences);

    /// Another picture is on the screen: of the engine, or A in its place.
    void followPicture();
    /// The choice is stored in the settings memory.
    void setColourBy(ColourBy by);
    [[nodiscard]] ColourBy colourBy() const { return by_; }
    /// True if the shown colours belong to the cloud on the screen.
    [[nodiscard]] bool settled() const { return !colours_.behind(); }
    /// Locked: the window of the range image stays when another scan is opened.
    [[nodiscard]] bool rangeLocked() const { return window_.locked(); }
    /// Of the range image; empty: as the method scales the ranges.
    [[nodiscard]] const std::optional<RangeSpan>& rangeWindow() const;
    void setRangeWindow(const std::optional<RangeSpan>& window, bool locked);

signals:
    void colourByChanged(edgescan::ui::ColourBy by);
    /// Whether the scan on the screen has intensities.
    void intensityKnown(bool some);
    /// The lock or the colours changed: session data that the views do not report.
    void changed();

private:
    struct Asked {
        std::shared_ptr<const Scan> scan;
        std::shared_ptr<const CloudGeometry> cloud;
        ColourBy by = ColourBy::Nothing;
        bool coarse = false;                             ///< its ranges are not counted
        std::shared_ptr<const RangeHistogram> counted{}; ///< set if they are known
    };
    struct Answer {
        std::shared_ptr<const RangeHistogram> histogram;
        CloudColours colours;
    };
    void followCoarse();
    void show(const Answer& answer);
    void showWindow();

    Engine& engine_;
    LinkedViews& views_;
    ScalePlate& plate_;
    RangeWindow& window_;
    Preferences& preferences_;
    ColourBy by_ = ColourBy::Nothing;
    std::weak_ptr<const CloudGeometry> coloured_; // that the newest question is about
    std::shared_ptr<const Answer> own_;           // of the engine's picture: it comes back at once after A
    Derived<Asked, Answer> colours_;              // last
};

} // namespace edgescan::ui
