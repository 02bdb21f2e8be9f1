// Numbers with thousands separators.
#pragma once

#include <QLocale>
#include <QString>

#include <cstddef>

namespace edgescan::ui {

/// "1,136,154", the same in every language.
[[nodiscard]] inline QString countText(std::size_t n) {
    return QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qulonglong>(n));
}

} // namespace edgescan::ui
