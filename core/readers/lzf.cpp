// LZF unpacking; every length and distance is checked.
#include "core/readers/lzf.h"

namespace edgescan {

std::vector<std::byte> unpackLzf(std::span<const std::byte> packed, std::size_t size) {
    std::vector<std::byte> out(size);
    std::size_t in = 0;
    std::size_t filled = 0;
    const auto next = [&] { return std::to_integer<std::size_t>(packed[in++]); };
    while (in < packed.size()) {
        const std::size_t control = next();
        if (control < 32) { // a run of control + 1 bytes as they are
            const std::size_t count = control + 1;
            if (count > packed.size() - in || count > size - filled) return {};
            for (std::size_t i = 0; i < count; ++i) out[filled++] = packed[in++];
            continue;
        }
        std::size_t length = control >> 5U;
        if (length == 7) {
            if (in == packed.size()) return {};
            length += next();
        }
        length += 2;
        if (in == packed.size()) return {};
        const std::size_t distance = ((control & 31U) << 8U) + next() + 1;
        if (distance > filled || length > size - filled) return {};
        for (std::size_t i = 0; i < length; ++i, ++filled) out[filled] = out[filled - distance]; // may overlap: byte by byte
    }
    if (filled != size) return {};
    return out;
}

} // namespace edgescan
