// The targets and measurements of the user on a scan, and their file (docs/guide/measure.md, "Where targets are stored").
#pragma once

#include "core/base/result.h"
#include "core/inspect/measure/lengths.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgescan::inspect {

inline constexpr std::size_t kMostTargets = 200;
inline constexpr std::size_t kMostMeasures = 200;
inline constexpr std::size_t kLongestTargetName = 60;  ///< bytes
inline constexpr std::size_t kLongestTargetNote = 400; ///< bytes

/// Row of a card with the size of the rock at the cell: an edit of the rocks changes it.
inline constexpr const char* kRockRow = "Rock, visible";

/// A picked cell, and the rows of its card at that time.
struct PinnedTarget {
    int number = 1;   ///< unique within a scan
    std::string name; ///< may be empty
    std::uint32_t cell = 0;
    bool locked = false;                                       ///< only its own button removes it
    std::string pinnedUtc;                                     ///< ISO 8601
    std::vector<std::pair<std::string, std::string>> asPinned; ///< label and value of each row
    std::optional<std::uint32_t> clicked{};                    ///< the cell of the click, if nearSideCell() moved it (near_side.h)
    std::string note{};                                        ///< of the operator; may be empty
    std::uint32_t rock = 0;                                    ///< in an export: the number of its rock; 0: none, or not known

    bool operator==(const PinnedTarget&) const = default;
};

/// The cells of a measurement: as many as its kind needs.
struct StoredMeasure {
    MeasureKind kind = MeasureKind::Distance;
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> clicked{}; ///< the cells of the clicks; empty if all of them are `cells`
    std::vector<double> shares{};         ///< for Section only, see measureCells()
    int number = 0;                       ///< 1 or more, in the order of measuring; it stays when another measurement is removed

    /// Twice the same cell: one click into the opening of a throat.
    [[nodiscard]] bool isByOneClick() const { return kind == MeasureKind::Throat && clicked.size() == 2 && clicked[0] == clicked[1]; }
    bool operator==(const StoredMeasure&) const = default;
};

/// measureCells() and measureClicks().
[[nodiscard]] std::optional<MeasuredCells> measureStored(const Scan& scan, const RangeNoise& noise, const StoredMeasure& measure);

struct Notebook {
    std::vector<PinnedTarget> targets; ///< in the order in which they were pinned
    std::vector<StoredMeasure> measures;

    bool operator==(const Notebook&) const = default;
    [[nodiscard]] bool empty() const { return targets.empty() && measures.empty(); }
};

/// The next number of a target, or of a measurement: one more than the largest existing one.
[[nodiscard]] int nextNumber(const Notebook& notebook);
[[nodiscard]] int nextMeasureNumber(const Notebook& notebook);
/// "M2": how it is named in lists, views and reports.
[[nodiscard]] std::string measureName(const StoredMeasure& measure);

/// What two windows made of one notebook, by the places of its entries: what one of them added, changed or removed. Where both changed an
/// entry, that of `mine` stays; what one removed and the other changed stays. Where both added one of the same number, that of `mine` gets
/// the next free number. @param base what both began with
[[nodiscard]] Notebook mergedNotebook(const Notebook& base, const Notebook& mine, const Notebook& theirs);

/// The notebook `value` of one end of a step that is undone or redone, whose other end is `opposite`, and what another window added to
/// `now`: entries at places of neither end.
[[nodiscard]] Notebook withOthers(const Notebook& value, const Notebook& opposite, const Notebook& now);

/// The scan that a notebook belongs to: in another scan its cells would be other places.
struct NotebookScan {
    std::string sha256; ///< of the file with the ranges
    std::string name;   ///< distinguishes the sweeps of a recording
    int lines = 0;
    int beams = 0;
};
[[nodiscard]] NotebookScan notebookScan(const Scan& scan);
/// The name of its file: "9f86d081....json", from the hash and the name; empty if the scan has no file.
[[nodiscard]] std::string notebookFileName(const NotebookScan& scan);

/// {"format": "edgescan-targets/1", "scan": {...}, "targets": [...], "measures": [...]}
[[nodiscard]] std::string notebookText(const Notebook& notebook, const NotebookScan& scan);
/// Error: damaged text, another format or scan, duplicate numbers or measurements out of their order, cells that do not exist, too many
/// entries, unknown keys.
Result<Notebook> notebookFromText(std::string_view text, const NotebookScan& scan, const std::string& where);

} // namespace edgescan::inspect
