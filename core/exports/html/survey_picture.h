// A scan as a stamp: for the contact sheet of an archive.
#pragma once

#include "core/edges/pipeline/detection.h"

#include <string>

namespace edgescan::exports {

/// The gray levels, darkened, with the edges white: PNG of at most 96 x 96 pixels, the scan's shape kept. Empty without cells.
[[nodiscard]] std::string surveyPicture(const edges::Detection& detection);

} // namespace edgescan::exports
