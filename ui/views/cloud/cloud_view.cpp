// The 3D view: the drawn layers, when they are drawn, and how many points. The mouse is in cloud_view_mouse.cpp, the camera in
// cloud_view_camera.cpp.
#include "ui/views/cloud/cloud_view.h"

#include "ui/base/count_text.h"
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/views/cloud/cloud_scene.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPixmap>
#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

using Eigen::Vector3d;

constexpr double kGuessMsPerPoint = 2.5e-4; // for llvmpipe on a busy machine; used until frames are measured
constexpr int kGrowingRestMs = 800;         // a growing cloud is drawn in full after this pause without new points
constexpr double kFocusShare = 0.03;        // radius of the focal sphere / half height of the view
constexpr double kLargestPoint = 12.0;      // px
constexpr double kFactorPerStep = 1.25;     // of a point size that follows the spacing
const QColor kCloudDimmed(121, 121, 121);   // dark enough to see edges in front of it
const QColor kCloudBright(230, 230, 230);

// Wide enough to see a line of single cells, but narrow enough that two lines do not merge.
double edgeSizeFor(double pointSize) { return std::max(2.5, 1.25 * pointSize); }

} // namespace

DragAction dragAction(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, MousePreset preset) {
    if (button == Qt::LeftButton) {
        if (modifiers & Qt::ShiftModifier) return DragAction::Pan;
        if (modifiers & Qt::ControlModifier) return DragAction::Roll;
        return DragAction::Rotate;
    }
    const bool cloudCompare = preset == MousePreset::CloudCompare;
    if (button == Qt::MiddleButton) return cloudCompare ? DragAction::Zoom : DragAction::Pan;
    if (button == Qt::RightButton) return cloudCompare ? DragAction::Pan : DragAction::Zoom;
    return DragAction::None;
}

WheelAction wheelAction(Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ControlModifier) return modifiers & Qt::ShiftModifier ? WheelAction::FarClip : WheelAction::NearClip;
    if (modifiers & Qt::AltModifier) return WheelAction::PointSize;
    return WheelAction::Zoom;
}

QSurfaceFormat CloudView::surfaceFormat() {
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0);
    return format;
}

CloudView::CloudView(QWidget* parent) : QVTKOpenGLNativeWidget(parent), scene_(std::make_unique<CloudScene>(renderWindow())) {
    interactor()->SetInteractorStyle(nullptr);    // this class handles the mouse itself
    setContextMenuPolicy(Qt::PreventContextMenu); // right drag zooms; cloud_view_mouse.cpp separates clicks from drags
    pose_.viewAngleDeg = 60.0;
    overlay_ = new CloudOverlay(this);
    overlay_->setGeometry(rect());
    restTimer_.setSingleShot(true);
    connect(&restTimer_, &QTimer::timeout, this, [this] {
        if (drag_ == DragAction::None) scene_->hideFocus();
        growing_ = false;
        pointAgain();
        requestFrame();
    });
    applyColours();
    applyCamera();
    updateOverlay();
}

CloudView::~CloudView() = default;

void CloudView::setCloud(std::shared_ptr<const Scan> scan, std::shared_ptr<const CloudGeometry> geometry, Camera camera) {
    const std::shared_ptr<const CloudGeometry> before = cloud_;
    scan_ = std::move(scan);
    whole_ = std::move(geometry);
    hidden_ = nullptr;
    screenMarks_.reset();
    cloud_ = whole_;
    edges_ = {};
    outline_ = nullptr;
    selection_ = nullptr;
    if (std::exchange(faces_, nullptr)) applyColours();
    marked_ = std::nullopt;
    pointer_.reset();
    pointAt(std::nullopt);
    scene_->setCloud(cloud_);
    scene_->setFaces(pointColours());
    if (!layers_.empty()) placeLayers();
    showGround();
    growing_ = camera == Camera::Keep && before && cloud_ && before->validCount > 0 && cloud_->validCount > 0;
    if (growing_) {
        budget_.grown(static_cast<double>(before->validCount) / static_cast<double>(cloud_->validCount));
    } else if (!cloud_ || !before || before->validCount / 2 > cloud_->validCount || cloud_->validCount / 2 > before->validCount) {
        guessBudget();
    }
    restTimer_.start(growing_ ? kGrowingRestMs : kRestMs); // shows a coarse picture at once; a growing scan stays coarse
    if (growing_) {
        const Vector3d shift = before->originM - cloud_->originM;
        pose_.position += shift;
        pose_.focus += shift;
        centre_ += shift;
        applyCamera();
    } else {
        resetView();
    }
}

void CloudView::guessBudget() {
    std::size_t points = cloud_ ? cloud_->validCount : 0;
    for (const CloudLayer& layer : layers_) points += layer.cloud->validCount;
    budget_.restart(kGuessMsPerPoint * static_cast<double>(points));
}

void CloudView::setScan(std::shared_ptr<const Scan> scan) {
    std::shared_ptr<const CloudGeometry> geometry = scan ? makeCloudGeometry(*scan) : nullptr;
    setCloud(std::move(scan), std::move(geometry));
}

void CloudView::setEdges(EdgeCells cells) {
    if (cells == edges_) return;
    edges_ = std::move(cells);
    scene_->setEdges(edges_);
    // A slider may be moving: the coarse cloud follows it, the full cloud is drawn when the slider rests.
    restTimer_.start(growing_ ? kGrowingRestMs : kRestMs);
    requestFrame();
}

void CloudView::setFaces(std::shared_ptr<const CellIndices> colours, EdgesOver edges) {
    if (colours == faces_ && edges == edgesOver_) return;
    edgesOver_ = edges;
    faces_ = std::move(colours);
    scene_->setFaces(pointColours());
    restTimer_.start(growing_ ? kGrowingRestMs : kRestMs); // as for edges
    applyColours();
}

void CloudView::setEdgesOverFaces(bool on) {
    edgesOverFaces_ = on;
    applyColours();
}

void CloudView::setOutline(std::shared_ptr<const CellIndices> cells) {
    if (cells == outline_) return;
    outline_ = std::move(cells);
    scene_->setOutline(outline_);
    requestFrame();
}

void CloudView::setTip(const QString& text) {
    if (text == tip_) return;
    tip_ = text;
    updateOverlay();
}

void CloudView::requestFrame() {
    nextPart_ = 0; // from the beginning
    framePending_ = true;
    update(); // Qt merges these calls: at most one is pending
}

void CloudView::moved(int restMs) {
    restTimer_.start(restMs);
    applyCamera();
}

void CloudView::applyCamera() {
    screenMarks_.reset();
    scene_->setCamera(pose_, clipRange(pose_, extent(), clip_.nearShare, clip_.farShare));
    followSpacing();
    updateOverlay();
    requestFrame();
    if (!restTimer_.isActive()) pointAgain();
}

double CloudView::pixelsOfEdge() const { return std::round(edgeSizeFor(pointSize_) * devicePixelRatioF()); }

bool CloudView::edgesDrawn() const { return edgesVisible_ && (!faces_ || edgesOverFaces_ || edgesOver_ == EdgesOver::Always); }

void CloudView::applyColours() {
    CloudLook look;
    look.background = background_;
    look.shaded = shaded_;
    look.cloud = cloudDimmed_ && edgesVisible_ ? kCloudDimmed : kCloudBright;
    look.edge = drawnColours(edgeColours_, byClass_);
    look.pointSize = pixelsOfPoint();
    look.edgeSize = pixelsOfEdge();
    look.halo = std::floor(devicePixelRatioF());
    look.edges = edgesDrawn();
    scene_->setLook(look);
    requestFrame();
    const bool covered = edgesVisible_ && !look.edges;
    if (std::exchange(edgesCovered_, covered) != covered) emit edgesCovered(covered);
}

void CloudView::initializeGL() {
    QVTKOpenGLNativeWidget::initializeGL();
    framePending_ = true;
}

void CloudView::resizeEvent(QResizeEvent* event) {
    QVTKOpenGLNativeWidget::resizeEvent(event);
    overlay_->setGeometry(rect());
    fitPane();
    if (!cloud_ || framed_ != pose_) return;
    frameFromScanner(*cloud_);
    emit refitted();
}

/// Sizes in pixels belong to the pane's height and to the device pixel ratio.
void CloudView::fitPane() {
    screenMarks_.reset();
    followSpacing();
    updateOverlay();
    applyColours();
}

void CloudView::paintGL() {
    if (!framePending_) {
        QVTKOpenGLNativeWidget::paintGL(); // shows the frame that VTK drew last
        return;
    }
    framePending_ = false;
    const bool moving = restTimer_.isActive();
    CloudScene::Parts parts{nextPart_, nextPart_, nextPart_ > 0, moving};
    // When the camera rests, a first share is drawn in the final size. The other parts follow on top of it, one per frame, so that no frame
    // takes long.
    if (nextPart_ == 0) parts.last = drawAll_ ? kCloudParts - 1 : std::max(budget_.lastPart(moving), leastPart());
    const bool uploads = scene_->setParts(parts);
    updateSize(); // makes VTK draw again in paintGL()
    QElapsedTimer clock;
    clock.start();
    QVTKOpenGLNativeWidget::paintGL();
    context()->functions()->glFinish(); // without it the clock measures only the sending of commands
    lastFrameMs_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    ++framesDrawn_;

    const double fraction = cloud_ ? kPartEnds[static_cast<std::size_t>(parts.last)] : 1.0;
    const bool changed = fraction != drawnFraction_;
    drawnFraction_ = fraction;
    // The upload of a cloud to the graphics memory is not part of a frame's time. For a growing cloud it is, because every frame has one.
    if ((!uploads || growing_) && cloud_ && !parts.onTop) budget_.measured(fraction, lastFrameMs_);
    nextPart_ = cloud_ && !moving ? (parts.last + 1) % kCloudParts : 0;
    // Slots must not run inside a paint event.
    QMetaObject::invokeMethod(
        this,
        [this, changed, ms = lastFrameMs_] {
            if (nextPart_ > 0 && !framePending_) refine();
            if (changed) emit drawnFractionChanged(drawnFraction_);
            emit frameDrawn(ms);
        },
        Qt::QueuedConnection);
}

/// On a busy machine too, enough evenly spread points are drawn to show the shape of the rocks.
int CloudView::leastPart() const {
    constexpr double kLeastPoints = 60'000;
    const double share = cloud_ && cloud_->validCount > 0 ? kLeastPoints / static_cast<double>(cloud_->validCount) : 1.0;
    const auto part = std::ranges::find_if(kPartEnds, [share](double end) { return end >= std::min(share, 1.0); });
    return static_cast<int>(part - kPartEnds.begin());
}

void CloudView::refine() {
    framePending_ = true;
    update();
}

QImage CloudView::grabFrame(Points points) {
    drawAll_ = points == Points::All;
    if (drawAll_) requestFrame(); // otherwise the grab shows the current frame, or draws the pending one
    const QImage image = grab().toImage();
    drawAll_ = false;
    return image;
}

void CloudView::setCamera(const CameraPose& pose) {
    const bool switched = pose.parallel != pose_.parallel;
    pose_ = pose;
    centre_ = pose.focus;
    applyCamera();
    if (switched) emit parallelChanged(pose_.parallel);
}

void CloudView::setNote(const QString& note) {
    note_ = note;
    updateOverlay();
}

void CloudView::setDrawn(const QPolygonF& line) {
    dragged_ = line;
    updateOverlay();
}

void CloudView::setPictureFrame(const PictureFrame& frame) {
    if (std::exchange(pictureFrame_, frame) != frame) updateOverlay();
}

void CloudView::setMarkedCell(std::optional<std::uint32_t> cell) {
    if (cell == marked_) return;
    marked_ = cell;
    // with many targets only the marked one is tested for points in front of it
    if (marks_.targets.size() > kMarksAsked) screenMarks_.reset();
    updateOverlay();
}

void CloudView::updateOverlay() {
    OverlayMarks marks;
    marks.frame = pictureFrame_;
    marks.tip = tip_;
    if (!cloud_) {
        marks.centreText = note_.isEmpty() ? tr("no scan open") : note_;
    } else if (cloud_->validCount == 0 && whole_->validCount > 0) {
        marks.centreText =
            tr("no point to show: all %1 points are hidden; Measure > Show All shows them").arg(countText(whole_->validCount));
        marks.note = note_;
    } else if (cloud_->validCount == 0) {
        marks.centreText = tr("no point to show: no cell of this scan has a valid range");
        marks.note = note_;
    } else {
        marks.note = note_;
    }
    // A tip describes the point under the mouse. The ring may belong to a target, which does not move with the mouse.
    const bool pinned =
        std::ranges::any_of(marks_.targets, [&](const TargetMark& target) { return target.active && target.cell == marked_; });
    const auto describedCell = hoveredCell_ ? hoveredCell_ : pinned ? std::nullopt : marked_;
    if (describedCell && !tip_.isEmpty()) marks.tipAt = pixelOf(*describedCell);
    marks.dragged = dragged_;
    if (cloud_ && !marks_.empty()) marks.marks = marksOnScreen();
    if (marked_ && cloud_ && cloud_->drawable(*marked_)) {
        const ScreenView view = screenView();
        marks.ring = pixelOf(*marked_);
        marks.hidden = marks.ring && isPointHidden(*cloud_, view, *marked_);
        const auto ray = screenSegment(view, cloud_->sensor, cloud_->point(*marked_));
        const double dpr = devicePixelRatioF();
        if (ray) marks.ray = QLineF(ray->x0 / dpr, ray->y0 / dpr, ray->x1 / dpr, ray->y1 / dpr);
    }
    if (const auto cell = chosenCell()) marks.way = wayOutTo(*cell);
    overlay_->setMarks(marks);
}

void CloudView::setEdgesVisible(bool on) {
    edgesVisible_ = on;
    applyColours();
}

void CloudView::setCloudDimmed(bool on) {
    cloudDimmed_ = on;
    applyColours();
}

void CloudView::setShaded(bool on) {
    if (on == shaded_) return;
    shaded_ = on;
    applyColours();
}

void CloudView::setPointSize(double pixels) {
    sizeFollows_ = false;
    usePointSize(pixels);
}

void CloudView::usePointSize(double pixels) {
    const double size = std::clamp(pixels, 1.0, kLargestPoint);
    if (size == pointSize_) return;
    pointSize_ = size;
    screenMarks_.reset();
    applyColours();
    emit pointSizeChanged(size);
}

void CloudView::setPointSizeFollows(bool on, double factor) {
    sizeFollows_ = on;
    sizeFactor_ = std::clamp(factor, 1.0 / 8, 8.0);
    followSpacing();
}

void CloudView::changePointSize(int steps) {
    if (!sizeFollows_) return setPointSize(pointSize_ + steps);
    // The factor does not change where the clamped sizes would not change.
    sizeFactor_ = std::clamp(sizeFactor_ * std::pow(kFactorPerStep, steps), 1.0 / 8, 8.0);
    followSpacing();
}

void CloudView::followSpacing() {
    if (!sizeFollows_ || !cloud_ || cloud_->validCount == 0) return;
    const double pixels = spacingOnScreen(*cloud_, pose_, height());
    usePointSize(std::clamp(pixels * sizeFactor_, 1.0, kLargestPoint));
}

void CloudView::setBackground(const QColor& colour) {
    background_ = colour;
    applyColours();
}

void CloudView::setEdgeColours(const EdgeColours& colours) {
    edgeColours_ = colours;
    applyColours();
}

void CloudView::setEdgesByClass(bool on) {
    byClass_ = on;
    applyColours();
}

void CloudView::showFocus() {
    const double depth = pose_.parallel ? pose_.distance() : std::abs(pose_.forward().dot(centre_ - pose_.position));
    scene_->showFocus(centre_, kFocusShare * pose_.halfHeight() * depth / pose_.distance());
}

} // namespace edgescan::ui

#include "moc_cloud_view.cpp"
