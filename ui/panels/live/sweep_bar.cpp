// The progress of a sweep as a bar.
#include "ui/panels/live/sweep_bar.h"

#include "ui/base/themes.h"

#include <QPainter>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kHigh = 12, kMark = 2; // px

} // namespace

SweepBar::SweepBar(QWidget* parent) : QWidget(parent) {
    setObjectName("sweep-bar");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Lines of the sweep. A red mark is a line that did not arrive."));
    hide();
}

void SweepBar::showRows(int row, int rows, const std::vector<int>& lost) {
    setVisible(rows > 0);
    if (row == row_ && rows == rows_ && lost == lost_) return;
    row_ = std::min(row, rows);
    rows_ = rows;
    lost_ = lost;
    update();
}

void SweepBar::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const Theme& theme = themeInUse();
    const QRect whole(0, (height() - kHigh) / 2, width() - 1, kHigh - 1);
    painter.setPen(theme.edge);
    painter.setBrush(theme.base);
    painter.drawRect(whole);
    if (rows_ <= 0) return;
    const auto at = [&](int row) { return whole.left() + 1 + static_cast<int>(static_cast<double>(row) / rows_ * (whole.width() - 1)); };
    painter.fillRect(QRect(QPoint(whole.left() + 1, whole.top() + 1), QPoint(at(row_) - 1, whole.bottom() - 1)), theme.accent);
    for (const int row : lost_)
        painter.fillRect(QRect(at(row), whole.top() + 1, std::max(kMark, at(row + 1) - at(row)), whole.height() - 1), theme.warn);
}

} // namespace edgescan::ui

#include "moc_sweep_bar.cpp"
