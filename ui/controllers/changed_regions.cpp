// Goes from one changed region of a comparison to the next.
#include "core/base/tolerance_text.h"
#include "ui/controllers/comparing.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/rocks/rock_picture.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kLeastAround = 10; // cells around a region, as visible context

/// Only the cells of the region: other regions of its kind may be in the same box.
std::vector<std::uint32_t> cellsOf(const Grid<inspect::RangeChange>& kinds, const inspect::ChangedRegion& region) {
    std::vector<std::uint32_t> cells{region.cell};
    std::vector<bool> seen(kinds.size(), false);
    seen[region.cell] = true;
    for (std::size_t n = 0; n < cells.size(); ++n) {
        const int line = static_cast<int>(cells[n]) / kinds.beams, beam = static_cast<int>(cells[n]) % kinds.beams;
        for (int i = std::max(region.firstLine, line - 1); i <= std::min(region.lastLine, line + 1); ++i) {
            for (int j = std::max(region.firstBeam, beam - 1); j <= std::min(region.lastBeam, beam + 1); ++j) {
                const std::size_t k = kinds.index(i, j);
                if (seen[k] || kinds[k] != kinds[region.cell]) continue;
                seen[k] = true;
                cells.push_back(static_cast<std::uint32_t>(k));
            }
        }
    }
    return cells;
}

} // namespace

std::vector<std::uint32_t> Comparing::someOfRegion() const {
    if (!shown_ || !comparison_ || comparison_->change.regions.empty()) return {};
    constexpr int kSteps = 4;
    const inspect::ChangedRegion& region = comparison_->change.regions[region_.value_or(0)];
    const auto& kinds = comparison_->change.ranges.cells;
    std::vector<std::uint32_t> cells{region.cell};
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            const std::size_t k = kinds.index(region.firstLine + i * (region.lastLine - region.firstLine) / kSteps,
                                              region.firstBeam + j * (region.lastBeam - region.firstBeam) / kSteps);
            if (kinds[k] == kinds[region.cell]) cells.push_back(static_cast<std::uint32_t>(k));
        }
    }
    return cells;
}

void Comparing::goToRegion(int by) {
    if (comparison_ && !comparison_->change.earlier.how.measurable())
        return notice_.showHint(tr("The surfaces of the two scans do not fit, so no areas of change are given."));
    if (!comparison_ || comparison_->change.regions.empty()) {
        notice_.showHint(tr("No surface came nearer or went farther: keep a scan as A and open another one."));
        return;
    }
    const auto& regions = comparison_->change.regions;
    const std::size_t count = regions.size();
    const std::size_t n = region_ ? (*region_ + (by > 0 ? 1 : count - 1)) % count : (by > 0 ? 0 : count - 1);
    region_ = n;
    const inspect::ChangedRegion& region = regions[n];
    const auto& kinds = comparison_->change.ranges.cells;
    const QRect box(region.firstBeam, region.firstLine, region.lastBeam - region.firstBeam + 1, region.lastLine - region.firstLine + 1);
    const int around = std::max(kLeastAround, std::max(box.width(), box.height()) / 3);
    regionPart_ = QRectF(box.adjusted(-around, -around, around, around));
    // First the words: the cloud turns the region to where the legend with them leaves room, and the legend stays where it is.
    legend_.showRegion(
        (n == 0 ? tr("region %1 of %2, the largest by area: %3 by %4 m ± %5 m,\nnow at %7 m; %6 m² at the nearer surface, without its "
                     "border of one cell")
                : tr("region %1 of %2: %3 by %4 m ± %5 m,\nnow at %7 m; %6 m² at the nearer surface, without its border of one cell"))
            .arg(n + 1)
            .arg(count)
            .arg(region.farther ? tr("farther") : tr("nearer"))
            .arg(region.byM, 0, 'f', 2)
            .arg(shownTolerance(region.toleranceM, 2), 0, 'f', 2)
            .arg(region.areaM2, 0, 'f', 2)
            .arg(region.rangeM, 0, 'f', 2),
        QString("%1/%2 <span style='color:%3'>■</span> %4%5 m")
            .arg(n + 1)
            .arg(count)
            .arg(changeColour(region.farther ? ChangeRow::Farther : ChangeRow::Nearer).name(), region.farther ? "+" : "−")
            .arg(region.byM, 0, 'f', 2));
    views_.gray().viewPort()->fitTo(regionPart_);
    const std::vector<std::uint32_t> cells = cellsOf(kinds, region);
    views_.cloud().lookAtCells(cells);
    outlineRegion(cells);
}

/// Without cells it takes the outline away, unless that is of a rock by now.
void Comparing::outlineRegion(const std::vector<std::uint32_t>& cells) {
    if (cells.empty() && (!outlined_ || outlined_ != views_.cloud().outline())) return outlined_.reset();
    RockOutline outline;
    if (!cells.empty()) {
        const auto& kinds = comparison_->change.ranges.cells;
        Grid<std::uint32_t> mask(kinds.lines, kinds.beams);
        for (const std::uint32_t k : cells) mask[k] = 1;
        outline = outlineOf(mask, 1);
    }
    views_.setOutline(outline.sides, std::move(outline.cells));
    outlined_ = views_.cloud().outline();
}

} // namespace edgescan::ui
