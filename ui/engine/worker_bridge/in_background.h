// Work that is done whatever is asked for after it: saving, closing a recording. Each on a thread of its own.
#pragma once

#include <QObject>
#include <QString>

#include <functional>

namespace edgescan::ui {

/// `work` runs on a thread of its own; what it returns is called on the GUI thread. `crashed` is told what it threw, `ended` comes last,
/// both on the GUI thread. Destroying `parent` waits for the work. GUI thread only.
void inBackground(
    QObject* parent, std::function<std::function<void()>()> work, std::function<void(const QString& what)> crashed,
    std::function<void()> ended = [] {});

} // namespace edgescan::ui
