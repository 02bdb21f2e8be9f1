// The scan that a list of points or an organised cloud of another program becomes.
#pragma once

#include "core/files/point_tables/point_table.h"

#include <optional>
#include <string>

namespace edgescan::files {

/// An organised cloud: its grid. Any other list: the grid that is recovered, or else the one onto which the points are projected. Error:
/// neither is possible, with the numbers that show why.
Result<Scan> scanOfPoints(PointTable table, const Source& source);

/// How many points of the file did not end in a cell of their own; empty when all did.
[[nodiscard]] std::optional<std::string> leftOutSentence(const Scan& scan);

} // namespace edgescan::files
