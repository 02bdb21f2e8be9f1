// A simulated scan with its ground truth.
#pragma once

#include "app/lab/sim/simulate.h"

namespace edgescan::test {

inline sim::Simulation scoredScene(const char* scene, std::uint64_t seed, int lines, int beams) {
    sim::SimulationSettings settings;
    settings.scene = scene;
    settings.seed = seed;
    settings.lines = lines;
    settings.beams = beams;
    settings.truth = true;
    return *sim::simulate(settings);
}

} // namespace edgescan::test
