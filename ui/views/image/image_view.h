// Shows one lines x beams image with linked zoom and pan, hover, crosshair and box.
#pragma once

#include "ui/base/cell_marks.h"
#include "ui/base/gestures.h"
#include "ui/base/marks.h"
#include "ui/base/touch.h"
#include "ui/views/image/pyramid.h"
#include "ui/views/image/viewport.h"

#include <QColor>
#include <QLine>
#include <QPoint>
#include <QPolygonF>
#include <QRect>
#include <QString>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QToolButton;

namespace edgescan::ui {

/// A highlighted edge chain. Cells as QPoint: x = beam, y = line.
struct EdgeTrail {
    std::vector<QPoint> cells; ///< drawn with frames, where a cell is large enough for a frame
    std::vector<QPoint> way;   ///< from the asked cell to the strong cell that keeps it in the mask (hysteresis), drawn as a line
};

/// GUI thread only. Cells as QPoint: x = beam, y = line.
class ImageView : public QWidget {
    Q_OBJECT
public:
    /// Several views may share the view port; each view keeps it alive. Null: the view makes its own.
    explicit ImageView(std::shared_ptr<ViewPort> viewPort = nullptr, QWidget* parent = nullptr);
    ~ImageView() override;

    [[nodiscard]] const std::shared_ptr<ViewPort>& viewPort() const { return viewPort_; }

    /// One pixel per cell. Setting the same pointer again is free; the image must never change. Null = empty.
    void setImage(std::shared_ptr<const QImage> image, Shrink shrink = Shrink::Average);
    /// Drawn over the image with this opacity (edges over gray); usually ARGB with a transparent background.
    void setOverlay(std::shared_ptr<const QImage> image, double opacity, Shrink shrink = Shrink::Lines);
    /// Drawn between the image and the overlay: coloured faces, transparent elsewhere. `faded`: they belong to an older picture.
    void setFaces(std::shared_ptr<const QImage> faces, bool faded = false);
    /// Shown until the next call; an empty list removes it. Sides of cells, with ends at corners of cells (x = beam, y = line).
    void setOutline(std::vector<QLine> sides);
    /// A short text next to a cell. Empty = no text.
    void setTip(const QPoint& cell, const QString& text);
    [[nodiscard]] const std::shared_ptr<const QImage>& faces() const { return faces_.image(); }
    [[nodiscard]] bool facesFaded() const { return facesFaded_; }
    [[nodiscard]] const std::vector<QLine>& outline() const { return outline_; }
    [[nodiscard]] const QString& tip() const { return tip_; }
    [[nodiscard]] const std::shared_ptr<const QImage>& image() const { return picture_.image(); }
    [[nodiscard]] const std::shared_ptr<const QImage>& overlay() const { return overlay_.image(); }

    /// The cell under the mouse in another view: ring with dark outline and centre dot.
    void setMarkedCell(std::optional<QPoint> cell);
    /// The fixed crosshair: thin lines through the cell. A click sets it in this view; the caller links the other views.
    void setCrosshair(std::optional<QPoint> cell);
    /// A selected box of cells that stays drawn; a finished Shift+drag sets it.
    void setBox(std::optional<QRect> cells);
    /// Shown until the next call; an empty trail removes it.
    void setTrail(EdgeTrail trail);
    [[nodiscard]] const EdgeTrail& trail() const { return trail_; }
    /// Replaces targets and measurements.
    void setMarks(CellMarks marks);
    [[nodiscard]] const CellMarks& marks() const { return marks_; }
    /// The tags of targets and measurements, where they were drawn last.
    [[nodiscard]] const std::vector<MarkTag>& tags() const { return tags_; }
    /// Drawn over the image and its faces, one pixel per cell: selected and hidden cells. Null = no selection.
    void setSelection(std::shared_ptr<const QImage> selection);
    [[nodiscard]] const std::shared_ptr<const QImage>& selection() const { return selection_.image(); }
    /// Sets the effect of dragging with the left button.
    void setDragTool(DragTool tool);
    /// The left button counts as a finger: a resting press is a right click.
    void setForGloves(bool on) { touch_.setMouseIsFinger(on); }
    [[nodiscard]] std::optional<QPoint> markedCell() const { return marked_; }
    [[nodiscard]] std::optional<QPoint> crosshair() const { return crosshair_; }
    [[nodiscard]] std::optional<QRect> box() const { return box_; }

    /// Areas of lost cells: amber dashes over them, of the same size at every zoom.
    void setLost(std::vector<QRect> areas);
    /// Area of lines that a sweep does not have, or not yet, x = beam, y = line: hatched. Empty: it has all.
    void setToCome(const QRect& area);
    /// Pixels at the top right that another widget covers: the texts avoid them.
    void setCovered(int pixels);
    /// Short text over the picture: "preview", "no scan open". Empty = no text.
    void setNote(const QString& note);
    [[nodiscard]] const QString& note() const { return note_; }
    void setBackground(const QColor& colour);
    void setPictureFrame(const PictureFrame& frame);
    [[nodiscard]] const PictureFrame& pictureFrame() const { return pictureFrame_; }

    /// The cell under a widget position; empty outside the image.
    [[nodiscard]] std::optional<QPoint> cellAt(QPointF pixel) const;

    [[nodiscard]] QSize sizeHint() const override { return {480, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 90}; }

signals:
    void hovered(int line, int beam);
    void hoverLeft();
    void clicked(int line, int beam);
    /// A left click on a target or a measurement, and the cell behind its mark; -1: none is there.
    void markClicked(const edgescan::ui::MarkName& mark, int line, int beam);
    /// Right click without a drag, with its position on the screen.
    void menuRequested(int line, int beam, const QPoint& position);
    void boxSelected(const QRect& cells);
    /// End of a drag with a selecting tool: its corners, in cells (x = beam, y = line).
    void outlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// Right drag, pixels since the last signal: x = window, y = level (positive downwards).
    void windowLevelDragged(int dx, int dy);
    void windowLevelFinished();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { None, Pan, WindowLevel, Box, Select };

    void drawPyramid(QPainter& painter, Pyramid& pyramid) const;
    void drawMarks(QPainter& painter) const;
    void drawRings(QPainter& painter, const QRect& plate);
    void drawLost(QPainter& painter) const;
    void drawTrail(QPainter& painter) const;
    void drawOutline(QPainter& painter) const;
    void drawTip(QPainter& painter) const;
    void drawTexts(QPainter& painter);
    void drawDragged(QPainter& painter) const;
    void offerFit();
    void pointAt(std::optional<QPoint> cell);
    void selectTo(QPointF at);
    void pinch(QPointF middle, QPointF shift, double factor);
    [[nodiscard]] QRect boxCells(QPointF from, QPointF to) const;
    [[nodiscard]] QRectF toPixels(const QRectF& cells) const;

    std::shared_ptr<ViewPort> viewPort_;
    // Before the children: event() asks it.
    Touch touch_{*this, [this](QPointF middle, QPointF shift, double factor) { pinch(middle, shift, factor); }};
    QToolButton* fit_;
    Pyramid picture_;
    Pyramid overlay_;
    double overlayOpacity_ = 1.0;
    Pyramid faces_;
    bool facesFaded_ = false;
    Pyramid selection_;
    CellMarks marks_;
    ScreenMarks screenMarks_; // as drawn last
    std::vector<MarkTag> tags_;
    std::vector<QRectF> texts_; // as drawn last
    DragTool tool_ = DragTool::Move;
    QPolygonF way_; // path of a selecting drag, in cells
    std::vector<QLine> outline_;
    QPoint tipCell_;
    QString tip_;
    std::optional<QPoint> marked_, crosshair_, hoveredCell_;
    std::optional<QRect> box_;
    EdgeTrail trail_;
    QString note_;
    PictureFrame pictureFrame_;
    int covered_ = 0;
    std::vector<QRect> lost_;
    QRect toCome_;
    QColor background_{48, 48, 48};

    Drag drag_ = Drag::None;
    Press press_;
};

} // namespace edgescan::ui
