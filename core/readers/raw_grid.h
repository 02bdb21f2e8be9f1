// Raw grid: NAME.json describes, NAME.u16 holds lines x beams counts (docs/formats.md, "Raw grid").
#pragma once

#include "core/base/file_bytes.h"
#include "core/points/source.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace edgescan {

/// Opens the pair through its description. `counts` is read from the file the description names, or from NAME.u16 beside it.
Result<Scan> readRawGridJson(const Source& source);

/// Opens the pair through its counts; the description is NAME.json beside them.
Result<Scan> readRawGridCounts(const Source& source);

/// The pair, counts first: the description must not appear before them. `path` names either of the two. Error: a range is no whole
/// count of unitMm up to 65535, or there are no angles.
Result<std::vector<FileBytes>> rawGridFiles(const Scan& scan, const std::filesystem::path& path);

} // namespace edgescan
