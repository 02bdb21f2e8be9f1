// A scale bar of the cloud, the directions of its axes, and the colour scale of its points.
#pragma once

#include "ui/views/cloud/camera_motion.h"
#include "ui/views/cloud/cloud_colours.h"
#include "ui/views/cloud/ground_grid.h"

#include <Eigen/Core>

#include <QSize>
#include <QWidget>

#include <array>
#include <optional>
#include <vector>

namespace edgescan::ui {

class CloudView;

/// GUI thread only. Follows the camera of the view; hidden while the view is, or has no point.
class ScalePlate : public QWidget {
    Q_OBJECT
public:
    explicit ScalePlate(CloudView* cloud);

    /// On: without axes and grid, for a cab.
    void setBrief(bool on);
    /// The colours of the cloud on the screen; ColourBy::Nothing: no colour scale.
    void showColours(const CloudColours& colours);
    /// "1 m at 4.9 m", the median distance of the points in view, and the length of the bar in pixels.
    [[nodiscard]] QString barText() const { return barText_; }
    [[nodiscard]] double barPixels() const { return barPixels_; }
    /// "X", "Y", "Z", or the names of the mine grid; their directions on the screen, x right, y up, 1 = in the plane of the screen.
    [[nodiscard]] const std::array<QString, 3>& axisNames() const { return names_; }
    [[nodiscard]] const std::array<Eigen::Vector2d, 3>& axesOnScreen() const { return axes_; }
    /// "Range [m]"; empty: no colours. The labels of the scale and their positions on it, 0 .. 1.
    [[nodiscard]] QString scaleTitle() const;
    [[nodiscard]] std::vector<std::pair<double, QString>> scaleTicks() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, sizeHint().height()}; } // drawn whole or not at all

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// The values that determine which points are in view.
    struct ViewInputs {
        std::shared_ptr<const CloudGeometry> cloud;
        CameraPose camera;
        CloudClip clip;
        QSize size;
        bool operator==(const ViewInputs&) const = default;
    };
    void follow();
    [[nodiscard]] double unit() const; // 1; larger with a larger font
    [[nodiscard]] QString barWords(const QString& length, double depth) const;
    [[nodiscard]] double medianDepth() const;
    [[nodiscard]] bool coloured() const;
    [[nodiscard]] QSize plain() const;   // without the colours, in units
    [[nodiscard]] double across() const; // the width in units
    void drawBar(QPainter& painter) const;
    void drawAxes(QPainter& painter) const;
    void drawColours(QPainter& painter) const;

    CloudView* cloud_;
    std::shared_ptr<const Scan> scan_; // the scan of these axes
    Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
    std::array<QString, 3> names_{"X", "Y", "Z"};
    std::array<Eigen::Vector2d, 3> axes_{};
    QString barText_, groundText_;
    double barPixels_ = 0.0;
    ViewInputs viewInputs_;
    double depth_ = 1.0; // metres, median of the points in view
    CloudColours colours_;
    bool coloured_ = false; // the points have these colours at present
    bool brief_ = false;
};

} // namespace edgescan::ui
