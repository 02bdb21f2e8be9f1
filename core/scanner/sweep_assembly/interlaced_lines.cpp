// Computes the layout of interlaced lines.
#include "core/scanner/sweep_assembly/interlaced_lines.h"

#include <algorithm>
#include <cmath>

namespace edgescan::scanner {
namespace {

constexpr int kMostParts = 8;
constexpr double kSameDeg = 1e-6; // angles are snapped or given in 1/10000 degree
constexpr double kAlignedPart = 0.01;

/// The part that starts `offset` steps after part 0, or -1.
int partAt(double offset, int parts) {
    const double part = offset * parts;
    const double nearest = std::round(part);
    if (std::abs(part - nearest) > kAlignedPart * parts || nearest < 0 || nearest >= parts) return -1;
    return static_cast<int>(nearest);
}

} // namespace

std::optional<int> InterlacedBeams::partOf(const BeamGrid& grid) const {
    if (std::abs(grid.stepDeg - stepDeg) > kSameDeg) return std::nullopt;
    const bool same = std::abs(grid.startDeg - startDeg) <= kSameDeg;
    const int part = same ? 0 : stepDeg > 0 ? partAt((grid.startDeg - startDeg) / stepDeg, parts) : -1;
    return part >= 0 && grid.beams <= beamsOf(part) ? std::optional(part) : std::nullopt;
}

std::vector<double> InterlacedBeams::beamDeg() const {
    std::vector<double> degrees;
    degrees.reserve(static_cast<std::size_t>(beams));
    // As in the telegram for part 0, and snapped to the grid for the starts of the other parts.
    for (int j = 0; j < beams; ++j) {
        const int part = j % parts;
        const double start = part == 0 ? startDeg : snappedDeg(startDeg + stepDeg * part / parts);
        degrees.push_back(start + j / parts * stepDeg);
    }
    return degrees;
}

std::optional<InterlacedBeams> interlacedBeams(std::span<const BeamGrid> grids) {
    if (grids.empty()) return std::nullopt;
    InterlacedBeams all{grids[0].startDeg, grids[0].stepDeg, 1, 0};
    for (const BeamGrid& grid : grids) all.startDeg = std::min(all.startDeg, grid.startDeg);
    const auto fits = [&](int parts) {
        return std::all_of(grids.begin(), grids.end(), [&](const BeamGrid& grid) {
            if (std::abs(grid.stepDeg - all.stepDeg) > kSameDeg) return false;
            if (std::abs(grid.startDeg - all.startDeg) <= kSameDeg) return true;
            return all.stepDeg > 0 && partAt((grid.startDeg - all.startDeg) / all.stepDeg, parts) >= 0;
        });
    };
    while (all.parts <= kMostParts && !fits(all.parts)) ++all.parts;
    if (all.parts > kMostParts) return std::nullopt;
    for (const BeamGrid& grid : grids) {
        const int part = all.parts == 1 ? 0 : partAt((grid.startDeg - all.startDeg) / all.stepDeg, all.parts);
        if (grid.beams > 0) all.beams = std::max(all.beams, part + (grid.beams - 1) * all.parts + 1);
    }
    return all;
}

} // namespace edgescan::scanner
