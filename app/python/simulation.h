// A simulated scan in Python, and its ground truth for whoever scores against it.
#pragma once

#include "app/python/module.h"

#include "core/lab/score/truth_files.h"

namespace edgescan::python {

struct SimulationObject {
    std::shared_ptr<const Simulation> simulation;
    ScanPtr scan; ///< that of the simulation, which it keeps
    SimulationSettings settings;
};

/// Error: it was made without truth.
[[nodiscard]] Result<TruthSet> truthOf(const SimulationObject& object);

} // namespace edgescan::python
