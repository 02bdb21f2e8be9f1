// The report of a scan: one page with the measurements, the results, and how to make it again (docs/reference/report.md).
#pragma once

#include "core/base/result.h"
#include "core/base/translated_text.h"
#include "core/edges/pipeline/detection.h"
#include "core/inspect/change_detection/scene_change.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/grid/reading_options.h"

#include <string>
#include <string_view>

namespace edgescan::exports {

/// Most points and edge cells of the rotating view. Of more, this number is chosen evenly, and the page says so.
inline constexpr std::size_t kMostPagePoints = 60'000, kMostPageEdges = 40'000;
/// Most pixels along a side of the gray and the edge picture; larger pictures are reduced.
inline constexpr int kMostPagePixels = 1200;
/// Largest size of a report of any scan; with rocks, and with a change, it may be larger by the other two numbers.
inline constexpr std::size_t kMostPageBytes = 14'000'000, kMostRockBytes = 12'000'000, kMostChangeBytes = 7'000'000;

struct PageWords {
    std::string command; ///< the command that makes the report again
    std::string operatorName, role;
    std::string madeUtc;
    std::string site{}, remark{}; ///< as typed; empty: left out
    std::string logoPng{};        ///< the bytes of a PNG picture; empty: none
};

/// Largest logo of a report, in bytes.
inline constexpr std::size_t kMostLogoBytes = 1'000'000;
/// The logo from the bytes of a file, which must be a PNG picture; `path` is for the error.
[[nodiscard]] Result<std::string> logoFrom(std::string_view bytes, const std::string& path);

/// Further results on the scan, all for the same detection. Null: left out.
struct PageNotes {
    const rocks::Study* rocks = nullptr;
    const inspect::Notebook* notebook = nullptr;
    const inspect::SceneChange* change = nullptr;
    std::string earlier;               ///< for a change: the name of the scan that it is compared with
    Translated translated = asWritten; ///< of remarks that are put together from several sentences
};

/// The whole page. All text from files is escaped.
[[nodiscard]] std::string scanPage(const edges::Detection& detection, const PageWords& words, const PageNotes& notes = {});

/// For the command that makes a page again: files by their names, without the folders of the one who made it.
[[nodiscard]] ReadingOptions withNames(ReadingOptions options);

} // namespace edgescan::exports
