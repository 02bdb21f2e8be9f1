// The 3D view: the cloud once in the graphics memory, edges as a list of cells, mouse.
#pragma once

#include "ui/base/cell_marks.h"
#include "ui/base/gestures.h"
#include "ui/base/touch.h"
#include "ui/views/cloud/camera_motion.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/drawing_budget.h"
#include "ui/views/cloud/edge_cells.h"
#include "ui/views/cloud/ground_grid.h"
#include "ui/views/cloud/mouse_bindings.h"
#include "ui/views/cloud/point_pick.h"

#include <QColor>
#include <QImage>
#include <QPolygonF>
#include <QString>
#include <QTimer>

#include <QVTKOpenGLNativeWidget.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

class CloudOverlay;
class CloudScene;

/// GUI thread only. The application must call QSurfaceFormat::setDefaultFormat(CloudView::surfaceFormat()) before it makes
/// QApplication, and ask checkGl() before it makes a CloudView.
class CloudView : public QVTKOpenGLNativeWidget {
    Q_OBJECT
public:
    using CellIndices = std::vector<std::uint32_t>;
    enum class Camera { Reset, Keep };
    enum class Points { AsShown, All };
    enum class EdgesOver { AsAsked, Always }; ///< edges over faces

    explicit CloudView(QWidget* parent = nullptr);
    ~CloudView() override;

    /// VTK's format with 0 samples: multi-sampling costs four times the time without a graphics card.
    [[nodiscard]] static QSurfaceFormat surfaceFormat();

    /// Takes a cloud made on the worker thread by makeCloudGeometry(*scan). Keep: a live scan that grows does not move
    /// the camera. Drops the edges, which belong to the old scan. Null pointers empty the view.
    void setCloud(std::shared_ptr<const Scan> scan, std::shared_ptr<const CloudGeometry> geometry, Camera camera = Camera::Reset);
    /// The same for callers that can wait: makes the geometry on this thread.
    void setScan(std::shared_ptr<const Scan> scan);
    /// Cells k = line * beams + beam, ascending. Replaces an index list only; the same pointer again costs nothing.
    void setEdges(EdgeCells cells);
    void setEdges(std::shared_ptr<const CellIndices> cells) { setEdges(EdgeCells{std::move(cells), {}}); }
    /// A colour for each point, instead of the cloud's gray (CloudScene::setFaces). While there are some, edges are drawn only where
    /// setEdgesOverFaces() asks for them.
    void setFaces(std::shared_ptr<const CellIndices> colours, EdgesOver edges = EdgesOver::AsAsked);
    [[nodiscard]] const std::shared_ptr<const CellIndices>& faces() const { return faces_; }
    void setEdgesOverFaces(bool on);
    /// Colours for the points of that cloud, wherever no faces are shown; edges stay over them. Null: its gray.
    void setColours(std::shared_ptr<const CloudGeometry> of, std::shared_ptr<const CellIndices> colours);
    /// What the points have now: faces, else colours of this cloud; null: gray.
    [[nodiscard]] std::shared_ptr<const CellIndices> pointColours() const;
    /// Cells along an outline, drawn white; null: none.
    void setOutline(std::shared_ptr<const CellIndices> cells);
    [[nodiscard]] const std::shared_ptr<const CellIndices>& outline() const { return outline_; }
    [[nodiscard]] const std::shared_ptr<const Scan>& scan() const { return scan_; }
    [[nodiscard]] const std::shared_ptr<const CloudGeometry>& geometryOfCloud() const { return cloud_; }

    [[nodiscard]] bool edgesVisible() const { return edgesVisible_; }
    [[nodiscard]] bool cloudDimmed() const { return cloudDimmed_; }
    [[nodiscard]] bool shaded() const { return shaded_; }
    /// Metres from line to line of the grid below the rocks; 0: it is not shown.
    [[nodiscard]] double groundStepM() const { return groundStepM_; }
    [[nodiscard]] double pointSize() const { return pointSize_; }
    /// What the size that follows the spacing is multiplied by; empty: the size stays as it is.
    [[nodiscard]] std::optional<double> pointSizeFactor() const { return sizeFollows_ ? std::optional(sizeFactor_) : std::nullopt; }
    [[nodiscard]] const CloudClip& clip() const { return clip_; }
    [[nodiscard]] QColor background() const { return background_; }
    [[nodiscard]] const EdgeColours& edgeColours() const { return edgeColours_; }
    [[nodiscard]] bool edgesByClass() const { return byClass_; }
    [[nodiscard]] MousePreset mousePreset() const { return mousePreset_; }
    [[nodiscard]] bool isParallel() const { return pose_.parallel; }
    [[nodiscard]] bool isTurntable() const { return turntable_; }

    /// Local coordinates: add geometryOfCloud()->originM for those of the scan.
    [[nodiscard]] CameraPose camera() const { return pose_; }
    void setCamera(const CameraPose& pose);
    [[nodiscard]] Eigen::Vector3d rotationCentre() const { return centre_; }

    /// The beam cursor: ring at the point and the laser ray to it; dashed when the point is hidden behind others.
    void setMarkedCell(std::optional<std::uint32_t> cell);
    [[nodiscard]] std::optional<std::uint32_t> markedCell() const { return marked_; }
    /// Text over the picture: "no scan open", "stale" ... Empty = the view's own ("no scan open", "no point to show").
    void setNote(const QString& note);
    /// Greys the picture and says why across it: it is older than it seems. Empty = none.
    void setStale(const QString& why);
    /// A short text beside the marked cell. Empty = none.
    void setTip(const QString& text);
    [[nodiscard]] const QString& tip() const { return tip_; }
    /// What holds for everything that is shown, in the upper right corner. Empty = nothing.
    void setCaption(const QString& text);
    [[nodiscard]] const QString& caption() const { return caption_; }
    /// Something stands in that corner, so many pixels from the right; 0: nothing.
    void setCaptionRoom(int pixels);
    [[nodiscard]] const QString& stale() const { return stale_; }
    /// Targets and measurements, until others are set.
    void setMarks(CellMarks marks);
    [[nodiscard]] const CellMarks& marks() const { return marks_; }
    /// What a drag with the left button does from now on.
    void setDragTool(DragTool tool);
    /// The left button is a finger: one that rests is a right click.
    void setForGloves(bool on) { touch_.setMouseIsFinger(on); }
    /// Cells, ascending, that are drawn in a colour of their own; null: none.
    void setSelection(std::shared_ptr<const CellIndices> cells);
    [[nodiscard]] const std::shared_ptr<const CellIndices>& selection() const { return selection_; }
    /// Cells that are not drawn and cannot be picked, 1 each; null: all are. Of another number of cells than the cloud: none is hidden.
    void setHidden(std::shared_ptr<const std::vector<std::uint8_t>> hidden);
    [[nodiscard]] const std::shared_ptr<const std::vector<std::uint8_t>>& hidden() const { return hidden_; }
    /// How the points lie on the screen now, device pixels.
    [[nodiscard]] ScreenView screenView() const;

    /// Point drawn under a widget position, within 8 px.
    [[nodiscard]] std::optional<std::uint32_t> cellAt(QPointF pixel) const;
    /// Where the point of a cell is drawn (widget position); none when behind the camera or not valid.
    [[nodiscard]] std::optional<QPointF> pixelOf(std::uint32_t cell) const;

    /// Nothing is under way: the frame shown is the one that stays.
    [[nodiscard]] bool atRest() const { return !restTimer_.isActive() && !framePending_ && nextPart_ == 0; }
    /// Share of the valid points in the frame shown; 1 when all.
    [[nodiscard]] double drawnFraction() const { return drawnFraction_; }
    [[nodiscard]] double lastFrameMs() const { return lastFrameMs_; }
    /// Frames that VTK really drew (a repaint without change draws none).
    [[nodiscard]] int framesDrawn() const { return framesDrawn_; }

    /// Draws what is pending and returns the picture with marker and texts, in device pixels.
    [[nodiscard]] QImage grabFrame(Points points = Points::AsShown);

public slots:
    void viewFromScanner();
    void viewFront();
    void viewBack();
    void viewLeft();
    void viewRight();
    void viewTop();
    void viewBottom();
    void viewIsometric();
    void resetView(); ///< from the scanner, clipping undone
    void zoomToFit(); ///< keeps the direction
    /// CloudScene::keepReady().
    void keepReady(const std::shared_ptr<const CloudGeometry>& cloud);
    /// From the side that the scanner saw them from, all but a few at the rim in the view, with some of what is round them.
    void lookAtCells(const CellIndices& cells);
    void zoomToCells(const edgescan::ui::CloudView::CellIndices& cells);
    void flyTo(qint64 cell); ///< looks at the point from nearby and turns about it
    void setParallel(bool on);
    void setTurntable(bool on); ///< off = free rotation
    void setEdgesVisible(bool on);
    void setCloudDimmed(bool on);     ///< off = the cloud stays bright while edges are on
    void setGround(bool on);          ///< a grid below the rocks
    void setShaded(bool on);          ///< off = the cloud is one flat gray
    void setPointSize(double pixels); ///< 1 .. 12; from then on it stays
    /// On: the size follows the spacing of the points and the zoom, so that a surface is closed and a crowd no blob.
    void setPointSizeFollows(bool on, double factor = 1.0);
    void setClip(const edgescan::ui::CloudClip& clip);
    void largerPoints() { changePointSize(+1); }
    void smallerPoints() { changePointSize(-1); }
    void setBackground(const QColor& colour);
    void setEdgeColours(const edgescan::ui::EdgeColours& colours);
    void setEdgesByClass(bool on); ///< each class in its own colour
    void setMousePreset(edgescan::ui::MousePreset preset) { mousePreset_ = preset; }
    void setWheelReversed(bool on) { wheelReversed_ = on; }

signals:
    void hovered(qint64 cell);
    void hoverLeft();
    void clicked(qint64 cell);
    /// A finished drag with a tool that selects: its corners, widget pixels.
    void outlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    void contextMenuRequested(const QPoint& globalPosition, qint64 cell); ///< cell -1: beside the cloud
    void drawnFractionChanged(double fraction);
    void frameDrawn(double ms);
    void pointSizeChanged(double pixels);
    void parallelChanged(bool on);
    void turntableChanged(bool on);
    /// Another cloud is drawn, or other points of it.
    void pointsChanged();
    /// Edges that are on are not drawn, because faces cover them; or they are drawn again.
    void edgesCovered(bool on);

protected:
    bool event(QEvent* event) override;
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    static constexpr std::size_t kMarksAsked = 20; // of more targets only the marked one is asked whether something lies before it
    static constexpr int kRestMs = 160;            // after the last movement the full picture is drawn

    void requestFrame();
    void refine();
    [[nodiscard]] int leastPart() const;
    void moved(int restMs = kRestMs); // the camera is under way: coarse picture now, full one after a pause
    void applyCamera();
    void applyColours();
    void changePointSize(int steps);
    void usePointSize(double pixels);
    void followSpacing();
    void fitPane();
    void updateOverlay();
    void look(const Eigen::Vector3d& forward, const Eigen::Vector3d& up);
    void drag(QPointF at);
    void selectTo(QPointF at);
    void showParts();
    void showGround();
    void guessBudget();
    [[nodiscard]] const ScreenMarks& marksOnScreen();
    void setRotationCentre(QPointF pixel);
    void showFocus();
    void pinch(QPointF middle, QPointF shift, double factor);
    void pointAt(std::optional<std::uint32_t> cell);
    void wheelZoom(QPointF pixel, double notches);
    void wheelClip(double& share, double notches);
    [[nodiscard]] double aspect() const;
    [[nodiscard]] Eigen::Vector3d anchorAt(QPointF pixel) const;

    std::unique_ptr<CloudScene> scene_;
    CloudOverlay* overlay_ = nullptr; // child widget, owned by Qt
    std::shared_ptr<const Scan> scan_;
    std::shared_ptr<const CloudGeometry> cloud_;
    EdgeCells edges_;
    std::shared_ptr<const CloudGeometry> whole_; // cloud_ without what is hidden is another one
    std::shared_ptr<const CellIndices> faces_, outline_, selection_;
    std::shared_ptr<const CloudGeometry> colouredCloud_;
    std::shared_ptr<const CellIndices> colours_; // of that cloud
    bool ground_ = false;
    double groundStepM_ = 0.0; // of the grid that is drawn; asked after each frame
    std::shared_ptr<const std::vector<std::uint8_t>> hidden_;
    CellMarks marks_;
    std::optional<ScreenMarks> screenMarks_; // marks_ as the camera sees them; empty: to be looked for
    QPolygonF dragged_;                      // while something is being selected, widget pixels
    DragTool tool_ = DragTool::Move;
    bool edgesOverFaces_ = false, edgesCovered_ = false;
    EdgesOver edgesOver_ = EdgesOver::AsAsked;

    CameraPose pose_;
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero(); // of rotation
    CloudClip clip_;
    bool turntable_ = true, edgesVisible_ = true, cloudDimmed_ = true, shaded_ = true, byClass_ = false, wheelReversed_ = false;
    double pointSize_ = 2.0;
    bool sizeFollows_ = false;
    double sizeFactor_ = 1.0; // where it follows: what the operator multiplied it by
    QColor background_{48, 48, 48};
    EdgeColours edgeColours_ = kUsualColours;
    MousePreset mousePreset_ = MousePreset::Default;
    QString note_, stale_, tip_, caption_;
    int captionRoom_ = 0;

    DragAction drag_ = DragAction::None;
    Press press_;
    Touch touch_{*this, [this](QPointF middle, QPointF shift, double factor) { pinch(middle, shift, factor); }};
    Eigen::Vector3d dragAnchor_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d wheelAnchor_ = Eigen::Vector3d::Zero();
    QPointF wheelAt_{-1e9, -1e9};
    std::optional<std::uint32_t> hoveredCell_, marked_;

    DrawingBudget budget_;
    QTimer restTimer_; // running = the camera (or a slider) is under way
    bool framePending_ = true, drawAll_ = false;
    bool growing_ = false; // the cloud replaced a shorter one of the same scan
    int nextPart_ = 0;     // of the drawing order; above 0: it goes on top of the frame before
    double drawnFraction_ = 1.0, lastFrameMs_ = 0.0;
    int framesDrawn_ = 0;
};

} // namespace edgescan::ui
