// Rocks: random corners of a block, their hull, and the half-spaces for ray casting.
#include "app/lab/sim/convex_rock.h"

#include "app/lab/sim/rounded_core.h"
#include "core/base/geometry/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::sim {
namespace {

constexpr double kMinSizeM = 0.16;
constexpr double kMaxSizeM = 2.6;

Eigen::Vector3d randomDirection(RandomSequence& dice) {
    Eigen::Vector3d d;
    do d = Eigen::Vector3d{dice.normal(), dice.normal(), dice.normal()};
    while (d.norm() < 1e-3);
    return d.normalized();
}

Eigen::Matrix3d randomTurn(RandomSequence& dice) {
    Eigen::Quaterniond q;
    do q = Eigen::Quaterniond{dice.normal(), dice.normal(), dice.normal(), dice.normal()};
    while (q.norm() < 1e-3);
    return q.normalized().toRotationMatrix();
}

/// A block between three sets of joints, with corners and edges broken off.
std::vector<Eigen::Vector3d> blockPlanes(int count, RandomSequence& dice) {
    std::vector<Eigen::Vector3d> planes;
    const double skew = dice.uniform(0.05, 0.30);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const Eigen::Vector3d normal = (side * Eigen::Vector3d::Unit(axis) + skew * randomDirection(dice)).normalized();
            planes.emplace_back(normal / dice.uniform(0.72, 0.92));
        }
    }
    while (static_cast<int>(planes.size()) < count) planes.emplace_back(randomDirection(dice) / dice.uniform(0.80, 1.0));
    return planes;
}

void addFacet(Scene& scene, ConvexBody& body, const Eigen::Vector3d& normal, double offset, const Surface& look) {
    Surface surface = look;
    surface.normal = normal.cast<float>();
    body.facets.push_back({surface.normal, static_cast<float>(offset), static_cast<std::int32_t>(scene.surfaces.size())});
    scene.surfaces.push_back(surface);
}

} // namespace

std::vector<double> rockSizes(int count, std::uint64_t seed) {
    RandomSequence dice(seed, Purpose::Sizes);
    std::vector<double> sizes;
    while (static_cast<int>(sizes.size()) < count) {
        const double size = 0.50 * std::exp(0.70 * dice.normal());
        if (size < kMinSizeM || size > kMaxSizeM) continue;
        sizes.push_back(std::round(size * 1e4) / 1e4); // the last bit of exp() may differ between machines
    }
    std::sort(sizes.rbegin(), sizes.rend());
    // A few blocks that are large compared with the throat hold an arch. With a log-normal distribution alone such blocks would be rare.
    constexpr std::array<double, 5> kKeystones{2.6, 2.5, 2.3, 2.1, 1.9};
    for (std::size_t i = 0; i < std::min(kKeystones.size(), sizes.size() / 8); ++i)
        sizes[i] = std::max(sizes[i], kKeystones[i] * dice.uniform(0.94, 1.0));
    return sizes;
}

std::vector<double> ballRadii(const std::vector<double>& sizesM) {
    constexpr double kShare = 0.43; // half the mean of the axes, which are 1, 0.78 and 0.78 on average
    std::vector<double> radii;
    for (const double size : sizesM) radii.push_back(kShare * size);
    return radii;
}

std::vector<Eigen::Vector3d> rockCorners(double sizeM, RandomSequence& dice) {
    const int planes = dice.whole(9, dice.whole(14, 22)); // a body with n planes has at most 2 n - 4 corners: 14-40
    std::vector<Eigen::Vector3d> corners = cornersBetween(blockPlanes(planes, dice));
    const Eigen::Vector3d axes{1.0, dice.uniform(0.55, 1.0), dice.uniform(0.55, 1.0)};
    const Eigen::Matrix3d turn = randomTurn(dice);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : corners) box.extend(corner);
    for (Eigen::Vector3d& corner : corners)
        corner = turn * (axes.array() * (corner - box.center()).array() / box.sizes().array() * sizeM).matrix();
    return corners;
}

void addRock(Scene& scene, const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& centreM, double rounding) {
    const std::vector<HullTriangle> hull = convexHull(corners);
    if (hull.empty()) return;
    const RoundedCore core = roundedCore(corners, hull, rounding);
    ConvexBody body;
    Surface look{.object = static_cast<std::uint16_t>(kFirstRock + scene.rocks.size()), .face = 0, .texture = Texture::Rock};
    for (const Eigen::Vector4d& plane : planesOf(core.corners, core.hull)) {
        ++look.face;
        addFacet(scene, body, plane.head<3>(), plane.w() + core.radiusM + plane.head<3>().dot(centreM), look);
    }
    look.body = static_cast<std::int32_t>(scene.bodies.size());
    for (const auto& [from, to] : core.ridges) {
        ++look.face;
        ++look.ridge;
        const auto place = [&](int corner) { return (core.corners[static_cast<std::size_t>(corner)] + centreM).cast<float>().eval(); };
        body.ridges.push_back({place(from), place(to), static_cast<std::int32_t>(scene.surfaces.size())});
        scene.surfaces.push_back(look);
    }
    body.radiusM = static_cast<float>(core.radiusM);
    for (const Eigen::Vector3d& corner : core.corners) body.box.extend((corner + centreM).cast<float>());
    body.box = {body.box.min().array() - body.radiusM, body.box.max().array() + body.radiusM};
    scene.bodies.push_back(std::move(body));
    scene.rocks.push_back({look.object, centreM.cast<float>(), {}, static_cast<float>(core.volumeM3)});
    std::ranges::transform(spansOf(core.corners), scene.rocks.back().spansM.begin(),
                           [&](double span) { return static_cast<float>(span + 2.0 * core.radiusM); });
}

std::array<double, 3> spansOf(const std::vector<Eigen::Vector3d>& cornersM) {
    const auto longest = [&](auto project) {
        Eigen::Vector3d best = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < cornersM.size(); ++i) {
            for (std::size_t j = i + 1; j < cornersM.size(); ++j) {
                const Eigen::Vector3d chord = project(cornersM[i] - cornersM[j]);
                if (chord.squaredNorm() > best.squaredNorm()) best = chord;
            }
        }
        return best;
    };
    const Eigen::Vector3d a = longest([](const Eigen::Vector3d& c) { return c; });
    const Eigen::Vector3d alongA = a.normalized();
    const auto acrossA = [&](const Eigen::Vector3d& c) -> Eigen::Vector3d { return c - alongA * alongA.dot(c); };
    const Eigen::Vector3d b = longest(acrossA);
    const Eigen::Vector3d across = alongA.cross(b.normalized());
    const Eigen::Vector3d c = longest([&](const Eigen::Vector3d& chord) -> Eigen::Vector3d { return across * across.dot(chord); });
    return {a.norm(), b.norm(), c.norm()};
}

void addBox(Scene& scene, const Eigen::AlignedBox3d& box, std::uint16_t object) {
    ConvexBody body;
    Surface look{.object = object, .face = 0, .texture = Texture::Smooth};
    for (int axis = 0; axis < 3; ++axis) {
        ++look.face;
        addFacet(scene, body, -Eigen::Vector3d::Unit(axis), -box.min()[axis], look);
        ++look.face;
        addFacet(scene, body, Eigen::Vector3d::Unit(axis), box.max()[axis], look);
    }
    body.box = box.cast<float>();
    scene.bodies.push_back(std::move(body));
}

} // namespace edgescan::sim
