// What somebody worked out on a scan, for its report: pins, measures, and what changed since an earlier scan.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/inspect/change_detection/scene_change.h"
#include "core/inspect/measure/notebook.h"

#include <string>

namespace edgescan::exports {

/// Markup: a table of the targets with what their cards said when they were pinned, and one of the measures with their uncertainty. Empty
/// where there is neither. Cells that the scan does not have are said to be none of it.
[[nodiscard]] std::string notebookSection(const edges::Detection& detection, const inspect::Notebook& notebook);

/// Markup: the counts, how the two lie on each other, the largest regions, and a picture of at most `mostPixels` along a side.
[[nodiscard]] std::string changeSection(const edges::Detection& now, const inspect::SceneChange& change, const std::string& earlier,
                                        int mostPixels);

} // namespace edgescan::exports
