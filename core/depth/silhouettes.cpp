// Voids along every line and every beam: which end is the near one, and whether it ends there.
#include "core/depth/silhouettes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace edgescan {
namespace {

constexpr int kSide = 5;          // cells of a surface that its slope is taken from
constexpr int kFewest = 3;        // of them
constexpr float kSure = 1;        // jump thresholds
constexpr float kBend = 0.25F;    // tangent by which a surface may bend on its way across the void
constexpr float kGrazing = 2.75F; // tangent of 70 degrees

// The cells of one line along the beams, or of one beam along the lines.
struct Way {
    const InverseRange& inverse;
    const AngularSteps& steps;
    Along along;
    int at;    // line or beam
    int count; // cells

    [[nodiscard]] std::size_t cell(int n) const { return along == Along::Beams ? inverse.u.index(at, n) : inverse.u.index(n, at); }
    [[nodiscard]] bool isVoid(int n) const { return inverse.support[cell(n)] == Support::Void; }
    [[nodiscard]] float u(int n) const { return inverse.u[cell(n)]; }
    [[nodiscard]] float angle(int n) const { return along == Along::Beams ? steps.beam[static_cast<std::size_t>(n)] : steps.lineAt(n, at); }
};

// The surface that ends at a cell: its slope of u per cell towards the void; not known where there are too few cells or a break.
struct End {
    float u = 0, slope = 0;
    bool known = false;
};
End endAt(const Way& way, int n, int awayFromVoid, const DepthLimits& limits) {
    End end{way.u(n)};
    float sum = 0, weighted = 0;
    int cells = 0;
    for (; cells < kSide; ++cells) {
        const int m = n + cells * awayFromVoid;
        if (m < 0 || m >= way.count || way.isVoid(m)) break;
        const float there = way.u(m);
        const float before = cells == 0 ? there : way.u(m - awayFromVoid);
        if (std::abs(1000 / there - 1000 / before) > limits.jumpAt(1000 / before)) break;
        sum += there - end.u;
        weighted += static_cast<float>(cells) * (there - end.u);
    }
    const auto count = static_cast<float>(cells);
    const float middle = 0.5F * (count - 1);
    end.known = cells >= kFewest;
    if (end.known) end.slope = -(weighted - middle * sum) / (count * (count * count - 1) / 12);
    return end;
}

// Whether the surface of `near` ends before the void of `cells` and the other one is behind it.
bool isOutline(const End& near, const End& far, int cells, float angle, const DepthLimits& limits) {
    if (!near.known || !far.known || std::abs(near.slope) > kGrazing * near.u * angle) return false;
    const auto steps = static_cast<float>(cells + 1);
    const float continued = near.u + steps * near.slope; // beside the far end
    const float backwards = far.u + steps * far.slope;   // beside the near end
    if (continued <= 0) return false;
    const float farMm = 1000 / far.u;
    const float least = kSure * limits.jumpAt(farMm) + kBend * steps * angle * farMm;
    const bool behind = farMm - 1000 / near.u > least && farMm - 1000 / continued > least;
    return behind && (backwards <= 0 || 1000 / backwards - 1000 / near.u > least);
}

void markOutlines(const Way& way, const DepthLimits& limits, Grid<std::uint8_t>& marked) {
    for (int n = 1; n < way.count; ++n) {
        if (!way.isVoid(n) || way.isVoid(n - 1)) continue;
        int after = n;
        while (after < way.count && way.isVoid(after)) ++after;
        if (after == way.count) return; // nobody knows what is behind
        const int before = n - 1;
        const bool first = way.u(before) >= way.u(after);
        const int at = first ? before : after;
        const End near = endAt(way, at, first ? -1 : 1, limits);
        const End far = endAt(way, first ? after : before, first ? 1 : -1, limits);
        if (way.inverse.support[way.cell(at)] == Support::Measured && isOutline(near, far, after - n, way.angle(at), limits))
            marked[way.cell(at)] = 1;
        n = after;
    }
}

} // namespace

std::vector<std::uint32_t> silhouetteCells(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits) {
    Grid<std::uint8_t> marked(inverse.u.lines, inverse.u.beams);
    for (int i = 0; i < inverse.u.lines; ++i) markOutlines({inverse, steps, Along::Beams, i, inverse.u.beams}, limits, marked);
    for (int j = 0; j < inverse.u.beams; ++j) markOutlines({inverse, steps, Along::Lines, j, inverse.u.lines}, limits, marked);
    std::vector<std::uint32_t> cells;
    for (std::size_t k = 0; k < marked.size(); ++k) {
        if (marked[k] != 0) cells.push_back(static_cast<std::uint32_t>(k));
    }
    return cells;
}

} // namespace edgescan
