// Carves stones.
#include "app/lab/stones/carved_stone.h"

#include "app/lab/sim/random.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::lab {
namespace {

/// A plane, or a sphere around `centre` where `radius` is above 0, whose outside stays.
struct Cut {
    Eigen::Vector3f normal, centre;
    float distance = 0, radius = 0;
};

Eigen::Vector3f direction(sim::RandomSequence& dice) {
    return Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal()).normalized().cast<float>();
}

/// A sum of waves in space, between -1 and 1.
class Waves {
public:
    Waves() = default;
    /// @param lowest, highest of the wave numbers, in radians per length of the stone
    Waves(sim::RandomSequence& dice, double lowest, double highest) {
        for (Wave& wave : waves_) {
            wave.vector = direction(dice) * static_cast<float>(dice.uniform(lowest, highest));
            wave.phase = static_cast<float>(dice.uniform(0.0, 6.28));
        }
    }
    [[nodiscard]] float at(const Eigen::Vector3f& point) const {
        float sum = 0;
        for (const Wave& wave : waves_) sum += std::sin(wave.vector.dot(point) + wave.phase);
        return sum / static_cast<float>(waves_.size());
    }

private:
    struct Wave {
        Eigen::Vector3f vector;
        float phase = 0;
    };
    std::array<Wave, 4> waves_;
};

/// Within a wavy sphere around a point of the surface, the surface is lower, with a steep rim, as where a flake broke off.
struct Scar {
    Eigen::Vector3f centre;
    float radius = 0, wobble = 0, depth = 0, rim = 0;
    Waves waves;
};

/// The share of the way from the middle to `point` that the cut leaves.
float remaining(const Cut& cut, const Eigen::Vector3f& point) {
    const float along = cut.normal.dot(point);
    if (cut.radius <= 0) return along > cut.distance ? cut.distance / along : 1.0F;
    if ((point - cut.centre).squaredNorm() >= cut.radius * cut.radius) return 1.0F;
    // Where the line from the middle enters the sphere.
    const float a = point.squaredNorm(), b = point.dot(cut.centre), c = cut.centre.squaredNorm() - cut.radius * cut.radius;
    const float root = b * b - a * c;
    return root > 0 ? std::clamp((b - std::sqrt(root)) / a, 0.2F, 1.0F) : 1.0F;
}

class Carver {
public:
    Carver(const Stone& stone, std::uint64_t seed) {
        sim::RandomSequence dice(seed, sim::Purpose::Shapes);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3f& point : stone.hull) sum += point.cast<double>();
        middle_ = (sum / static_cast<double>(stone.hull.size())).cast<float>();
        const auto reach = [&](const Eigen::Vector3f& normal) {
            float most = 0;
            for (const Eigen::Vector3f& point : stone.hull) most = std::max(most, normal.dot(point - middle_));
            return most;
        };
        for (int n = dice.whole(2, 6); n > 0; --n) {
            Cut cut;
            cut.normal = direction(dice);
            cut.distance = reach(cut.normal) * static_cast<float>(dice.uniform(0.6, 0.95));
            if (dice.uniform() < 0.5) {
                cut.radius = static_cast<float>(dice.uniform(0.25, 1.2));
                cut.centre = cut.normal * (cut.distance + cut.radius);
            }
            cuts_.push_back(cut);
        }
        for (int n = dice.whole(3, 10); n > 0; --n) {
            Scar scar;
            const Eigen::Vector3f normal = direction(dice);
            scar.centre = normal * reach(normal);
            scar.radius = static_cast<float>(dice.uniform(0.15, 0.6));
            scar.wobble = static_cast<float>(dice.uniform(0.02, 0.1));
            scar.depth = static_cast<float>(dice.uniform(0.05, 0.25));
            scar.rim = static_cast<float>(std::max(stone.edgeLength, dice.uniform(0.003, 0.02)));
            scar.waves = Waves(dice, 6, 20);
            scars_.push_back(scar);
        }
        relief_ = static_cast<float>(dice.uniform(0.0, 0.03));
        rough_ = Waves(dice, 10, 40);
    }

    [[nodiscard]] Eigen::Vector3f operator()(const Eigen::Vector3f& point) const {
        constexpr float kRelief = 0.1F;
        const Eigen::Vector3f from = point - middle_;
        float share = 1;
        for (const Cut& cut : cuts_) share = std::min(share, remaining(cut, from));
        share += kRelief * (1 - share);
        for (const Scar& scar : scars_) {
            const float within = scar.radius + scar.wobble * scar.waves.at(from) - (from - scar.centre).norm();
            share *= 1 - scar.depth * std::clamp(within / scar.rim, 0.0F, 1.0F);
        }
        return middle_ + share * (1 + relief_ * rough_.at(from)) * from;
    }

private:
    Eigen::Vector3f middle_;
    std::vector<Cut> cuts_;
    std::vector<Scar> scars_;
    float relief_ = 0;
    Waves rough_;
};

} // namespace

Stone carvedStone(const Stone& stone, std::uint64_t seed) {
    const Carver carver(stone, seed);
    std::vector<Eigen::Vector3f> points = stone.mesh->points();
    std::ranges::transform(points, points.begin(), carver);
    Stone carved = stone;
    carved.mesh = std::make_shared<const sim::StoredMesh>(std::move(points), stone.mesh->triangles());
    std::ranges::transform(carved.hull, carved.hull.begin(), carver);
    return carved;
}

} // namespace edgescan::lab
