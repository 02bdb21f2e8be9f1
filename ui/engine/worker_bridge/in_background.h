// Work that is always completed, whatever is requested later: saving, closing a recording. Each runs on its own thread.
#pragma once

#include <QObject>
#include <QString>

#include <functional>

namespace edgescan::ui {

/// `work` runs on its own thread; the function that it returns is called on the GUI thread. `crashed` gets the text of an exception,
/// `ended` is called last, both on the GUI thread. Destroying `parent` waits for the work. GUI thread only.
void inBackground(
    QObject* parent, std::function<std::function<void()>()> work, std::function<void(const QString& what)> crashed,
    std::function<void()> ended = [] {});

} // namespace edgescan::ui
