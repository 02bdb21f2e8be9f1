// Rocks as coloured faces: which colour each has, where their borders run, and which are hatched.
#pragma once

#include "core/base/rgb.h"
#include "core/rocks/attributes/study.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace edgescan {

inline constexpr std::size_t kRockColourCount = 7;
/// All of one luminance, so that shade means form.
inline constexpr std::array<Rgb, kRockColourCount> kRockFaceColours{{{0x46, 0x7c, 0xc4},
                                                                     {0xb5, 0x67, 0x2b},
                                                                     {0x90, 0x66, 0xc6},
                                                                     {0xc8, 0x53, 0x6e},
                                                                     {0x26, 0x88, 0x84},
                                                                     {0x88, 0x7b, 0x25},
                                                                     {0x79, 0x7a, 0x80}}};

/// By label, place 0 unused: places in kRockFaceColours. Rocks that touch have others; a rock keeps its colour while its pieces stay
/// together and no neighbour needs it.
[[nodiscard]] std::vector<std::uint8_t> rockColours(const RockMap& map);

/// Cells of rocks with another label beside them; between two rocks only one of the two, so that the border is one cell wide.
[[nodiscard]] bool isRockBorder(const Grid<std::uint32_t>& labels, int line, int beam);

/// What is painted in a picture of so many beams.
struct RockFaces {
    Grid<std::uint32_t> labels;        ///< lines x beams: 0 none
    std::vector<std::uint8_t> colours; ///< by label
    std::vector<std::uint8_t> hatched; ///< by label: 1 where the outline is doubtful
    int hatchCells = 6;                ///< from one dark stripe to the next

    /// Dark on borders and in the stripes of hatched faces; empty beside rocks.
    [[nodiscard]] std::optional<Rgb> at(int line, int beam) const;
};
[[nodiscard]] RockFaces rockFaces(const RockStudy& study);

} // namespace edgescan
