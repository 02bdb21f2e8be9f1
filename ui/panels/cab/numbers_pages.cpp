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

/// Where the pages after the first one begin: what belongs together is on one page, but for lines of warnings.
std::vector<int> NumbersSide::pageStarts(int room, int high) const {
    std::vector<const QWidget*> firsts;
    if (!coordinateLabels_.empty()) firsts.push_back(coordinateLabels_.front().second); // a place is whole
    firsts.push_back(rockHead_->isVisibleTo(facts_) ? rockHead_ : sizeRemark_);
    if (!sizeTolerance_->text().isEmpty()) firsts.push_back(sizeRemark_);
    for (const auto& [name, value] : rowLabels_) firsts.push_back(value);
    std::erase_if(firsts, [this](const QWidget* each) { return !each->isVisibleTo(facts_); });
    std::vector<int> tops;
    const int line = warned_->fontMetrics().lineSpacing(), lines = warned_->isVisibleTo(facts_) ? warned_->height() / line : 0;
    for (int n = 0; n < lines; ++n) tops.push_back(warned_->y() + n * line);
    for (const QWidget* each : firsts) tops.push_back(each->y());
    std::ranges::sort(tops);
    std::vector<int> starts;
    for (std::size_t n = 0; n < tops.size(); ++n) {
        const int end = n + 1 < tops.size() ? tops[n + 1] : high, start = starts.empty() ? 0 : starts.back();
        if (end - start > room && tops[n] > start) starts.push_back(tops[n]);
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
        const int last = starts_.empty() ? 0 : starts_.back();
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
    const int start = shownPage_ == 0 ? 0 : starts_[shownPage_ - 1], end = last ? factsHigh_ : starts_[shownPage_];
    const int from = std::min(room.height() - kPageHigh, end - start);
    below_->setVisible(!starts_.empty());
    below_->setGeometry(0, from, room.width(), room.height() - from);
    page_->setGeometry(0, room.height() - kPageHigh, room.width(), kPageHigh);
    scroll_->verticalScrollBar()->setValue(start);
}

} // namespace edgescan::ui
