// Start by pairs or poses, then the surfaces in two rounds: first with a wide reach.
#include "core/inspect/registration/stations.h"

#include "core/base/number_text.h"
#include "core/inspect/registration/point_index.h"
#include "core/scan/georef/placed_points.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace edgescan::inspect {
namespace {

constexpr std::array<double, 2> kReachesM{1.0, 0.3}; // the first brings wrong poses near, the second leaves out what only one scan sees
constexpr double kLeastSpread = 1e-3;                // of pairs: second principal axis divided by first

/// The other scan's points in the first one's scanner frame, by their places in the mine. One transform: that of the first scan's middle
/// cell, because a moving base has a pose per line.
PlacedScan byPoses(const Scan& first, const std::shared_ptr<const Scan>& other) {
    PlacedScan placed = placedInMine(other, first.placement->originEnhM);
    const PlacedPoints mine(first);
    const int line = first.lines() / 2, beam = first.beams() / 2;
    const auto toScanner = [&](const Eigen::Vector3d& p) { return mine.scanner(line, beam, p); };
    for (Eigen::Vector3d& p : placed.pointsM) p = p.allFinite() ? toScanner(p) : p;
    placed.sensorM = toScanner(placed.sensorM);
    return placed;
}

/// In the frame of `fixed`. Error: the first reach finds nothing to hold on to.
Result<ScanAlignment> bySurfaces(const PlacedScan& fixed, const PlacedScan& start) {
    PlacedScan moved = start;
    ScanAlignment all;
    bool first = true;
    for (const double reachM : kReachesM) {
        const auto aligned = alignScans(fixed, moved, reachM);
        if (!aligned && first) return aligned.error();
        if (!aligned) break;
        moved = corrected(std::move(moved), aligned->correction);
        const double before = first ? aligned->residualBeforeM : all.residualBeforeM;
        all = {aligned->correction * all.correction, before, aligned->residualM, aligned->pairs};
        first = false;
    }
    return all;
}

void judge(Station& station, const std::string& name) {
    if (!station.fit)
        station.warnings.push_back("OUT OF SPEC: whether the surfaces of \"" + name + "\" fit cannot be seen.");
    else if (station.fit->residualM > kMostResidualM)
        station.warnings.push_back("OUT OF SPEC: the surfaces of \"" + name + "\" are " + fixedText(1000 * station.fit->residualM, 1) +
                                   " mm from those of the first scan at best.");
}

/// The label that most cells of each rock fall on, and how many of its cells fall on anything.
struct Votes {
    std::map<int, std::map<int, std::size_t>> on; ///< by rock, by label of the other scan
    std::map<int, std::size_t> seen;
};

Votes votesOf(const PlacedScan& from, std::span<const int> rocks, const PlacedScan& onto, std::span<const int> ontoRocks, double reachM) {
    const PointIndex index(onto.pointsM);
    Votes votes;
    for (std::size_t k = 0; k < from.pointsM.size(); ++k) {
        if (rocks[k] == 0 || !from.pointsM[k].allFinite()) continue;
        const auto near = index.nearest(from.pointsM[k]);
        if (!near || (onto.pointsM[*near] - from.pointsM[k]).norm() > reachM) continue;
        ++votes.seen[rocks[k]];
        if (ontoRocks[*near] != 0) ++votes.on[rocks[k]][ontoRocks[*near]];
    }
    return votes;
}

std::optional<std::pair<int, std::size_t>> mostOf(const Votes& votes, int rock) {
    const auto found = votes.on.find(rock);
    if (found == votes.on.end()) return std::nullopt;
    const auto most = std::ranges::max_element(found->second, {}, [](const auto& one) { return one.second; });
    return std::pair(most->first, most->second);
}

} // namespace

Result<RigidTransform> transformOfPairs(std::span<const PointPair> pairs) {
    const Error few{"the pairs of points do not determine how the scans are placed", "", "pick three places that are not on one line"};
    if (pairs.size() < 3) return few;
    Eigen::Matrix3Xd first(3, pairs.size()), other(3, pairs.size());
    for (std::size_t n = 0; n < pairs.size(); ++n) {
        first.col(static_cast<Eigen::Index>(n)) = pairs[n].firstM;
        other.col(static_cast<Eigen::Index>(n)) = pairs[n].otherM;
    }
    for (const Eigen::Matrix3Xd& points : {first, other}) {
        const Eigen::Matrix3Xd spread = points.colwise() - points.rowwise().mean();
        const Eigen::Vector3d axes = Eigen::JacobiSVD<Eigen::Matrix3Xd>(spread).singularValues();
        if (!(axes[1] > kLeastSpread * axes[0])) return few;
    }
    const Eigen::Matrix4d m = Eigen::umeyama(other, first, false);
    return RigidTransform{m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
}

Result<Station> stationOf(const std::shared_ptr<const Scan>& first, const std::shared_ptr<const Scan>& other, const StationRequest& wish) {
    Station station;
    if (!wish.pairs.empty()) {
        const auto start = transformOfPairs(wish.pairs);
        if (!start) return Error{start.error().what, other->name, start.error().hint};
        double square = 0;
        for (const PointPair& pair : wish.pairs) square += (*start * pair.otherM - pair.firstM).squaredNorm();
        station.pairsM = std::sqrt(square / static_cast<double>(wish.pairs.size()));
        station.by = StationBasis::Pairs;
        station.placed = placedBy(other, *start);
    } else if (first->placement && other->placement) {
        station.placed = byPoses(*first, other);
    } else {
        station.by = StationBasis::Surfaces;
        station.placed = placedBy(other, {});
    }
    const auto fit = bySurfaces(placedBy(first, {}), station.placed);
    if (fit) station.fit = *fit;
    if (!fit && station.by == StationBasis::Surfaces)
        return Error{fit.error().what, other->name, "give both scans a pose, or pick three points in both"};
    station.corrected = fit && (wish.bySurfaces || station.by == StationBasis::Surfaces);
    if (station.corrected) station.placed = corrected(std::move(station.placed), fit->correction);
    judge(station, other->name);
    return station;
}

std::vector<SameRock> sameRocks(const PlacedScan& first, std::span<const int> firstRocks, const PlacedScan& other,
                                std::span<const int> otherRocks, double reachM) {
    const Votes ofFirst = votesOf(first, firstRocks, other, otherRocks, reachM);
    const Votes ofOther = votesOf(other, otherRocks, first, firstRocks, reachM);
    std::vector<SameRock> same;
    for (const auto& [rock, seen] : ofFirst.seen) {
        const auto there = mostOf(ofFirst, rock);
        const auto back = there ? mostOf(ofOther, there->first) : std::nullopt;
        if (!back || back->first != rock) continue;
        const double share = std::max(static_cast<double>(there->second) / static_cast<double>(seen),
                                      static_cast<double>(back->second) / static_cast<double>(ofOther.seen.at(there->first)));
        same.push_back({rock, there->first, back->second, share});
    }
    return same;
}

} // namespace edgescan::inspect
