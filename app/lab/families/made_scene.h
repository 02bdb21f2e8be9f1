// A scan with its truth, if it is known.
#pragma once

#include "app/lab/sim/truth/truth_files.h"
#include "core/scan/grid/scan.h"

#include <memory>
#include <optional>

namespace edgescan::lab {

struct MadeScene {
    std::shared_ptr<const Scan> scan;
    std::optional<sim::TruthSet> truth;
};

} // namespace edgescan::lab
