// The cube of directions: it turns with the camera, and a click on a face looks at the cloud from there.
#pragma once

#include <Eigen/Core>

#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace edgescan::ui {

class CloudView;

/// GUI thread only. Hidden while the view is, or has no point.
class ViewCube : public QWidget {
    Q_OBJECT
public:
    explicit ViewCube(CloudView* cloud);

    enum class Face { Front, Back, Left, Right, Top, Bottom };
    /// Where a face is seen; empty: it points away.
    [[nodiscard]] std::optional<QPointF> middleOf(Face face) const;
    /// Off: hidden.
    void setWanted(bool on);
    /// Its faces are too small for gloves: hidden.
    void setForGloves(bool on);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct VisibleFace {
        Face face = Face::Front;
        QPolygonF corners;
        double towardsEye = 0.0; ///< 0 .. 1
    };
    void follow();
    [[nodiscard]] std::optional<Face> at(QPointF pixel) const;

    CloudView* cloud_;
    Eigen::Matrix3d turn_ = Eigen::Matrix3d::Zero(); // rows: right, up and forward of the camera in the axes of the cloud
    std::vector<VisibleFace> visibleFaces_;          // the faces that point at the eye
    std::optional<Face> under_;                      // the mouse
    bool wanted_ = true, forGloves_ = false;
};

} // namespace edgescan::ui
