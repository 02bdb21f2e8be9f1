// Numbers with their thousands apart.
#pragma once

#include "ui/base/language/languages.h"

#include <QLocale>
#include <QString>

#include <concepts>

namespace edgescan::ui {

/// "1,136,154" in English. In the other languages "1 136 154" with narrow no-break spaces (ISO 80000-1): all numbers of the window have a
/// decimal point, next to which neither a comma nor a point may part thousands. The only place that does this (tests/cli/exits_test.cpp).
template <std::integral Number>
[[nodiscard]] QString countText(Number n) {
    QString text = QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qlonglong>(n));
    return languageInUse() == QLatin1String("en") ? text : text.replace(QLatin1Char(','), QChar(0x202F));
}

} // namespace edgescan::ui
