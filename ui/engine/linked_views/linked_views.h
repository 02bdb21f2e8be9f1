// Keeps the two images and the cloud in step: the same picture, the same cell under the mouse, the same place while a scan grows.
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

/// What a click or a drag over a view means.
enum class Tool { Pin, Measure, Box, Lasso };

/// Drawn in place of the edges of the picture, on its grid.
struct EdgesInstead {
    EdgeCells cells; ///< by class, in these colours
    EdgeColours colours;
    std::shared_ptr<const QImage> map, overlay;               ///< of the edge map; over the range image
    std::shared_ptr<const std::vector<std::uint32_t>> points; ///< colours of the points of the cloud; null: as they are
    bool overlayAsAsked = false;                              ///< over the range image only where edges are shown there
    QString words{};                                          ///< what their colours tell, beside the title of the edge map
};

/// GUI thread only. Session and views must outlive it.
class LinkedViews : public QObject {
    Q_OBJECT
public:
    LinkedViews(const Engine& engine, ImageView& gray, ImageView& edges, CloudView& cloud);

    /// A new picture is on the screen.
    void followPicture();
    /// What all views show; null before the first picture.
    [[nodiscard]] const std::shared_ptr<const Picture>& shown() const { return shown_; }
    [[nodiscard]] ImageView& gray() { return *images_[0]; }
    [[nodiscard]] ImageView& edges() { return *images_[1]; }
    [[nodiscard]] CloudView& cloud() { return cloud_; }

    /// The cell that was clicked, until it is let go; else the one that the mouse points at.
    [[nodiscard]] std::optional<std::size_t> marked() const { return pinned_ ? pinned_ : hovered_; }
    [[nodiscard]] std::optional<std::size_t> pinned() const { return pinned_; }
    [[nodiscard]] std::optional<std::size_t> cellAt(int line, int beam) const;
    /// The cell of the crosshair.
    void pin(std::optional<std::size_t> cell);
    /// As a click does: where one pin follows the clicks, that one goes there.
    void pinByClick(std::size_t cell);
    [[nodiscard]] bool pinnedByClick() const { return byClick_; }
    /// Of the cell and of the box.
    void letGo();
    void setTool(Tool tool);
    [[nodiscard]] Tool tool() const { return tool_; }
    /// Targets and measurements, in all views.
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
    /// Until null is set, or the picture has another size.
    void setEdgesInstead(std::shared_ptr<const EdgesInstead> instead);
    [[nodiscard]] const std::shared_ptr<const EdgesInstead>& edgesInstead() const { return instead_; }
    /// Shows another picture of the same number of lines and beams in all views, which stay where they are; null, or a new picture of the
    /// session, ends it.
    void flipTo(std::shared_ptr<const Picture> other);
    [[nodiscard]] bool flipped() const { return flipped_ != nullptr; }
    void setEdgeColours(const EdgeColours& colours);
    [[nodiscard]] const EdgeColours& edgeColours() const { return colours_; }
    /// Pixels as wide and high as the angles between beams and lines are; else square.
    void setTrueAngles(bool on);
    void resetView();
    /// The cloud where it has the focus, about what it looks at; else the images, about the cell that is marked.
    void zoomBy(double factor);
    /// Which ranges the range image shows from black to white; empty: as the method scales them. Until another scan is opened, unless it is
    /// kept.
    void setRangeWindow(const std::optional<RangeSpan>& window);
    [[nodiscard]] const std::optional<RangeSpan>& rangeWindow() const { return window_; }
    void keepRangeWindow(bool on) { windowKept_ = on; }
    /// Those that are shown now, also where nobody chose them.
    [[nodiscard]] RangeSpan rangesShown() const;

signals:
    void probed(const std::optional<edgescan::Probe>& probe);
    void toolChanged();
    void edgeColoursChanged();
    /// Another cell is pinned, or none.
    void pinChanged(std::optional<std::size_t> cell);
    /// Somebody let go of the cell that was pinned; pinChanged() came before.
    void letGoOf(std::size_t cell);
    /// A click on a cell with another tool than Pin.
    void picked(std::size_t cell, Qt::KeyboardModifiers modifiers);
    /// A drag that selects, over an image: corners in cells (x = beam, y = line) ...
    void imageOutlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// ... and over the cloud: corners in pixels of its view.
    void cloudOutlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// Another file, scanner or recording is shown: no cell of before means anything.
    void newScanShown();
    void rangeWindowChanged();
    /// An image shows something else: other ranges or edges, or these in other colours.
    void picturesChanged();
    /// The menu of a cell is about to be shown, in whichever view: room for what belongs to others.
    void cellMenuOpens(QMenu& menu, std::size_t cell);
    /// What lies inside the box that was dragged over an image, in words.
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
    CameraPose fittedCamera_; // as long as the camera is there nobody moved it, and a growing cloud may be fitted again
    int fittedLines_ = 0;
    std::optional<RangeSpan> window_;
    bool windowKept_ = false;
    bool overlay_ = false;
    bool byClass_ = false;
    EdgeColours colours_ = kUsualColours;
    std::shared_ptr<const EdgesInstead> instead_;
    std::shared_ptr<const Picture> flipped_, own_; // what is shown for a while, and what comes back after it
    bool trueAngles_ = false;
    bool byClick_ = false; // the pin that is being told of
};

} // namespace edgescan::ui
