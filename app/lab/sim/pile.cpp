// The pile: the rocks in the drawpoint after the bell has run; and the empty bell.
#include "app/lab/sim/bell.h"
#include "app/lab/sim/convex_rock.h"
#include "app/lab/sim/noise.h"
#include "app/lab/sim/packing.h"
#include "app/lab/sim/scenes.h"

#include <algorithm>
#include <cmath>

namespace edgescan::sim {
namespace {

// the slope is built at the size of the bell in "hangup" and then enlarged, so that there is space in front of it
constexpr double kLarger = 2.1;

/// Surface of the slope below the rocks: rises towards -y at the angle of repose.
double slopeHeight(double x, double y, std::uint64_t seed) {
    const double rise = 0.72 * std::max(0.0, -y - 1.6 + 0.03 * x * x);
    return kFloorM - 0.2 + std::min(rise, 3.2) + 0.15 * valueNoise({0.9 * x, 0.9 * y, 2.0}, seed);
}

void settle(Ball& ball, const Bell& bell, std::uint64_t seed) {
    constexpr double kClearM = 1.7; // keeps rocks away from the robot
    const double level = slopeHeight(ball.centre.x(), ball.centre.y(), seed) + 0.4 * ball.radius;
    ball.centre.z() = std::max(level, ball.centre.z() - 0.05);
    const double distance = ball.centre.norm();
    const double clear = kClearM + ball.radius;
    if (distance < clear && distance > 1e-6) ball.centre *= clear / distance;
    const double share = bell.share(ball.centre);
    const double limit = 1.0 - 0.65 * ball.radius / bell.halfAxes(ball.centre.z()).minCoeff();
    if (share > limit) ball.centre.head<2>() *= limit / share;
}

void addPile(Scene& scene, const Bell& bell, const Rocks& rocks, std::uint64_t seed) {
    RandomSequence places(seed, Purpose::Places);
    std::vector<double> sizes = rockSizes(rocks.count, seed);
    for (double& size : sizes) size = rocks.size * size / kLarger;
    const auto place = [&](RandomSequence& dice) {
        Eigen::Vector3d p;
        do p = Eigen::Vector3d{dice.uniform(-5.5, 5.5), dice.uniform(-5.5, -0.8), 1.0};
        while (bell.share(p) > 0.97);
        p.z() = slopeHeight(p.x(), p.y(), seed) + dice.uniform(0.2, 1.5);
        return p;
    };
    const std::vector<Ball> balls = relaxed(
        scattered(ballRadii(sizes), place, places), [&](std::size_t, Ball& ball) { settle(ball, bell, seed); }, 0.88, 140);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        RandomSequence shape(seed, Purpose::Shapes, i);
        addRock(scene, rockCorners(sizes[i], shape), balls[i].centre, rocks.rounding);
    }
}

} // namespace

Scene pileScene(std::uint64_t seed, const Rocks& rocks, const WallKind& wall) {
    const Bell bell(mixed(seed), wall);
    Scene scene;
    addBell(scene, bell, {.present = false});
    addGround(scene, bell, [&](double x, double y) { return slopeHeight(x, y, seed); });
    addPile(scene, bell, rocks, seed);
    // The boom leans towards the slope: the middle beam points along -y, 16 degrees up.
    Eigen::Matrix3f lean;
    lean << 1.0F, 0.0F, 0.0F, 0.0F, 0.28F, 0.96F, 0.0F, -0.96F, 0.28F;
    return rotated(scaled(std::move(scene), static_cast<float>(kLarger)), lean);
}

Scene emptyScene(std::uint64_t seed, const WallKind& wall) {
    const Bell bell(mixed(seed), wall);
    Scene scene;
    addBell(scene, bell, {.openingRadiusM = wall.archFits ? 1.2 : 0.0});
    addMuck(scene, bell, mixed(seed));
    return scene;
}

} // namespace edgescan::sim
