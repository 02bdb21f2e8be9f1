// Breaks a row into lines.
#include "ui/base/flow_layout.h"

#include <QWidget>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kLeastOfGrowing = 160; // px

bool grows(QLayoutItem& item) {
    const QSizePolicy::Policy policy = item.widget()->sizePolicy().horizontalPolicy();
    return policy == QSizePolicy::Expanding || policy == QSizePolicy::Ignored;
}

/// Px that it takes of a line of this width.
int widthOf(QLayoutItem& item, int line) {
    return std::min(line, grows(item) ? std::max(kLeastOfGrowing, item.minimumSize().width()) : item.sizeHint().width());
}

} // namespace

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) { setSpacing(8); }

FlowLayout::~FlowLayout() {
    for (QLayoutItem* item : items_) delete item;
}

void FlowLayout::addItem(QLayoutItem* item) { items_.push_back(item); }

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    QLayoutItem* item = itemAt(index);
    if (item != nullptr) items_.erase(items_.begin() + index);
    return item;
}

std::vector<FlowLayout::Line> FlowLayout::lines(int width) const {
    std::vector<Line> lines;
    for (QLayoutItem* item : items_) {
        if (item->isEmpty()) continue; // hidden
        const int needed = widthOf(*item, width);
        const bool fits = !lines.empty() && lines.back().width + spacing() + needed <= width;
        if (!fits) lines.emplace_back();
        Line& line = lines.back();
        line.width += (line.items.empty() ? 0 : spacing()) + needed;
        line.height = std::max({line.height, item->sizeHint().height(), item->minimumSize().height()});
        line.items.push_back(item);
    }
    return lines;
}

int FlowLayout::heightForWidth(int width) const {
    const QMargins around = contentsMargins();
    const auto all = lines(width - around.left() - around.right());
    int height = around.top() + around.bottom() + spacing() / 2 * std::max(0, static_cast<int>(all.size()) - 1);
    for (const Line& line : all) height += line.height;
    return height;
}

QSize FlowLayout::minimumSize() const {
    QSize least(0, 0);
    for (const QLayoutItem* item : items_) {
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    }
    const QMargins around = contentsMargins();
    return least + QSize(around.left() + around.right(), around.top() + around.bottom());
}

QSize FlowLayout::sizeHint() const {
    const QMargins around = contentsMargins();
    constexpr int kUnlimited = 1 << 20;
    const auto all = lines(kUnlimited);
    if (all.empty()) return {around.left() + around.right(), around.top() + around.bottom()};
    return {all.front().width + around.left() + around.right(), all.front().height + around.top() + around.bottom()};
}

void FlowLayout::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    const QRect inner = rect.marginsRemoved(contentsMargins());
    int y = inner.top();
    for (const Line& line : lines(inner.width())) {
        const auto growing = std::ranges::count_if(line.items, [](QLayoutItem* item) { return grows(*item); });
        const int more = growing == 0 ? 0 : (inner.width() - line.width) / static_cast<int>(growing);
        int x = inner.left();
        for (QLayoutItem* item : line.items) {
            const int wide = widthOf(*item, inner.width()) + (grows(*item) ? more : 0);
            const int high = std::min(line.height, std::max(item->sizeHint().height(), item->minimumSize().height()));
            item->setGeometry(QRect(x, y + (line.height - high) / 2, wide, high));
            x += wide + spacing();
        }
        y += line.height + spacing() / 2;
    }
}

} // namespace edgescan::ui
