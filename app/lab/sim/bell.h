// The draw-bell: a rough funnel above the drift in which the robot is parked.
#pragma once

#include "app/lab/sim/scene.h"
#include "app/lab/sim/wall_kinds.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace edgescan::sim {

inline constexpr double kFloorM = -1.5; ///< floor of the drift, relative to the scanner

/// Elliptic cross-section that widens upward, with slow undulations that depend on seed and place.
class Bell {
public:
    explicit Bell(std::uint64_t seed, const WallKind& kind = wallKinds().front()) : seed_(seed), kind_(&kind) {}

    /// The point of the wall at a height, in the horizontal unit direction (c, s); metres.
    [[nodiscard]] Eigen::Vector3d wall(double c, double s, double heightM) const;

    /// 0 on the axis, 1 on the wall.
    [[nodiscard]] double share(const Eigen::Vector3d& placeM) const;

    /// Half-axes at a height without the undulation, metres.
    [[nodiscard]] Eigen::Vector2d halfAxes(double heightM) const;

    [[nodiscard]] const WallKind& kind() const { return *kind_; }
    /// Height of loose ground that would be at `heightM` without the lumps of this kind, metres.
    [[nodiscard]] double onGround(double x, double y, double heightM) const;

private:
    std::uint64_t seed_;
    const WallKind* kind_;
};

/// The roof of the bell.
struct Roof {
    bool present = true;
    Eigen::Vector2d openingM{0.0, 0.0}; ///< horizontal centre of the open raise, metres
    double openingRadiusM = 1.2;        ///< 0: no opening
};

/// Adds the bell and the drift below it (along +y, the direction from which the robot came) as two voids.
void addBell(Scene& scene, const Bell& bell, const Roof& roof);

/// Adds broken rock that ran down: a heap that rises towards the wall on all sides except at the drift.
void addMuck(Scene& scene, const Bell& bell, std::uint64_t seed);

/// Adds loose ground with a height given over the horizontal plane, up to 8 m around the scanner.
void addGround(Scene& scene, const Bell& bell, const std::function<double(double x, double y)>& heightM);

/// Height of the muck's surface, metres.
[[nodiscard]] double muckHeight(const Bell& bell, double x, double y, std::uint64_t seed);

/// Unit vectors at `count` equal angles; calls sine and cosine of the C library only once.
[[nodiscard]] std::vector<Eigen::Vector2d> compass(int count);

} // namespace edgescan::sim
