// Rows of the menu: lasers to choose, sources of their angles to choose, and the rest for reading.
#include "ui/panels/live/topic_menu.h"

#include "core/base/number_text.h"
#include "ui/base/shown_text.h"

#include <QActionGroup>
#include <QMenu>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kMostRows = 30;

bool isCloud(const files::OfferedTopic& topic) { return topic.topic.type == "sensor_msgs/PointCloud2"; }

QString counted(const files::OfferedTopic& topic, const QString& gives) {
    if (!topic.subscribed) return gives;
    const QString hertz = topic.topic.hertz > 0 ? shownText(significantText(topic.topic.hertz, 3)) : QString("?");
    return TopicMenu::tr("%1; messages: %2, per second: %3").arg(gives).arg(topic.topic.messages).arg(hertz);
}

} // namespace

TopicMenu::TopicMenu(QWidget* parent) : QToolButton(parent), menu_(new QMenu(this)) {
    setObjectName("live-topics");
    setText(tr("Topics…"));
    setToolTip(tr("What the robot offers, and which laser the scan comes from"));
    setPopupMode(QToolButton::InstantPopup);
    setMenu(menu_);
    connect(menu_, &QMenu::aboutToShow, this, &TopicMenu::asked);
}

void TopicMenu::showTopics(const std::vector<files::OfferedTopic>& topics, const std::string& joint) {
    menu_->clear();
    addScans(topics, joint);
    addAngles(topics, joint);
    addOthers(topics);
    if (topics.empty()) menu_->addAction(tr("The robot has not offered a topic yet."))->setEnabled(false);
}

void TopicMenu::addScans(const std::vector<files::OfferedTopic>& topics, const std::string& joint) {
    auto* group = new QActionGroup(menu_);
    for (const files::OfferedTopic& topic : topics) {
        if (!topic.topic.isScan || menu_->actions().size() >= kMostRows) continue;
        const std::size_t size = topic.topic.size;
        const QString gives = isCloud(topic) ? size > 0 ? tr("clouds of %1 points").arg(size) : tr("clouds of a scanner")
                              : size > 0 ? tr("lines of %1 beams").arg(size)
                                             : tr("lines of a laser");
        QAction* row = menu_->addAction(shownText(topic.topic.name) + ": " + counted(topic, gives));
        row->setCheckable(true);
        row->setChecked(topic.lines);
        group->addAction(row);
        connect(row, &QAction::triggered, this, [this, name = topic.topic.name, joint] { emit chosen(name, joint); });
    }
}

void TopicMenu::addAngles(const std::vector<files::OfferedTopic>& topics, const std::string& joint) {
    const auto taken = std::ranges::find_if(topics, &files::OfferedTopic::lines);
    if (taken == topics.end() || isCloud(*taken)) return;
    menu_->addSection(tr("Angle of each line"));
    auto* group = new QActionGroup(menu_);
    const auto add = [&](const QString& words, const std::string& of) {
        QAction* row = menu_->addAction(words);
        row->setCheckable(true);
        row->setChecked(of == joint);
        group->addAction(row);
        connect(row, &QAction::triggered, this, [this, name = taken->topic.name, of] { emit chosen(name, of); });
    };
    add(tr("from the transforms, or from the joint that turned furthest"), {});
    for (const files::OfferedTopic& topic : topics) {
        for (const std::string& each : topic.topic.joints) {
            if (menu_->actions().size() < 2 * kMostRows) add(tr("from the joint %1").arg(shownText(each)), each);
        }
    }
}

void TopicMenu::addOthers(const std::vector<files::OfferedTopic>& topics) {
    menu_->addSeparator();
    int unused = 0;
    for (const files::OfferedTopic& topic : topics) {
        if (topic.topic.isScan) continue;
        if (topic.subscribed && !topic.topic.gives.empty())
            menu_->addAction(shownText(topic.topic.name) + ": " + counted(topic, shownText(topic.topic.gives)))->setEnabled(false);
        else
            ++unused;
    }
    if (unused > 0) menu_->addAction(tr("Topics that are not used: %1").arg(unused))->setEnabled(false);
}

} // namespace edgescan::ui

#include "moc_topic_menu.cpp"
