// A picture of the window with what the scan warns of.
#pragma once

#include <QFont>
#include <QImage>
#include <QStringList>

namespace edgescan::ui {

/// A picture travels without the window: the warnings stand below it. As it is where there are none.
[[nodiscard]] QImage withWarnings(const QImage& window, const QStringList& warnings, const QFont& font);

} // namespace edgescan::ui
