// The size curve of the visible rocks: the share of rocks up to each width.
#pragma once

#include "core/rocks/attributes/size_curve.h"

#include <QWidget>

#include <vector>

namespace edgescan::ui {

/// "Visible width b by count: P20 0.31, P50 0.52, P80 0.98 (...), largest 2.01 m; ▲ 12 % over 1.50 m. Hidden parts ..."; empty without
/// rocks.
[[nodiscard]] QString sizeCurveText(const rocks::SizeCurve& curve);

/// GUI thread only.
class SizeCurveView : public QWidget {
    Q_OBJECT
public:
    explicit SizeCurveView(QWidget* parent = nullptr);

    void show(const rocks::SizeCurve& curve);
    /// Visible b of the selected rocks, metres: dots on the curve.
    void mark(std::vector<double> widthsM);
    [[nodiscard]] const rocks::SizeCurve& curve() const { return curve_; }
    [[nodiscard]] const std::vector<double>& marked() const { return marked_; }
    /// The position of a width and a share in the drawing.
    [[nodiscard]] QPointF placeOf(double wideM, double share) const;
    /// The text about a width: "63 % of the rocks are visibly no wider than 0.60 m".
    [[nodiscard]] QString textAt(QPointF place) const;

    /// The text above the curve: without its second sentence where it would take more than half of the height.
    [[nodiscard]] QString caption() const;
    struct AxisLabel {
        QRectF place;
        QString text;
    };
    /// The numbers of the axis of widths; those that would touch are left out, never the last one, which has the unit.
    [[nodiscard]] std::vector<AxisLabel> axisLabels() const;

    [[nodiscard]] QSize sizeHint() const override { return {300, 200}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 110}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] QFont letters() const;
    /// Of a text over the whole width, px.
    [[nodiscard]] int heightOf(const QString& text) const;
    void drawAxes(QPainter& painter) const;
    void drawOversize(QPainter& painter) const;
    void drawCurve(QPainter& painter) const;

    rocks::SizeCurve curve_;
    std::vector<double> marked_;
    double rightM_ = 1.0; // end of the axis
};

} // namespace edgescan::ui
