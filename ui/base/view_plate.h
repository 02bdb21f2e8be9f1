// The dark plate under legends, over a view.
#pragma once

#include <QFrame>

class QScrollArea;

namespace edgescan::ui {

/// GUI thread only. The same plate and text colours in every theme: contrast 13.8.
class ViewPlate : public QFrame {
    Q_OBJECT
public:
    explicit ViewPlate(QWidget* parent = nullptr);
    /// Its view has this height for it, px: a plate that needs more becomes smaller, or its content scrolls.
    virtual void fitInto(int height);

protected:
    /// Content that scrolls where the view is too low for it; `foot`, which is below it, is always seen.
    void setContent(QWidget& content, QLayout* foot = nullptr);
    /// To be called after each change of the content.
    void fitContent();
    void paintEvent(QPaintEvent* event) override;
    /// A click between its rows is not one on the view below it.
    void mousePressEvent(QMouseEvent* event) override;

private:
    QScrollArea* area_ = nullptr;
    QLayout* foot_ = nullptr;
    int room_ = QWIDGETSIZE_MAX;
};

} // namespace edgescan::ui
