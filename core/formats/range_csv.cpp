// Range CSV (thesis figure 5.7): one text line per scan line, millimetres between commas.

#include "core/formats/format.h"

#include "core/base/memory.h"
#include "core/formats/range_geometry.h"
#include "core/points/text_layout.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

constexpr std::size_t kFewestRangeColumns = 16; // point lists have x y z and a few attributes
constexpr double kLongestRange = 1e9;

struct Ranges {
    std::vector<float> mm;
    std::vector<CellState> states;
    std::size_t lines = 0;
    std::size_t infinite = 0;
};

Result<Ranges> readRanges(const Source& source, const TextLayout& layout, double unitMm) {
    Ranges ranges;
    RowReader rows(source, layout);
    std::vector<double> row;
    while (rows.next(row)) {
        if (row.size() != layout.columns) {
            return source.refusedAtLine(rows.lineNumber(),
                                        "holds " + std::to_string(row.size()) + " ranges where the first line holds " +
                                            std::to_string(layout.columns),
                                        "copy or export the file again");
        }
        for (std::size_t j = 0; j < row.size(); ++j) {
            if (row[j] < 0 || (std::isfinite(row[j]) && row[j] * unitMm > kLongestRange)) {
                return source.refusedAtLine(rows.lineNumber(), "column " + std::to_string(j + 1) + " is no range in millimetres",
                                            "check that this is a table of ranges");
            }
            if (std::isinf(row[j])) ++ranges.infinite;
            const bool valid = std::isfinite(row[j]) && row[j] > 0;
            ranges.mm.push_back(valid ? static_cast<float>(row[j] * unitMm) : 0.0F);
            ranges.states.push_back(valid ? CellState::Valid : CellState::NoReturn);
        }
        ++ranges.lines;
        if (ranges.lines % 64 == 0 && !source.goOn("reading ranges", rows.fraction())) return source.cancelled();
    }
    if (rows.problem()) return *rows.problem();
    return ranges;
}

/// Ranges rather than points: many columns without names, or few with the geometry given.
bool looksLikeRangeCsv(const Source& source) {
    if (firstByteThatIsNoText(source.text())) return false;
    const auto layout = textLayoutOf(source);
    if (!layout || !layout->names.empty() || !layout->description.empty()) return false;
    if (layout->columns >= kFewestRangeColumns) return true;
    const ReadingOptions& options = *source.options;
    return source.extension() == ".csv" && options.beamStepDeg && options.lineStepDeg;
}

/// 0 and empty cells are no returns. Geometry from the options, or the LMS511 defaults for 1141 columns.
Result<Scan> readRangeCsv(const Source& source) {
    const auto found = textLayoutOf(source);
    if (!found) return found.error();
    const TextLayout& layout = *found;
    if (auto known = checkAnglesKnown(layout.columns, "table", source); !known) return known.error();
    // A range takes two bytes of text at least, and five in memory that may double while growing.
    if (auto enough = checkMemory(std::uint64_t{source.bytes.size()} * 6, source.path.string()); !enough) return enough.error();
    Scan scan;
    scan.unitMm = source.options->unitMm.value_or(1.0);
    auto ranges = readRanges(source, layout, scan.unitMm);
    if (!ranges) return ranges.error();
    const int lines = static_cast<int>(ranges->lines);
    const int beams = static_cast<int>(layout.columns);
    scan.rangeMm = Grid<float>(lines, beams, std::move(ranges->mm));
    scan.state = Grid<CellState>(lines, beams, std::move(ranges->states));
    auto angles = assumedAngles(ranges->lines, layout.columns, "table", source);
    if (!angles) return angles.error();
    scan.geometry = std::move(angles->polar);
    scan.format = "range CSV";
    if (!angles->warning.empty()) scan.warnings.push_back(angles->warning);
    if (ranges->infinite > 0) scan.warnings.push_back(std::to_string(ranges->infinite) + " infinite ranges were taken as no return.");
    if (endsWithoutLineEnd(source.text())) scan.warnings.emplace_back(kMayBeCutOff);
    return scan;
}

} // namespace

Format rangeTableFormat() {
    return {.title = "Range or point table", .reads = {".csv"}, .recognises = looksLikeRangeCsv, .read = readRangeCsv};
}

} // namespace edgescan
