// Puts panes into their places.
#include "ui/window/pane_places.h"

#include "ui/base/pane.h"

#include <QSplitter>

#include <algorithm>
#include <utility>

namespace edgescan::ui {

PanePlaces::PanePlaces(QSplitter& outer, QSplitter& images, const std::array<Pane*, 3>& panes, QObject* parent)
    : QObject(parent), outer_(outer), images_(images), panes_(panes) {}

void PanePlaces::setImagesFirst(bool on) {
    if (on == imagesFirst_) return;
    imagesFirst_ = on;
    orient();
    images_.setSizes({1000, 1000});
    emit imagesFirstChanged(on);
    emit changed();
}

void PanePlaces::setSideBySide(bool on) {
    if (std::exchange(sideBySide_, on) == on) return;
    orient();
    images_.setSizes({1000, 1000});
}

void PanePlaces::orient() { images_.setOrientation(imagesFirst_ && sideBySide_ ? Qt::Horizontal : Qt::Vertical); }

void PanePlaces::swap(Pane* pane) {
    swapped_ = pane == panes_.back() || pane == swapped_ ? nullptr : pane;
    place();
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

QString PanePlaces::text() const { return swapped_ == nullptr ? QString() : swapped_->content()->objectName(); }

void PanePlaces::use(const QString& text) {
    const auto found = std::ranges::find_if(panes_, [&](const Pane* pane) { return pane->content()->objectName() == text; });
    Pane* wanted = text.isEmpty() || found == panes_.end() || *found == panes_.back() ? nullptr : *found;
    if (wanted != swapped_) swap(wanted == nullptr ? swapped_ : wanted);
}

} // namespace edgescan::ui

#include "moc_pane_places.cpp"
