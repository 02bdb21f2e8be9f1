// Registers by poses and surfaces, and finds the nearest point in each direction.
#include "core/inspect/change_detection/common_grid.h"

#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/inspect/registration/point_index.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr double kReachM = 0.5;        // m: largest distance of surfaces that are matched
constexpr double kSameCellSteps = 0.5; // a smaller correction than half a cell does not move cells
constexpr double kWithinSteps = 0.75;  // distance to a direction in steps: half the diagonal of a cell
constexpr double kSameEdge = 1.02;     // ratio of the ranges of one cell that belong to one surface
constexpr double kSamePlaceM = 0.002, kSameTurn = 2e-4;

bool sameGrid(const Scan& a, const Scan& b) {
    const auto* polarA = std::get_if<PolarGeometry>(&a.geometry);
    const auto* polarB = std::get_if<PolarGeometry>(&b.geometry);
    return polarA != nullptr && polarB != nullptr && *polarA == *polarB && a.lines() == b.lines() && a.beams() == b.beams();
}

bool samePlace(const Placement& a, const Placement& b) {
    if (!(a.mount == b.mount) || a.poses.size() != b.poses.size()) return false;
    const Eigen::Vector3d shift = a.originEnhM - b.originEnhM;
    for (std::size_t n = 0; n < a.poses.size(); ++n) {
        if ((a.poses[n].translationM + shift - b.poses[n].translationM).norm() > kSamePlaceM) return false;
        if ((a.poses[n].rotation - b.poses[n].rotation).norm() > kSameTurn) return false;
    }
    return true;
}

/// One file that was opened twice in the same way. Of a raw grid only the description has a hash, so the cells count too.
bool oneFile(const Scan& a, const Scan& b) {
    const bool onePlace = a.placement && b.placement ? samePlace(*a.placement, *b.placement) : !a.placement && !b.placement;
    return !a.sha256.empty() && a.sha256 == b.sha256 && onePlace && sameGrid(a, b) && a.state == b.state && a.rangeMm == b.rangeMm;
}

/// Both scans in one frame, and the directions of the later scan's cells in it.
struct PlacedPair {
    PlacedScan later, earlier;
    std::vector<Eigen::Vector3d> directions; ///< unit vectors; NaN where unknown
};

template <class Turn>
std::vector<Eigen::Vector3d> directionsOf(const Scan& scan, Turn turn) {
    const CartesianTables tables(scan);
    std::vector<Eigen::Vector3d> directions;
    directions.reserve(scan.cells());
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) directions.push_back(turn(i, j, tables.sensor(), tables.direction(i, j)));
    }
    return directions;
}

bool inMine(RegistrationBasis by, const RegistrationRequest& wish) { return by == RegistrationBasis::Poses && !wish.poses; }

std::array<PlacedScan, 2> placed(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier, RegistrationBasis by,
                                 const RegistrationRequest& wish) {
    if (inMine(by, wish)) {
        const Eigen::Vector3d origin = later->placement->originEnhM;
        return {placedInMine(later, origin), placedInMine(earlier, origin)};
    }
    const auto poses = wish.poses.value_or(std::array<RigidTransform, 2>{});
    return {placedBy(later, poses[0]), placedBy(earlier, poses[1])};
}

PlacedPair placedPair(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier, RegistrationBasis by,
                      const RegistrationRequest& wish) {
    std::array<PlacedScan, 2> both = placed(later, earlier, by, wish);
    if (inMine(by, wish)) {
        const PlacedPoints mine(*later);
        const auto turn = [&](int i, int j, const Eigen::Vector3d& sensor, const Eigen::Vector3d& direction) {
            return (mine.local(i, j, sensor + direction) - mine.local(i, j, sensor)).normalized().eval();
        };
        return {std::move(both[0]), std::move(both[1]), directionsOf(*later, turn)};
    }
    const RigidTransform ofLater = wish.poses ? (*wish.poses)[0] : RigidTransform{};
    const auto turn = [&](int, int, const Eigen::Vector3d&, const Eigen::Vector3d& direction) {
        return (ofLater.rotation * direction).eval();
    };
    return {std::move(both[0]), std::move(both[1]), directionsOf(*later, turn)};
}

/// The median distance by which a correction moves the points, in steps of the grid.
double movedSteps(const PlacedScan& placed, const PlacedScan& grid, const RigidTransform& correction) {
    constexpr std::size_t kLooked = 2000;
    std::vector<double> steps;
    const std::size_t stride = std::max<std::size_t>(1, placed.pointsM.size() / kLooked);
    for (std::size_t k = 0; k < placed.pointsM.size(); k += stride) {
        const Eigen::Vector3d& p = placed.pointsM[k];
        const double stepM = grid.stepRad * (p - grid.sensorM).norm();
        if (p.allFinite() && stepM > 0) steps.push_back((correction * p - p).norm() / stepM);
    }
    return median(std::move(steps));
}

std::string tenthsOfMm(double metres) { return fixedText(1000 * metres, 1) + " mm"; }

/// Moves the points of the earlier scan to the grid; of several in one direction the nearest is used.
Result<EarlierOnGrid> moved(const PlacedPair& pair, const Grid<std::uint8_t>& edges) {
    const Scan& later = *pair.later.scan;
    const PointIndex index(pair.directions);
    const double most = kWithinSteps * pair.later.stepRad;
    auto scan = std::make_shared<Scan>(later);
    std::ranges::fill(scan->rangeMm.cells, 0.0F);
    std::ranges::fill(scan->state.cells, CellState::NoReturn);
    scan->intensity = {};
    scan->attached.clear();
    scan->name = pair.earlier.scan->name;
    scan->path = pair.earlier.scan->path;
    scan->sha256 = pair.earlier.scan->sha256;
    scan->format = pair.earlier.scan->format;
    scan->warnings = pair.earlier.scan->warnings;
    scan->acquisition = pair.earlier.scan->acquisition;
    struct Fallen {
        std::uint32_t from, to;
        float rangeMm;
    };
    std::vector<Fallen> edgeCells;
    std::size_t hits = 0, edgesLeftOut = 0;
    for (std::size_t k = 0; k < pair.earlier.pointsM.size(); ++k) {
        const Eigen::Vector3d ray = pair.earlier.pointsM[k] - pair.later.sensorM;
        if (!ray.allFinite() || ray.isZero(0.0)) continue;
        const auto cell = index.nearest(ray.normalized());
        if (!cell || (pair.directions[*cell] - ray.normalized()).norm() > most) {
            edgesLeftOut += edges[k] != 0 ? 1 : 0;
            continue;
        }
        const auto range = static_cast<float>(1000.0 * ray.norm());
        ++hits;
        if (edges[k] != 0) edgeCells.push_back({static_cast<std::uint32_t>(k), *cell, range});
        if (scan->state[*cell] == CellState::Valid && scan->rangeMm[*cell] <= range) continue;
        scan->state[*cell] = CellState::Valid;
        scan->rangeMm[*cell] = range;
    }
    if (hits == 0)
        return Error{"no point of the earlier scan is in a direction that the later one looked at", pair.earlier.scan->name,
                     "choose two scans of one place, with poses that say so"};
    auto mask = std::make_shared<Grid<std::uint8_t>>(later.lines(), later.beams());
    for (const Fallen& edge : edgeCells) {
        if (static_cast<double>(edge.rangeMm) <= kSameEdge * static_cast<double>(scan->rangeMm[edge.to]))
            (*mask)[edge.to] = 255;
        else
            ++edgesLeftOut;
    }
    return EarlierOnGrid{std::move(scan), std::move(mask), {}, edgesLeftOut};
}

Result<RegistrationBasis> waysOf(const Scan& later, const Scan& earlier, const RegistrationRequest& wish) {
    if (wish.poses || (later.placement && earlier.placement)) return RegistrationBasis::Poses;
    if (!later.placement && !earlier.placement) return RegistrationBasis::Surfaces;
    if (wish.bySurfaces) return RegistrationBasis::Surfaces;
    const Scan& without = later.placement ? earlier : later;
    return Error{
        "one of the two scans has a place in the mine and this one has none, so their positions relative to each other are unknown",
        without.name, "give it a pose, or line the two up by their surfaces"};
}

/// Adds the warnings about the registration.
void judge(RegistrationResult& how, double off) {
    const auto say = [&](const std::string& sentence) {
        how.outOfSpec = true;
        how.warnings.push_back("OUT OF SPEC: " + sentence);
    };
    if (how.by == RegistrationBasis::Surfaces)
        say("without a pose of both, the two scans are lined up by their surfaces alone.");
    else if (how.surfaces && off > kSameCellSteps)
        say("the surfaces of the two scans do not lie where their poses put them: " + tenthsOfMm(how.surfaces->residualBeforeM) +
            " apart, and " + tenthsOfMm(how.surfaces->residualM) + " if one is moved by " + fixedText(off, 1) + " cells.");
    if (!how.measurable())
        say("the surfaces of the two scans lie " + tenthsOfMm(how.surfaces->residualM) +
            " apart at best, so most of the place changed or they are not scans of one place. No areas of change are given.");
}

} // namespace

std::array<PlacedScan, 2> inOneFrame(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier,
                                     const RegistrationResult& how, const RegistrationRequest& wish) {
    std::array<PlacedScan, 2> both = placed(later, earlier, how.by, wish);
    if (how.moved) both[1] = corrected(std::move(both[1]), *how.moved);
    return both;
}

Result<EarlierOnGrid> earlierOnGridOf(const std::shared_ptr<const Scan>& later, const std::shared_ptr<const Scan>& earlier,
                                      const std::shared_ptr<const Grid<std::uint8_t>>& edges, const RegistrationRequest& wish) {
    if (later == earlier) return EarlierOnGrid{earlier, edges, {}};
    if (!wish.poses && !wish.bySurfaces && oneFile(*later, *earlier)) {
        EarlierOnGrid same{earlier, edges, {}};
        same.how.warnings.emplace_back("Both are one scan: the files are the same.");
        return same;
    }
    const Result<RegistrationBasis> by = waysOf(*later, *earlier, wish);
    if (!by) return by.error();
    RegistrationResult how;
    how.by = *by;
    how.inMine = inMine(*by, wish);
    PlacedPair pair = placedPair(later, earlier, *by, wish);
    const auto aligned = alignScans(pair.later, pair.earlier, kReachM);
    const bool bySurfaces = *by == RegistrationBasis::Surfaces || wish.bySurfaces;
    if (!aligned && bySurfaces) return Error{aligned.error().what, earlier->name, "choose two scans of one place, or give both a pose"};
    double off = 0.0;
    if (aligned) {
        how.surfaces = *aligned;
        off = movedSteps(pair.earlier, pair.later, aligned->correction);
    } else {
        how.outOfSpec = true;
        how.warnings.push_back("OUT OF SPEC: whether the poses fit cannot be seen, " + aligned.error().what + ".");
    }
    const bool onePlace = *by == RegistrationBasis::Surfaces || (!wish.poses && samePlace(*later->placement, *earlier->placement)) ||
                          (wish.poses && (*wish.poses)[0] == (*wish.poses)[1]);
    how.sameCells = sameGrid(*later, *earlier) && onePlace && (!bySurfaces || off < kSameCellSteps);
    judge(how, bySurfaces ? 0.0 : off);
    if (bySurfaces && *by == RegistrationBasis::Poses && off > kSameCellSteps) {
        how.outOfSpec = true;
        how.warnings.push_back("OUT OF SPEC: the poses do not fit the surfaces, so the earlier scan was moved by its surfaces, by " +
                               fixedText(off, 1) + " cells.");
    }
    if (how.sameCells) return EarlierOnGrid{earlier, edges, std::move(how)};
    if (bySurfaces) {
        how.moved = aligned->correction;
        pair.earlier = corrected(std::move(pair.earlier), *how.moved);
    }
    Result<EarlierOnGrid> on = moved(pair, *edges);
    if (on) on->how = std::move(how);
    return on;
}

} // namespace edgescan::inspect
