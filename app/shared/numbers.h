// Flags that take a number. A number flag needs limits: NaN, infinities and values outside the limits are refused with the flag's name.
#pragma once

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace edgescan::cli {

struct TypedCell {
    int line = 0;
    int beam = 0;
};

/// Error: the text is not LINE,BEAM. `flag`: where it was typed.
[[nodiscard]] Result<TypedCell> typedCell(const std::string& text, const char* flag);

/// Refuses what is not LINE,BEAM.
[[nodiscard]] CLI::Validator cellText();

/// The index of the cell in the scan. Error: the scan has no such cell.
[[nodiscard]] Result<std::uint32_t> cellIn(const Scan& scan, const std::string& text, const char* flag);

/// Limits of every flag for a duration, seconds: the maximum is more than a year.
inline constexpr NumberLimits kSeconds{0, 4e7};

/// "a number from 0 to 20", "a whole number from 1 to 1000".
[[nodiscard]] std::string limitsText(NumberLimits limits, bool whole);

/// "NUMBER 0..20", for the help.
[[nodiscard]] std::string rangeName(NumberLimits limits);

/// Parses a number. Throws CLI::ValidationError with the flag's name, limits and unit (may be empty).
[[nodiscard]] double numberTyped(const std::string& flag, const std::string& text, NumberLimits limits, bool whole,
                                 const std::string& unit);

/// "s" of "End after this time [s]; 0 = run on"; empty: the help names no unit.
[[nodiscard]] std::string unitIn(const std::string& help);

template <class Value>
struct NumberIn {
    using Type = Value;
};
template <class Number>
struct NumberIn<std::optional<Number>> {
    using Type = Number;
};

/// Adds `flag` for a number of any type, or for an optional number. Integer types refuse fractions. The help shows the default.
template <class Value>
CLI::Option& addNumber(CLI::App& command, const std::string& flag, Value& value, NumberLimits limits, const std::string& help) {
    using Number = typename NumberIn<Value>::Type;
    static_assert(std::is_arithmetic_v<Number>);
    const auto parse = [flag, limits, unit = unitIn(help), &value](const std::string& text) {
        value = static_cast<Number>(numberTyped(flag, text, limits, std::is_integral_v<Number>, unit));
    };
    CLI::Option& option = *command.add_option_function<std::string>(flag, parse, help)->type_name(rangeName(limits));
    if constexpr (std::is_same_v<Value, Number>) {
        std::string start;
        appendShortest(start, value);
        option.default_str(start);
    }
    return option;
}

} // namespace edgescan::cli
