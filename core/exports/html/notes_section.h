// The operator's results on a scan, for its report: targets, measurements, and changes since an earlier scan.
#pragma once

#include "core/base/translated_text.h"
#include "core/edges/pipeline/detection.h"
#include "core/inspect/change_detection/scene_change.h"
#include "core/inspect/measure/notebook.h"

#include <string>

namespace edgescan::exports {

/// Markup: a table of the targets with their places by the pose of now and what differed on their cards when they were pinned, and one of
/// the measurements with their uncertainty. Empty if there are neither. Cells that do not exist in the scan are reported as such.
/// A picture of at most `mostPixels` along a side shows where the targets are.
[[nodiscard]] std::string notebookSection(const edges::Detection& detection, const inspect::Notebook& notebook, int mostPixels,
                                          Translated translated = asWritten);

/// Markup: the counts, the quality of the registration, the largest regions, and a picture of at most `mostPixels` along a side.
[[nodiscard]] std::string changeSection(const edges::Detection& now, const inspect::SceneChange& change, const std::string& earlier,
                                        int mostPixels);

} // namespace edgescan::exports
