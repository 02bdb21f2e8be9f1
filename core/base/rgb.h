// A colour of 8 bits per channel.
#pragma once

#include <cstdint>

namespace edgescan {

struct Rgb {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Rgb&) const = default;
};

} // namespace edgescan
