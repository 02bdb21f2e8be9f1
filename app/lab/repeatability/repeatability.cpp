// Searches the edges of one scan in another.
#include "app/lab/repeatability/repeatability.h"

#include "app/lab/sim/truth/thin.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/method_traits.h"
#include "core/inspect/registration/point_index.h"

#include <algorithm>
#include <cmath>

namespace edgescan::lab {
namespace {

constexpr double kStepsAway = 1.5; // steps from a measured direction: farther away the other scan did not measure

/// Which points of `a` the sensor of `b` saw: `b` measured in that direction, and its range there is not shorter by more than `toleranceM`.
std::vector<std::uint8_t> visibleFrom(const inspect::PlacedScan& a, const inspect::PlacedScan& b, double toleranceM) {
    std::vector<Eigen::Vector3d> directions;
    for (const Eigen::Vector3d& p : b.pointsM) directions.push_back((p - b.sensorM).normalized());
    const inspect::PointIndex index(directions);
    const double mostAway = kStepsAway * b.stepRad;
    std::vector<std::uint8_t> seen(a.pointsM.size(), 0);
    for (std::size_t k = 0; k < a.pointsM.size(); ++k) {
        const Eigen::Vector3d ray = a.pointsM[k] - b.sensorM;
        if (!ray.allFinite() || ray.isZero(0.0)) continue;
        const auto cell = index.nearest(ray.normalized());
        if (!cell || (directions[*cell] - ray.normalized()).norm() > mostAway) continue;
        seen[k] = (b.pointsM[*cell] - b.sensorM).norm() >= ray.norm() - toleranceM ? 1 : 0;
    }
    return seen;
}

std::vector<Eigen::Vector3d> pointsOf(const inspect::PlacedScan& placed, const Grid<std::uint8_t>& mask) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < mask.size(); ++k) {
        if (mask[k] != 0 && placed.pointsM[k].allFinite()) points.push_back(placed.pointsM[k]);
    }
    return points;
}

void countOneWay(RepeatCount& count, const inspect::PlacedScan& from, const Grid<std::uint8_t>& mask, const std::vector<std::uint8_t>& seen,
                 const std::vector<Eigen::Vector3d>& others, double radiusM) {
    const inspect::PointIndex index(others);
    for (std::size_t k = 0; k < mask.size(); ++k) {
        if (mask[k] == 0 || !from.pointsM[k].allFinite()) continue;
        ++count.edges;
        if (seen[k] == 0) continue;
        ++count.visible;
        const auto nearest = index.nearest(from.pointsM[k]);
        count.found += nearest && (others[*nearest] - from.pointsM[k]).norm() <= radiusM ? 1 : 0;
    }
}

std::size_t edgesIn(const Grid<std::uint8_t>& mask) { return mask.size() - static_cast<std::size_t>(std::ranges::count(mask.cells, 0)); }

/// The mask with the threshold that gives at least `edges` edges, and as few more as possible; empty if no threshold gives as many.
std::optional<Grid<std::uint8_t>> maskWith(std::size_t edges, const inspect::PlacedScan& placed, const edges::Settings& settings) {
    const edges::ThresholdMap map = edges::thresholdMapOf(*edges::detectEdges(placed.scan, settings));
    std::vector<double> highest;
    for (const double value : map.highest.cells) {
        if (value >= 0 && std::isfinite(value)) highest.push_back(value);
    }
    if (edges == 0 || edges >= highest.size()) return std::nullopt;
    std::ranges::nth_element(highest, highest.begin() + static_cast<std::ptrdiff_t>(edges), std::greater<>());
    return edges::edgesAt(map, highest[edges]);
}

/// The thinned mask with the threshold, found by bisection, that gives this many cells after thinning; empty if no threshold gives as many.
std::optional<Grid<std::uint8_t>> thinnedWith(std::size_t places, const inspect::PlacedScan& placed, const edges::Settings& settings) {
    const edges::ThresholdMap map = edges::thresholdMapOf(*edges::detectEdges(placed.scan, settings));
    std::vector<double> highest;
    for (const double value : map.highest.cells) {
        if (value >= 0 && std::isfinite(value)) highest.push_back(value);
    }
    std::ranges::sort(highest, std::greater<>());
    highest.erase(std::unique(highest.begin(), highest.end()), highest.end());
    const auto at = [&](std::size_t n) { return sim::thinned(edges::edgesAt(map, highest[n])); };
    std::size_t first = 0, end = highest.size();
    while (first < end) {
        const std::size_t middle = first + (end - first) / 2;
        if (edgesIn(at(middle)) < places)
            first = middle + 1;
        else
            end = middle;
    }
    if (places == 0 || first == highest.size()) return std::nullopt;
    return at(first);
}

} // namespace

RepeatCounter::RepeatCounter(const inspect::PlacedScan& a, const inspect::PlacedScan& b, double radiusM)
    : a_(a), b_(b), radiusM_(radiusM), aSeenByB_(visibleFrom(a, b, 2 * radiusM)), bSeenByA_(visibleFrom(b, a, 2 * radiusM)) {}

RepeatCount RepeatCounter::count(const Grid<std::uint8_t>& maskA, const Grid<std::uint8_t>& maskB) const {
    RepeatCount count;
    countOneWay(count, a_, maskA, aSeenByB_, pointsOf(b_, maskB), radiusM_);
    countOneWay(count, b_, maskB, bSeenByA_, pointsOf(a_, maskA), radiusM_);
    return count;
}

std::vector<MethodRepeatability> methodRepeatability(const inspect::PlacedScan& a, const inspect::PlacedScan& b, double radiusM,
                                                     const ComparisonSettings& settings, const ComparisonProgress& progress) {
    const auto half = [&](double from) {
        return [&progress, from](const char* name, double fraction) { return !progress || progress(name, from + 0.5 * fraction); };
    };
    const auto ofA = compareMethods(a.scan, nullptr, settings, half(0.0));
    const auto ofB = compareMethods(b.scan, nullptr, settings, half(0.5));
    const RepeatCounter counter(a, b, radiusM);
    const auto named = [](const std::vector<ComparedMethod>& methods, const std::string& key) {
        return std::ranges::find_if(methods, [&](const ComparedMethod& m) { return m.key == key; });
    };
    const std::string ours = edges::traitsOf(edges::Method::EdgeScanPlus).key;
    const auto referenceA = named(ofA, ours);
    const auto referenceB = named(ofB, ours);
    const Grid<std::uint8_t> thinOfA = referenceA != ofA.end() ? sim::thinned(referenceA->mask) : Grid<std::uint8_t>();
    const Grid<std::uint8_t> thinOfB = referenceB != ofB.end() ? sim::thinned(referenceB->mask) : Grid<std::uint8_t>();
    std::vector<MethodRepeatability> rows;
    for (const ComparedMethod& method : ofA) {
        const auto other = named(ofB, method.key);
        if (other == ofB.end()) continue;
        MethodRepeatability row{method.name, method.key, {}, std::nullopt, std::nullopt, method.note.empty() ? other->note : method.note};
        row.withFixedSettings = counter.count(method.mask, other->mask);
        if (method.settings && referenceA != ofA.end() && referenceB != ofB.end()) {
            const auto maskA = maskWith(edgesIn(referenceA->mask), a, *method.settings);
            const auto maskB = maskWith(edgesIn(referenceB->mask), b, *method.settings);
            if (maskA && maskB) row.atEqual = counter.count(*maskA, *maskB);
            const auto thinA = method.key == ours ? std::optional(thinOfA) : thinnedWith(edgesIn(thinOfA), a, *method.settings);
            const auto thinB = method.key == ours ? std::optional(thinOfB) : thinnedWith(edgesIn(thinOfB), b, *method.settings);
            if (thinA && thinB) row.atEqualPlaces = counter.count(*thinA, *thinB);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace edgescan::lab
