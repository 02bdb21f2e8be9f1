// Marker, laser ray and texts over the 3D picture: a transparent child, so that a moving marker redraws no point.
#pragma once

#include "ui/base/cell_marks.h"

#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QString>
#include <QWidget>

#include <optional>

namespace edgescan::ui {

struct OverlayMarks {
    std::optional<QPointF> ring;  ///< the marked point, widget pixels
    std::optional<QLineF> ray;    ///< from the sensor to the point
    bool hidden = false;          ///< the point lies behind others: dashed
    QString centreText;           ///< why the view is empty
    QString note;                 ///< top left
    QString tip;                  ///< beside a point ...
    std::optional<QPointF> tipAt; ///< ... that is in view
    QString caption;              ///< top right ...
    int captionRoom = 0;          ///< ... of what stands there already, so many pixels from the right
    QString stale;                ///< greys the picture and says why; empty = none
    ScreenMarks marks;            ///< targets and measurements
    QPolygonF dragged;            ///< round what is being selected

    bool operator==(const OverlayMarks&) const = default;
    [[nodiscard]] bool empty() const {
        return !ring && !ray && !tipAt && centreText.isEmpty() && note.isEmpty() && caption.isEmpty() && stale.isEmpty() && marks.empty() &&
               dragged.isEmpty();
    }
};

class CloudOverlay : public QWidget {
    Q_OBJECT
public:
    explicit CloudOverlay(QWidget* parent);
    void setMarks(const OverlayMarks& marks);
    [[nodiscard]] const OverlayMarks& marks() const { return marks_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRect covered(const OverlayMarks& marks) const;

    OverlayMarks marks_;
};

} // namespace edgescan::ui
