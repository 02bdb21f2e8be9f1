// The hang-up: large rocks get their places first, then the others jam between them and against the walls.
#include "app/lab/sim/scenes.h"

#include "app/lab/sim/bell.h"
#include "app/lab/sim/convex_rock.h"
#include "app/lab/sim/noise.h"
#include "app/lab/sim/packing.h"

#include <algorithm>
#include <cmath>

namespace edgescan::sim {
namespace {

/// The place where the rocks jam: a vault supported by the walls, with the chimney through it.
struct Vault {
    const Bell& bell;
    Eigen::Vector2d chimneyM;
    double chimneyRadiusM = 0.95;
    double springingM = 4.2; ///< height at the wall
    double crownM = 6.0;     ///< height on the axis
    double tilt = 0.0;       ///< rise per metre along x: real arches are never level

    [[nodiscard]] double height(const Eigen::Vector3d& p) const {
        const double s = std::min(1.0, bell.share(p));
        return springingM + (crownM - springingM) * (1.0 - s * s) + tilt * p.x();
    }
};

/// Weight and arching: moves a ball down onto the vault, away from the chimney, and never through the wall.
void settle(Ball& ball, const Vault& vault, double hang) {
    const double level = vault.height(ball.centre) + hang;
    if (ball.centre.z() < level)
        ball.centre.z() += 0.5 * (level - ball.centre.z());
    else
        ball.centre.z() -= std::min(0.06, ball.centre.z() - level);
    const Eigen::Vector2d off = ball.centre.head<2>() - vault.chimneyM;
    const double clear = vault.chimneyRadiusM + 0.9 * ball.radius;
    const double distance = off.norm();
    if (distance < clear && distance > 1e-6) ball.centre.head<2>() += off * (0.5 * (clear - distance) / distance);
    const double share = vault.bell.share(ball.centre);
    const double axis = vault.bell.halfAxes(ball.centre.z()).minCoeff();
    const double limit = 1.0 - 0.65 * ball.radius / axis; // wedged into the rough wall instead of leaning on it
    if (share > limit) ball.centre.head<2>() *= limit / share;
}

/// The large rock nearest to the axis.
std::size_t keystone(const std::vector<Ball>& balls) {
    constexpr std::size_t kLarge = 5; // the first ones are the largest
    std::size_t best = 0;
    for (std::size_t i = 1; i < std::min(kLarge, balls.size()); ++i) {
        if (balls[i].centre.head<2>().norm() < balls[best].centre.head<2>().norm()) best = i;
    }
    return best;
}

/// A place on the muck for a fallen rock; far below everything if there is no place: then the rock was drawn out.
Eigen::Vector3d landing(const Bell& bell, std::uint64_t seed, double sizeM, RandomSequence& dice) {
    constexpr int kTries = 40;
    for (int n = 0; n < kTries; ++n) {
        const double x = dice.uniform(-4.0, 4.0);
        const double y = dice.uniform(-4.5, 1.0);
        const double height = muckHeight(bell, x, y, seed) + 0.25 * sizeM;
        const bool nearScanner = std::hypot(x, y) < 1.6 + sizeM;
        // near the axis of a sweep it would appear in every line
        const bool onPole = y * y + height * height < (0.15 + 0.5 * sizeM) * x * x;
        if (!nearScanner && !onPole && bell.share({x, y, height}) < 0.95) return {x, y, height};
    }
    return {0.0, 0.0, -60.0};
}

/// Moves the rocks that the blast moves.
void blast(std::vector<Ball>& balls, const std::vector<double>& sizes, const Bell& bell, std::uint64_t seed) {
    constexpr double kBrokenOutM = 1.8, kLoosenedM = 2.8;
    if (balls.empty()) return;
    const Eigen::Vector3d at = balls[keystone(balls)].centre;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        RandomSequence dice(seed, Purpose::Blast, i);
        const double away = (balls[i].centre - at).norm();
        const bool stays = dice.uniform() < 0.5;
        if (away < kBrokenOutM)
            balls[i].centre = stays ? landing(bell, mixed(seed), sizes[i], dice) : Eigen::Vector3d(0.0, 0.0, -60.0);
        else if (away < kLoosenedM && !stays)
            balls[i].centre.z() -= dice.uniform(0.05, 0.4);
    }
}

void addArch(Scene& scene, const Vault& vault, const Rocks& rocks, std::uint64_t seed, bool afterBlast) {
    RandomSequence places(seed, Purpose::Places);
    std::vector<double> sizes = rockSizes(rocks.count, seed);
    for (double& size : sizes) size *= rocks.size;
    std::vector<double> hang;
    for (const double size : sizes) hang.push_back(size > 1.2 ? places.uniform(-0.45, 0.35) : places.uniform(0.0, 0.7));
    const auto place = [&](RandomSequence& dice) {
        Eigen::Vector3d p;
        do p = Eigen::Vector3d{dice.uniform(-7.0, 7.0), dice.uniform(-6.0, 6.0), vault.crownM};
        while (vault.bell.share(p) > 0.97);
        p.z() = vault.height(p) + dice.uniform(0.0, 0.8);
        return p;
    };
    const Confine confine = [&](std::size_t i, Ball& ball) { settle(ball, vault, hang[i]); };
    std::vector<Ball> balls = relaxed(scattered(ballRadii(sizes), place, places), confine, 0.88, 140);
    if (afterBlast) blast(balls, sizes, vault.bell, seed);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        RandomSequence shape(seed, Purpose::Shapes, i);
        addRock(scene, rockCorners(sizes[i], shape), balls[i].centre, rocks.rounding);
    }
}

/// Stones that fell before the hang-up.
void addRubble(Scene& scene, const Bell& bell, const Rocks& rocks, std::uint64_t seed) {
    RandomSequence dice(seed, Purpose::Rubble);
    for (int i = 0; i < rocks.count / 5;) {
        const double x = dice.uniform(-4.5, 4.5);
        const double y = dice.uniform(-4.5, 2.0);
        const double usual = dice.uniform(0.16, 0.4) + 0.8 * dice.uniform() * dice.uniform() * dice.uniform();
        const double size = rocks.size * usual;
        const double height = muckHeight(bell, x, y, seed);
        const bool onSlope = height > kFloorM + 0.6 && bell.share({x, y, height}) < 0.98;
        const bool onPole = y * y + height * height < 0.2 * x * x; // near the axis of a sweep it would appear in every line
        if (!onSlope || onPole) continue;
        RandomSequence shape(seed, Purpose::Shapes, static_cast<std::uint64_t>(1000000 + i));
        addRock(scene, rockCorners(size, shape), {x, y, height + 0.1 * size}, rocks.rounding);
        ++i;
    }
}

} // namespace

Scene hangupScene(std::uint64_t seed, const Rocks& rocks, const WallKind& wall, bool afterBlast) {
    RandomSequence dice(seed, Purpose::Bell);
    const Bell bell(mixed(seed), wall);
    const double side = dice.uniform() < 0.5 ? -1.0 : 1.0;
    const Vault vault{bell,
                      {side * dice.uniform(1.3, 2.2), dice.uniform(-1.6, 0.4)},
                      dice.uniform(0.8, 1.0),
                      4.2,
                      dice.uniform(5.6, 6.2),
                      dice.uniform(-0.12, 0.12)};
    Scene scene;
    addBell(scene, bell, {true, vault.chimneyM * 2.3, 1.3});
    addMuck(scene, bell, mixed(seed));
    addArch(scene, vault, rocks, seed, afterBlast);
    addRubble(scene, bell, rocks, mixed(seed));
    return scene;
}

} // namespace edgescan::sim
