// The folder of a bag of ROS 2: metadata.yaml names the files in it.
#pragma once

#include "core/base/result.h"

#include <filesystem>

namespace edgescan::files {

/// The file of messages of a bag's folder, or of its metadata.yaml; any other path as it is. Error: a folder without such a file, or with
/// several.
Result<std::filesystem::path> fileOfBag(const std::filesystem::path& path);

} // namespace edgescan::files
