// Zooms the large view by taps.
#pragma once

#include <QWidget>

namespace edgescan::ui {

/// GUI thread only.
class ZoomButtons : public QWidget {
    Q_OBJECT
public:
    ZoomButtons();

signals:
    void zoomed(double factor);
};

} // namespace edgescan::ui
