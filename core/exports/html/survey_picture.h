// A small picture of a scan for the contact sheet of an archive.
#pragma once

#include "core/edges/pipeline/detection.h"

#include <string>

namespace edgescan::exports {

/// The darkened gray levels with white edges: PNG of at most 96 x 96 pixels, in the proportions of the scan. Empty without cells.
[[nodiscard]] std::string surveyPicture(const edges::Detection& detection);

} // namespace edgescan::exports
