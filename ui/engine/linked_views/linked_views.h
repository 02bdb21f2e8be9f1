// Links the two images and the cloud: the same picture, the same cell under the mouse, the same place while a scan grows.
#pragma once

#include "core/edges/explain/cell_values.h"
#include "core/inspect/measure/near_side.h"
#include "ui/base/cell_marks.h"
#include "ui/base/gestures.h"
#include "ui/base/marks.h"
#include "ui/engine/linked_views/scene.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/views/cloud/camera_motion.h"

#include <QLine>
#include <QObject>

#include <array>
#include <optional>
#include <vector>

class QMenu;
class QPolygonF;

namespace edgescan::ui {

class CloudView;
class ImageView;
struct EdgeTrail;

/// The meaning of a click or a drag over a view.
enum class Tool { Pin, Measure, Box, Lasso, Why };

/// GUI thread only. Engine and views must outlive it.
class LinkedViews : public QObject {
    Q_OBJECT
public:
    LinkedViews(const Engine& engine, ImageView& gray, ImageView& edges, CloudView& cloud);

    /// A new picture is on the screen.
    void followPicture();
    /// The engine has a coarse picture, which can be turned and zoomed, but its cells cannot be pointed at. Or its opening ended without a
    /// picture.
    void followCoarse();
    /// The picture in all views; null before the first picture.
    [[nodiscard]] const std::shared_ptr<const Picture>& shown() const { return state_.flippedTo ? state_.flippedTo : picture_; }
    /// Of the engine: what clicks, marks and measurements are of, also while another picture is shown.
    [[nodiscard]] const std::shared_ptr<const Picture>& picture() const { return picture_; }
    /// Why a click is refused while another picture is shown.
    [[nodiscard]] static QString onlyOfB();
    [[nodiscard]] ImageView& gray() { return *images_[0]; }
    [[nodiscard]] ImageView& edges() { return *images_[1]; }
    [[nodiscard]] CloudView& cloud() { return cloud_; }

    /// The cell in the status bar: under the mouse, else the pinned one.
    [[nodiscard]] std::optional<std::size_t> marked() const { return hovered_ ? hovered_ : pinned_; }
    [[nodiscard]] std::optional<std::size_t> hovered() const { return hovered_; }
    /// Sends probed() again: what is said of the cell depends on more than the picture.
    void probeAgain() { hover(hovered_, nullptr); }
    /// How far apart two cells are drawn in the view that the pointer was in last, device-independent pixels; empty: one is not drawn
    /// there.
    [[nodiscard]] std::optional<double> pixelsBetween(std::size_t a, std::size_t b) const;
    /// Where the visible views draw it, in pixels of the screen.
    [[nodiscard]] QVector<QPoint> onScreen(std::size_t cell) const;
    [[nodiscard]] std::optional<std::size_t> pinned() const { return pinned_; }
    [[nodiscard]] std::optional<std::size_t> cellAt(int line, int beam) const;
    /// Sets the cell of the crosshair.
    void pin(std::optional<std::size_t> cell);
    /// The cell that a click means: on the near side of an edge, or the nearest measured one.
    [[nodiscard]] inspect::ClickedCell nearSideCell(std::size_t clicked) const;
    /// Pins like a click. If one target follows the clicks, it moves there.
    void pinByClick(const inspect::ClickedCell& click);
    /// With the tool in use.
    void click(const inspect::ClickedCell& click);
    /// The menu of a cell, the same in every view and in lists of cells; empty: only what concerns no cell.
    void openMenu(const QPoint& position, const std::optional<inspect::ClickedCell>& click);
    /// While pinChanged() is emitted: the click that pins.
    [[nodiscard]] const std::optional<inspect::ClickedCell>& pinningClick() const { return byClick_; }
    /// Clears the pinned cell and the box; its target stays.
    void clearPin();
    /// Off: a click with the tool Pin sets no target.
    void setPinsOnClick(bool on);
    [[nodiscard]] bool pinsOnClick() const { return pinsOnClick_; }
    /// On: a click with the tool Pin chooses the rock or the target that is there. It sets a new target only with Shift.
    void setChoosesOnly(bool on);
    [[nodiscard]] bool choosesOnly() const { return choosesOnly_; }
    /// Whether a click sets a target with the modifiers that are pressed now. Ctrl selects several rocks.
    [[nodiscard]] bool clickPins() const;
    void setTool(Tool tool);
    [[nodiscard]] Tool tool() const { return tool_; }
    /// Sets targets and measurements in all views.
    void setMarks(CellMarks marks);
    [[nodiscard]] const CellMarks& marks() const { return marks_; }
    [[nodiscard]] bool isTarget(std::size_t cell) const;
    /// The cells along a section, surface by surface, as a line in all views; empty: none.
    void setCut(std::vector<std::vector<std::size_t>> cut);
    /// Sides of cells in the images (corners: x = beam, y = line), and the cells along them in the cloud, ascending; empty: no outline.
    /// It ends with its scan.
    void setOutline(const std::vector<QLine>& sides, std::vector<std::uint32_t> cells);
    /// As if the mouse were over the cell in a view outside of these.
    void pointAt(std::optional<std::size_t> cell);
    void flyToHovered();
    void setTrail(const EdgeTrail& trail);
    /// Marks cells in all views, each with its words, until there is another scan.
    void setExplained(const std::vector<std::pair<std::size_t, QString>>& cells);
    /// x = beam, y = line.
    [[nodiscard]] QPoint placeOf(std::size_t cell) const;

    void setNote(const QString& note);
    /// What a tool waits for, before the note; empty: no tool.
    void setAsked(const QString& words);
    /// In the cloud below the note; images have no shape.
    void setShapeNote(const QString& note);
    /// Of all views: the picture does not follow the scanner.
    void setPictureFrame(const PictureFrame& frame);
    /// As the operator asked.
    void setEdgesOverImage(bool on);
    /// Also if the operator did not ask for them: no other view shows them.
    void setOnlyImage(bool on);
    void setEdgesByClass(bool on);
    [[nodiscard]] bool edgesByClass() const { return state_.byClass; }
    /// Replaces the overlay of this name.
    void put(Overlay overlay);
    void remove(OverlayName name);
    /// What the views show.
    [[nodiscard]] const Scene& scene() const { return scene_; }
    /// Shows another picture with the same number of lines and beams in all views, which keep their place. Null, or a new picture of the
    /// engine, ends it. Meanwhile no mark is drawn and no cell can be clicked: both belong to the engine's picture.
    void flipTo(std::shared_ptr<const Picture> other);
    [[nodiscard]] bool flipped() const { return state_.flippedTo != nullptr; }
    void setEdgeColours(const EdgeColours& colours);
    [[nodiscard]] const EdgeColours& edgeColours() const { return state_.colours; }
    /// Width and height of a pixel follow the angles between beams and lines; off: square pixels.
    void setTrueAngles(bool on);
    /// All of the cloud and of the images, without clipping; the cloud's direction stays.
    void fitAll();
    /// Zooms the cloud about its focus point if it has the keyboard focus; else the images about the marked cell.
    void zoomBy(double factor);
    /// The ranges drawn from black to white in the range image; empty: scaled by the method. Valid until another scan is opened, unless it
    /// is locked.
    void setRangeWindow(const std::optional<RangeSpan>& window);
    [[nodiscard]] const std::optional<RangeSpan>& rangeWindow() const { return state_.window; }
    void keepRangeWindow(bool on) { windowKept_ = on; }
    /// The ranges shown at present, whether chosen by the operator or automatic.
    [[nodiscard]] RangeSpan rangesShown() const;

signals:
    void flippedChanged(bool on);
    void probed(const std::optional<edgescan::edges::Probe>& probe);
    void toolChanged();
    void edgeColoursChanged();
    /// Another cell is pinned, or the pin was cleared.
    void pinChanged(std::optional<std::size_t> cell);
    /// A click on a cell in any view, with any tool; Pin has pinned it.
    void clicked(const edgescan::inspect::ClickedCell& click);
    /// A click that chooses a measurement: its index in marks().
    void measureClicked(std::size_t index);
    /// End of a selecting drag over an image: corners in cells (x = beam, y = line) ...
    void imageOutlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// ... and over the cloud: corners in pixels of its view.
    void cloudOutlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// Another file, scanner or recording is shown: cells of the previous scan are invalid. Where the same file was opened again, as with
    /// another pose, its points may be at the same places in the cloud.
    void newScanShown(bool atSamePlaces);
    void rangeWindowChanged();
    /// An image has new content: other ranges or edges, or other colours.
    void picturesChanged();
    /// The menu of a cell is about to open: receivers may add actions.
    void cellMenuOpens(QMenu& menu, const edgescan::inspect::ClickedCell& click);
    /// Text about the content of the box that was dragged over an image.
    void boxed(const QString& words);

private:
    void showNote();
    [[nodiscard]] std::optional<std::size_t> visibleCellAt(const ImageView& view, int line, int beam) const;
    void linkImages();
    void linkCloud();
    [[nodiscard]] bool refusesClicks(QWidget& view) const;
    void openMenuAt(const QPoint& position, std::optional<std::size_t> cell);
    void clickAt(std::size_t cell);
    bool clickMark(const MarkName& mark, std::optional<std::size_t> behind);
    void clickHole(QPointF pixel);
    void lookAtBox(const QRect& cells);
    std::vector<std::uint32_t> showBox();
    void showMarks();
    void showCoarse();
    void draw();
    void applyScene();
    void showNewScan(const Picture* same);
    void showMoreLines(const Picture& last);
    void frameFirstLines(const CameraPose& before);
    void followSweep(const Picture& last, bool untouched);
    void showEndOfSweep();
    void fitToSweep();
    void nameDirections();
    void hover(std::optional<std::size_t> cell, const QObject* from);
    void changeRangeWindow(int window, int level);
    void applyAspect();

    const Engine& engine_;
    std::array<ImageView*, 2> images_; // gray, edges
    CloudView& cloud_;
    std::shared_ptr<const Picture> picture_;      // of the engine
    std::shared_ptr<const CoarsePicture> coarse_; // on the screen until the first picture of its scan
    SceneState state_;
    Overlays overlays_;
    Scene scene_;
    std::optional<std::size_t> hovered_;
    const QObject* hoveredIn_ = nullptr; // the view that the pointer was in last
    std::optional<std::size_t> pinned_;
    Tool tool_ = Tool::Pin;
    bool pinsOnClick_ = true, choosesOnly_ = false;
    QString note_, asked_, shapeNote_;
    CameraPose fittedCamera_; // while the camera equals it, the operator has not moved it
    bool fitted_ = false;     // to the whole sweep
    int framedLines_ = 0;     // the first lines that the view shows, while the view of the whole sweep has them outside
    bool windowKept_ = false;
    bool trueAngles_ = false;
    bool edgesAsked_ = false, onlyImage_ = false; // over the range image
    std::optional<QRect> box_;                    // of cells, as dragged
    CellMarks marks_;
    std::vector<std::vector<std::size_t>> cut_;
    std::vector<TargetMark> explained_;
    std::optional<inspect::ClickedCell> byClick_;
};

} // namespace edgescan::ui
