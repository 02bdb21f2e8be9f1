// Breaks a row into lines.
#include "ui/base/flow_layout.h"

#include <QWidget>

#include <algorithm>
#include <iterator>

namespace edgescan::ui {
namespace {

constexpr int kLeastOfGrowing = 160; // px

bool grows(QLayoutItem& item) {
    const QSizePolicy::Policy policy = item.widget()->sizePolicy().horizontalPolicy();
    return policy == QSizePolicy::Expanding || policy == QSizePolicy::Ignored;
}

/// Px that it takes of a line of this width. An expanding one has a least width; an ignored one gets enough for words.
int widthOf(QLayoutItem& item, int line) {
    if (item.isEmpty()) return std::min(line, item.widget()->sizeHint().width()); // hidden: what it would take
    const bool known = item.widget()->minimumWidth() > 0 || item.widget()->sizePolicy().horizontalPolicy() == QSizePolicy::Expanding;
    const int least = known ? 0 : kLeastOfGrowing;
    return std::min(line, grows(item) ? std::max(least, item.minimumSize().width()) : item.sizeHint().width());
}

int highOf(QLayoutItem& item, int width) {
    const int height = item.hasHeightForWidth() ? item.heightForWidth(width) : item.sizeHint().height();
    return std::max(height, item.minimumSize().height());
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

std::vector<QLayoutItem*> FlowLayout::shown() const {
    std::vector<QLayoutItem*> shown;
    std::ranges::copy_if(items_, std::back_inserter(shown), [](QLayoutItem* item) { return !item->isEmpty(); });
    return shown;
}

bool FlowLayout::isHigherWith(const QWidget& widget, int width) const {
    std::vector<QLayoutItem*> with, without;
    for (QLayoutItem* item : items_) {
        const bool isIt = item->widget() == &widget;
        if (isIt || !item->isEmpty()) with.push_back(item);
        if (!isIt && !item->isEmpty()) without.push_back(item);
    }
    return heightOf(with, width) > heightOf(without, width);
}

std::vector<FlowLayout::Line> FlowLayout::lines(const std::vector<QLayoutItem*>& shown, int width) const {
    std::vector<Line> lines;
    const auto add = [&](QLayoutItem* item) {
        const int needed = widthOf(*item, width);
        const bool fits = !lines.empty() && lines.back().width + spacing() + needed <= width;
        if (!fits) lines.emplace_back();
        Line& line = lines.back();
        line.width += (line.items.empty() ? 0 : spacing()) + needed;
        line.items.push_back(item);
    };
    std::ranges::for_each(shown, add);
    for (Line& line : lines) {
        for (QLayoutItem* item : line.items) line.height = std::max(line.height, highOf(*item, widthIn(line, *item, width)));
    }
    return lines;
}

/// With its part of what is left of the line.
int FlowLayout::widthIn(const Line& line, QLayoutItem& item, int width) {
    if (!grows(item)) return widthOf(item, width);
    const auto growing = std::ranges::count_if(line.items, [](QLayoutItem* each) { return grows(*each); });
    return widthOf(item, width) + (width - line.width) / static_cast<int>(growing);
}

int FlowLayout::heightForWidth(int width) const { return heightOf(shown(), width); }

int FlowLayout::heightOf(const std::vector<QLayoutItem*>& shown, int width) const {
    const QMargins around = contentsMargins();
    const auto all = lines(shown, width - around.left() - around.right());
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
        int x = inner.left();
        for (QLayoutItem* item : line.items) {
            const int wide = widthIn(line, *item, inner.width());
            const int high = highOf(*item, wide);
            item->setGeometry(QRect(x, y + (line.height - high) / 2, wide, high));
            x += wide + spacing();
        }
        y += line.height + spacing() / 2;
    }
}

} // namespace edgescan::ui
