// Writes digits by std::to_chars, which rounds like printf and does not depend on the locale.
#include "core/base/number_text.h"

#include <cmath>
#include <limits>
#include <system_error>

namespace edgescan {
namespace {

using Digits = std::array<char, 400>; // the largest double has 309 digits before its point

template <class... Format>
std::string_view write(Digits& digits, double value, Format... format) {
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value, format...).ptr};
}

} // namespace

void appendFixed(std::string& text, double value, int decimals) {
    Digits digits;
    std::string_view written = write(digits, value, std::chars_format::fixed, decimals);
    if (written.starts_with("-0") && written.find_first_of("123456789") == std::string_view::npos) written.remove_prefix(1);
    text += written;
}

std::string fixedText(double value, int decimals) {
    std::string text;
    appendFixed(text, value, decimals);
    return text;
}

std::string significantText(double value, int digits) {
    Digits room;
    return std::string(write(room, value, std::chars_format::general, digits));
}

std::string shortestText(double value) {
    Digits digits;
    return std::string(write(digits, value, std::abs(value) < 1e15 ? std::chars_format::fixed : std::chars_format::general));
}

double rounded(double value, double parts) { return std::round(value * parts) / parts; }

std::optional<double> numberOf(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty()) return std::nullopt;
    if (code == std::errc::result_out_of_range) { // 1e999 is read as infinite, 1e-999 as 0
        const std::size_t exponent = text.find_first_of("eE");
        const bool tiny = exponent != std::string_view::npos && text.substr(exponent + 1).starts_with('-');
        return tiny ? 0.0 : std::copysign(std::numeric_limits<double>::infinity(), text[0] == '-' ? -1.0 : 1.0);
    }
    if (code != std::errc{}) return std::nullopt;
    return value;
}

std::string asciiLower(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    return lower;
}

std::string counted(std::uint64_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many.empty() ? one + "s" : many);
}

std::string rightAligned(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

} // namespace edgescan
