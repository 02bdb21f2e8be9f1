// Plus and minus over a view in cab mode: a glove has no wheel, and one hand cannot always spread two fingers.
#pragma once

#include "ui/base/view_plate.h"

class QBoxLayout;

namespace edgescan::ui {

/// GUI thread only. At the right of its view; it signals the operator's choices.
class ZoomButtons : public ViewPlate {
    Q_OBJECT
public:
    ZoomButtons();

    /// Shows them over the view, below `corner`, which is in its upper right corner.
    void setOver(QWidget& view, QWidget& corner);
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// In a view that is too low for them they stay hidden: two fingers zoom there.
    void setVisible(bool on) override;

signals:
    void zoomed(double factor);

private:
    void place();

    QBoxLayout* buttons_;
    QWidget* corner_ = nullptr;
    bool wanted_ = false;
};

} // namespace edgescan::ui
