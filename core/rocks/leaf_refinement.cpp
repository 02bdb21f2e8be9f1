// Cells on the borders of leaves choose the leaf whose plane they lie on.
#include "core/rocks/leaf_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr int kPasses = 4;
constexpr int kWindow = 4;          // cells on each side that a plane is fitted to
constexpr int kReach = kWindow + 1; // cells on each side that a choice depends on
constexpr double kRidge = 0.5;      // added to the spreads, so that few cells on a line tilt nothing
constexpr int kFewestForPlane = 6;
constexpr double kFarOff = 30.0; // standard deviations; beyond, more hardly counts
constexpr double kBeyond = 0.01;
constexpr double kPerNeighbour = 2.0;
constexpr float kAcrossEdge = 0.5F; // how little a neighbour counts behind a full jump or valley
constexpr double kFitsOpen = 20.0;  // standard deviations within which an open cell is taken
constexpr std::size_t kMostChoices = 9;
constexpr double kLeastU = 1e-4; // 1/m

// Sums for the plane u = a + b x + c y through cells of one leaf, about the cell that chooses.
struct PlaneSums {
    std::uint32_t leaf = kOpen;
    double neighbours = 0; // of the cell that chooses; less for those behind an edge
    int n = 0;
    int x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    double u = 0, xu = 0, yu = 0;

    void add(int dx, int dy, double value) {
        ++n;
        x += dx;
        y += dy;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
        u += value;
        xu += dx * value;
        yu += dy * value;
    }
    // Of the plane at the cell that chooses.
    [[nodiscard]] double height() const {
        if (n < kFewestForPlane) return u / n;
        const double a = xx + kRidge;
        const double d = yy + kRidge;
        const double minor = a * d - static_cast<double>(xy) * xy;
        const double cx = x * d - static_cast<double>(y) * xy;
        const double cy = y * a - static_cast<double>(x) * xy;
        const double determinant = n * minor - x * cx - y * cy;
        return (u * minor - xu * cx - yu * cy) / determinant;
    }
};

class Refinement {
public:
    Refinement(const InverseRange& inverse, const DepthCracks& cracks, const RangeNoise& noise, Grid<std::uint32_t>& leaf)
        : inverse_(inverse), cracks_(cracks), noise_(noise), leaf_(leaf), next_(leaf), touches_(leaf.lines, leaf.beams),
          changed_(leaf.lines, leaf.beams, 1) {}

    void pass() {
        const Grid<std::uint8_t> looked = around(changed_);
        markTouching(looked);
        std::fill(changed_.cells.begin(), changed_.cells.end(), std::uint8_t{0});
        for (int i = 0; i < leaf_.lines; ++i) {
            for (int j = 0; j < leaf_.beams; ++j) {
                const std::size_t k = leaf_.index(i, j);
                if (touches_[k] == 0 || looked[k] == 0) continue;
                next_[k] = choice(i, j);
                if (next_[k] != leaf_[k]) changed_[k] = 1;
            }
        }
        leaf_ = next_;
    }

private:
    // 1 at cells with a neighbour (of 8) that holds a range and belongs to another leaf, or to none. Far from changes it is as it was.
    void markTouching(const Grid<std::uint8_t>& looked) {
        for (int i = 0; i < leaf_.lines; ++i) {
            for (int j = 0; j < leaf_.beams; ++j) {
                const std::size_t k = leaf_.index(i, j);
                if (looked[k] != 0) touches_[k] = touchesAnother(i, j) ? 1 : 0;
            }
        }
    }
    [[nodiscard]] bool touchesAnother(int line, int beam) const {
        const std::size_t k = leaf_.index(line, beam);
        if (inverse_.support[k] == Support::Void) return false;
        for (int i = std::max(line - 1, 0); i <= std::min(line + 1, leaf_.lines - 1); ++i) {
            for (int j = std::max(beam - 1, 0); j <= std::min(beam + 1, leaf_.beams - 1); ++j) {
                const std::size_t there = leaf_.index(i, j);
                if (leaf_[there] != leaf_[k] && inverse_.support[there] != Support::Void) return true;
            }
        }
        return false;
    }
    // 1 within kReach of marked cells.
    static Grid<std::uint8_t> around(const Grid<std::uint8_t>& marked) {
        Grid<std::uint8_t> wide(marked.lines, marked.beams);
        Grid<std::uint8_t> result(marked.lines, marked.beams);
        for (int i = 0; i < marked.lines; ++i) {
            int left = 0; // cells that are still within reach of a mark
            for (int j = -kReach; j < marked.beams; ++j) {
                if (j + kReach < marked.beams && marked.at(i, j + kReach) != 0) left = 2 * kReach + 1;
                if (j >= 0) wide.at(i, j) = left > 0 ? 1 : 0;
                --left;
            }
        }
        for (int i = 0; i < marked.lines; ++i) {
            for (int there = std::max(0, i - kReach); there <= std::min(marked.lines - 1, i + kReach); ++there) {
                const std::uint8_t* from = wide.line(there);
                std::uint8_t* to = result.line(i);
                for (int j = 0; j < marked.beams; ++j) to[j] |= from[j];
            }
        }
        return result;
    }
    [[nodiscard]] std::uint32_t choice(int line, int beam) const {
        std::array<PlaneSums, kMostChoices> planes;
        const std::size_t count = choices(line, beam, planes);
        if (count == 0) return leaf_.at(line, beam);
        fill(line, beam, planes, count);
        const bool isOpen = leaf_.at(line, beam) == kOpen;
        const auto here = static_cast<double>(inverse_.u.at(line, beam));
        std::uint32_t best = leaf_.at(line, beam);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t n = 0; n < count; ++n) {
            const double off = planes[n].n == 0 ? kFarOff : deviations(planes[n].height(), here);
            if (isOpen && off >= kFitsOpen) continue;
            const double cost = (off > kFarOff ? kFarOff + kBeyond * (off - kFarOff) : off) - kPerNeighbour * planes[n].neighbours;
            if (cost < least || (cost == least && planes[n].leaf < best)) {
                least = cost;
                best = planes[n].leaf;
            }
        }
        return best;
    }
    // How far the plane lies off the range, in standard deviations of the noise.
    [[nodiscard]] double deviations(double height, double here) const {
        const double rangeM = 1.0 / here;
        return 1000.0 * std::abs(1.0 / std::max(height, kLeastU) - rangeM) / std::max(noise_.at(rangeM), 0.1);
    }
    // 0..1: the jump or valley between two cells that are neighbours (of 8); round a corner, on the way where it is less.
    [[nodiscard]] float edgeBetween(int line, int beam, int i, int j) const {
        const auto alongBeams = [&](int l) { return edgeAt(leaf_.index(l, std::min(beam, j)), 1, cracks_.jumpBeams, cracks_.foldBeams); };
        const auto alongLines = [&](int b) {
            return edgeAt(leaf_.index(std::min(line, i), b), static_cast<std::size_t>(leaf_.beams), cracks_.jumpLines, cracks_.foldLines);
        };
        if (i == line) return alongBeams(line);
        if (j == beam) return alongLines(beam);
        return std::min(std::max(alongBeams(line), alongLines(j)), std::max(alongLines(beam), alongBeams(i)));
    }
    static float edgeAt(std::size_t p, std::size_t step, const Grid<float>& jump, const Grid<float>& fold) {
        return std::clamp(std::max({jump[p], -fold[p], -fold[p + step]}), 0.0F, 1.0F);
    }
    // The leaves among the cell and its neighbours, and how many neighbours each has.
    std::size_t choices(int line, int beam, std::array<PlaneSums, kMostChoices>& planes) const {
        std::size_t count = 0;
        for (int i = std::max(line - 1, 0); i <= std::min(line + 1, leaf_.lines - 1); ++i) {
            for (int j = std::max(beam - 1, 0); j <= std::min(beam + 1, leaf_.beams - 1); ++j) {
                const std::uint32_t there = leaf_.at(i, j);
                if (there == kOpen) continue;
                std::size_t n = 0;
                while (n < count && planes[n].leaf != there) ++n;
                if (n == count) planes[count++].leaf = there;
                if (i != line || j != beam) planes[n].neighbours += static_cast<double>(1.0F - kAcrossEdge * edgeBetween(line, beam, i, j));
            }
        }
        return count;
    }
    // Takes in the cells around that touch no other leaf.
    void fill(int line, int beam, std::array<PlaneSums, kMostChoices>& planes, std::size_t count) const {
        for (int i = std::max(line - kWindow, 0); i <= std::min(line + kWindow, leaf_.lines - 1); ++i) {
            for (int j = std::max(beam - kWindow, 0); j <= std::min(beam + kWindow, leaf_.beams - 1); ++j) {
                const std::size_t k = leaf_.index(i, j);
                if (touches_[k] != 0 || leaf_[k] == kOpen) continue;
                for (std::size_t n = 0; n < count; ++n) {
                    if (planes[n].leaf == leaf_[k]) planes[n].add(j - beam, i - line, static_cast<double>(inverse_.u[k]));
                }
            }
        }
    }

    const InverseRange& inverse_;
    const DepthCracks& cracks_;
    const RangeNoise& noise_;
    Grid<std::uint32_t>& leaf_;
    Grid<std::uint32_t> next_;
    Grid<std::uint8_t> touches_;
    Grid<std::uint8_t> changed_;
};

} // namespace

void refineLeaves(const InverseRange& inverse, const DepthCracks& cracks, const RangeNoise& noise, Grid<std::uint32_t>& leaf,
                  std::uint32_t count) {
    std::vector<std::uint32_t> cells(static_cast<std::size_t>(count) + 1);
    for (const std::uint32_t l : leaf.cells) ++cells[l];
    for (std::uint32_t& l : leaf.cells) {
        if (cells[l] < kSmallestLeaf) l = kOpen;
    }
    Refinement refinement(inverse, cracks, noise, leaf);
    for (int pass = 0; pass < kPasses; ++pass) refinement.pass();
}

} // namespace edgescan
