// Finds the voids as runs of cells along the lines, and the measured cells around the large ones.
#include "core/edges/edgescan_plus/void_rim.h"

#include "core/base/simd.h"
#include "core/edges/edgescan_plus/surface_end.h"
#include "core/scan/grid/marked_cells.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>

namespace edgescan::edges {
namespace {

constexpr std::uint32_t kOpen = 30; // cells of the smallest open void

// Cells of one line without a range between them; `last` is behind the run.
struct Run {
    int line, first, last;
};

EDGESCAN_INLINE void markVoid(const Support* support, int beams, std::uint8_t* __restrict empty) {
    for (int j = 0; j < beams; ++j) empty[j] = static_cast<std::uint8_t>(support[j] == Support::Void);
}

EDGESCAN_INLINE void markWithheld(const CellState* state, int beams, std::uint8_t* __restrict withheld) {
    for (int j = 0; j < beams; ++j)
        withheld[j] = static_cast<std::uint8_t>((state[j] == CellState::OutOfWindow) | (state[j] == CellState::Masked) |
                                                (state[j] == CellState::Lost));
}

std::vector<Run> runsOfVoids(const Grid<Support>& support, const std::vector<CellRun>& withheld) {
    std::vector<Run> runs;
    std::vector<std::uint8_t> empty(static_cast<std::size_t>(support.beams) + 1, 0); // the last one stays 0 and ends every run
    auto next = withheld.begin();
    for (int i = 0; i < support.lines; ++i) {
        vectorised<markVoid>(support.line(i), support.beams, empty.data());
        const std::size_t begin = support.index(i, 0), behind = support.index(i + 1, 0);
        for (; next != withheld.end() && next->first < behind; ++next) {
            const auto from = static_cast<std::ptrdiff_t>(std::max<std::size_t>(next->first, begin) - begin);
            const auto to = static_cast<std::ptrdiff_t>(std::min<std::size_t>(next->last, behind) - begin);
            std::fill(empty.begin() + from, empty.begin() + to, std::uint8_t{0});
            if (next->last > behind) break; // it goes on in the next line
        }
        for (std::size_t j = 0; j < empty.size();) {
            const auto* first = static_cast<const std::uint8_t*>(std::memchr(empty.data() + j, 1, empty.size() - j));
            if (first == nullptr) break;
            const auto from = static_cast<std::size_t>(first - empty.data());
            const auto* last = static_cast<const std::uint8_t*>(std::memchr(first, 0, empty.size() - from));
            j = static_cast<std::size_t>(last - empty.data());
            runs.push_back({i, static_cast<int>(from), static_cast<int>(j)});
        }
    }
    return runs;
}

std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t n) {
    while (parent[n] != n) n = parent[n] = parent[parent[n]];
    return n;
}

// By run: the cells of the void that it belongs to.
std::vector<std::uint32_t> sizesOfVoids(const std::vector<Run>& runs) {
    std::vector<std::uint32_t> parent(runs.size());
    std::iota(parent.begin(), parent.end(), 0U);
    std::size_t above = 0; // the first run of the line before that may touch this one
    for (std::size_t n = 0; n < runs.size(); ++n) {
        while (runs[above].line < runs[n].line - 1 || (runs[above].line == runs[n].line - 1 && runs[above].last <= runs[n].first)) ++above;
        for (std::size_t m = above; runs[m].line == runs[n].line - 1 && runs[m].first < runs[n].last; ++m) {
            const std::uint32_t a = rootOf(parent, static_cast<std::uint32_t>(m)), b = rootOf(parent, static_cast<std::uint32_t>(n));
            parent[std::max(a, b)] = std::min(a, b);
        }
    }
    std::vector<std::uint32_t> cells(runs.size(), 0), sizes(runs.size());
    for (std::uint32_t n = 0; n < runs.size(); ++n) cells[rootOf(parent, n)] += static_cast<std::uint32_t>(runs[n].last - runs[n].first);
    for (std::uint32_t n = 0; n < runs.size(); ++n) sizes[n] = cells[rootOf(parent, n)];
    return sizes;
}

class Rim {
public:
    Rim(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits, bool ofCamera)
        : inverse_(inverse), steps_(steps), limits_(limits), ofCamera_(ofCamera), marked_(inverse.u.lines, inverse.u.beams) {}

    void surround(const Run& run) {
        look(Along::Beams, run.line, run.first - 1, -1);
        look(Along::Beams, run.line, run.last, 1);
        for (int j = run.first; j < run.last; ++j) {
            look(Along::Lines, j, run.line - 1, -1);
            look(Along::Lines, j, run.line + 1, 1);
        }
    }
    [[nodiscard]] std::vector<std::uint32_t> cells() const {
        std::vector<std::uint32_t> cells;
        forEachMarked(marked_.cells, [&cells](std::size_t k) { cells.push_back(static_cast<std::uint32_t>(k)); });
        return cells;
    }

private:
    // Whether the void beyond cell `n` of the way ends at a surface that is farther away by a jump.
    [[nodiscard]] bool isBeforeFarther(const Way& way, int n, int towardsVoid) const {
        int end = n + towardsVoid;
        while (end >= 0 && end < way.count && way.isVoid(end)) end += towardsVoid;
        if (end < 0 || end >= way.count) return false;
        const float nearMm = 1000 / way.u(n), farMm = 1000 / way.u(end);
        return farMm - nearMm > limits_.jumpAt(nearMm);
    }
    // Marks cell `n` of the way unless its surface, which begins there, fades out.
    void look(Along along, int at, int n, int awayFromVoid) {
        const int count = along == Along::Beams ? inverse_.u.beams : inverse_.u.lines;
        if (n < 0 || n >= count) return;
        const Way way{inverse_, steps_, along, at, count};
        const std::size_t k = way.cell(n);
        if (inverse_.support[k] != Support::Measured || marked_[k] != 0) return;
        if (ofCamera_ && !isBeforeFarther(way, n, -awayFromVoid)) return;
        SurfaceEnd end = surfaceEnd(way, n, awayFromVoid, limits_);
        // Where every step is as large as a jump, a surface looks like jumps: then the next cell gives the slant.
        const int next = n + awayFromVoid;
        if (!end.known && next >= 0 && next < count && !way.isVoid(next)) end.slope = way.u(n) - way.u(next);
        marked_[k] = static_cast<std::uint8_t>(!end.slants(way.angle(n), limits_.rimSlant));
    }

    const InverseRange& inverse_;
    const AngularSteps& steps_;
    const DepthLimits& limits_;
    bool ofCamera_;
    Grid<std::uint8_t> marked_;
};

} // namespace

std::vector<CellRun> withheldCells(const Scan& scan) {
    std::vector<CellRun> runs;
    std::vector<std::uint8_t> withheld(static_cast<std::size_t>(scan.beams()));
    for (int i = 0; i < scan.lines(); ++i) {
        vectorised<markWithheld>(scan.state.line(i), scan.beams(), withheld.data());
        forEachMarked(withheld, [&](std::size_t beam) {
            const auto cell = static_cast<std::uint32_t>(scan.state.index(i, static_cast<int>(beam)));
            if (runs.empty() || runs.back().last != cell) runs.push_back({cell, cell});
            ++runs.back().last;
        });
    }
    return runs;
}

std::vector<std::uint32_t> voidRimCells(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits,
                                        const std::vector<CellRun>& withheld, bool ofCamera) {
    const std::vector<Run> runs = runsOfVoids(inverse.support, withheld);
    const std::vector<std::uint32_t> sizes = sizesOfVoids(runs);
    Rim rim(inverse, steps, limits, ofCamera);
    for (std::size_t n = 0; n < runs.size(); ++n) {
        if (sizes[n] >= kOpen) rim.surround(runs[n]);
    }
    return rim.cells();
}

} // namespace edgescan::edges
