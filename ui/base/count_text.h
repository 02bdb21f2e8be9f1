// Counts in words: thousands apart, one and several.
#pragma once

#include "ui/base/language/languages.h"

#include <QLocale>
#include <QObject>
#include <QString>

#include <concepts>
#include <cstddef>

namespace edgescan::ui {

/// "1,136,154" in English. In the other languages "1 136 154" with narrow no-break spaces (ISO 80000-1): all numbers of the window have a
/// decimal point, next to which neither a comma nor a point may part thousands. The only place that does this (tests/cli/exits_test.cpp).
template <std::integral Number>
[[nodiscard]] QString countText(Number n) {
    QString text = QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qlonglong>(n));
    return languageInUse() == QLatin1String("en") ? text : text.replace(QLatin1Char(','), QChar(0x202F));
}

/// "1 target", "3 targets".
[[nodiscard]] inline QString targetCount(std::size_t targets) {
    return targets == 1 ? QObject::tr("1 target") : QObject::tr("%1 targets").arg(targets);
}

/// "1 rock", "12 rocks".
[[nodiscard]] inline QString rockCount(std::size_t rocks) {
    return rocks == 1 ? QObject::tr("1 rock") : QObject::tr("%1 rocks").arg(countText(rocks));
}

} // namespace edgescan::ui
