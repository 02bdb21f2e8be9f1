// Shows one lines x beams image: linked zoom and pan, hover, crosshair, box.
#pragma once

#include "ui/base/cell_marks.h"
#include "ui/base/gestures.h"
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

namespace edgescan::ui {

/// An edge chain that is pointed out. Cells as QPoint: x = beam, y = line.
struct EdgeTrail {
    std::vector<QPoint> cells;       ///< framed
    std::vector<QPoint> way;         ///< from the cell asked about to the strong one that keeps it: a line
    std::optional<QPoint> strongest; ///< ringed
};

/// GUI thread only. Cells as QPoint: x = beam, y = line.
class ImageView : public QWidget {
    Q_OBJECT
public:
    /// The view port may be shared with other views; the view keeps it alive. Null makes an own one.
    explicit ImageView(std::shared_ptr<ViewPort> viewPort = nullptr, QWidget* parent = nullptr);
    ~ImageView() override;

    [[nodiscard]] const std::shared_ptr<ViewPort>& viewPort() const { return viewPort_; }

    /// One pixel per cell. The same pointer again costs nothing; the pointed-to image must never change. Null = empty.
    void setImage(std::shared_ptr<const QImage> image, Shrink shrink = Shrink::Average);
    /// Drawn over the image with this opacity (edges over gray); usually ARGB with transparent background.
    void setOverlay(std::shared_ptr<const QImage> image, double opacity, Shrink shrink = Shrink::KeepBrightest);
    /// Drawn between the two: coloured faces, transparent where there are none. `faded`: they belong to an older picture.
    void setFaces(std::shared_ptr<const QImage> faces, bool faded = false);
    /// Stays until another one, or an empty one, is set: sides of cells, ends as corners of cells (x = beam, y = line).
    void setOutline(std::vector<QLine> sides);
    /// A short text beside a cell. Empty = none.
    void setTip(const QPoint& cell, const QString& text);
    [[nodiscard]] const std::shared_ptr<const QImage>& faces() const { return faces_.image(); }
    [[nodiscard]] bool facesFaded() const { return facesFaded_; }
    [[nodiscard]] const std::vector<QLine>& outline() const { return outline_; }
    [[nodiscard]] const QString& tip() const { return tip_; }
    [[nodiscard]] const QString& title() const { return title_; }
    [[nodiscard]] const std::shared_ptr<const QImage>& image() const { return picture_.image(); }
    [[nodiscard]] const std::shared_ptr<const QImage>& overlay() const { return overlay_.image(); }

    /// The cell hovered in another view: ring with dark outline and centre dot.
    void setMarkedCell(std::optional<QPoint> cell);
    /// The sticky crosshair: thin lines through the cell. A click sets it in this view; the caller links the others.
    void setCrosshair(std::optional<QPoint> cell);
    /// Box of cells that stays drawn (a selection); a finished Shift+drag sets it.
    void setBox(std::optional<QRect> cells);
    /// Stays until another one, or an empty one, is set.
    void setTrail(EdgeTrail trail);
    [[nodiscard]] const EdgeTrail& trail() const { return trail_; }
    /// Targets and measurements, until others are set.
    void setMarks(CellMarks marks);
    [[nodiscard]] const CellMarks& marks() const { return marks_; }
    /// Drawn over the image and its faces, one pixel per cell: what is selected, and what is hidden. Null = nothing.
    void setSelection(std::shared_ptr<const QImage> selection);
    [[nodiscard]] const std::shared_ptr<const QImage>& selection() const { return selection_.image(); }
    /// What a drag with the left button does from now on.
    void setDragTool(DragTool tool);
    /// The left button is a finger: one that rests is a right click.
    void setForGloves(bool on) { touch_.setMouseIsFinger(on); }
    /// Off: Esc belongs to somebody else, crosshair and box stay.
    void setClearsOnEscape(bool on) { clearsOnEscape_ = on; }
    [[nodiscard]] std::optional<QPoint> markedCell() const { return marked_; }
    [[nodiscard]] std::optional<QPoint> crosshair() const { return crosshair_; }
    [[nodiscard]] std::optional<QRect> box() const { return box_; }

    void setTitle(const QString& title);
    /// Short text over the picture: "preview", "stale", "no scan open". Empty = none.
    void setNote(const QString& note);
    [[nodiscard]] const QString& note() const { return note_; }
    void setBackground(const QColor& colour);
    /// Greys the picture and says why across it ("STALE 3 s"): it is older than it seems. Empty = none.
    void setStale(const QString& why);
    [[nodiscard]] const QString& stale() const { return stale_; }

    /// Cell under a widget position; none outside the image.
    [[nodiscard]] std::optional<QPoint> cellAt(QPointF pixel) const;

    [[nodiscard]] QSize sizeHint() const override { return {480, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 90}; }

signals:
    void hovered(int line, int beam);
    void hoverLeft();
    void clicked(int line, int beam);
    /// Esc took the crosshair (and box) away.
    void cleared();
    /// Right click without a drag; where on the screen.
    void menuWanted(int line, int beam, const QPoint& position);
    void boxSelected(const QRect& cells);
    /// A finished drag with a tool that selects: its corners, in cells (x = beam, y = line).
    void outlined(const QPolygonF& corners, Qt::KeyboardModifiers modifiers);
    /// Right drag, pixels since the last signal: x = window, y = level (down is positive).
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
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { None, Pan, WindowLevel, Box, Select };

    void drawPyramid(QPainter& painter, Pyramid& pyramid) const;
    void drawMarks(QPainter& painter) const;
    void drawTrail(QPainter& painter) const;
    void drawOutline(QPainter& painter) const;
    void drawTip(QPainter& painter) const;
    void drawTexts(QPainter& painter) const;
    void drawDragged(QPainter& painter) const;
    void pointAt(std::optional<QPoint> cell);
    void selectTo(QPointF at);
    void pinch(QPointF middle, QPointF shift, double factor);
    [[nodiscard]] QRect boxCells(QPointF from, QPointF to) const;
    [[nodiscard]] QRectF toPixels(const QRectF& cells) const;

    std::shared_ptr<ViewPort> viewPort_;
    Pyramid picture_;
    Pyramid overlay_;
    double overlayOpacity_ = 1.0;
    Pyramid faces_;
    bool facesFaded_ = false;
    Pyramid selection_;
    CellMarks marks_;
    DragTool tool_ = DragTool::Move;
    bool clearsOnEscape_ = true;
    QPolygonF way_; // of a drag that selects, in cells
    std::vector<QLine> outline_;
    QPoint tipCell_;
    QString tip_;
    std::optional<QPoint> marked_, crosshair_, hoveredCell_;
    std::optional<QRect> box_;
    EdgeTrail trail_;
    QString title_, note_, stale_;
    QColor background_{48, 48, 48};

    Drag drag_ = Drag::None;
    Press press_;
    Touch touch_{*this, [this](QPointF middle, QPointF shift, double factor) { pinch(middle, shift, factor); }};
};

} // namespace edgescan::ui
