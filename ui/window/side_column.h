// The column at the right of the views: legends, scale and directions, which would cover the pictures. In a cab it is a strip below them.
#pragma once

#include <QScrollArea>

class QBoxLayout;

namespace edgescan::ui {

/// GUI thread only. Its width depends on the font only: no view moves when a legend comes or goes.
class SideColumn : public QScrollArea {
public:
    explicit SideColumn(QWidget* parent = nullptr);

    /// After the others.
    void add(QWidget& part);
    /// On: a strip, as high as what it shows.
    void setStrip(bool on);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void keepWidth();

    QBoxLayout* rows_;
    bool strip_ = false;
};

} // namespace edgescan::ui
