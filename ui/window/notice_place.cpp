// Follows the views with the notice bar.
#include "ui/window/notice_place.h"

#include "ui/base/notice_bar.h"

#include <QEvent>
#include <QLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

class NoticePlace : public QObject {
public:
    NoticePlace(NoticeBar& notice, QWidget& views) : QObject(&notice), notice_(notice), views_(views) {
        for (QObject* watched : {static_cast<QObject*>(&notice), static_cast<QObject*>(&views)}) watched->installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto type = event->type();
        if (watched == &views_ ? type == QEvent::Resize || type == QEvent::Move : type == QEvent::LayoutRequest || type == QEvent::Show)
            place();
        return false;
    }

private:
    /// As high as its text needs at this width, and no higher than the views.
    void place() {
        const int width = views_.width();
        notice_.setGeometry(views_.x(), views_.y(), width, std::min(notice_.layout()->heightForWidth(width), views_.height()));
        notice_.raise();
    }

    NoticeBar& notice_;
    QWidget& views_;
};

} // namespace

void keepOverViews(NoticeBar& notice, QWidget& views) { new NoticePlace(notice, views); }

} // namespace edgescan::ui
