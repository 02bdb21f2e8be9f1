// A line of text that shrinks to its room.
#pragma once

#include <QLabel>

namespace edgescan::ui {

/// With the largest letters, from `mostPx` down to `leastPx`, in which the text fits into the room.
[[nodiscard]] QFont fittedFont(QFont letters, const QString& text, int room, int mostPx, int leastPx);

/// One line. It never requests more width than it is given. The font shrinks down to `leastPx`; text that still does not fit is in the tool
/// tip.
class FittedLabel : public QLabel {
public:
    FittedLabel(int mostPx, int leastPx, QWidget* parent = nullptr);

    void showText(const QString& text);
    void setMost(int px);
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    int mostPx_, leastPx_;
};

} // namespace edgescan::ui
