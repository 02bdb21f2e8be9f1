// The grid of a list of points that this program wrote, from its sidecar: the record NAME.EXT.provenance.json in the same folder.
#pragma once

#include "core/files/formats/reading.h"

#include <filesystem>
#include <optional>

namespace edgescan::files {

inline constexpr const char* kSidecarFormat = "edgescan-provenance/1";

/// NAME.EXT.provenance.json in the folder of the export.
[[nodiscard]] std::filesystem::path sidecarPath(const std::filesystem::path& exported);

/// The sidecar that is there: that of the export, or for a link that of the file it leads to.
[[nodiscard]] std::optional<std::filesystem::path> sidecarOf(const std::filesystem::path& exported);

/// The scan as it was exported: each point in the cell that the sidecar lists for it, and each range a whole number of counts again where
/// the numbers of the file do not distinguish it from one. Empty when the file has no sidecar with a grid; also when the sidecar was
/// written for another file or does not fit the points, and a remark says why. `place`: as in Reading.
[[nodiscard]] std::optional<Scan> scanOfSidecar(PointTable& table, const std::optional<WrittenPlace>& place, const Source& source);

} // namespace edgescan::files
