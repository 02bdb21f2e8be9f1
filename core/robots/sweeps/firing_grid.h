// The grid of a scanner with several beams that turns: a line for each firing, a beam for each ring.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgescan::robots {

/// By point: the number of its firing. A firing is one shot of all beams; each beam may have its own delay in it. `times`: of the points,
/// in any unit. Points that were not measured leave gaps. Empty: the times show no firings.
std::optional<std::vector<std::uint32_t>> firingsOf(std::span<const std::uint32_t> rings, std::span<const double> times);

} // namespace edgescan::robots
