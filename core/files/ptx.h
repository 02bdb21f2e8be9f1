// PTX (Leica Cyclone): scans as full grids about their scanner, with the pose of each; columns are lines, rows are beams.
#pragma once

#include "core/files/source.h"

#include <string_view>

namespace edgescan {

/// Two lines with one whole number, then rows of three, three, three and three numbers and of four.
[[nodiscard]] bool looksLikePtx(std::string_view text);

/// The scan that the options ask for. 0 0 0 is no return. Error: cut off, a count that lies, no such scan.
Result<Scan> readPtx(const Source& source);

} // namespace edgescan
