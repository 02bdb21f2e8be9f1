// How far the points of a scan are from another scan, as bars.
#pragma once

#include "ui/panels/change/comparison.h"

#include <QWidget>

#include <memory>

namespace edgescan::ui {

/// The histogram of distances between two clouds, in the colours of the points. Bars of the square root of the counts: a few changed
/// surfaces stay visible next to many that are the same.
class DistanceView : public QWidget {
public:
    explicit DistanceView(QWidget* parent = nullptr);

    /// Null: nothing to show.
    void showDistances(std::shared_ptr<const SurfaceDistances> distances);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::shared_ptr<const SurfaceDistances> distances_;
};

} // namespace edgescan::ui
