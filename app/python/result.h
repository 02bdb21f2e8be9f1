// A detection in Python.
#pragma once

#include "app/python/module.h"

#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/threshold_map.h"

#include <mutex>

namespace edgescan::python {

struct ResultObject {
    std::shared_ptr<const edges::Detection> detection;
    /// Computed at the first access.
    struct Strength {
        std::once_flag once;
        edges::ThresholdMap map;
    };
    std::shared_ptr<Strength> strength = std::make_shared<Strength>();
};

} // namespace edgescan::python
