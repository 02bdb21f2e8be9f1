// The draw-bell: a rough funnel above the drift that the robot stands in.
#pragma once

#include "core/sim/scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace edgescan::sim {

inline constexpr double kFloorM = -1.5; ///< floor of the drift below the scanner
inline constexpr double kBellTopM = 16.0;

/// Elliptic cross-section that widens upward, with slow undulations that seed and place decide.
class Bell {
public:
    explicit Bell(std::uint64_t seed) : seed_(seed) {}

    /// Place on the wall at a height, at unit direction (c, s) in plan; metres.
    [[nodiscard]] Eigen::Vector3d wall(double c, double s, double heightM) const;

    /// 0 on the axis, 1 on the wall.
    [[nodiscard]] double share(const Eigen::Vector3d& placeM) const;

    /// Half-axes at a height without the undulation, metres.
    [[nodiscard]] static Eigen::Vector2d halfAxes(double heightM);

private:
    std::uint64_t seed_;
};

/// What closes the bell at the top.
struct Roof {
    bool present = true;
    Eigen::Vector2d openingM{0.0, 0.0}; ///< centre of the open raise in plan, metres
    double openingRadiusM = 1.2;        ///< 0 closes it
};

/// Adds the bell and the drift below it (along +y, towards where the robot came from) as two voids.
void addBell(Scene& scene, const Bell& bell, const Roof& roof);

/// Adds broken rock that has run down: a heap that rises towards the wall all round except where the drift comes in.
void addMuck(Scene& scene, const Bell& bell, std::uint64_t seed);

/// Adds loose ground of a given height over plan, out to 8 m round the scanner.
void addGround(Scene& scene, const std::function<double(double x, double y)>& heightM);

/// Height of the muck's surface, metres.
[[nodiscard]] double muckHeight(const Bell& bell, double x, double y, std::uint64_t seed);

/// Unit vectors at `count` equal angles, without calling sine and cosine of the C library more than once.
[[nodiscard]] std::vector<Eigen::Vector2d> compass(int count);

} // namespace edgescan::sim
