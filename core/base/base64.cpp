// Three bytes become four characters.
#include "core/base/base64.h"

#include <cstdint>

namespace edgescan {
namespace {

constexpr std::string_view kSigns = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
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

} // namespace edgescan
