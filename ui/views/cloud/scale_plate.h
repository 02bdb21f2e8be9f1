// The plate in the lower right corner of the cloud: a scale bar, the directions of the axes, and the colour scale of the points.
#pragma once

#include "ui/base/view_plate.h"
#include "ui/views/cloud/camera_motion.h"
#include "ui/views/cloud/cloud_colours.h"
#include "ui/views/cloud/ground_grid.h"

#include <Eigen/Core>

#include <QPoint>
#include <QRect>
#include <QSize>

#include <array>
#include <optional>
#include <vector>

namespace edgescan::ui {

class CloudView;

/// GUI thread only. Follows the camera of the view under it, in the corner opposite to the legends. It passes the mouse through. In a
/// small view it has the bar alone, in one that is too small it is hidden.
class ScalePlate : public ViewPlate {
    Q_OBJECT
public:
    explicit ScalePlate(CloudView* cloud);

    /// Parts of the view that it must not cover: the pinned target with its label, or null, and the rings of the other targets. It stays
    /// where it is until a plate or, while the view is at rest, the pinned target is there. Over a ring it is see-through.
    void keepOff(const QRect& pinned, std::vector<QRect> rings);
    [[nodiscard]] bool isSeeThrough() const { return seeThrough_; }
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

    [[nodiscard]] bool isSmall() const { return isSmall_; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// The values that determine which points are in view.
    struct Seen {
        std::shared_ptr<const CloudGeometry> cloud;
        CameraPose camera;
        CloudClip clip;
        QSize size;
        bool operator==(const Seen&) const = default;
    };
    void follow();
    void place();
    /// Places of the other plates and of the pinned target.
    [[nodiscard]] std::vector<QRect> taken() const;
    [[nodiscard]] std::optional<QPoint> freePlace(const std::vector<QRect>& rings) const;
    bool isSmall_ = false;
    QSize view_; // in which it found its place
    QRect keptFree_;
    std::vector<QRect> rings_;
    bool seeThrough_ = false;          // it covers a ring
    [[nodiscard]] double unit() const; // 1; larger with a larger font
    [[nodiscard]] QString barWords(const QString& length, double depth) const;
    [[nodiscard]] double medianDepth() const;
    void watch(QObject* child);
    [[nodiscard]] bool coloured() const;
    [[nodiscard]] QSize plain() const; // without the colours, in units
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
    Seen seen_;
    double depth_ = 1.0; // metres, median of the points in view
    CloudColours colours_;
    bool coloured_ = false; // the points have these colours at present
};

} // namespace edgescan::ui
