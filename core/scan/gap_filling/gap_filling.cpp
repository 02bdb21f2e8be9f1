// For each gap: finds its cells and the measured cells around it, and decides how to fill it.
#include "core/scan/gap_filling/gap_filling.h"

#include "core/scan/gap_filling/plane_in_u.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/missing_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgescan {
namespace {

constexpr int kRing = 2;              // width of the ring around a gap, in cells
constexpr int kLongSides = 4;         // the longest side, in units of the short one
constexpr double kTwoSurfacesMm = 40; // if the ranges around a gap leave a step of this size between them, they belong to two surfaces ...
constexpr double kTwoSurfaces = 0.01; // ... or of this share of the range
constexpr std::size_t kFewestOfSurface = 3;
constexpr double kSmallestSurface = 0.04; // share of the ring
constexpr double kOnPlane = 0.8;          // share of the ring that must have weight
constexpr double kFlatMm = 12, kFlat = 0.002;
constexpr double kEndsApartMm = 80, kEndsApart = 0.02;
constexpr double kLineSdMm = 13;     // half-width that contains 68 % of the ranges between two ends, mm
constexpr double kOwnScatter = 0.15; // share of a cell's variance: the relief between the cells
constexpr double kBend = 0.2;        // share of a cell's width, per cell of distance from the measured cells

enum Cell : std::uint8_t { kMeasured, kDust, kMissing, kKeptOut, kSeen };

struct Place {
    int line, beam;
};

struct Gap {
    std::vector<Place> cells; // the cells to fill come first, in the order in which they were found
    Place least{}, most{};
    bool closed = true; // not at the border of the grid, and without cells that the operator masked or gated
};

class Filler {
public:
    Filler(const Scan& scan, const RangeNoise& noise, int longest)
        : scan_(scan), noise_(noise), steps_(angularSteps(scan)), longest_(longest), cells_(scan.lines(), scan.beams()) {
        const Grid<std::uint8_t> isolated = isolatedCells(scan);
        for (std::size_t k = 0; k < cells_.size(); ++k) cells_[k] = kindOf(scan.state[k], scan.rangeMm[k] > 0 && isolated[k] == 0);
    }

    GapFilling filled() {
        for (int i = 0; i < cells_.lines; ++i) {
            for (int j = 0; j < cells_.beams; ++j) {
                if (cells_.at(i, j) == kMissing) fill(gapAt({i, j}));
            }
        }
        std::ranges::sort(filling_.cells, {}, &FilledCell::cell);
        return std::move(filling_);
    }

private:
    static Cell kindOf(CellState state, bool isSupported) {
        if (state == CellState::Valid) return isSupported ? kMeasured : kDust;
        return state == CellState::Masked || state == CellState::OutOfWindow ? kKeptOut : kMissing;
    }

    // All missing cells connected with the seed cell. Dust inside the gap belongs to it and is not filled.
    Gap gapAt(Place seed) {
        Gap gap;
        gap.least = gap.most = seed;
        gap.cells.push_back(seed);
        cells_.at(seed.line, seed.beam) = kSeen;
        for (std::size_t n = 0; n < gap.cells.size(); ++n) {
            const Place at = gap.cells[n];
            gap.least = {std::min(gap.least.line, at.line), std::min(gap.least.beam, at.beam)};
            gap.most = {std::max(gap.most.line, at.line), std::max(gap.most.beam, at.beam)};
            for (int i = at.line - 1; i <= at.line + 1; ++i) {
                for (int j = at.beam - 1; j <= at.beam + 1; ++j) {
                    if (!cells_.contains(i, j)) {
                        gap.closed = false;
                        continue;
                    }
                    std::uint8_t& there = cells_.at(i, j);
                    if (there == kKeptOut) gap.closed = false;
                    if (there != kMissing) continue;
                    there = kSeen;
                    gap.cells.push_back({i, j});
                }
            }
        }
        return gap;
    }

    void fill(const Gap& gap) {
        const int lines = gap.most.line - gap.least.line + 1;
        const int beams = gap.most.beam - gap.least.beam + 1;
        const int side = longest_ + 2;
        if (!gap.closed || std::min(lines, beams) > side || std::max(lines, beams) > kLongSides * side) return;
        const std::size_t before = filling_.cells.size();
        if (!fillByPlane(gap)) {
            for (const Place at : gap.cells) fillByLine(at);
        }
        if (filling_.cells.size() > before) ++filling_.gaps;
    }

    void add(Place at, double rangeMm, double sdMm, FilledBy by) {
        const auto cell = static_cast<std::uint32_t>(cells_.index(at.line, at.beam));
        filling_.cells.push_back({cell, static_cast<float>(rangeMm), static_cast<float>(sdMm), by});
        if (by == FilledBy::Plane) ++filling_.byPlane;
    }

    [[nodiscard]] double rangeAt(int line, int beam) const { return static_cast<double>(scan_.rangeMm.at(line, beam)); }

    // Measured cells at most two cells away from the gap, each once.
    [[nodiscard]] std::vector<Place> ringOf(const Gap& gap) const {
        const Place from{gap.least.line - kRing, gap.least.beam - kRing};
        const int beams = gap.most.beam - from.beam + kRing + 1;
        const int lines = gap.most.line - from.line + kRing + 1;
        std::vector<std::uint8_t> near(static_cast<std::size_t>(beams) * static_cast<std::size_t>(lines), 0);
        for (const Place at : gap.cells) {
            for (int i = at.line - kRing; i <= at.line + kRing; ++i) {
                const auto row = static_cast<std::size_t>(i - from.line) * static_cast<std::size_t>(beams);
                const auto first = near.begin() + static_cast<std::ptrdiff_t>(row) + at.beam - kRing - from.beam;
                std::fill_n(first, 2 * kRing + 1, std::uint8_t{1});
            }
        }
        std::vector<Place> ring;
        for (std::size_t n = 0; n < near.size(); ++n) {
            const Place at{from.line + static_cast<int>(n) / beams, from.beam + static_cast<int>(n) % beams};
            if (near[n] != 0 && cells_.contains(at.line, at.beam) && cells_.at(at.line, at.beam) == kMeasured) ring.push_back(at);
        }
        return ring;
    }

    // The ring without single outliers; empty if two surfaces remain, one behind the other.
    [[nodiscard]] std::vector<Place> oneSurface(std::vector<Place> ring) const {
        std::ranges::stable_sort(ring, {}, [&](Place at) { return rangeAt(at.line, at.beam); });
        const std::size_t fewest =
            std::max(kFewestOfSurface, static_cast<std::size_t>(std::ceil(kSmallestSurface * static_cast<double>(ring.size()))));
        std::vector<Place> surface;
        std::size_t start = 0;
        for (std::size_t n = 1; n <= ring.size(); ++n) {
            if (n < ring.size()) {
                const double here = rangeAt(ring[n - 1].line, ring[n - 1].beam);
                const double next = rangeAt(ring[n].line, ring[n].beam);
                if (next - here <= std::max(kTwoSurfacesMm, kTwoSurfaces * here)) continue;
            }
            if (n - start >= fewest) {
                if (!surface.empty()) return {};
                surface.assign(ring.begin() + static_cast<std::ptrdiff_t>(start), ring.begin() + static_cast<std::ptrdiff_t>(n));
            }
            start = n;
        }
        return surface;
    }

    bool fillByPlane(const Gap& gap) {
        const std::vector<Place> ring = oneSurface(ringOf(gap));
        if (ring.empty()) return false;
        const double middleLine = 0.5 * (gap.least.line + gap.most.line);
        const double middleBeam = 0.5 * (gap.least.beam + gap.most.beam);
        std::vector<RingCell> cells;
        double meanU = 0;
        for (const Place at : ring) {
            cells.push_back({at.beam - middleBeam, at.line - middleLine, 1000.0 / rangeAt(at.line, at.beam)});
            meanU += cells.back().u / static_cast<double>(ring.size());
        }
        const std::optional<PlaneInU> plane = fitPlaneInU(cells, 0.001 * noise_.at(1 / meanU) * meanU * meanU);
        if (!plane || plane->weighed < kOnPlane) return false;
        const double flatMm = 1000 * plane->sdU / (meanU * meanU);
        if (flatMm > kFlatMm + kFlat * 1000 / meanU) return false;
        for (const Place at : gap.cells) {
            // A plane that reaches the horizon is not a fit.
            if (!(plane->at(at.beam - middleBeam, at.line - middleLine) > 0.5 * meanU)) return false;
        }
        for (const Place at : gap.cells) {
            const double dx = at.beam - middleBeam, dy = at.line - middleLine;
            const double rangeMm = 1000 / plane->at(dx, dy);
            const auto beam = static_cast<std::size_t>(at.beam);
            const double step = static_cast<double>(std::max(steps_.beam[beam], steps_.lineAt(at.line, at.beam)));
            const double bend = kBend * fromMeasured(at, ring) * rangeMm * step;
            const double sdMm = std::sqrt(flatMm * flatMm * (plane->leverage(dx, dy) + kOwnScatter) + bend * bend);
            add(at, rangeMm, sdMm, FilledBy::Plane);
        }
        return true;
    }

    // Distance in cells to the nearest cell of the ring.
    static int fromMeasured(Place at, const std::vector<Place>& ring) {
        int least = INT32_MAX;
        for (const Place there : ring) least = std::min(least, std::max(std::abs(there.line - at.line), std::abs(there.beam - at.beam)));
        return least;
    }

    // The straight line between the two ends of the gap in one direction; empty if an end is missing or the ends are too far apart in
    // range.
    struct Between {
        double rangeMm, apartMm;
    };
    [[nodiscard]] std::optional<Between> between(Place at, int lines, int beams) const {
        const auto end = [&](int sign) {
            for (int n = 1; n <= longest_; ++n) {
                const int i = at.line + sign * n * lines, j = at.beam + sign * n * beams;
                if (!cells_.contains(i, j)) break; // dust next to the gap may reach the border
                if (cells_.at(i, j) == kMeasured) return n;
            }
            return longest_ + 1;
        };
        const int back = end(-1), on = end(1);
        if (back + on - 1 > longest_) return std::nullopt;
        const double before = rangeAt(at.line - back * lines, at.beam - back * beams);
        const double after = rangeAt(at.line + on * lines, at.beam + on * beams);
        const double apart = std::abs(before - after);
        if (!(apart < kEndsApartMm + kEndsApart * std::min(before, after))) return std::nullopt;
        return Between{(back + on) / (on / before + back / after), apart};
    }

    void fillByLine(Place at) {
        const auto alongBeams = between(at, 0, 1);
        const auto alongLines = between(at, 1, 0);
        if (!alongBeams && !alongLines) return;
        const bool beams = alongBeams && (!alongLines || alongBeams->apartMm <= alongLines->apartMm);
        add(at, (beams ? alongBeams : alongLines)->rangeMm, kLineSdMm, FilledBy::Line);
    }

    const Scan& scan_;
    const RangeNoise& noise_;
    AngularSteps steps_;
    int longest_;
    Grid<std::uint8_t> cells_;
    GapFilling filling_;
};

} // namespace

const FilledCell* GapFilling::at(std::size_t cell) const {
    const auto found = std::ranges::lower_bound(cells, cell, {}, &FilledCell::cell);
    return found != cells.end() && found->cell == cell ? &*found : nullptr;
}

GapFilling fillGaps(const Scan& scan, const RangeNoise& noise, int longest) {
    return longest < 1 || scan.cells() == 0 ? GapFilling{} : Filler(scan, noise, longest).filled();
}

GapFilling fillGaps(const Scan& scan, int longest) {
    return longest < 1 || scan.cells() == 0 ? GapFilling{} : fillGaps(scan, noiseByRange(inverseRange(scan)), longest);
}

ScanWithFilled withFilled(const Scan& scan, const GapFilling& filling) {
    ScanWithFilled with{scan, Grid<float>(scan.lines(), scan.beams())};
    const CartesianTables tables(scan);
    auto* points = std::get_if<PointGeometry>(&with.scan.geometry);
    const auto beams = static_cast<std::size_t>(scan.beams());
    for (const FilledCell& filled : filling.cells) {
        const std::size_t k = filled.cell;
        if (points != nullptr) {
            const Eigen::Vector3d ray = tables.direction(static_cast<int>(k / beams), static_cast<int>(k % beams));
            if (!ray.allFinite()) continue;
            points->pointsM[k] = points->sensorM + 0.001 * static_cast<double>(filled.rangeMm) * ray;
        }
        with.scan.rangeMm[k] = filled.rangeMm;
        with.scan.state[k] = CellState::Valid;
        with.sdMm[k] = filled.sdMm;
    }
    return with;
}

} // namespace edgescan
