// Which segment fits each of several cells best, by the planes of the segments (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/lanes.h"
#include "core/rocks/segmentation/planes.h"
#include "core/rocks/segmentation/segments.h"
#include "core/scan/grid/inverse_range.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace edgescan::rocks {

/// A cell and its neighbours by line, then beam.
inline constexpr std::size_t kThreeByThree = 9;

/// Cells that choose among the segments of their neighbours, a cell per lane.
struct ChoosingCells {
    /// Cracks between the cells of the 3 x 3, by line, then beam: six towards the next beam, six towards the next line.
    enum Crack : std::size_t {
        kAboveLeft,
        kAboveRight,
        kLeft,
        kRight,
        kBelowLeft,
        kBelowRight,
        kUpLeft,
        kUp,
        kUpRight,
        kDownLeft,
        kDown,
        kDownRight,
        kCracks
    };
    std::array<Lanes<std::uint32_t>, kThreeByThree> solid; ///< segments as in InnerCells
    std::array<Lanes<float>, kCracks> edge;                ///< 0..1: strength of the jump or valley there
    Lanes<float> u;                                        ///< 1/m
};

/// The segments that each cell may choose: those of the cell and its neighbours. A cell with fewer than others has kNoSegment there.
struct SegmentChoices {
    std::size_t most = 0; ///< number of choices of the cell that has most
    std::array<Lanes<std::uint32_t>, kThreeByThree> segment;
    /// Weights of the neighbours in it, in units of kWeightUnit; of the first segment the largest.
    std::array<Lanes<std::int32_t>, kThreeByThree> weight;
};

/// Weights are whole multiples of this, so that their sums are exact.
inline constexpr double kWeightUnit = 1.0 / (1U << 24U);

/// A neighbour behind an edge weighs less. For a diagonal neighbour: the path around the corner with the larger weight.
void listChoices(const ChoosingCells& cells, SegmentChoices& choices);

/// How far the ranges of the cells are from the planes, in standard deviations of the noise; `without` where a plane has no cells.
void measureDeviations(const WindowSums& windows, const Lanes<float>& u, const RangeNoise& noise, double without, Lanes<double>& off);

} // namespace edgescan::rocks
