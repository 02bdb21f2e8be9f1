// Flags that take a number. There is no way to add one without its limits: NaN, infinities and whatever lies outside are refused by name.
#pragma once

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace edgescan::cli {

/// Of any flag that says how long, seconds: more than a year.
inline constexpr NumberLimits kSeconds{0, 4e7};

/// "a number from 0 to 20", "a whole number from 1 to 1000".
[[nodiscard]] std::string limitsText(NumberLimits limits, bool whole);

/// "NUMBER 0..20", for the help.
[[nodiscard]] std::string rangeName(NumberLimits limits);

/// The number typed. Throws CLI::ValidationError with the flag's name and limits.
[[nodiscard]] double numberTyped(const std::string& flag, const std::string& text, NumberLimits limits, bool whole);

/// Adds `flag` for a number of any type; whole ones take no fractions. A default is told in the help.
template <class Number>
CLI::Option& addNumber(CLI::App& command, const std::string& flag, Number& value, NumberLimits limits, const std::string& help) {
    static_assert(std::is_arithmetic_v<Number>);
    constexpr bool kWhole = std::is_integral_v<Number>;
    std::string start;
    appendShortest(start, value);
    return *command
                .add_option_function<std::string>(
                    flag,
                    [flag, limits, &value](const std::string& text) {
                        value = static_cast<Number>(numberTyped(flag, text, limits, kWhole));
                    },
                    help)
                ->type_name(rangeName(limits))
                ->default_str(start);
}

template <class Number>
CLI::Option& addNumber(CLI::App& command, const std::string& flag, std::optional<Number>& value, NumberLimits limits,
                       const std::string& help) {
    constexpr bool kWhole = std::is_integral_v<Number>;
    return *command
                .add_option_function<std::string>(
                    flag,
                    [flag, limits, &value](const std::string& text) {
                        value = static_cast<Number>(numberTyped(flag, text, limits, kWhole));
                    },
                    help)
                ->type_name(rangeName(limits));
}

} // namespace edgescan::cli
