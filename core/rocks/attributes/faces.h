// Rocks as coloured faces: the colour of each rock, the borders, and the hatching.
#pragma once

#include "core/base/rgb.h"
#include "core/rocks/attributes/study.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace edgescan::rocks {

inline constexpr std::size_t kRockColourCount = 7;
/// All of the same luminance, so that brightness shows only the shape.
inline constexpr std::array<Rgb, kRockColourCount> kRockFaceColours{{{0x46, 0x7c, 0xc4},
                                                                     {0xb5, 0x67, 0x2b},
                                                                     {0x90, 0x66, 0xc6},
                                                                     {0xc8, 0x53, 0x6e},
                                                                     {0x26, 0x88, 0x84},
                                                                     {0x88, 0x7b, 0x25},
                                                                     {0x79, 0x7a, 0x80}}};

/// By label, index 0 unused: indices of kRockFaceColours. Rocks that touch get different colours. A rock keeps its colour while its pieces
/// stay together and a neighbour does not need the colour.
[[nodiscard]] std::vector<std::uint8_t> rockColours(const RegionMap& map);

/// Whether the cell belongs to a rock and a neighbour has another label. Between two rocks this is true on one side only, so that the
/// border is one cell wide.
[[nodiscard]] bool isRockBorder(const Grid<std::uint32_t>& labels, int line, int beam);

/// The faces painted into a picture of the scan.
struct Faces {
    Grid<std::uint32_t> labels;        ///< lines x beams: 0 = not a rock
    std::vector<std::uint8_t> colours; ///< by label: index of kRockFaceColours
    std::vector<std::uint8_t> hatched; ///< by label: 1 if the outline is doubtful
    int hatchCells = 6;                ///< distance between dark stripes

    /// The colour of a cell: dark on borders and in the stripes of hatched faces; empty outside rocks.
    [[nodiscard]] std::optional<Rgb> at(int line, int beam) const;
};
[[nodiscard]] Faces rockFaces(const Study& study);

} // namespace edgescan::rocks
