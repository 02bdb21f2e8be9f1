// Marker, laser ray and texts over the 3D picture: a transparent child widget, so that a moving marker does not redraw the points.
#pragma once

#include "ui/base/cell_marks.h"
#include "ui/base/marks.h"

#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace edgescan::ui {

struct OverlayMarks {
    std::optional<QPointF> ring;  ///< the marked point, widget pixels
    std::optional<QLineF> ray;    ///< from the sensor to the point
    bool hidden = false;          ///< other points hide the point: drawn dashed
    std::optional<QPointF> way;   ///< from the middle of the view to the chosen point, which is outside of it: an arrow is drawn
    QString centreText;           ///< the reason why the view is empty
    QString note;                 ///< top left
    QString tip;                  ///< next to a point ...
    std::optional<QPointF> tipAt; ///< ... if it is in view
    PictureFrame frame;           ///< of a picture that does not follow the scanner
    ScreenMarks marks;            ///< targets and measurements
    QPolygonF dragged;            ///< outline of the selection that the operator is drawing

    bool operator==(const OverlayMarks&) const = default;
    [[nodiscard]] bool empty() const {
        return !ring && !ray && !way && !tipAt && centreText.isEmpty() && note.isEmpty() && !frame.colour.isValid() && marks.empty() &&
               dragged.isEmpty();
    }
};

class CloudOverlay : public QWidget {
    Q_OBJECT
public:
    explicit CloudOverlay(QWidget* parent);
    void setMarks(const OverlayMarks& marks);
    [[nodiscard]] const OverlayMarks& marks() const { return marks_; }
    /// The tags of targets and measurements, where they were drawn last.
    [[nodiscard]] const std::vector<MarkTag>& tags() const { return tags_; }
    /// At the rim of the view or of a plate there, towards the chosen point outside of it.
    [[nodiscard]] std::optional<QLineF> arrow() const;
    /// The picture in the corner of a cab: what else is over the view now.
    [[nodiscard]] std::vector<QRectF> platesOver() const;
    /// The note, where it was drawn last.
    [[nodiscard]] const QRect& label() const { return label_; }
    [[nodiscard]] const QRect& warning() const { return warning_; } ///< the plate that says LOST or STALE

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRect covered(const OverlayMarks& marks) const;

    OverlayMarks marks_;
    std::vector<QRectF> plates_;
    std::vector<MarkTag> tags_;
    QRect label_, warning_;
};

} // namespace edgescan::ui
