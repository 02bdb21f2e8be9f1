// The surroundings of cells on borders, a cell per lane, and the features that are computed from them.
#pragma once

#include "core/rocks/segmentation/border_network.h"
#include "core/rocks/segmentation/planes.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace edgescan::rocks {

inline constexpr int kAround = 2; ///< cells on each side that are counted
inline constexpr std::size_t kAcross = 2 * kAround + 1;
inline constexpr std::size_t kCellsAround = kAcross * kAcross;

/// The four neighbours with a side in common.
enum CellSide : std::size_t { kLineBefore, kBeamBefore, kNextBeam, kNextLine, kCellSides };

/// Cells of a profile, in steps across the border towards the other segment.
inline constexpr std::array kProfile{-2, -1, 1, 2};

struct BorderLanes {
    std::array<Lanes<std::uint32_t>, 2> segment;          ///< the cell's own, and the other one
    std::array<Lanes<std::uint32_t>, kCellsAround> solid; ///< of the cells within kAround, by line, then beam
    std::array<Lanes<float>, kCellsAround> u;             ///< 1/m
    std::array<WindowSums, 2> windows;                    ///< of both segments
    std::array<Lanes<float>, kCellSides> jump, valley;    ///< towards each neighbour; any number if the grid ends there
    Lanes<float> rangeM, smoothedRangeM;
    Lanes<float> perM; ///< standard deviations per metre
    Lanes<float> beamStep, lineStep;
    Lanes<float> footprintMm;                           ///< width of the beam
    Lanes<float> jumpHere, foldHere;                    ///< after suppression
    std::array<Lanes<float>, kProfile.size()> profileU; ///< 1/m, of the profile's cells; 0 without a range
    std::array<Lanes<float>, 2> jumps, folds;           ///< after suppression, one step back and one step on
};

/// One segment as the cells see it.
struct BorderSide {
    Lanes<double> u, x, y, scatter; ///< plane: height at the cell, 1/m; slopes per cell; root of the mean square distance, 1/m
    Lanes<float> n;                 ///< cells of the plane
    Lanes<float> rangeM;            ///< of the plane at the cell; 0 without a plane
    Lanes<float> off, smoothOff; ///< of the cell's range, and of the smoothed one, from the plane, standard deviations; 61 without a plane
    Lanes<float> around;         ///< of its cells within kAround, their number
    Lanes<float> neighbours;     ///< of its cells next to the cell, the weights
    Lanes<float> adjacent;       ///< of the four neighbours, those in it
    Lanes<float> jump, valley;   ///< the largest towards them
    Lanes<float> closest, mean;  ///< of the neighbours' ranges from the cell's, standard deviations
};
using BorderSides = std::array<BorderSide, 2>;

/// The cells around.
struct BorderVotes {
    Lanes<std::int32_t> down, right; ///< which way the other segment is
    Lanes<float> own, other, near;   ///< means of the distance from the plane of `own` minus that from the other one
};

void measureSides(const BorderLanes& lanes, BorderSides& sides, BorderVotes& votes);
/// By the table in docs/method/rocks.md, "Step 6"; after the profile was looked up.
void writeFeatures(const BorderLanes& lanes, const BorderSides& sides, const BorderVotes& votes, BorderFeatureLanes& features);

} // namespace edgescan::rocks
