// The noise of the ranges that a picture was made with, in words.
#pragma once

#include "core/edges/pipeline/detection.h"

#include <QString>

namespace edgescan::ui {

/// "each cell errs for itself; sigma 6.1 mm at 2.6 m, 6.7 mm at 5.2 m, ..."; empty where the method asks for no noise.
[[nodiscard]] QString noiseWords(const Detection& detection);

} // namespace edgescan::ui
