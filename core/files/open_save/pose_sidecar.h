// The pose of a scan in a sidecar: wall.pcd has wall.pcd.pose.json. Every program that opens the scan reads it.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/reading_options.h"

#include <filesystem>
#include <optional>
#include <string>

namespace edgescan::files {

/// NAME.EXT.pose.json in the folder of the scan.
[[nodiscard]] std::filesystem::path poseSidecar(const std::filesystem::path& scan);
[[nodiscard]] bool isPoseSidecar(const std::filesystem::path& path);

/// Options without a pose get the pose sidecar of the scan, if there is one.
[[nodiscard]] ReadingOptions withPoseSidecar(ReadingOptions options, const std::filesystem::path& scan);

/// Its text; empty if there is none. Error: it is there and cannot be read.
Result<std::optional<std::string>> readPoseSidecar(const std::filesystem::path& scan);

/// Replaces or removes the file. It alone of the inputs may be replaced while the scan is shown: it holds what the operator typed.
Result<Done> writePoseSidecar(const std::filesystem::path& scan, const std::optional<std::string>& text);

} // namespace edgescan::files
