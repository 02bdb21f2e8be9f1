// Follows the views with the notice bar.
#include "ui/window/notice_place.h"

#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/view_cube.h"
#include "ui/views/image/image_view.h"

#include <QEvent>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kTextMargin = 8;       // px
constexpr int kLeastWidth = 220;     // px of a note
constexpr int kLeastTexts = 80;      // px of height for the texts of a view under a high note
constexpr int kLeastUnderNote = 480; // px of a cloud that has a line of a note with its buttons

class NoticePlace : public QObject {
public:
    NoticePlace(NoticeBar& notice, QWidget& views)
        : QObject(&notice), notice_(notice), views_(views), cloud_(views.findChild<CloudView*>()) {
        for (QObject* watched : {static_cast<QObject*>(&notice), static_cast<QObject*>(&views)}) watched->installEventFilter(this);
        if (auto* cloud = views.findChild<CloudView*>()) cloud->installEventFilter(this);
        for (QWidget* pane : views.findChildren<Pane*>()) pane->installEventFilter(this); // they move when images and cloud share otherwise
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto type = event->type();
        const bool isPlaced = type == QEvent::Resize || type == QEvent::Move;
        if (watched == &notice_ ? type == QEvent::LayoutRequest || type == QEvent::Show : isPlaced) place();
        if (watched == &notice_ && type == QEvent::Hide) keepTextsFree();
        if (watched == cloud_ && (type == QEvent::ShowToParent || type == QEvent::HideToParent)) place();
        const bool isOver = watched != &notice_ && watched != &views_ && watched != cloud_;
        if (isOver && (type == QEvent::Show || type == QEvent::Hide)) place();
        return false;
    }

private:
    /// Over the cloud, which can be turned: images stay free, unless the cloud is too narrow for a note. Below the titles of the panes, and
    /// next to the view cube and the picture in the corner. As high as its text needs at this width, and no higher than the views.
    void place() {
        int top = 0;
        const bool isCovered = cloud_ != nullptr && cloud_->isHidden(); // by the start page, which is below the notice
        for (const Pane* pane : views_.findChildren<Pane*>()) {
            const QPoint at = pane->mapTo(&views_, QPoint(0, 0));
            if (!isCovered && pane->isVisible() && at.y() == 0) top = std::max(top, pane->content()->mapTo(&views_, QPoint(0, 0)).y());
        }
        const int left = cloud_ == nullptr ? 0 : cloud_->mapTo(&views_, QPoint(0, 0)).x();
        const bool overCloud = cloud_ != nullptr && cloud_->isVisible() && cloud_->width() >= kLeastUnderNote;
        QRect place =
            overCloud ? rectAt(left, left + cloud_->width(), cloud_->mapTo(&views_, QPoint(0, 0)).y()) : rectAt(0, views_.width(), top);
        for (QWidget* each : views_.findChildren<QWidget*>()) {
            if (qobject_cast<ViewCube*>(each) != nullptr || qobject_cast<CornerPicture*>(each) != nullptr) place = nextTo(*each, place);
        }
        notice_.setGeometry(place.translated(views_.pos()));
        notice_.raise();
        keepTextsFree();
    }
    /// The texts at the top of a view move below the bar.
    void keepTextsFree() {
        const QRect bar(views_.mapFromGlobal(notice_.mapToGlobal(QPoint(0, 0))), notice_.size());
        const auto takenOf = [&](const QWidget& view) {
            const QRect place(view.mapTo(&views_, QPoint(0, 0)), view.size());
            const bool covers = !notice_.isHidden() && bar.intersects(place) && bar.top() <= place.top() + kTextMargin;
            return covers ? std::min(bar.bottom() + 1 - place.top(), std::max(place.height() / 2, place.height() - kLeastTexts)) : 0;
        };
        for (auto* view : views_.findChildren<CloudView*>()) view->setTopTaken(takenOf(*view));
        for (auto* view : views_.findChildren<ImageView*>()) view->setTopTaken(takenOf(*view));
    }
    /// On the wider side of `over`, which is over a view; below it if that side is too narrow for a note.
    [[nodiscard]] QRect nextTo(QWidget& over, const QRect& place) {
        over.installEventFilter(this); // it may show, hide or move later; a second installation changes nothing
        const QRect taken(over.mapTo(&views_, QPoint(0, 0)), over.size());
        if (!over.isVisible() || !place.intersects(taken)) return place;
        const bool isRight = taken.left() - place.left() >= place.right() - taken.right();
        const QRect free =
            isRight ? rectAt(place.left(), taken.left(), place.top()) : rectAt(taken.right() + 1, place.right() + 1, place.top());
        return free.width() < kLeastWidth ? rectAt(place.left(), place.right() + 1, taken.bottom() + 1) : free;
    }
    [[nodiscard]] QRect rectAt(int left, int right, int top) const {
        const int width = right - left;
        return {left, top, width, std::min(notice_.heightForWidth(width), views_.height() - top)};
    }

    NoticeBar& notice_;
    QWidget& views_;
    const CloudView* cloud_;
};

} // namespace

void keepOverViews(NoticeBar& notice, QWidget& views) { new NoticePlace(notice, views); }

} // namespace edgescan::ui
