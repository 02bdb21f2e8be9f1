// A heap of stones at rest: where each of them is, from physics or from a file.
#pragma once

#include "app/lab/stones/site.h"
#include "app/lab/stones/stones.h"

#include <Eigen/Geometry>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace edgescan::lab {

struct RestingStone {
    std::string stone; ///< Stone::name
    double sizeM = 0;  ///< scale of its mesh
    Eigen::Vector3d placeM = Eigen::Vector3d::Zero();
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity(); ///< from the mesh's frame
    double speedMps = 0;                                      ///< above 0.5: it still falls, or fell out
};
using Heap = std::vector<RestingStone>;

/// Called with the share done, 0..1; false cancels.
using StoneProgress = std::function<bool(double fraction)>;

/// Whether this program has the physics (Bullet).
[[nodiscard]] bool canSettle();

/// Lets stones of a set fall one after another as their convex hulls, until they rest. One seed gives the same heap on one machine. Error:
/// "cancelled", no physics in this program.
Result<Heap> settledHeap(const Site& site, const Stones& stones, const std::string& set, std::uint64_t seed,
                         const StoneProgress& progress = {});

/// The name of the file of a heap: "bench-free-1.json".
[[nodiscard]] std::string heapFileName(const std::string& kind, const std::string& set, std::uint64_t seed);

/// readHeap() gives back the same bits. Error: the folder cannot be written to, the file is missing or damaged.
Result<Done> writeHeap(const Heap& heap, const std::filesystem::path& folder, const std::string& name);
Result<Heap> readHeap(const std::filesystem::path& path);

} // namespace edgescan::lab
