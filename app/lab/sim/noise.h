// Smooth random fields in space: rough rock, rough walls, the undulation of a funnel.
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace edgescan::sim {

/// Value noise on the unit lattice, twice continuously differentiable, within [-1, 1], with a standard deviation of 0.400: that of eight
/// uniform lattice values, interpolated.
inline constexpr double kValueNoiseSpread = 0.400;
[[nodiscard]] double valueNoise(const Eigen::Vector3d& place, std::uint64_t seed);

/// Sum of octaves, each with half the wavelength and half the amplitude of the one before. Standard deviation about 1, never above 5.
/// @param wavelengthM of the first octave, metres
[[nodiscard]] double fractalNoise(const Eigen::Vector3d& placeM, double wavelengthM, int octaves, std::uint64_t seed);

} // namespace edgescan::sim
