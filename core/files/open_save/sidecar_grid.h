// The grid of a list of points that this program wrote, from its sidecar: the record NAME.EXT.provenance.json in the same folder.
#pragma once

#include "core/files/formats/reading.h"

#include <filesystem>
#include <optional>

namespace edgescan::files {

inline constexpr const char* kSidecarFormat = "edgescan-provenance/1";

/// NAME.EXT.provenance.json in the folder of the export.
[[nodiscard]] std::filesystem::path sidecarPath(const std::filesystem::path& exported);

/// The scan as it was exported: each point in the cell that its direction names, in the order of the cells, and each range a whole number
/// of counts again where the printed digits allow only that one. Empty when the file has no sidecar, when the sidecar was written for
/// another file, or when its grid has no angles or does not fit the points; a remark says why. `place`: as in Reading.
[[nodiscard]] std::optional<Scan> scanOfSidecar(PointTable& table, const std::optional<WrittenPlace>& place, const Source& source);

} // namespace edgescan::files
