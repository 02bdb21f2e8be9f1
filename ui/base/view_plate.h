// The dark plate that legends stand on, over a view.
#pragma once

#include <QFrame>

namespace edgescan::ui {

/// The same in every theme, with what stands on it: 13.8 to its words.
class ViewPlate : public QFrame {
    Q_OBJECT
public:
    explicit ViewPlate(QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace edgescan::ui
