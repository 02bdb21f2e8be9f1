// Resamples an earlier scan of a place onto the grid of a later one, and reports the quality of the registration.
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

namespace edgescan::inspect {

/// The basis of the registration.
enum class RegistrationBasis : std::uint8_t {
    OneScan,  ///< both are the same scan, with two settings or opened twice
    Poses,    ///< both have a placement, or the request has poses
    Surfaces, ///< only their surfaces: at least one has no placement
};

struct RegistrationRequest {
    /// later, earlier: transforms from the scanner frame to a common frame, instead of the scans' own placements
    std::optional<std::array<RigidTransform, 2>> poses{};
    bool bySurfaces = false; ///< also correct existing placements by the surfaces
};

struct RegistrationResult {
    RegistrationBasis by = RegistrationBasis::OneScan;
    bool inMine = false; ///< by the placements of both scans; false for poses of the request: those of a simulation, or --poses-3dtk
    /// cell k of one scan is cell k of the other; otherwise points were moved to the cells that they fall into
    bool sameCells = true;
    std::optional<ScanAlignment> surfaces; ///< the remaining distance of the surfaces, also if they were not moved; empty for one scan
    std::optional<RigidTransform> moved;   ///< by which the earlier scan's points were moved in the common frame; empty: not at all
    bool outOfSpec = false;                ///< the warnings give the reasons
    std::vector<std::string> warnings;

    /// Otherwise the surfaces do not fit, and areas or lengths of change would be those of the registration.
    [[nodiscard]] bool measurable() const { return !surfaces || surfaces->residualM <= kMostResidualM; }
};

/// The earlier scan on the grid of the later one.
struct EarlierOnGrid {
    std::shared_ptr<const Scan> scan;                ///< lines x beams of the later scan; ranges in mm from its sensor
    std::shared_ptr<const Grid<std::uint8_t>> edges; ///< 255 = edge of the earlier scan
    RegistrationResult how;
    std::size_t edgesLeftOut = 0; ///< edge cells of the earlier scan that do not fall into a cell of the later one
};

/// The points of the later and of the earlier scan in one frame, as they were registered. Both must be those of earlierOnGridOf().
[[nodiscard]] std::array<PlacedScan, 2> inOneFrame(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier,
                                                   const RegistrationResult& how, const RegistrationRequest& wish = {});

/// `edges`: of the earlier scan, not 0 = edge. Scans without a placement are registered by their surfaces; the result is OUT OF SPEC and
/// carries a warning (docs/reference/rules.md, "S20"). Error: only one of them has a placement and `bySurfaces` is false, the surfaces do
/// not determine the registration, or the two scans have no common direction.
Result<EarlierOnGrid> earlierOnGridOf(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier,
                                      const std::shared_ptr<const Grid<std::uint8_t>>& edges, const RegistrationRequest& wish = {});

} // namespace edgescan::inspect
