// A simulated scan in Python, with its ground truth for scores.
#pragma once

#include "app/python/module.h"

#include "core/lab/score/truth_files.h"

namespace edgescan::python {

struct SimulationObject {
    std::shared_ptr<const sim::Simulation> simulation;
    ScanPtr scan; ///< the simulated scan
    sim::SimulationSettings settings;
};

/// Error: the simulation was made without truth.
[[nodiscard]] Result<lab::TruthSet> truthOf(const SimulationObject& object);

} // namespace edgescan::python
