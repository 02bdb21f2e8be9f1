// A slider over the lines of a recording, with a mark at the start of each sweep.
#pragma once

#include <QSlider>

#include <vector>

namespace edgescan::ui {

class TimelineSlider : public QSlider {
    Q_OBJECT
public:
    explicit TimelineSlider(QWidget* parent = nullptr);
    void setMarks(std::vector<int> positions);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] int pixelOf(int position) const;

    std::vector<int> marks_;
};

} // namespace edgescan::ui
