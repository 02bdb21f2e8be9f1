// Draws the warnings of the scan below a picture of the window.
#pragma once

#include <QFont>
#include <QImage>
#include <QStringList>

namespace edgescan::ui {

/// The picture is used without the window; therefore the warnings are drawn below it. Unchanged without warnings.
[[nodiscard]] QImage withWarnings(const QImage& window, const QStringList& warnings, const QFont& font);

} // namespace edgescan::ui
