// Puts panes into their places.
#include "ui/window/pane_places.h"

#include "ui/base/pane.h"

#include <QSplitter>

#include <algorithm>
#include <utility>

namespace edgescan::ui {

PanePlaces::PanePlaces(QSplitter& outer, QSplitter& images, const std::array<Pane*, 3>& panes, QObject* parent)
    : QObject(parent), outer_(outer), images_(images), panes_(panes) {}

void PanePlaces::setShare(Share share) {
    if (std::exchange(share_, share) == share) return;
    Pane* large = share != Share::Images ? nullptr : swapped_ != nullptr ? swapped_ : panes_[1]; // the edge map
    if (std::exchange(swapped_, large) != large) place();
    emit shareChanged(share);
    emit changed();
}

void PanePlaces::swap(Pane* pane) {
    swapped_ = pane == panes_.back() || pane == swapped_ ? nullptr : pane;
    place();
    if (swapped_ == nullptr && share_ == Share::Images) emit shareChanged(share_ = Share::Balanced);
    emit changed();
}

void PanePlaces::place() {
    const QList<int> outer = outer_.sizes(), images = images_.sizes();
    std::array<Pane*, 3> order = panes_;
    if (swapped_ != nullptr) std::iter_swap(std::ranges::find(order, swapped_), std::prev(order.end()));
    for (int n = 0; n < 2; ++n) images_.insertWidget(n, order[static_cast<std::size_t>(n)]);
    outer_.insertWidget(1, order.back());
    outer_.setStretchFactor(1, 1);
    outer_.setSizes(outer);
    images_.setSizes(images);
}

QString PanePlaces::text() const {
    const QString large = swapped_ == nullptr ? QString() : swapped_->content()->objectName();
    return share_ == Share::Balanced ? large : (kShareNames.at(static_cast<int>(share_)) + ' ' + large).trimmed();
}

void PanePlaces::use(const QString& text) {
    QStringList words = text.split(' ', Qt::SkipEmptyParts);
    const int share = words.isEmpty() ? -1 : static_cast<int>(kShareNames.indexOf(words.front()));
    if (share >= 0) words.removeFirst();
    const auto found = std::ranges::find_if(panes_, [&](const Pane* pane) { return pane->content()->objectName() == words.value(0); });
    Pane* wanted = found == panes_.end() || *found == panes_.back() ? nullptr : *found;
    setShare(static_cast<Share>(std::max(0, share)));
    if (wanted != swapped_) swap(wanted == nullptr ? swapped_ : wanted);
}

} // namespace edgescan::ui

#include "moc_pane_places.cpp"
