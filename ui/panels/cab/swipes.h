// A swipe scrolls lists and pages, in cab mode: many screens report touches as a mouse.
#pragma once

#include <QObject>

class QAbstractScrollArea;

namespace edgescan::ui {

inline constexpr const char* kPaged = "paged"; ///< property of an area that a button turns by pages instead

/// GUI thread only. While it is on, a drag with the left button scrolls each page that is higher than its room, and each list. A tap still
/// presses what is below it, and a drag across still moves a slider. Lists of boxes are popups and scroll by their arrows.
class Swipes : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    ~Swipes() override;

    void setOn(bool on);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static void grab(QAbstractScrollArea& area);
    static void giveBack(QAbstractScrollArea& area);
};

} // namespace edgescan::ui
