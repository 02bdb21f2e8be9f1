// The dark plate under legends, over a view.
#pragma once

#include <QFrame>

namespace edgescan::ui {

/// The same plate and text colours in every theme: contrast 13.8.
class ViewPlate : public QFrame {
    Q_OBJECT
public:
    explicit ViewPlate(QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace edgescan::ui
