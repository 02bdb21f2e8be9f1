// Colours of rock faces: all of one luminance, so that shade means form; rocks that touch never have the same.
#pragma once

#include "core/rocks/rock_map.h"

#include <QColor>

#include <array>
#include <cstdint>
#include <vector>

namespace edgescan::ui {

inline constexpr int kRockColourCount = 7;
inline const std::array<QColor, kRockColourCount> kRockColours{QColor(0x46, 0x7c, 0xc4), QColor(0xb5, 0x67, 0x2b), QColor(0x90, 0x66, 0xc6),
                                                               QColor(0xc8, 0x53, 0x6e), QColor(0x26, 0x88, 0x84), QColor(0x88, 0x7b, 0x25),
                                                               QColor(0x79, 0x7a, 0x80)};

/// By label, place 0 unused: places in kRockColours. A rock keeps its colour while its pieces stay together and no neighbour needs it.
[[nodiscard]] std::vector<std::uint8_t> rockColours(const RockMap& map);

} // namespace edgescan::ui
