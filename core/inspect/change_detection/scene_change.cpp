// Compares each cell with nine cells of the other scan.
#include "core/inspect/change_detection/scene_change.h"

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

/// Brings the earlier scan onto the later one. From one side the fit may end where the surfaces do not meet: then the other side is tried,
/// so that the result does not depend on the order of the two.
Result<ScanAlignment> alignedEitherWay(const PlacedScan& later, const PlacedScan& earlier) {
    auto forth = alignScans(later, earlier, kReachM);
    if (forth && forth->residualM <= kMostResidualM) return forth;
    auto back = alignScans(earlier, later, kReachM);
    if (!back || (forth && forth->residualM <= back->residualM)) return forth;
    back->correction = inverse(back->correction);
    return back;
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

/// Whether any cell within `reach` has a value, by rows and then by columns.
Grid<std::uint8_t> widened(const Grid<std::uint8_t>& from, int reach) {
    if (reach == 0) return from;
    Grid<std::uint8_t> rows(from.lines, from.beams), all(from.lines, from.beams);
    for (int i = 0; i < from.lines; ++i) {
        for (int j = 0; j < from.beams; ++j) {
            if (from.at(i, j) == 0) continue;
            std::fill(rows.line(i) + std::max(0, j - reach), rows.line(i) + std::min(from.beams - 1, j + reach) + 1, std::uint8_t{255});
        }
    }
    for (int i = 0; i < from.lines; ++i) {
        for (int n = std::max(0, i - reach); n <= std::min(from.lines - 1, i + reach); ++n) {
            for (int j = 0; j < from.beams; ++j) all.at(i, j) |= rows.at(n, j);
        }
    }
    return all;
}

Grid<std::uint8_t> measured(const Grid<CellState>& state) {
    Grid<std::uint8_t> valid(state.lines, state.beams);
    for (std::size_t k = 0; k < state.size(); ++k) valid[k] = state[k] == CellState::Valid ? 255 : 0;
    return valid;
}

/// Smallest and largest range of the nine cells, mm; both 0 if all are missing.
struct Span {
    float least = 0.0F, most = 0.0F;
    [[nodiscard]] bool known() const { return most > 0.0F; }
};

Span spanAt(const Scan& scan, int line, int beam) {
    Span span;
    for (int i = std::max(0, line - 1); i <= std::min(scan.lines() - 1, line + 1); ++i) {
        for (int j = std::max(0, beam - 1); j <= std::min(scan.beams() - 1, beam + 1); ++j) {
            if (scan.state.at(i, j) != CellState::Valid) continue;
            const float r = scan.rangeMm.at(i, j);
            span = span.known() ? Span{std::min(span.least, r), std::max(span.most, r)} : Span{r, r};
        }
    }
    return span;
}

/// Distance of a range from a span, mm: above 0 farther, below 0 nearer, 0 inside.
double beyond(double rangeMm, const Span& span) {
    if (rangeMm > static_cast<double>(span.most)) return rangeMm - static_cast<double>(span.most);
    if (rangeMm < static_cast<double>(span.least)) return rangeMm - static_cast<double>(span.least);
    return 0.0;
}

/// For a cell that both scans measured (the earlier scan there or in a neighbouring cell): later minus earlier range, mm; 0 if unchanged.
double changeAt(const Scan& later, const Scan& earlier, int line, int beam, const ChangeNoise& noise) {
    const double now = static_cast<double>(later.rangeMm.at(line, beam));
    const Span before = spanAt(earlier, line, beam);
    const double limit = kChangeSigmas * noise.at(now / 1000.0);
    const double off = beyond(now, before);
    if (std::abs(off) <= limit) return 0.0;
    if (earlier.state.at(line, beam) != CellState::Valid) return off;
    const double was = static_cast<double>(earlier.rangeMm.at(line, beam));
    const double back = -beyond(was, spanAt(later, line, beam));
    if (back * off <= 0.0 || std::abs(back) <= kChangeSigmas * noise.at(was / 1000.0)) return 0.0;
    return now - was;
}

/// The cells connected with `start`; they are removed from `open`.
std::vector<std::uint32_t> removeConnected(Grid<std::uint8_t>& open, const Grid<RangeChange>& cells, std::uint32_t start) {
    std::vector<std::uint32_t> found{start};
    open[start] = 0;
    const RangeChange kind = cells[start];
    for (std::size_t n = 0; n < found.size(); ++n) {
        const int line = static_cast<int>(found[n]) / cells.beams;
        const int beam = static_cast<int>(found[n]) % cells.beams;
        for (int i = std::max(0, line - 1); i <= std::min(cells.lines - 1, line + 1); ++i) {
            for (int j = std::max(0, beam - 1); j <= std::min(cells.beams - 1, beam + 1); ++j) {
                const std::size_t k = cells.index(i, j);
                if (open[k] == 0 || cells[k] != kind) continue;
                open[k] = 0;
                found.push_back(static_cast<std::uint32_t>(k));
            }
        }
    }
    return found;
}

ChangedRegion regionOf(const std::vector<std::uint32_t>& cells, const Scan& later, const AngularSteps& steps, const RangeChanges& changes,
                       const ChangeNoise& noise) {
    ChangedRegion region;
    region.farther = changes.cells[cells.front()] == RangeChange::Farther;
    region.cells = cells.size();
    region.firstLine = later.lines();
    region.firstBeam = later.beams();
    std::vector<double> by;
    double middleLine = 0.0, middleBeam = 0.0;
    for (const std::uint32_t k : cells) {
        const int line = static_cast<int>(k) / later.beams();
        const int beam = static_cast<int>(k) % later.beams();
        const double changeMm = static_cast<double>(changes.byMm[k]);
        const double nearerM = (static_cast<double>(later.rangeMm[k]) - std::max(0.0, changeMm)) / 1000.0;
        const double sideM = static_cast<double>(steps.beam[static_cast<std::size_t>(beam)]) * nearerM;
        region.areaM2 += sideM * static_cast<double>(steps.lineAt(line, beam)) * nearerM;
        by.push_back(std::abs(changeMm) / 1000.0);
        middleLine += line / static_cast<double>(cells.size());
        middleBeam += beam / static_cast<double>(cells.size());
        region.firstLine = std::min(region.firstLine, line);
        region.lastLine = std::max(region.lastLine, line);
        region.firstBeam = std::min(region.firstBeam, beam);
        region.lastBeam = std::max(region.lastBeam, beam);
    }
    const auto away = [&](std::uint32_t k) {
        return std::hypot(static_cast<int>(k) / later.beams() - middleLine, static_cast<int>(k) % later.beams() - middleBeam);
    };
    region.cell = *std::ranges::min_element(cells, {}, [&](std::uint32_t k) { return std::pair(away(k), k); });
    region.byM = median(std::move(by));
    region.rangeM = static_cast<double>(later.rangeMm[region.cell]) / 1000.0;
    region.toleranceM = 2.0 * noise.at(region.rangeM) / 1000.0;
    return region;
}

/// The distribution of the range differences: differences beyond the noise of both scans are errors of the registration.
void measureAgreement(SceneChange& change, const Scan& later) {
    constexpr double kToSigma = 1.4826; // converts a median of absolute values to a standard deviation of a normal distribution
    std::vector<double> off, ranges;
    for (std::size_t k = 0; k < later.cells(); ++k) {
        if (later.state[k] != CellState::Valid || change.earlier.scan->state[k] != CellState::Valid) continue;
        off.push_back(std::abs(static_cast<double>(later.rangeMm[k]) - static_cast<double>(change.earlier.scan->rangeMm[k])));
        ranges.push_back(static_cast<double>(later.rangeMm[k]) / 1000.0);
    }
    if (off.empty()) return;
    change.differMm = median(std::move(off));
    const double spread = kToSigma * change.differMm;
    const double expected = change.noise.at(median(std::move(ranges)));
    change.noise.placesMm = std::sqrt(std::max(0.0, spread * spread - expected * expected));
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
    const auto aligned = alignedEitherWay(pair.later, pair.earlier);
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

double ChangeNoise::at(double rangeM) const {
    return std::sqrt(std::pow(later.at(rangeM), 2) + std::pow(earlier.at(rangeM), 2) + placesMm * placesMm);
}

EdgeChanges edgeChanges(const Grid<std::uint8_t>& later, const Grid<std::uint8_t>& earlier, const Grid<CellState>& laterState,
                        const Grid<CellState>& earlierState, int reach) {
    EdgeChanges changes{{later.lines, later.beams, EdgeChange::None}};
    const Grid<std::uint8_t> nearLater = widened(later, reach), nearEarlier = widened(earlier, reach);
    const int looks = std::max(1, reach);
    const Grid<std::uint8_t> laterSaw = widened(measured(laterState), looks), earlierSaw = widened(measured(earlierState), looks);
    for (std::size_t k = 0; k < later.size(); ++k) {
        const auto is = [&](EdgeChange change, std::size_t& count) {
            changes.cells[k] = change;
            ++count;
        };
        changes.earlierUnchanged += earlier[k] != 0 && nearLater[k] != 0 ? 1 : 0;
        if (later[k] != 0 && nearEarlier[k] != 0)
            is(EdgeChange::Unchanged, changes.unchanged);
        else if (later[k] != 0)
            earlierSaw[k] != 0 ? is(EdgeChange::Gained, changes.gained) : is(EdgeChange::Unknown, changes.unknown);
        else if (earlier[k] != 0 && nearLater[k] == 0)
            laterSaw[k] != 0 ? is(EdgeChange::Lost, changes.lost) : is(EdgeChange::Unknown, changes.unknown);
    }
    return changes;
}

RangeChanges rangeChanges(const Scan& later, const Scan& earlier, const ChangeNoise& noise) {
    RangeChanges changes{{later.lines(), later.beams(), RangeChange::Unknown}, {later.lines(), later.beams()}};
    std::size_t k = 0;
    for (int line = 0; line < later.lines(); ++line) {
        for (int beam = 0; beam < later.beams(); ++beam, ++k) {
            const auto is = [&](RangeChange change, std::size_t& count) {
                changes.cells[k] = change;
                ++count;
            };
            const bool now = later.state[k] == CellState::Valid;
            const bool was = earlier.state[k] == CellState::Valid;
            if (!now) {
                if (was) is(RangeChange::NoReturnNow, changes.noReturnNow);
                continue;
            }
            if (!was && !spanAt(earlier, line, beam).known()) {
                is(RangeChange::NoReturnBefore, changes.noReturnBefore);
                continue;
            }
            const double by = changeAt(later, earlier, line, beam, noise);
            if (by == 0.0) {
                is(RangeChange::Same, changes.same);
                continue;
            }
            changes.byMm[k] = static_cast<float>(by);
            by > 0.0 ? is(RangeChange::Farther, changes.farther) : is(RangeChange::Nearer, changes.nearer);
        }
    }
    return changes;
}

std::vector<ChangedRegion> changedRegions(const Scan& later, const RangeChanges& changes, const ChangeNoise& noise) {
    Grid<std::uint8_t> open(later.lines(), later.beams());
    for (std::size_t k = 0; k < open.size(); ++k)
        open[k] = changes.cells[k] == RangeChange::Nearer || changes.cells[k] == RangeChange::Farther ? 1 : 0;
    const AngularSteps steps = angularSteps(later);
    std::vector<ChangedRegion> regions;
    for (std::size_t k = 0; k < open.size(); ++k) {
        if (open[k] == 0) continue;
        const auto cells = removeConnected(open, changes.cells, static_cast<std::uint32_t>(k));
        if (cells.size() >= kSmallestRegion) regions.push_back(regionOf(cells, later, steps, changes, noise));
    }
    std::ranges::stable_sort(regions, std::greater<>(), &ChangedRegion::areaM2);
    return regions;
}

SceneChange withEdges(SceneChange change, const ScanEdges& later) {
    const int reach = change.earlier.how.by == RegistrationBasis::OneScan ? 0 : kEdgeReachCells;
    change.edges = edgeChanges(*later.mask, *change.earlier.edges, later.scan->state, change.earlier.scan->state, reach);
    return change;
}

Result<SceneChange> sceneChange(const ScanEdges& later, const ScanEdges& earlier, const RegistrationRequest& wish) {
    auto on = earlierOnGridOf(later.scan, earlier.scan, earlier.mask, wish);
    if (!on) return on.error();
    SceneChange change;
    change.earlier = std::move(*on);
    const Scan& before = *change.earlier.scan;
    change = withEdges(std::move(change), later);
    if (change.earlier.how.by == RegistrationBasis::OneScan) return change;
    change.noise = {noiseByRange(inverseRange(*later.scan)), noiseByRange(inverseRange(*earlier.scan)), 0.0};
    measureAgreement(change, *later.scan);
    change.ranges = rangeChanges(*later.scan, before, change.noise);
    if (change.earlier.how.measurable()) change.regions = changedRegions(*later.scan, change.ranges, change.noise);
    return change;
}

} // namespace edgescan::inspect
