// Describes the range noise that a picture was computed with.
#pragma once

#include "core/edges/pipeline/detection.h"

#include <QString>

namespace edgescan::ui {

/// "each cell errs for itself; sigma 6.1 mm at 2.6 m, 6.7 mm at 5.2 m, ..."; empty if the method uses no noise.
[[nodiscard]] QString noiseWords(const edges::Detection& detection);

} // namespace edgescan::ui
