// Value noise: random numbers on a lattice with smooth interpolation.
#include "app/lab/sim/noise.h"

#include "app/lab/sim/random.h"

#include <array>
#include <cmath>

namespace edgescan::sim {
namespace {

double latticeValue(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) {
    const std::uint64_t key = static_cast<std::uint64_t>(x) * 0x8DA6B343ULL ^ static_cast<std::uint64_t>(y) * 0xD8163841ULL ^
                              static_cast<std::uint64_t>(z) * 0xCB1AB31FULL;
    return 2.0 * uniformOf(mixed(key ^ seed)) - 1.0;
}

double smoothStep(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

double blend(double a, double b, double t) { return a + (b - a) * t; }

} // namespace

double valueNoise(const Eigen::Vector3d& place, std::uint64_t seed) {
    const Eigen::Vector3d floor = place.array().floor();
    const auto x = static_cast<std::int64_t>(floor.x());
    const auto y = static_cast<std::int64_t>(floor.y());
    const auto z = static_cast<std::int64_t>(floor.z());
    const Eigen::Vector3d part = place - floor;
    const double u = smoothStep(part.x());
    const double v = smoothStep(part.y());
    std::array<double, 2> layers{};
    for (std::int64_t k = 0; k < 2; ++k) {
        const double near = blend(latticeValue(x, y, z + k, seed), latticeValue(x + 1, y, z + k, seed), u);
        const double far = blend(latticeValue(x, y + 1, z + k, seed), latticeValue(x + 1, y + 1, z + k, seed), u);
        layers[static_cast<std::size_t>(k)] = blend(near, far, v);
    }
    return blend(layers[0], layers[1], smoothStep(part.z()));
}

double fractalNoise(const Eigen::Vector3d& placeM, double wavelengthM, int octaves, std::uint64_t seed) {
    // One octave has a standard deviation of 0.40 (8 uniform lattice values, interpolated); the others add 15 %.
    constexpr double kSpread = 0.46;
    double sum = 0.0;
    double height = 1.0;
    double frequency = 1.0 / wavelengthM;
    for (int octave = 0; octave < octaves; ++octave) {
        // The shift prevents the lattices of the octaves from sharing nodes.
        const Eigen::Vector3d place = placeM * frequency + Eigen::Vector3d::Constant(0.37 * octave);
        sum += height * valueNoise(place, seed + static_cast<std::uint64_t>(octave));
        height *= 0.5;
        frequency *= 2.0;
    }
    return sum / kSpread;
}

} // namespace edgescan::sim
