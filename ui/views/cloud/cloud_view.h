// The 3D view: the cloud once in the graphics memory, edges as a list of cells, mouse.
#pragma once

#include "ui/base/cell_marks.h"
#include "ui/base/gestures.h"
#include "ui/base/marks.h"
#include "ui/base/touch.h"
#include "ui/views/cloud/camera_motion.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/cloud_layer.h"
#include "ui/views/cloud/drawing_budget.h"
#include "ui/views/cloud/edge_cells.h"
#include "ui/views/cloud/ground_grid.h"
#include "ui/views/cloud/point_pick.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QColor>
#include <QImage>
#include <QPolygonF>
#include <QString>
#include <QTimer>
#include <Qt>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

enum class MousePreset { Default, CloudCompare };
enum class DragAction { None, Rotate, Pan, Zoom, Roll, Select };
enum class WheelAction { Zoom, PointSize, NearClip, FarClip };

[[nodiscard]] DragAction dragAction(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, MousePreset preset = MousePreset::Default);
[[nodiscard]] WheelAction wheelAction(Qt::KeyboardModifiers modifiers);

class CloudOverlay;
class CloudScene;

/// GUI thread only. The application must call QSurfaceFormat::setDefaultFormat(CloudView::surfaceFormat()) before it makes QApplication,
/// and checkGl() before it makes a CloudView.
class CloudView : public QVTKOpenGLNativeWidget {
    Q_OBJECT
public:
    using CellIndices = std::vector<std::uint32_t>;
    enum class Camera { Reset, Keep };
    enum class Points { AsShown, All };
    enum class EdgesOver { AsAsked, Always }; ///< whether edges are drawn over faces

    explicit CloudView(QWidget* parent = nullptr);
    ~CloudView() override;

    /// VTK's format with 0 samples: without a graphics card multi-sampling quadruples the time.
    [[nodiscard]] static QSurfaceFormat surfaceFormat();

    /// Takes a cloud made on the worker thread by makeCloudGeometry(*scan). Keep: the camera does not move, for a growing live scan. Drops
    /// the edges, which belong to the old scan. Null pointers empty the view.
    void setCloud(std::shared_ptr<const Scan> scan, std::shared_ptr<const CloudGeometry> geometry, Camera camera = Camera::Reset);
    /// The same for callers that can wait: makes the geometry in this thread.
    void setScan(std::shared_ptr<const Scan> scan);
    /// Names of the directions, while the cloud that is shown is a part of what is to come. Empty: those of the cloud.
    void setAxes(const std::optional<ViewFrame>& axes) { axes_ = axes; }
    [[nodiscard]] bool axesSet() const { return axes_.has_value(); }
    [[nodiscard]] const ViewFrame& axes() const;
    /// Cells k = line * beams + beam, ascending. Replaces only an index list; setting the same pointer again is free.
    void setEdges(EdgeCells cells);
    void setEdges(std::shared_ptr<const CellIndices> cells) { setEdges(EdgeCells{std::move(cells), {}}); }
    /// A colour for each point instead of the cloud's gray (CloudScene::setFaces). While faces are shown, edges are drawn only if `edges`
    /// or setEdgesOverFaces() requests them.
    void setFaces(std::shared_ptr<const CellIndices> colours, EdgesOver edges = EdgesOver::AsAsked);
    [[nodiscard]] const std::shared_ptr<const CellIndices>& faces() const { return faces_; }
    void setEdgesOverFaces(bool on);
    /// Clouds of other scans, drawn with this one; their points cannot be picked. They stay when setCloud() replaces the cloud: their
    /// places belong to the new one, or they have to be replaced.
    void setLayers(std::vector<CloudLayer> layers);
    [[nodiscard]] const std::vector<CloudLayer>& layers() const { return layers_; }
    /// Point colours of the cloud `of`, used where no faces are shown; edges are drawn over them. Null: gray.
    void setColours(std::shared_ptr<const CloudGeometry> of, std::shared_ptr<const CellIndices> colours);
    /// The current colours of the points: faces, else colours of this cloud; null: gray.
    [[nodiscard]] std::shared_ptr<const CellIndices> pointColours() const;
    /// Cells along an outline, drawn white; null: no outline.
    void setOutline(std::shared_ptr<const CellIndices> cells);
    [[nodiscard]] const std::shared_ptr<const CellIndices>& outline() const { return outline_; }
    [[nodiscard]] const std::shared_ptr<const Scan>& scan() const { return scan_; }
    /// The scan whose frame the cloud is shown in; null: its own. A of a comparison is shown in the frame of B.
    void setFrameOf(std::shared_ptr<const Scan> scan) { frameOf_ = std::move(scan); }
    [[nodiscard]] const std::shared_ptr<const Scan>& frameOf() const { return frameOf_ ? frameOf_ : scan_; }
    [[nodiscard]] const std::shared_ptr<const CloudGeometry>& geometryOfCloud() const { return cloud_; }

    [[nodiscard]] bool edgesVisible() const { return edgesVisible_; }
    [[nodiscard]] bool shaded() const { return shaded_; }
    /// Spacing of the lines of the ground grid, metres; 0: the grid is hidden.
    [[nodiscard]] double groundStepM() const { return groundStepM_; }
    [[nodiscard]] double pointSize() const { return pointSize_; }
    /// The factor on a point size that follows the spacing; empty: the size is fixed.
    [[nodiscard]] std::optional<double> pointSizeFactor() const { return sizeFollows_ ? std::optional(sizeFactor_) : std::nullopt; }
    [[nodiscard]] const CloudClip& clip() const { return clip_; }
    [[nodiscard]] QColor background() const { return background_; }
    [[nodiscard]] const EdgeColours& edgeColours() const { return edgeColours_; }
    [[nodiscard]] bool edgesByClass() const { return byClass_; }
    [[nodiscard]] bool isParallel() const { return pose_.parallel; }
    [[nodiscard]] bool isTurntable() const { return turntable_; }

    /// In local coordinates: add geometryOfCloud()->originM for the coordinates of the scan.
    [[nodiscard]] CameraPose camera() const { return pose_; }
    void setCamera(const CameraPose& pose);
    [[nodiscard]] Eigen::Vector3d rotationCentre() const { return centre_; }

    /// The marked cell: a ring at the point and the laser ray to it; dashed if other points hide the point.
    void setMarkedCell(std::optional<std::uint32_t> cell);
    [[nodiscard]] std::optional<std::uint32_t> markedCell() const { return marked_; }
    /// Text over the picture: "no scan open" ... Empty = the view's own text ("no scan open", "no point to show").
    void setNote(const QString& note);
    /// What a tool draws, widget pixels; empty: nothing.
    void setDrawn(const QPolygonF& line);
    void setPictureFrame(const PictureFrame& frame);
    /// A short text next to the marked cell. Empty = no text.
    void setTip(const QString& text);
    [[nodiscard]] const QString& tip() const { return tip_; }
    [[nodiscard]] const PictureFrame& pictureFrame() const { return pictureFrame_; }
    /// Replaces targets and measurements.
    void setMarks(CellMarks marks);
    [[nodiscard]] const CellMarks& marks() const { return marks_; }
    /// Sets the effect of dragging with the left button.
    void setDragTool(DragTool tool);
    /// The left button counts as a finger: a resting press is a right click.
    void setForGloves(bool on) { touch_.setMouseIsFinger(on); }
    /// Cells, ascending, drawn in the colour of the selection; null: no selection.
    void setSelection(std::shared_ptr<const CellIndices> cells);
    [[nodiscard]] const std::shared_ptr<const CellIndices>& selection() const { return selection_; }
    /// One byte per cell: 1 = the cell is neither drawn nor pickable. Null, or a number of cells that differs from the cloud's: no cell is
    /// hidden.
    void setHidden(std::shared_ptr<const std::vector<std::uint8_t>> hidden);
    [[nodiscard]] const std::shared_ptr<const std::vector<std::uint8_t>>& hidden() const { return hidden_; }
    /// The current projection of the points to the screen, device pixels.
    [[nodiscard]] ScreenView screenView() const;

    /// The point drawn under a widget position, within 8 px; an edge that is drawn over the pixel before nearer points.
    [[nodiscard]] std::optional<std::uint32_t> cellAt(QPointF pixel) const;
    /// The cell without a return whose beam goes through the widget position, where no point is drawn. It looks at all cells.
    [[nodiscard]] std::optional<std::uint32_t> holeAt(QPointF pixel) const;
    /// The widget position of a cell's point; empty if the point is behind the camera or not valid.
    [[nodiscard]] std::optional<QPointF> pixelOf(std::uint32_t cell) const;

    /// True if no drawing is pending: the shown frame is final.
    [[nodiscard]] bool atRest() const { return !restTimer_.isActive() && !framePending_ && nextPart_ == 0; }
    /// Share of the valid points in the shown frame; 1 = all.
    [[nodiscard]] double drawnFraction() const { return drawnFraction_; }
    [[nodiscard]] double lastFrameMs() const { return lastFrameMs_; }
    /// Number of frames that VTK really drew (a repaint without changes draws none).
    [[nodiscard]] int framesDrawn() const { return framesDrawn_; }

    /// Finishes pending drawing and returns the picture with marker and texts, in device pixels.
    [[nodiscard]] QImage grabFrame(Points points = Points::AsShown);
    struct Sample {
        Eigen::Vector3f point;
        std::optional<QPointF> pixel; ///< empty: not in front of the camera
    };
    /// About 2,000 points of the cloud, of all lines and beams.
    [[nodiscard]] std::vector<Sample> samples() const;

public slots:
    void viewFromScanner();
    /// As if the cloud were this one, of the same scanner.
    void frameFromScanner(const CloudGeometry& cloud);
    /// Of the points, those within the picture, whatever hides them, 0 .. 1: of half a turn, a quarter fits one.
    [[nodiscard]] double shareInPicture() const;
    void viewFront();
    void viewBack();
    void viewLeft();
    void viewRight();
    void viewTop();
    void viewBottom();
    void viewIsometric();
    void resetView(); ///< the scanner's view, without clipping
    /// All but single far points, in the direction of the camera. Where only zoomed or moved, the scanner's view is first what it was.
    void zoomToFit();
    /// CloudScene::keepReady().
    void keepReady(const std::shared_ptr<const CloudGeometry>& cloud);
    /// Looks from the scanner's side at these cells and some of their surroundings. A few cells at the rim may be outside the view.
    void lookAtCells(const CellIndices& cells);
    /// True of pixels that are in the view and that nothing is over now.
    [[nodiscard]] std::function<bool(QPointF)> freePixels() const;
    /// Keeps direction and distance; the point becomes the focus.
    void centreOn(const Eigen::Vector3d& point);
    void zoomToCells(const edgescan::ui::CloudView::CellIndices& cells);
    void flyTo(qint64 cell); ///< looks at the point from nearby; it becomes the centre of rotation
    void setParallel(bool on);
    void setTurntable(bool on); ///< off = free rotation
    void setEdgesVisible(bool on);
    void setCloudDimmed(bool on);     ///< off = the cloud stays bright under edges
    void setGround(bool on);          ///< a grid below the rocks
    void setShaded(bool on);          ///< off = the cloud is one flat gray
    void setPointSize(double pixels); ///< 1 .. 12; then fixed
    /// On: the size follows the spacing of the points and the zoom, so that surfaces are closed and dense points do not merge.
    void setPointSizeFollows(bool on, double factor = 1.0);
    void setClip(const edgescan::ui::CloudClip& clip);
    void largerPoints() { changePointSize(+1); }
    void smallerPoints() { changePointSize(-1); }
    void setBackground(const QColor& colour);
    void setEdgeColours(const edgescan::ui::EdgeColours& colours);
    void setEdgesByClass(bool on); ///< off: drawnColours()
    void setMousePreset(edgescan::ui::MousePreset preset) { mousePreset_ = preset; }
    void setWheelReversed(bool on) { wheelReversed_ = on; }

signals:
    void hovered(qint64 cell);
    void hoverLeft();
    void clicked(qint64 cell);
    /// A left click at `pixel` on a target or a measurement, and the cell of the point behind its mark; -1: no point is there.
    void markClicked(const edgescan::ui::MarkName& mark, qint64 behind, QPointF pixel);
    /// The view from the scanner, unmoved since, was fitted to another size of the pane.
    void refitted();
    /// A left click where no point is drawn ...
    void missed(QPointF pixel);
    /// ... and where a point of a layer is drawn in front: its index.
    void layerClicked(int layer);
    /// End of a drag with a selecting tool: its corners, widget pixels.
    void outlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    void contextMenuRequested(const QPoint& globalPosition, qint64 cell); ///< cell -1: the position is outside the cloud
    void drawnFractionChanged(double fraction);
    void frameDrawn(double ms);
    void pointSizeChanged(double pixels);
    void parallelChanged(bool on);
    void turntableChanged(bool on);
    /// Another cloud, or other points of it, are drawn.
    void pointsChanged();
    /// on: faces cover the edges, which are therefore not drawn; off: they are drawn again.
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
    static constexpr std::size_t kMarksAsked = 20; // with more targets only the marked one is tested for points in front of it
    static constexpr int kRestMs = 160;            // pause after the last movement before the full picture is drawn

    void requestFrame();
    void refine();
    [[nodiscard]] int leastPart() const;
    void moved(int restMs = kRestMs); // the camera is moving: coarse picture now, full picture after a pause
    void applyCamera();
    void applyColours();
    void changePointSize(int steps);
    void usePointSize(double pixels);
    /// As drawn, device pixels: whole ones, and rounded up, because a smaller point leaves a black line between two scan lines.
    [[nodiscard]] double pixelsOfPoint() const;
    [[nodiscard]] double pixelsOfEdge() const;
    [[nodiscard]] bool edgesDrawn() const;
    [[nodiscard]] std::optional<std::uint32_t> edgeAt(QPointF pixel) const;
    void followSpacing();
    void fitPane();
    void updateOverlay();
    void look(const Eigen::Vector3d& forward, const Eigen::Vector3d& up);
    void look(const Eigen::Vector3d& forward, const Eigen::Vector3d& up, const Box3f& all);
    [[nodiscard]] std::optional<QPointF> pixelIn(const ScreenView& view, const Eigen::Vector3f& point) const;
    void drag(QPointF at);
    void selectTo(QPointF at);
    void showParts();
    void showGround();
    void guessBudget();
    [[nodiscard]] const ScreenMarks& marksOnScreen();
    [[nodiscard]] std::optional<MarkName> markUnder(QPointF pixel) const;
    [[nodiscard]] std::optional<std::uint32_t> chosenCell() const;
    /// In the plane of the screen; empty: the cell is in view.
    [[nodiscard]] std::optional<QPointF> wayOutTo(std::uint32_t cell) const;
    /// Goes to the chosen point, if the arrow to it is at this place.
    bool followArrow(QPointF pixel);
    void setRotationCentre(QPointF pixel);
    void showFocus();
    void pinch(QPointF middle, QPointF shift, double factor);
    void pointAt(std::optional<std::uint32_t> cell);
    void pointAgain();
    void wheelZoom(QPointF pixel, double notches);
    void wheelClip(double& share, double notches);
    [[nodiscard]] double aspect() const;
    [[nodiscard]] CloudGeometry extent() const;
    void placeLayers();
    [[nodiscard]] std::optional<int> layerInFront(QPointF pixel, const std::optional<std::uint32_t>& of) const;
    [[nodiscard]] Eigen::Vector3d anchorAt(QPointF pixel) const;

    std::unique_ptr<CloudScene> scene_;
    CloudOverlay* overlay_ = nullptr; // child widget, owned by Qt
    std::shared_ptr<const Scan> scan_, frameOf_;
    std::shared_ptr<const CloudGeometry> cloud_;
    EdgeCells edges_;
    std::shared_ptr<const CloudGeometry> whole_; // the cloud with all cells; cloud_ differs from it while cells are hidden
    std::vector<CloudLayer> layers_;
    Box3f layersBounds_, layersMain_; // local
    std::shared_ptr<const CellIndices> faces_, outline_, selection_;
    std::shared_ptr<const CloudGeometry> colouredCloud_;
    std::shared_ptr<const CellIndices> colours_; // the point colours of setColours()
    bool ground_ = false;
    double groundStepM_ = 0.0; // of the drawn grid; compared after each frame
    std::shared_ptr<const std::vector<std::uint8_t>> hidden_;
    CellMarks marks_;
    std::optional<ScreenMarks> screenMarks_; // marks_ projected by the camera; empty: must be computed
    QPolygonF dragged_;                      // while something is being selected, widget pixels
    DragTool tool_ = DragTool::Move;
    bool edgesOverFaces_ = false, edgesCovered_ = false;
    EdgesOver edgesOver_ = EdgesOver::AsAsked;

    CameraPose pose_;
    std::optional<CameraPose> framed_;                 // of all of the cloud, from the scanner
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero(); // centre of rotation
    Eigen::Vector3d asked_ = Eigen::Vector3d::Zero();  // direction of the last view by name
    CloudClip clip_;
    bool turntable_ = true, edgesVisible_ = true, cloudDimmed_ = true, shaded_ = true, byClass_ = false, wheelReversed_ = false;
    double pointSize_ = 2.0;
    bool sizeFollows_ = false;
    double sizeFactor_ = 1.0; // the operator's factor on a size that follows the spacing
    QColor background_{48, 48, 48};
    EdgeColours edgeColours_ = kUsualColours;
    MousePreset mousePreset_ = MousePreset::Default;
    QString note_, tip_;
    PictureFrame pictureFrame_;

    DragAction drag_ = DragAction::None;
    Press press_;
    Touch touch_{*this, [this](QPointF middle, QPointF shift, double factor) { pinch(middle, shift, factor); }};
    Eigen::Vector3d turnAxis_ = Eigen::Vector3d::UnitZ(); // of the turntable, while a drag turns
    Eigen::Vector3d dragAnchor_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d wheelAnchor_ = Eigen::Vector3d::Zero();
    QPointF wheelAt_{-1e9, -1e9};
    std::optional<QPointF> pointer_; // over the cloud, without a drag
    std::optional<std::uint32_t> hoveredCell_, marked_;

    DrawingBudget budget_;
    QTimer restTimer_; // active = the camera (or a slider) is moving
    bool framePending_ = true, drawAll_ = false;
    std::optional<ViewFrame> axes_;
    bool growing_ = false; // the cloud replaced a shorter one of the same scan
    int nextPart_ = 0;     // next part of the drawing order; above 0: it is drawn over the frame before
    double drawnFraction_ = 1.0, lastFrameMs_ = 0.0;
    int framesDrawn_ = 0;
};

} // namespace edgescan::ui
