// Draws the cube of directions and reads clicks on its faces.
#include "ui/views/cloud/view_cube.h"

#include "ui/base/gestures.h"
#include "ui/views/cloud/cloud_view.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>

namespace edgescan::ui {
namespace {

constexpr int kSide = 92;                 // px of the widget
constexpr double kHalf = 25.0;            // px: half an edge of the cube
constexpr double kLeastTowardsEye = 0.05; // faces seen more edge-on have no area to click

/// A face: its outward direction and one of its edges, along right, forward and up of the cloud.
struct CubeFace {
    ViewCube::Face face;
    const char* name;
    Eigen::Vector3d out, along;
    void (CloudView::*look)();
};

const std::array<CubeFace, 6>& cubeFaces() {
    using Face = ViewCube::Face;
    static const std::array<CubeFace, 6> faces{{
        {Face::Front, QT_TRANSLATE_NOOP("QObject", "Front"), {0, -1, 0}, {1, 0, 0}, &CloudView::viewFront},
        {Face::Back, QT_TRANSLATE_NOOP("QObject", "Back"), {0, 1, 0}, {-1, 0, 0}, &CloudView::viewBack},
        {Face::Left, QT_TRANSLATE_NOOP("QObject", "Left"), {-1, 0, 0}, {0, -1, 0}, &CloudView::viewLeft},
        {Face::Right, QT_TRANSLATE_NOOP("QObject", "Right"), {1, 0, 0}, {0, 1, 0}, &CloudView::viewRight},
        {Face::Top, QT_TRANSLATE_NOOP("QObject", "Top"), {0, 0, 1}, {1, 0, 0}, &CloudView::viewTop},
        {Face::Bottom, QT_TRANSLATE_NOOP("QObject", "Bottom"), {0, 0, -1}, {1, 0, 0}, &CloudView::viewBottom},
    }};
    return faces;
}

} // namespace

ViewCube::ViewCube(CloudView* cloud) : cloud_(cloud) {
    setObjectName("view-cube");
    setMouseTracking(true);
    setCursor(Qt::PointingHandCursor);
    setToolTip(tr("Click a face: look at the cloud from there") + "\n" + tr("Without a pose, up is the scanner's z"));
    setFixedSize(kSide, kSide);
    connect(cloud, &CloudView::frameDrawn, this, &ViewCube::follow);
    cloud->installEventFilter(this);
    hide();
}

void ViewCube::setWanted(bool on) {
    wanted_ = on;
    follow();
}

void ViewCube::setForGloves(bool on) {
    forGloves_ = on;
    follow();
}

bool ViewCube::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::HideToParent) hide(); // a frame shows it
    return QWidget::eventFilter(watched, event);
}

void ViewCube::follow() {
    const auto& cloud = cloud_->geometryOfCloud();
    setVisible(wanted_ && !forGloves_ && cloud && cloud->validCount > 0 && cloud_->isVisible());
    if (isHidden()) return;
    const CameraPose pose = cloud_->camera();
    const ViewFrame& axes = cloud_->axes();
    const auto inCloud = [&axes](const Eigen::Vector3d& way) {
        return Eigen::Vector3d(way.dot(axes.right), way.dot(axes.forward), way.dot(axes.up));
    };
    Eigen::Matrix3d turn;
    turn.row(0) = inCloud(pose.right());
    turn.row(1) = inCloud(pose.up);
    turn.row(2) = inCloud(pose.forward());
    if (turn == turn_) return;
    turn_ = turn;
    visibleFaces_.clear();
    for (const CubeFace& face : cubeFaces()) {
        const double towardsEye = -turn.row(2).dot(face.out);
        if (towardsEye < kLeastTowardsEye) continue;
        const Eigen::Vector3d across = face.out.cross(face.along);
        VisibleFace one{face.face, {}, towardsEye};
        for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            const Eigen::Vector3d corner = turn * (face.out + a * face.along + b * across);
            one.corners << QPointF(kSide / 2.0 + kHalf * corner.x(), kSide / 2.0 - kHalf * corner.y());
        }
        visibleFaces_.push_back(one);
    }
    update();
}

std::optional<ViewCube::Face> ViewCube::at(QPointF pixel) const {
    for (const VisibleFace& each : visibleFaces_) {
        if (each.corners.containsPoint(pixel, Qt::OddEvenFill)) return each.face;
    }
    return std::nullopt;
}

std::optional<QPointF> ViewCube::middleOf(Face face) const {
    const auto found = std::ranges::find(visibleFaces_, face, &VisibleFace::face);
    if (found == visibleFaces_.end()) return std::nullopt;
    return (found->corners[0] + found->corners[2]) / 2.0;
}

void ViewCube::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont letters = painter.font();
    letters.setPixelSize(12);
    painter.setFont(letters);
    for (const VisibleFace& each : visibleFaces_) {
        const int light = static_cast<int>(56 + 60 * each.towardsEye);
        painter.setPen(QPen(QColor(0x63, 0x68, 0x6e), 1.0));
        painter.setBrush(under_ == each.face ? QColor(0x1f, 0x4f, 0x80) : QColor(light, light, light));
        painter.drawPolygon(each.corners);
        if (each.towardsEye < 0.4) continue; // too narrow for letters
        const QString name = QObject::tr(cubeFaces()[static_cast<std::size_t>(each.face)].name);
        const QRectF room(*middleOf(each.face) - QPointF(kHalf, kHalf), QSizeF(2 * kHalf, 2 * kHalf));
        painter.setPen(QColor(0xe8, 0xe8, 0xe8));
        painter.drawText(room, Qt::AlignCenter, painter.fontMetrics().elidedText(name, Qt::ElideRight, static_cast<int>(2 * kHalf)));
    }
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
    const auto now = at(ui::place(*event));
    if (now == under_) return;
    under_ = now;
    update();
}

/// The press does not reach the cloud under the cube.
void ViewCube::mousePressEvent(QMouseEvent* event) { event->accept(); }

void ViewCube::mouseReleaseEvent(QMouseEvent* event) {
    if (const auto face = at(ui::place(*event))) (cloud_->*cubeFaces()[static_cast<std::size_t>(*face)].look)();
}

void ViewCube::leaveEvent(QEvent* /*event*/) {
    under_.reset();
    update();
}

} // namespace edgescan::ui

#include "moc_view_cube.cpp"
