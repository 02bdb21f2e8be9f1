// Three bytes become four characters.
#include "core/base/base64.h"

#include <array>
#include <cstdint>

namespace edgescan {
namespace {

constexpr std::string_view kSigns = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoSign = 64;

constexpr std::array<std::uint8_t, 256> valuesOfSigns() {
    std::array<std::uint8_t, 256> values{};
    values.fill(kNoSign);
    for (std::size_t i = 0; i < kSigns.size(); ++i) values[static_cast<unsigned char>(kSigns[i])] = static_cast<std::uint8_t>(i);
    return values;
}

} // namespace

std::string base64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        std::uint32_t three = static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << 16U;
        if (left > 1) three |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + 1])) << 8U;
        if (left > 2) three |= static_cast<unsigned char>(bytes[i + 2]);
        text += kSigns[three >> 18U & 63U];
        text += kSigns[three >> 12U & 63U];
        text += left > 1 ? kSigns[three >> 6U & 63U] : '=';
        text += left > 2 ? kSigns[three & 63U] : '=';
    }
    return text;
}

std::optional<std::string> bytesOfBase64(std::string_view text) {
    static constexpr std::array<std::uint8_t, 256> kValues = valuesOfSigns();
    if (text.size() % 4 != 0) return std::nullopt;
    const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        const std::size_t signs = i + 4 == text.size() ? 4 - padding : 4;
        std::uint32_t three = 0;
        for (std::size_t n = 0; n < 4; ++n) {
            const std::uint8_t value = n < signs ? kValues[static_cast<unsigned char>(text[i + n])] : std::uint8_t{0};
            if (value == kNoSign) return std::nullopt;
            three = three << 6U | value;
        }
        for (std::size_t n = 0; n + 1 < signs; ++n) bytes += static_cast<char>(three >> (16U - 8U * n) & 255U);
    }
    return bytes;
}

} // namespace edgescan
