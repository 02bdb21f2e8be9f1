// Scanned stones: their meshes, read once from a folder and shared by all scenes.
#pragma once

#include "app/lab/sim/stored_mesh.h"
#include "core/base/result.h"

#include <Eigen/Core>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::lab {

/// Its longest length is about 1.
struct Stone {
    std::string name;
    double edgeLength = 0; ///< of its triangles, mean
    std::shared_ptr<const sim::StoredMesh> mesh;
    std::vector<Eigen::Vector3f> hull; ///< corners of its convex hull
};

struct Stones {
    std::vector<Stone> stones;

    /// Null if there is none.
    [[nodiscard]] const Stone* named(std::string_view name) const;
};

/// Whether a stone belongs to a set. "free": weights that learned from it may be shipped (CC0, CC-BY). "lab": the others (epfl*, savaas*,
/// GPL-3.0), which only judge. "all": both.
[[nodiscard]] bool isInSet(std::string_view stone, std::string_view set);

/// "free", "lab", "all".
[[nodiscard]] const std::vector<std::string>& stoneSets();

/// Reads rocks.json and the NPZ file of each stone of a set. @param threads 0: one per core. Error: unknown set, a missing or damaged file.
Result<Stones> readStones(const std::filesystem::path& folder, const std::string& set = "all", int threads = 0);

} // namespace edgescan::lab
