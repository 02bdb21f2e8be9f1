// Scans from several stations of one place as layers in the frame of the first one.
#pragma once

#include "core/base/result.h"
#include "core/inspect/registration/scan_alignment.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::inspect {

/// One place as two scans show it, each in its own scanner frame, metres.
struct PointPair {
    Eigen::Vector3d firstM, otherM;
};

/// The rigid transform that brings the others onto the first with the least squares. Error: fewer than three pairs, or all on one line.
Result<RigidTransform> transformOfPairs(std::span<const PointPair> pairs);

/// How a scan got its place among the layers.
enum class StationBasis : std::uint8_t {
    Poses,    ///< both scans have a place in the mine
    Pairs,    ///< three or more points were picked in both
    Surfaces, ///< the scanners' frames are taken for the start
};

struct StationRequest {
    std::vector<PointPair> pairs = {}; ///< come before poses
    bool bySurfaces = true;            ///< the surfaces correct the start; always without poses and pairs
};

/// One layer.
struct Station {
    PlacedScan placed; ///< points in the scanner's frame of the first scan
    StationBasis by = StationBasis::Poses;
    std::optional<double> pairsM;     ///< root mean square distance of the pairs, if there were any
    std::optional<ScanAlignment> fit; ///< of the surfaces; empty where they do not determine it
    bool corrected = false;           ///< the fit was applied
    std::vector<std::string> warnings;
};

/// The layer of `other` in the frame of `first`. Error: of transformOfPairs(), or without poses and pairs of alignScans().
Result<Station> stationOf(const std::shared_ptr<const Scan>& first, const std::shared_ptr<const Scan>& other,
                          const StationRequest& wish = {});

/// A rock of one scan and the rock of another scan that is the same.
struct SameRock {
    int first = 0, other = 0; ///< labels
    std::size_t cells = 0;    ///< cells of the other rock that are on the first one
    double share = 0.0;       ///< of the smaller rock's cells that the other scan can see
};

/// Labels per cell, 0 = not a rock. Two rocks are the same if each is the one that the other one's cells fall on most often, within
/// `reachM`. Ordered by `first`.
[[nodiscard]] std::vector<SameRock> sameRocks(const PlacedScan& first, std::span<const int> firstRocks, const PlacedScan& other,
                                              std::span<const int> otherRocks, double reachM);

} // namespace edgescan::inspect
