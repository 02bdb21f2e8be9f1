// The cells that the gray methods ignore.
#include "core/edges/gray/masked_cells.h"

#include "core/scan/grid/missing_cells.h"

namespace edgescan::edges {

Grid<std::uint8_t> maskedCells(const Scan& scan, const Settings& settings) {
    if (!settings.maskMissing) return {};
    Grid<std::uint8_t> masked = missingCells(scan);
    if (!settings.maskIsolated) return masked;
    const Grid<std::uint8_t> isolated = isolatedCells(scan);
    for (std::size_t k = 0; k < masked.size(); ++k) masked[k] |= isolated[k];
    return masked;
}

} // namespace edgescan::edges
