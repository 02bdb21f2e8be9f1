// Where a command's results go, asked before anything is read.
#pragma once

#include "core/base/result.h"

#include <span>
#include <string>

namespace edgescan::cli {

/// Error when two of the paths are one file, however they are spelled, or one is the record beside another
/// (core/files/open_save/sidecar_grid.h). Empty paths and devices do not count; standard output takes one result.
Result<Done> checkDistinct(std::span<const std::string> outputs);

} // namespace edgescan::cli
