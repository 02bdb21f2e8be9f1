// What somebody pinned and measured on a scan, and the file that keeps it (docs/targets.md, "Where it is kept").
#pragma once

#include "core/base/result.h"
#include "core/inspect/measure/lengths.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgescan {

inline constexpr std::size_t kMostTargets = 200;
inline constexpr std::size_t kMostMeasures = 200;
inline constexpr std::size_t kLongestTargetName = 60; ///< bytes

/// A cell that was picked, and what its card said then, row by row.
struct PinnedTarget {
    int number = 1;   ///< of all of a scan none twice
    std::string name; ///< may be empty
    std::uint32_t cell = 0;
    bool locked = false;                                       ///< only its own button lets go of it
    std::string pinnedUtc;                                     ///< ISO 8601
    std::vector<std::pair<std::string, std::string>> asPinned; ///< row, value

    bool operator==(const PinnedTarget&) const = default;
};

/// Cells between which something is measured: as many as the kind takes.
struct KeptMeasure {
    MeasureKind kind = MeasureKind::Distance;
    std::vector<std::uint32_t> cells;

    bool operator==(const KeptMeasure&) const = default;
};

struct Notebook {
    std::vector<PinnedTarget> targets; ///< in the order in which they were pinned
    std::vector<KeptMeasure> measures;

    bool operator==(const Notebook&) const = default;
    [[nodiscard]] bool empty() const { return targets.empty() && measures.empty(); }
};

/// The next number: one more than the highest there is.
[[nodiscard]] int nextNumber(const Notebook& notebook);

/// Which scan a notebook belongs to: cells of another one would be other places.
struct NotebookScan {
    std::string sha256; ///< of the file that holds the ranges
    std::string name;   ///< a recording holds several sweeps
    int lines = 0;
    int beams = 0;
};
[[nodiscard]] NotebookScan notebookScan(const Scan& scan);
/// The name of its file: "9f86d081....json", from the hash and the name; empty where the scan is of no file.
[[nodiscard]] std::string notebookFileName(const NotebookScan& scan);

/// {"format": "edgescan-targets/1", "scan": {...}, "targets": [...], "measures": [...]}
[[nodiscard]] std::string notebookText(const Notebook& notebook, const NotebookScan& scan);
/// Error: damaged, of another format or scan, numbers twice, cells that do not exist, too much of anything, unknown keys.
Result<Notebook> notebookFromText(std::string_view text, const NotebookScan& scan, const std::string& where);

} // namespace edgescan
