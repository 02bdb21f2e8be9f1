// Decimal numbers as text, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace edgescan {

/// "-12.345" with so many decimals; a zero is never "-0.000". The value is finite.
inline void appendDecimal(std::string& text, double value, int decimals) {
    std::array<char, 340> digits{};
    const auto [end, problem] = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
    if (problem != std::errc{}) return;
    const std::string_view written(digits.data(), static_cast<std::size_t>(end - digits.data()));
    text += written.starts_with('-') && written.find_first_of("123456789") == std::string_view::npos ? written.substr(1) : written;
}

} // namespace edgescan
