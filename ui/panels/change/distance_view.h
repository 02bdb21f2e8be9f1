// The histogram of distances between two clouds, in the colours of the points.
#pragma once

#include "ui/panels/change/comparison.h"

#include <QWidget>

namespace edgescan::ui {

/// GUI thread only.
class DistanceView : public QWidget {
    Q_OBJECT
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
