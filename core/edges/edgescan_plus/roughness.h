// How rough the surfaces of a scan are: where nearly half of the cells fold, a fold must exceed its surroundings
// (docs/method/edges.md, "Rules of default set 4").
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// The share of the cells within 15 degrees that fold.
struct Roughness {
    double share = 0;       ///< of all cells of the scan
    double aroundFolds = 0; ///< median around those cells whose fold is, or is nearly, an edge
    bool rough = false;     ///< the scan is one of rough surfaces: aroundFolds is above 0.46, and neither noise nor coarseness explains it
    Grid<float> around;     ///< lines x groups of kGroup beams; empty unless the scan is rough

    static constexpr int kGroup = 16;

    [[nodiscard]] float aroundAt(int line, int beam) const { return around.at(line, beam / kGroup); }
    /// How many times as strong as elsewhere a fold must be: 1 where the surface is not rough.
    [[nodiscard]] float factorAt(int line, int beam) const;
};

/// |S_C| before suppression above which a cell folds.
inline constexpr float kFoldingFrom = 0.35F;

/// The sums of groups of Roughness::kGroup values of 0 or 1.
void countGroups(const std::vector<std::uint8_t>& marks, std::uint8_t* counts);

/// Lines x groups of Roughness::kGroup beams: the number of cells that fold before suppression, and of those that are not void.
struct FoldingCells {
    Grid<std::uint8_t> folding, solid;
    int beams = 0;

    FoldingCells() = default;
    FoldingCells(int lines, int beamCount);
    /// Notes one line. `alongBeams`, `alongLines`: S_C of its cells. Lines may be noted in any order, and by several threads.
    void note(int line, const float* alongBeams, const float* alongLines, const Support* support);
};

/// The fold that noise alone may look like, divided by the smallest fold C0, at the range `rangeM` and the distance `spacingMm` of points.
[[nodiscard]] double foldOfNoise(const DepthLimits& limits, double rangeM, double spacingMm);

/// `crease`: S_C after suppression. `ofNoise`: foldOfNoise(); from 1.2 on no scan is rough, because folds may be noise. Nor is one rough
/// where points at folds are 80 mm apart or more: a rock of a few cells folds everywhere.
[[nodiscard]] Roughness roughnessOf(const FoldingCells& cells, const Grid<float>& u, const AngularSteps& steps, const Grid<float>& crease,
                                    double ofNoise);

/// Divides each fold by the factor of its cell, if the scan is rough.
void weighFolds(const Roughness& roughness, Grid<float>& crease);

} // namespace edgescan::edges
