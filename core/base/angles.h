// Degrees and radians.
#pragma once

namespace edgescan {

inline constexpr double kDegreesPerRadian = 180.0 / 3.14159265358979323846;

[[nodiscard]] constexpr double radians(double degrees) { return degrees * (3.14159265358979323846 / 180.0); }
[[nodiscard]] constexpr double degrees(double radians) { return radians * kDegreesPerRadian; }

} // namespace edgescan
