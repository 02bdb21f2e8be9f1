// A small sweep of the simulated draw-bell.
#pragma once

#include "app/lab/sim/simulate.h"
#include "core/files/open_save/save_scan.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
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

/// Saves a bell with rocks, and returns the path: boxesScan() has no rock that is sure. Empty: it could not be saved.
inline std::string savedBell(const std::filesystem::path& file) {
    const auto bell = simulatedBell(250, 286, 4711);
    return bell && files::saveScan(*bell, file) ? file.string() : std::string();
}

} // namespace edgescan::test
