// Digits by std::to_chars, which rounds as printf does and knows no locale.
#include "core/base/number_text.h"

#include <cmath>
#include <string_view>

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

std::string rightAligned(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

} // namespace edgescan
