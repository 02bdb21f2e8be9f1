// Numbers as text for people and files, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace edgescan {

/// "-12.345" with so many decimals; a zero is never "-0.000".
[[nodiscard]] std::string fixedText(double value, int decimals);
void appendFixed(std::string& text, double value, int decimals);

/// At most so many digits that count, with an exponent where it is shorter: "0.0123", "1.2e+06" (printf's %g).
[[nodiscard]] std::string significantText(double value, int digits);

/// The fewest digits that are read back as the same number; written out below 1e15: "250000", "0.1".
[[nodiscard]] std::string shortestText(double value);

/// The same for files, with an exponent wherever that is shorter. Floats keep the few digits of a float.
template <class Number>
void appendShortest(std::string& text, Number value) {
    if (value != value) { // whatever its sign
        text += "nan";
        return;
    }
    std::array<char, 40> digits;
    text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

/// Text with blanks before it until it is so wide.
[[nodiscard]] std::string rightAligned(const std::string& text, std::size_t width);

} // namespace edgescan
