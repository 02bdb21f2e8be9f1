// Numbers as text for people and files, independent of the locale.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

/// "-12.345" with `decimals` decimals; zero is never written as "-0.000".
[[nodiscard]] std::string fixedText(double value, int decimals);
void appendFixed(std::string& text, double value, int decimals);

/// At most `digits` significant digits, with an exponent if that is shorter: "0.0123", "1.2e+06" (printf's %g).
[[nodiscard]] std::string significantText(double value, int digits);

/// The fewest digits that are read back as the same number; without exponent below 1e15: "250000", "0.1".
[[nodiscard]] std::string shortestText(double value);

/// The same for files, with an exponent wherever that is shorter. A float gets no more digits than a float needs.
template <class Number>
void appendShortest(std::string& text, Number value) {
    if (value != value) { // NaN, with either sign
        text += "nan";
        return;
    }
    std::array<char, 40> digits;
    text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

/// The nearest multiple of 1 / `parts`, so that the number is written with few digits.
[[nodiscard]] double rounded(double value, double parts);

/// The number that the whole text represents: "12", "-1.5e3", "+2", "nan", "inf". Empty for any other text.
[[nodiscard]] std::optional<double> numberOf(std::string_view text);

/// Changes capital letters A to Z to small ones, independent of the locale: in Turkish an I would become another letter.
[[nodiscard]] std::string asciiLower(std::string_view text);

/// "1 point", "0 points", "3 points". `many`: where the word for several, or a verb behind it, takes more than an s.
[[nodiscard]] std::string counted(std::uint64_t count, const std::string& one, const std::string& many = {});

/// The text with blanks before it, so that it has at least this width.
[[nodiscard]] std::string rightAligned(const std::string& text, std::size_t width);

} // namespace edgescan
