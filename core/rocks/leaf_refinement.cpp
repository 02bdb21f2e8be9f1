// Cells on the borders of leaves choose the leaf whose plane they lie on.
#include "core/rocks/leaf_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr int kPasses = 4;
constexpr int kWindow = 4;     // cells on each side that a plane is fitted to
constexpr int kNeighbours = 9; // the cell itself included
constexpr std::uint32_t kVoid = UINT32_MAX;
constexpr std::size_t kColumns = 12; // a window, filled up to whole vectors
constexpr int kReach = kWindow + 1;  // cells on each side that a choice depends on
constexpr double kRidge = 0.5;       // added to the spreads, so that few cells on a line tilt nothing
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

// 0..1 on the crack between each cell and the next one along the way: the jump or valley there.
Grid<float> edgesOf(const Grid<float>& jump, const Grid<float>& fold, std::size_t step) {
    Grid<float> edge(jump.lines, jump.beams);
    for (std::size_t k = 0; k + step < edge.size(); ++k) edge[k] = std::clamp(std::max({jump[k], -fold[k], -fold[k + step]}), 0.0F, 1.0F);
    return edge;
}

class Refinement {
public:
    Refinement(const InverseRange& inverse, const DepthCracks& cracks, const RangeNoise& noise, Grid<std::uint32_t>& leaf)
        : inverse_(inverse), noise_(noise), edgeBeams_(edgesOf(cracks.jumpBeams, cracks.foldBeams, 1)),
          edgeLines_(edgesOf(cracks.jumpLines, cracks.foldLines, static_cast<std::size_t>(leaf.beams))), leaf_(leaf), next_(leaf),
          inner_(marginBeams_ * static_cast<std::size_t>(leaf.lines + 2 * kWindow) + kColumns), solid_(inner_.size(), kVoid),
          u_(inner_.size()), touches_(leaf.lines, leaf.beams), changed_(leaf.lines, leaf.beams, 1) {
        for (int i = 0; i < leaf.lines; ++i) {
            for (int j = 0; j < leaf.beams; ++j) {
                const std::size_t k = leaf.index(i, j);
                u_[marginIndex(i, j)] = inverse.u[k];
                if (inverse.support[k] != Support::Void) solid_[marginIndex(i, j)] = leaf[k];
            }
        }
    }

    void pass() {
        std::vector<std::uint32_t> moved;
        const Grid<std::uint8_t> looked = around(changed_);
        markTouching(looked);
        std::fill(changed_.cells.begin(), changed_.cells.end(), std::uint8_t{0});
        for (int i = 0; i < leaf_.lines; ++i) {
            for (int j = 0; j < leaf_.beams; ++j) {
                const std::size_t k = leaf_.index(i, j);
                if (touches_[k] == 0 || looked[k] == 0) continue;
                next_[k] = choice(i, j);
                if (next_[k] == leaf_[k]) continue;
                changed_[k] = 1;
                moved.push_back(static_cast<std::uint32_t>(k));
            }
        }
        for (const std::uint32_t k : moved) {
            leaf_[k] = next_[k];
            solid_[marginIndex(static_cast<int>(k) / leaf_.beams, static_cast<int>(k) % leaf_.beams)] = leaf_[k];
        }
    }

private:
    // 1 at cells with a neighbour (of 8) that holds a range and belongs to another leaf, or to none. Far from changes it is as it was.
    void markTouching(const Grid<std::uint8_t>& looked) {
        const auto beams = static_cast<std::size_t>(leaf_.beams);
        std::vector<std::uint8_t> touching(beams);
        for (int i = 0; i < leaf_.lines; ++i) {
            const std::uint8_t* const look = looked.line(i);
            if (std::find(look, look + beams, std::uint8_t{1}) == look + beams) continue;
            const std::uint32_t* const here = &solid_[marginIndex(i, 0)];
            std::fill(touching.begin(), touching.end(), std::uint8_t{0});
            for (int n = 0; n < kNeighbours; ++n) {
                const std::uint32_t* const there = &solid_[marginIndex(i + n / 3 - 1, n % 3 - 1)];
                for (std::size_t j = 0; j < beams; ++j)
                    touching[j] = static_cast<std::uint8_t>(touching[j] | ((there[j] != here[j]) & (there[j] != kVoid)));
            }
            for (std::size_t j = 0; j < beams; ++j) {
                if (look[j] == 0) continue;
                const std::size_t k = leaf_.index(i, static_cast<int>(j));
                touches_[k] = here[j] != kVoid ? touching[j] : std::uint8_t{0};
                inner_[marginIndex(i, static_cast<int>(j))] = touches_[k] != 0 ? kOpen : leaf_[k];
            }
        }
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
        std::vector<std::uint8_t> left(static_cast<std::size_t>(marked.beams));
        for (int i = -kReach; i < marked.lines; ++i) {
            const std::uint8_t* const ahead = i + kReach < marked.lines ? wide.line(i + kReach) : nullptr;
            std::uint8_t* const to = i >= 0 ? result.line(i) : nullptr;
            for (std::size_t j = 0; j < left.size(); ++j) {
                const bool isMarked = ahead != nullptr && ahead[j] != 0;
                left[j] = isMarked ? 2 * kReach + 1 : left[j];
                if (to != nullptr) to[j] = left[j] != 0 ? 1 : 0;
                left[j] = static_cast<std::uint8_t>(left[j] - (left[j] != 0 ? 1 : 0));
            }
        }
        return result;
    }
    [[nodiscard]] std::uint32_t choice(int line, int beam) const {
        std::array<PlaneSums, kMostChoices> planes;
        const std::size_t count = choices(line, beam, planes);
        if (count == 0 || (count == 1 && planes[0].leaf == leaf_.at(line, beam))) return leaf_.at(line, beam);
        // The one with most neighbours first: after it most others cannot cost less, however well they fit.
        const auto fewer = [](const PlaneSums& x, const PlaneSums& y) { return x.neighbours < y.neighbours; };
        std::swap(planes[0], *std::max_element(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(count), fewer));
        const bool isOpen = leaf_.at(line, beam) == kOpen;
        const auto here = static_cast<double>(inverse_.u.at(line, beam));
        std::uint32_t best = leaf_.at(line, beam);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t n = 0; n < count; ++n) {
            if (-kPerNeighbour * planes[n].neighbours > least) continue;
            fill(line, beam, planes[n]);
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
        const int above = std::min(line, i);
        const int left = std::min(beam, j);
        if (i == line) return edgeBeams_.at(line, left);
        if (j == beam) return edgeLines_.at(above, beam);
        return std::min(std::max(edgeBeams_.at(line, left), edgeLines_.at(above, j)),
                        std::max(edgeLines_.at(above, beam), edgeBeams_.at(i, left)));
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
    // Takes in the cells of its leaf around that touch no other one; what belongs elsewhere adds zeros. Column by column, so that all
    // columns are worked on at once. All sums are exact, in any order: u has 24 bits, and a double 53.
    void fill(int line, int beam, PlaneSums& plane) const {
        std::array<double, kColumns> u{}, yu{};
        std::array<int, kColumns> n{}, y{}, yy{};
        for (int dy = -kWindow; dy <= kWindow; ++dy) {
            const std::size_t first = marginIndex(line + dy, beam - kWindow);
            const std::uint32_t* const inner = &inner_[first];
            const float* const values = &u_[first];
            for (std::size_t x = 0; x < kColumns; ++x) {
                const int own = inner[x] == plane.leaf ? 1 : 0;
                const auto value = static_cast<double>(values[x] * static_cast<float>(own));
                n[x] += own;
                y[x] += own * dy;
                yy[x] += own * (dy * dy);
                u[x] += value;
                yu[x] += dy * value;
            }
        }
        for (int dx = -kWindow; dx <= kWindow; ++dx) {
            const auto x = static_cast<std::size_t>(dx + kWindow);
            plane.n += n[x];
            plane.x += dx * n[x];
            plane.xx += dx * dx * n[x];
            plane.y += y[x];
            plane.xy += dx * y[x];
            plane.yy += yy[x];
            plane.u += u[x];
            plane.xu += dx * u[x];
            plane.yu += yu[x];
        }
    }
    // Of a cell in the grids with a margin.
    [[nodiscard]] std::size_t marginIndex(int line, int beam) const {
        return static_cast<std::size_t>(line + kWindow) * marginBeams_ + static_cast<std::size_t>(beam + kWindow);
    }

    const InverseRange& inverse_;
    const RangeNoise& noise_;
    const Grid<float> edgeBeams_, edgeLines_;
    Grid<std::uint32_t>& leaf_;
    Grid<std::uint32_t> next_;
    // With kWindow cells more on each side, and a few beams more after them.
    const std::size_t marginBeams_ = static_cast<std::size_t>(leaf_.beams + 2 * kWindow);
    std::vector<std::uint32_t> inner_; // the leaf of cells that touch no other one, else kOpen
    std::vector<std::uint32_t> solid_; // the leaf, or kVoid where there is no range
    std::vector<float> u_;
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
