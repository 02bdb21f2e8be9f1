// Checks the outputs of a command before it reads anything.
#pragma once

#include "core/base/result.h"

#include <span>
#include <string>

namespace edgescan::cli {

/// Error if two of the paths are the same file, however they are spelled, or if one is the provenance record or sidecar of another
/// (core/files/open_save/sidecar_grid.h). Empty paths and devices are ignored; standard output takes only one result.
Result<Done> checkDistinct(std::span<const std::string> outputs);

} // namespace edgescan::cli
