// The kinds of wall of the simulated bell: a kind changes its section, moves its points, or fixes things to it.
#pragma once

#include "app/lab/sim/scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <string_view>

namespace edgescan::sim {

class Bell;

struct WallKind {
    const char* name;
    const char* help;
    /// Half-axes of the section at a height above the floor, metres.
    Eigen::Vector2d (*halfAxesM)(double aboveFloorM);
    double topM = 16.0;   ///< height of the roof's rim, relative to the scanner
    bool archFits = true; ///< high enough for rocks that jam, and for a raise in the roof
    int nodesPerNode = 1; ///< of the lattice in both directions, compared with the plain wall
    /// How far a point of the wall is moved away from the axis, metres. Absent: not at all.
    double (*outwardM)(const Eigen::Vector3d& placeM, std::uint64_t seed) = nullptr;
    /// How far a point of the loose ground is raised, metres. Absent: not at all.
    double (*groundM)(const Eigen::Vector3d& placeM, std::uint64_t seed) = nullptr;
    /// Adds what is fixed to the wall. Absent: nothing.
    void (*attach)(Scene& scene, const Bell& bell) = nullptr;
};

/// The first kind is the plain wall.
[[nodiscard]] std::span<const WallKind> wallKinds();

/// Null if there is no such kind.
[[nodiscard]] const WallKind* wallKindNamed(std::string_view name);

} // namespace edgescan::sim
