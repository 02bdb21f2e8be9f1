// Puts the clicks of a measurement into words.
#include "core/inspect/measure/click_remarks.h"

#include "core/inspect/measure/near_side.h"

#include <optional>

namespace edgescan::inspect {
namespace {

/// The click that an end of a measurement comes from, if it is where such a click is measured.
std::optional<ClickedCell> clickAtEnd(const Scan& scan, const StoredMeasure& measure, std::size_t n) {
    const std::uint32_t clicked = n < measure.clicked.size() ? measure.clicked[n] : measure.cells[n];
    if (clicked >= scan.cells()) return std::nullopt;
    const ClickedCell click = nearSideCell(scan, clicked);
    return click.cell == measure.cells[n] ? std::optional(click) : std::nullopt;
}

} // namespace

bool isDoubtful(const Scan& scan, const StoredMeasure& measure) {
    if (!traitsOf(measure.kind).inViews) return false;
    for (std::size_t n = 0; n < measure.cells.size(); ++n) {
        const auto click = clickAtEnd(scan, measure, n);
        if (click && click->alsoNear) return true;
    }
    return false;
}

std::string offEdgeText(const Grid<std::uint8_t>& mask, const StoredMeasure& measure, Translated translated) {
    const auto say = [&](const char* pattern, const std::string& value) { return withValues(translated(pattern), {value}); };
    if (measure.kind == MeasureKind::Throat || measure.kind == MeasureKind::Section) return {};
    std::vector<std::string> off;
    for (std::size_t n = 0; n < measure.cells.size(); ++n) {
        if (measure.cells[n] < mask.size() && mask[measure.cells[n]] == 0) off.push_back(std::to_string(n + 1));
    }
    if (off.empty()) return {};
    return off.size() == 1 ? say("end %1 not on an edge", off.front()) : say("%1 ends not on an edge", std::to_string(off.size()));
}

std::vector<std::string> clickRemarks(const Scan& scan, const Grid<std::uint8_t>& mask, const StoredMeasure& measure,
                                      Translated translated) {
    const auto say = [&](const char* pattern, int value) { return withValues(translated(pattern), {std::to_string(value)}); };
    std::vector<std::string> remarks;
    int moved = 0;
    for (std::size_t n = 0; n < measure.clicked.size(); ++n) moved += measure.clicked[n] != measure.cells[n] ? 1 : 0;
    if (moved > 0 && measure.kind != MeasureKind::Throat) // whose ends are near the clicks anyway
        remarks.push_back(moved == 1 ? say("1 end was moved to the near side", 1) : say("%1 ends were moved to the near side", moved));
    if (isDoubtful(scan, measure)) remarks.push_back(say("▲ a nearer surface is within %1 cells of a click", kSnapReach));
    if (std::string off = offEdgeText(mask, measure, translated); !off.empty()) remarks.push_back(std::move(off));
    return remarks;
}

} // namespace edgescan::inspect
