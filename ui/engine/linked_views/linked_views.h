// Links the two images and the cloud: the same picture, the same cell under the mouse, the same place while a scan grows.
#pragma once

#include "core/edges/explain/probe.h"
#include "ui/base/gestures.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/views/cloud/camera_motion.h"

#include <QObject>

#include <array>
#include <optional>

class QMenu;
class QPolygonF;

namespace edgescan::ui {

class CloudView;
class ImageView;
struct EdgeTrail;
struct CellMarks;

/// The meaning of a click or a drag over a view.
enum class Tool { Pin, Measure, Box, Lasso };

/// Drawn instead of the picture's edges, on the picture's grid.
struct EdgesInstead {
    EdgeCells cells; ///< by class, in these colours
    EdgeColours colours;
    std::shared_ptr<const QImage> map, overlay;               ///< of the edge map, and over the range image
    std::shared_ptr<const std::vector<std::uint32_t>> points; ///< colours of the points of the cloud; null: unchanged
    bool overlayAsAsked = false;                              ///< over the range image only if edges are shown there
    QString words{};                                          ///< the meaning of the colours, appended to the title of the edge map
};

/// GUI thread only. Engine and views must outlive it.
class LinkedViews : public QObject {
    Q_OBJECT
public:
    LinkedViews(const Engine& engine, ImageView& gray, ImageView& edges, CloudView& cloud);

    /// A new picture is on the screen.
    void followPicture();
    /// The picture in all views; null before the first picture.
    [[nodiscard]] const std::shared_ptr<const Picture>& shown() const { return shown_; }
    [[nodiscard]] ImageView& gray() { return *images_[0]; }
    [[nodiscard]] ImageView& edges() { return *images_[1]; }
    [[nodiscard]] CloudView& cloud() { return cloud_; }

    /// The clicked cell until it is cleared; else the cell under the mouse.
    [[nodiscard]] std::optional<std::size_t> marked() const { return pinned_ ? pinned_ : hovered_; }
    [[nodiscard]] std::optional<std::size_t> pinned() const { return pinned_; }
    [[nodiscard]] std::optional<std::size_t> cellAt(int line, int beam) const;
    /// Sets the cell of the crosshair.
    void pin(std::optional<std::size_t> cell);
    /// Pins like a click. If one target follows the clicks, it moves there.
    void pinByClick(std::size_t cell);
    [[nodiscard]] bool pinnedByClick() const { return byClick_; }
    /// Clears the pinned cell and the box.
    void clearPin();
    void setTool(Tool tool);
    [[nodiscard]] Tool tool() const { return tool_; }
    /// Sets targets and measurements in all views.
    void setMarks(const CellMarks& marks);
    void flyToHovered();
    void setTrail(const EdgeTrail& trail);
    /// x = beam, y = line.
    [[nodiscard]] QPoint placeOf(std::size_t cell) const;

    void setNote(const QString& note);
    void setStale(const QString& why);
    void setOverlay(bool on);
    void setEdgesByClass(bool on);
    [[nodiscard]] bool edgesByClass() const { return byClass_; }
    /// Valid until null is set, or the picture has another size.
    void setEdgesInstead(std::shared_ptr<const EdgesInstead> instead);
    [[nodiscard]] const std::shared_ptr<const EdgesInstead>& edgesInstead() const { return instead_; }
    /// Shows another picture with the same number of lines and beams in all views, which keep their place. Null, or a new picture of the
    /// engine, ends it.
    void flipTo(std::shared_ptr<const Picture> other);
    [[nodiscard]] bool flipped() const { return flipped_ != nullptr; }
    void setEdgeColours(const EdgeColours& colours);
    [[nodiscard]] const EdgeColours& edgeColours() const { return colours_; }
    /// Width and height of a pixel follow the angles between beams and lines; off: square pixels.
    void setTrueAngles(bool on);
    void resetView();
    /// Zooms the cloud about its focus point if it has the keyboard focus; else the images about the marked cell.
    void zoomBy(double factor);
    /// The ranges drawn from black to white in the range image; empty: scaled by the method. Valid until another scan is opened, unless it
    /// is locked.
    void setRangeWindow(const std::optional<RangeSpan>& window);
    [[nodiscard]] const std::optional<RangeSpan>& rangeWindow() const { return window_; }
    void keepRangeWindow(bool on) { windowKept_ = on; }
    /// The ranges shown at present, whether chosen by the operator or automatic.
    [[nodiscard]] RangeSpan rangesShown() const;

signals:
    void probed(const std::optional<edgescan::edges::Probe>& probe);
    void toolChanged();
    void edgeColoursChanged();
    /// Another cell is pinned, or the pin was cleared.
    void pinChanged(std::optional<std::size_t> cell);
    /// The operator cleared the pinned cell; pinChanged() was emitted before.
    void pinCleared(std::size_t cell);
    /// A click on a cell with a tool other than Pin.
    void picked(std::size_t cell, Qt::KeyboardModifiers modifiers);
    /// End of a selecting drag over an image: corners in cells (x = beam, y = line) ...
    void imageOutlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// ... and over the cloud: corners in pixels of its view.
    void cloudOutlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// Another file, scanner or recording is shown: cells of the previous scan are invalid.
    void newScanShown();
    void rangeWindowChanged();
    /// An image has new content: other ranges or edges, or other colours.
    void picturesChanged();
    /// The menu of a cell is about to open in one of the views: receivers may add actions.
    void cellMenuOpens(QMenu& menu, std::size_t cell);
    /// Text about the content of the box that was dragged over an image.
    void boxed(const QString& words);

private:
    void linkImages();
    void linkCloud();
    void showCellMenu(const QPoint& position, std::optional<std::size_t> cell);
    void click(std::size_t cell);
    void lookAtBox(const QRect& cells);
    void showEdgeMap();
    void showEdgesOfCloud();
    void drawShown();
    [[nodiscard]] const EdgesInstead* insteadNow() const { return flipped_ ? nullptr : instead_.get(); }
    void showNewScan();
    void showMoreLines(const Picture& last);
    void noteFit();
    void hover(std::optional<std::size_t> cell, const QObject* from);
    void changeRangeWindow(int window, int level);
    void showRanges();
    void applyAspect();

    const Engine& engine_;
    std::array<ImageView*, 2> images_; // gray, edges
    CloudView& cloud_;
    std::shared_ptr<const Picture> shown_;
    std::optional<std::size_t> hovered_;
    std::optional<std::size_t> pinned_;
    Tool tool_ = Tool::Pin;
    CameraPose fittedCamera_; // while the camera equals it, the operator has not moved the camera, and a growing cloud may be fitted again
    int fittedLines_ = 0;
    std::optional<RangeSpan> window_;
    bool windowKept_ = false;
    bool overlay_ = false;
    bool byClass_ = false;
    EdgeColours colours_ = kUsualColours;
    std::shared_ptr<const EdgesInstead> instead_;
    std::shared_ptr<const Picture> flipped_, own_; // the picture shown during a flip, and the picture that returns after it
    bool trueAngles_ = false;
    bool byClick_ = false; // the current pin comes from a click
};

} // namespace edgescan::ui
