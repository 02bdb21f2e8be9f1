// A small sweep of the simulated draw-bell.
#pragma once

#include "app/lab/sim/simulate.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace edgescan::test {

/// Empty: it could not be simulated.
inline std::optional<Scan> simulatedBell(int lines, int beams, std::uint64_t seed = sim::SimulationSettings{}.seed) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.lines = lines;
    settings.beams = beams;
    auto simulation = sim::simulate(settings);
    if (!simulation) return std::nullopt;
    return std::move(simulation->scan);
}

} // namespace edgescan::test
