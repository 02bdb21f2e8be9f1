// The edge count at every threshold, drawn under the threshold's slider. Marks the range in which the count changes little.
#pragma once

#include "core/edges/pipeline/edge_count_curve.h"

#include <QWidget>

#include <optional>
#include <utility>

namespace edgescan::edges {
struct Parameter;
} // namespace edgescan::edges

namespace edgescan::ui {

/// GUI thread only. `parameter` must outlive it (the table does).
class CountCurve : public QWidget {
    Q_OBJECT
public:
    explicit CountCurve(const edges::Parameter& parameter, QWidget* parent = nullptr);

    /// Null: not known yet.
    void showCurve(std::optional<edges::EdgeCountCurve> curve);
    /// The threshold in use.
    void showValue(double value);
    /// The edge count at a threshold: the curve itself knows only the positions of the slider.
    void showFound(double threshold, std::size_t edges);
    [[nodiscard]] const std::optional<edges::EdgeCountCurve>& curve() const { return curve_; }

    [[nodiscard]] QSize sizeHint() const override { return {260, 58}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 48}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] double xOf(double threshold) const;
    [[nodiscard]] double yOf(std::size_t edges) const;
    [[nodiscard]] QString words(bool brief = false) const; ///< brief: for a narrow panel

    const edges::Parameter& parameter_;
    std::optional<edges::EdgeCountCurve> curve_;
    double value_ = 0.0;
    std::optional<std::pair<double, std::size_t>> found_; ///< threshold and edges
};

} // namespace edgescan::ui
