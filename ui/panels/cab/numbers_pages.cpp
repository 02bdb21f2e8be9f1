// The pages of the numbers, where a low screen has no room for all rows.
#include "ui/panels/cab/numbers_side.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kPageHigh = 48; // px: of the button that turns the page

} // namespace

/// The rows that begin the pages after the first one: what belongs together is on one page.
std::vector<const QWidget*> NumbersSide::pageStarts(int room, int high) const {
    std::vector<const QWidget*> firsts;
    firsts.push_back(warned_);
    for (const auto& [name, value] : coordinateLabels_) firsts.push_back(value);
    firsts.push_back(rock_->isVisibleTo(facts_) ? rock_ : sizeRemark_);
    for (const auto& [name, value] : rowLabels_) firsts.push_back(value);
    std::erase_if(firsts, [this](const QWidget* each) { return !each->isVisibleTo(facts_); });
    std::vector<const QWidget*> starts;
    for (std::size_t n = 0; n < firsts.size(); ++n) {
        const int end = n + 1 < firsts.size() ? firsts[n + 1]->y() : high, start = starts.empty() ? 0 : starts.back()->y();
        if (end - start > room && firsts[n]->y() > start) starts.push_back(firsts[n]);
    }
    return starts;
}

/// Where the facts have no room, they have pages of whole rows, and a button for the next one.
void NumbersSide::fitPages() {
    pages_->widget(0)->layout()->activate();
    facts_->layout()->setContentsMargins(0, 0, 0, 0);
    const QSize room = scroll_->viewport()->size();
    factsHigh_ = facts_->layout()->heightForWidth(room.width());
    starts_.clear();
    if (factsHigh_ > room.height() && isVisible()) {
        facts_->resize(room.width(), factsHigh_);
        facts_->layout()->activate();
        starts_ = pageStarts(room.height() - kPageHigh, factsHigh_);
        const int last = starts_.empty() ? 0 : starts_.back()->y();
        facts_->layout()->setContentsMargins(0, 0, 0, std::max(0, last + room.height() - factsHigh_));
        facts_->resize(room.width(), std::max(factsHigh_, last + room.height()));
    }
    shownPage_ = std::min(shownPage_, starts_.size());
    showPage();
}

void NumbersSide::showPage() {
    facts_->layout()->activate();
    const bool last = shownPage_ == starts_.size();
    page_->setVisible(!starts_.empty());
    page_->setText(last ? "▲ " + tr("Back") : "▼ " + tr("More"));
    const QSize room = scroll_->viewport()->size();
    const int start = shownPage_ == 0 ? 0 : starts_[shownPage_ - 1]->y(), end = last ? factsHigh_ : starts_[shownPage_]->y();
    const int from = std::min(room.height() - kPageHigh, end - start);
    below_->setVisible(!starts_.empty());
    below_->setGeometry(0, from, room.width(), room.height() - from);
    page_->setGeometry(0, room.height() - kPageHigh, room.width(), kPageHigh);
    scroll_->verticalScrollBar()->setValue(start);
}

} // namespace edgescan::ui
