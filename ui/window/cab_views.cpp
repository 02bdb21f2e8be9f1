// The views of cab mode: which one is large, the picture in the corner, and zoom.
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/cab/keypad.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QMouseEvent>
#include <QTimer>
#include <QToolButton>
#include <QTouchEvent>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr qint64 kSecondTapMs = 700;
constexpr int kZoomSide = 52, kBetweenZooms = 4; // px
constexpr double kZoomStep = 1.25;

} // namespace

/// Where the image has what is chosen: the ends of a measurement, a rock or a target.
PictureMark CabMode::chosenPlace() const {
    const LinkedViews& views = window_.viewer().views;
    if (!window_.viewer().engine.picture()) return {};
    PictureMark mark;
    const auto& measures = views.marks().measures;
    if (const auto chosen = std::ranges::find_if(measures, &MeasureMark::active); chosen != measures.end()) {
        for (const std::size_t cell : chosen->cells) mark.cells << views.placeOf(cell);
        mark.links = chosen->links;
        return mark;
    }
    const rocks::Rock* const rock = chosenRock();
    // A tap on the label of a target leaves the pointer over the cell behind it.
    const auto pinned = views.pinned() ? views.pinned() : views.marked();
    if (const auto cell = rock != nullptr ? std::optional<std::size_t>(rock->cell) : pinned) mark.cells << views.placeOf(*cell);
    return mark;
}

void CabMode::showCorner() {
    const bool some = on_ && window_.viewer().engine.picture() != nullptr && small_;
    corner_->setVisible(some);
    if (!some) return;
    corner_->setWords("⇄ " + (image_ == Large::Range ? QObject::tr("Range image") : QObject::tr("Edge map")));
    corner_->show(imageView().image(), chosenPlace(), imageView().viewPort()->toScreen());
}

ImageView& CabMode::imageView() const {
    LinkedViews& views = window_.viewer().views;
    return image_ == Large::Edges ? views.edges() : views.gray();
}

/// A tap at this place is meant for what was there, for a moment after the change is painted: a large cloud takes its time.
void CabMode::noteChangeUnder(const QRegion& place) {
    if (!on_ || place.isEmpty()) return;
    std::erase_if(left_, [](const LeftPlace& each) { return each.isOver(); });
    left_.push_back({place});
    QTimer::singleShot(0, this, [this] {
        for (LeftPlace& each : left_) {
            if (!each.since.isValid()) each.since.start();
        }
    });
}

/// Exchanges the large view and the corner: image and cloud.
void CabMode::swap() {
    const CornerPicture& used = large_ == Large::Cloud ? *corner_ : *back_;
    const QRect place = used.isVisible() ? QRect(used.mapToGlobal(QPoint()), used.size()) : QRect();
    showLarge(large_ == Large::Cloud ? image_ : Large::Cloud);
    noteChangeUnder(place); // also of the other one, which is there now
}

void CabMode::showLarge(Large which) {
    if (std::exchange(large_, which) == which) return;
    if (which != Large::Cloud) image_ = which;
    const bool isImage = which != Large::Cloud;
    ImageView& image = imageView();
    for (ImageView* each : {&window_.viewer().views.gray(), &window_.viewer().views.edges()}) {
        each->removeEventFilter(back_);
        each->setCovered(0);
    }
    back_->setParent(&image);
    image.installEventFilter(back_);
    window_.viewer().views.setOnlyImage(which == Large::Range);
    window_.showAlone(isImage ? static_cast<QWidget*>(&image) : &window_.viewer().views.cloud());
    back_->setVisible(isImage);
    back_->endAt(corner_->isHidden() ? 0 : corner_->geometry().bottom()); // a second tap at the same place swaps them back
    if (isImage) image.setCovered(back_->reach());
    showCorner();
    emit viewsChanged();
}

/// A direction is one of the cloud.
void CabMode::showCloud() {
    if (on_) showLarge(Large::Cloud);
}

/// Each does what it says, whatever is large.
void CabMode::fillViews(QMenu& menu) {
    menu.clear();
    auto* views = menu.findChild<QActionGroup*>();
    if (views == nullptr) views = new QActionGroup(&menu); // one of them is on
    for (const auto& [which, words] : {std::pair(Large::Cloud, QObject::tr("Cloud")), std::pair(Large::Range, QObject::tr("Range image")),
                                       std::pair(Large::Edges, QObject::tr("Edge map"))}) {
        QAction* action = menu.addAction(words, this, [this, which = which] { showLarge(which); });
        action->setCheckable(true);
        action->setChecked(large_ == which);
        views->addAction(action);
    }
    menu.addSeparator();
    QAction* small = menu.addAction(tr("Small picture"), this, [this](bool on) {
        small_ = on;
        showCorner();
        emit viewsChanged();
    });
    small->setCheckable(true);
    small->setChecked(small_);
    small->setEnabled(large_ == Large::Cloud); // an image has no picture in its corner
    QMenu& directions = menuWith("View/Look from/Top (from Above)");
    menu.addSeparator();
    menu.addMenu(&directions);
    connect(&directions, &QMenu::triggered, this, &CabMode::showCloud, Qt::UniqueConnection);
}

std::string CabMode::viewsKept() const {
    const char* names[]{"cloud", "range", "edges"};
    return std::string(names[static_cast<int>(large_)]) + (image_ == Large::Edges ? " edges" : " range") + (small_ ? " small" : "");
}

void CabMode::useViews(const QString& kept) {
    const QStringList words = kept.split(' ');
    const QStringList names{"cloud", "range", "edges"};
    const auto large = names.indexOf(words.value(0));
    if (large < 0) return;
    showLarge(Large::Cloud);
    image_ = words.value(1) == "edges" ? Large::Edges : Large::Range;
    small_ = words.contains("small");
    showLarge(static_cast<Large>(large));
    showCorner();
}

/// Shows all of the large view.
void CabMode::fit() {
    if (large_ == Large::Cloud)
        window_.viewer().views.cloud().zoomToFit();
    else
        window_.viewer().views.gray().viewPort()->fit();
}

/// Zooms the large view about its middle.
void CabMode::zoom(double factor) {
    CloudView& cloud = window_.viewer().views.cloud();
    if (large_ == Large::Cloud) return cloud.setCamera(zoomed(cloud.camera(), cloud.camera().focus, factor));
    ViewPort& images = *window_.viewer().views.gray().viewPort();
    images.zoomAt(images.centre(), factor);
}

void CabMode::addZoom() {
    zoom_->setObjectName("cab-zoom");
    auto* row = new QHBoxLayout(zoom_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kBetweenZooms);
    for (const bool in : {true, false}) {
        auto* button = new QToolButton;
        button->setObjectName(in ? "cab-zoom-in" : "cab-zoom-out");
        button->setText(in ? "+" : "−");
        button->setAccessibleName(in ? tr("Zoom in") : tr("Zoom out"));
        button->setFixedSize(kZoomSide, kZoomSide);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoRepeat(true);
        QFont letters = button->font();
        letters.setPixelSize(kZoomSide / 2);
        letters.setBold(true);
        button->setFont(letters);
        connect(button, &QToolButton::clicked, this, [this, in] { zoom(in ? kZoomStep : 1.0 / kZoomStep); });
        row->addWidget(button);
    }
    zoom_->hide();
}

bool CabMode::LeftPlace::isOver() const { return since.isValid() && since.elapsed() >= kSecondTapMs; }

bool CabMode::isOnLeftPlace(const QPoint& onScreen) const {
    return std::ranges::any_of(left_, [&onScreen](const LeftPlace& each) { return !each.isOver() && each.onScreen.contains(onScreen); });
}

bool CabMode::eventFilter(QObject* watched, QEvent* event) {
    const bool press = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    const bool follows = event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseMove;
    if (press) {
        const QPoint at = static_cast<QMouseEvent*>(event)->globalPos();
        secondTap_ = !keypad_->place().contains(at) && isOnLeftPlace(at);
    }
    if (event->type() == QEvent::TouchBegin) {
        const auto points = static_cast<QTouchEvent*>(event)->touchPoints();
        if (std::ranges::any_of(points, [this](const auto& each) { return isOnLeftPlace(each.screenPos().toPoint()); })) {
            event->ignore(); // Qt sends the mouse event instead
            return true;
        }
    }
    return ((press || follows) && secondTap_) || QObject::eventFilter(watched, event);
}

} // namespace edgescan::ui
