// Numbers as text for people and files, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

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

/// The nearest multiple of 1 / `parts`: a number that is written with few digits.
[[nodiscard]] double rounded(double value, double parts);

/// The number that a text is from its first character to its last: "12", "-1.5e3", "+2", "nan", "inf". Empty for anything else.
[[nodiscard]] std::optional<double> numberOf(std::string_view text);

/// Capital letters A to Z made small, whatever the locale: in Turkish an I would become another letter.
[[nodiscard]] std::string asciiLower(std::string_view text);

/// Text with blanks before it until it is so wide.
[[nodiscard]] std::string rightAligned(const std::string& text, std::size_t width);

} // namespace edgescan
