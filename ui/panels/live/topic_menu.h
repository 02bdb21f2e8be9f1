// The topics of a robot's bridge: what each gives, and which of them the scan comes from.
#pragma once

#include "core/files/live_feed/live_feed.h"

#include <QToolButton>

#include <string>
#include <vector>

class QMenu;

namespace edgescan::ui {

/// A button with a menu. GUI thread only.
class TopicMenu : public QToolButton {
    Q_OBJECT
public:
    explicit TopicMenu(QWidget* parent = nullptr);

    /// `joint`: the one that was chosen; empty: what is found gives the angles.
    void showTopics(const std::vector<files::OfferedTopic>& topics, const std::string& joint);

signals:
    /// The menu is about to be shown: showTopics() gives it what is known by now.
    void asked();
    void chosen(const std::string& topic, const std::string& joint);

private:
    void addScans(const std::vector<files::OfferedTopic>& topics, const std::string& joint);
    void addAngles(const std::vector<files::OfferedTopic>& topics, const std::string& joint);
    void addOthers(const std::vector<files::OfferedTopic>& topics);

    QMenu* menu_;
};

} // namespace edgescan::ui
