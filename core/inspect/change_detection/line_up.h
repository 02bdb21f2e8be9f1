// Brings an earlier scan of a place onto the grid of a later one, and says how well the two lie on each other.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/inspect/registration/scan_alignment.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// What says where the cells of the one lie on the grid of the other.
enum class LinedUpBy : std::uint8_t {
    OneScan,  ///< there is one scan, with other settings
    Poses,    ///< both have a place
    Surfaces, ///< their surfaces alone: at least one has no place
};

struct LineUpWish {
    std::optional<std::array<RigidTransform, 2>>
        poses{};             ///< later, earlier: scanner frame to a common one, instead of the scans' own places
    bool bySurfaces = false; ///< also mend places that there are
};

struct LinedUp {
    LinedUpBy by = LinedUpBy::OneScan;
    bool sameCells = true;                 ///< cell k of the one is cell k of the other; else points were moved to the cells they fall into
    std::optional<ScanAlignment> surfaces; ///< how far they lie apart, also where they were not moved; empty for one scan
    bool outOfSpec = false;                ///< the warnings say why
    std::vector<std::string> warnings;
};

/// The earlier scan on the grid of the later one.
struct EarlierOnGrid {
    std::shared_ptr<const Scan> scan;                ///< lines x beams of the later one; ranges in mm from its sensor
    std::shared_ptr<const Grid<std::uint8_t>> edges; ///< 255 = edge of the earlier scan
    LinedUp how;
    std::size_t edgesLeftOut = 0; ///< edge cells of the earlier scan that no cell of the later one stands for
};

/// `edges`: of the earlier scan, not 0 = edge. Scans without a place are lined up by their surfaces, which is OUT OF SPEC and said
/// (docs/operator.md, "S20"). Error: only one of them has a place and `bySurfaces` is not wished, the surfaces do not hold each other, or
/// the two share no direction.
Result<EarlierOnGrid> onGridOf(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier,
                               const std::shared_ptr<const Grid<std::uint8_t>>& edges, const LineUpWish& wish = {});

} // namespace edgescan
