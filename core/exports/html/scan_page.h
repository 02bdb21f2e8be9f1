// The report of a scan: one page that says what was measured, what was found and how it is made again (docs/report.md).
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/inspect/change_detection/scene_change.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/study.h"

#include <string>

namespace edgescan::exports {

/// Most points and edge cells of the turning view; of more, as many are chosen evenly, and the page says so.
inline constexpr std::size_t kMostPagePoints = 60'000, kMostPageEdges = 40'000;
/// Most pixels along a side of the gray and the edge picture; larger ones are made smaller.
inline constexpr int kMostPagePixels = 1200;
/// No report is larger, whatever the scan; with rocks, and with a change, it may be as much larger.
inline constexpr std::size_t kMostPageBytes = 14'000'000, kMostRockBytes = 12'000'000, kMostChangeBytes = 7'000'000;

struct PageWords {
    std::string command; ///< that makes the report again
    std::string operatorName, role;
    std::string madeUtc;
};

/// What was worked out on the scan besides its edges; all of the same detection. Null: left out.
struct PageNotes {
    const rocks::Study* rocks = nullptr;
    const inspect::Notebook* notebook = nullptr;
    const inspect::SceneChange* change = nullptr;
    std::string earlier; ///< of a change: which scan it is compared with
};

/// The whole page. All of its text that comes from files is escaped.
[[nodiscard]] std::string scanPage(const edges::Detection& detection, const PageWords& words, const PageNotes& notes = {});

} // namespace edgescan::exports
