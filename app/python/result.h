// A detection in Python.
#pragma once

#include "app/python/module.h"

#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/threshold_map.h"

#include <mutex>

namespace edgescan::python {

struct ResultObject {
    std::shared_ptr<const edges::Detection> detection; ///< of a pickle: only settings, mask, classes and times
    /// Computed at the first access.
    struct Later {
        std::once_flag again, strength;
        std::shared_ptr<const edges::Detection> detection;
        edges::ThresholdMap map;
    };
    std::shared_ptr<Later> later = std::make_shared<Later>();
};

/// The detection with all its parts. Of a result that was pickled, they are computed once. Call it without the interpreter's lock.
[[nodiscard]] std::shared_ptr<const edges::Detection> whole(const ResultObject& result);

} // namespace edgescan::python
