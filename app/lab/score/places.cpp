// The nearest detection of each true cell.
#include "app/lab/score/places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace edgescan::lab {
namespace {

constexpr int kReach = kPlaceDistances.back();
constexpr int kFewestAround = 3;   // cells of the edge that give its direction, including the cell itself
constexpr double kSideCells = 2.0; // across the edge, where the ranges of both sides are read

struct Offset {
    double line = 0, beam = 0;
};

struct Nearest {
    int squared = 0; ///< of the distance, cells
    Offset mean;     ///< of all detections at this distance
};

std::optional<Nearest> nearestDetection(const Grid<std::uint8_t>& thin, int line, int beam) {
    int best = kReach * kReach + 1;
    Offset sum;
    int count = 0;
    for (int i = -kReach; i <= kReach; ++i) {
        for (int j = -kReach; j <= kReach; ++j) {
            const int squared = i * i + j * j;
            if (squared > best || !thin.contains(line + i, beam + j) || thin.at(line + i, beam + j) == 0) continue;
            if (squared < best) sum = {}, count = 0;
            best = squared;
            sum.line += i;
            sum.beam += j;
            ++count;
        }
    }
    if (count == 0 || best > kReach * kReach) return std::nullopt;
    return Nearest{best, {sum.line / count, sum.beam / count}};
}

// The unit vector across the edge: where the true cells of the same class around scatter least.
std::optional<Offset> acrossEdge(const Grid<std::uint8_t>& edgeClass, int line, int beam) {
    const std::uint8_t own = edgeClass.at(line, beam);
    int count = 0;
    double ii = 0, ij = 0, jj = 0, si = 0, sj = 0;
    for (int i = -kReach; i <= kReach; ++i) {
        for (int j = -kReach; j <= kReach; ++j) {
            if (!edgeClass.contains(line + i, beam + j) || edgeClass.at(line + i, beam + j) != own) continue;
            ++count;
            si += i, sj += j;
            ii += i * i, ij += i * j, jj += j * j;
        }
    }
    if (count < kFewestAround) return std::nullopt;
    const double a = ii - si * si / count, b = ij - si * sj / count, c = jj - sj * sj / count;
    const double half = 0.5 * (a - c), root = std::sqrt(half * half + b * b);
    if (root < 1e-9) return std::nullopt; // no direction
    // The eigenvector of the smaller eigenvalue, (a + c) / 2 - root; of two forms the longer one.
    const Offset first{b, -half - root}, second{half - root, b};
    const double one = std::hypot(first.line, first.beam), two = std::hypot(second.line, second.beam);
    const Offset& longer = one > two ? first : second;
    return Offset{longer.line / std::max(one, two), longer.beam / std::max(one, two)};
}

// The direction turned to the farther side; nothing if both sides are as far.
std::optional<Offset> towardsFarther(const Grid<std::uint16_t>& cleanMm, int line, int beam, Offset across) {
    constexpr int kNothing = 1 << 20; // mm: farther than every range
    const auto at = [&](double sign) {
        const int i = line + static_cast<int>(std::lround(sign * kSideCells * across.line));
        const int j = beam + static_cast<int>(std::lround(sign * kSideCells * across.beam));
        return !cleanMm.contains(i, j) || cleanMm.at(i, j) == 0 ? kNothing : static_cast<int>(cleanMm.at(i, j));
    };
    const int ahead = at(1), behind = at(-1);
    if (ahead == behind) return std::nullopt;
    return ahead > behind ? across : Offset{-across.line, -across.beam};
}

} // namespace

EdgePlaces& EdgePlaces::operator+=(const EdgePlaces& other) {
    truth += other.truth;
    for (std::size_t n = 0; n < near.size(); ++n) near[n] += other.near[n];
    measured += other.measured;
    across += other.across;
    return *this;
}

double EdgePlaces::share(std::size_t distance) const {
    return truth == 0 ? 1.0 : static_cast<double>(near[distance]) / static_cast<double>(truth);
}

double EdgePlaces::offset() const { return measured == 0 ? 0.0 : across / static_cast<double>(measured); }

PlacesByClass edgePlaces(const Grid<std::uint8_t>& thin, const sim::TruthSet& truth) {
    PlacesByClass places;
    const Grid<std::uint8_t>& edgeClass = truth.edges.edgeClass;
    for (int line = 0; line < edgeClass.lines; ++line) {
        for (int beam = 0; beam < edgeClass.beams; ++beam) {
            const std::uint8_t own = edgeClass.at(line, beam);
            if (own == 0 || truth.edges.ignore.at(line, beam) != 0) continue;
            EdgePlaces& place = places.at(own);
            ++place.truth;
            const auto nearest = nearestDetection(thin, line, beam);
            if (!nearest) continue;
            for (std::size_t n = 0; n < kPlaceDistances.size(); ++n)
                place.near[n] += nearest->squared <= kPlaceDistances[n] * kPlaceDistances[n] ? 1 : 0;
            if (truth.cleanMm.size() == 0) continue;
            const auto across = acrossEdge(edgeClass, line, beam);
            const auto farther = across ? towardsFarther(truth.cleanMm, line, beam, *across) : std::nullopt;
            if (!farther) continue;
            ++place.measured;
            place.across += farther->line * nearest->mean.line + farther->beam * nearest->mean.beam;
        }
    }
    return places;
}

EdgePlaces allPlaces(const PlacesByClass& places) {
    EdgePlaces all;
    for (const EdgePlaces& place : places) all += place;
    return all;
}

} // namespace edgescan::lab
