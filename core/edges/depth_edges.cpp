// EdgeScan+.
#include "core/edges/depth_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace edgescan {
namespace {

constexpr double kNominalNoiseMm = 6.75; // sigma at 5 m of an LMS511
constexpr double kJumpMm = 30.0;
constexpr double kMisfitMm = 8.0;
constexpr double kWindowMm = 70.0;

// Everything that follows from noise and sliders, in the units of the inner loops.
struct Tuning {
    float jumpMm, growth, grazing, misfitMm, windowMm, creaseDeg;
    int passes;
    RangeNoise noise;
};

Tuning tune(const InverseRange& inverse, const DepthEdgeSettings& settings) {
    Tuning tuning{};
    tuning.noise = settings.noiseAt5mMm >= 0 ? RangeNoise{settings.noiseAt5mMm * 0.815, settings.noiseAt5mMm * 0.037} : rangeNoise(inverse);
    const double q = std::clamp(tuning.noise.at(5.0) / kNominalNoiseMm, 0.2, 10.0);
    tuning.jumpMm = static_cast<float>(settings.jumpMm >= 0 ? settings.jumpMm : kJumpMm * std::pow(q, 0.8));
    tuning.growth = static_cast<float>(settings.jumpGrowth);
    tuning.grazing = static_cast<float>(settings.grazing);
    tuning.misfitMm = static_cast<float>(kMisfitMm * q);
    tuning.windowMm = static_cast<float>(kWindowMm * std::pow(q, 0.7));
    tuning.creaseDeg = static_cast<float>(settings.creaseDeg);
    tuning.passes = q < 1.5 ? 2 : q < 2.5 ? 4 : 6;
    return tuning;
}

// One direction through the grid: cell n of run m is start(m) + n * stride.
struct Direction {
    int runs, length;
    std::size_t runStep, stride;
    [[nodiscard]] std::size_t cell(int run, int n) const {
        return static_cast<std::size_t>(run) * runStep + static_cast<std::size_t>(n) * stride;
    }
};

Direction alongBeams(const Grid<float>& u) { return {u.lines, u.beams, static_cast<std::size_t>(u.beams), 1}; }
Direction alongLines(const Grid<float>& u) { return {u.beams, u.lines, 1, static_cast<std::size_t>(u.beams)}; }

// [1 2 1] / 4 along one direction; the ends stand for themselves.
Grid<float> blurred(const Grid<float>& u, const Direction& d) {
    Grid<float> result = u;
    for (int m = 0; m < d.runs; ++m) {
        for (int n = 1; n + 1 < d.length; ++n) {
            const std::size_t k = d.cell(m, n);
            result[k] = (u[k - d.stride] + 2 * u[k] + u[k + d.stride]) * 0.25F;
        }
    }
    return result;
}

// Step 3: S_J of the crack between k and k + stride, stored at k.
Grid<float> jumpsAlong(const InverseRange& inverse, const Direction& d, const Direction& across, const Tuning& tuning) {
    const Grid<float> u = blurred(inverse.u, across);
    Grid<float> jump(u.lines, u.beams);
    for (int m = 0; m < d.runs; ++m) {
        for (int n = 0; n + 1 < d.length; ++n) {
            const std::size_t a = d.cell(m, n);
            const std::size_t b = a + d.stride;
            const std::size_t before = n > 0 ? a - d.stride : a;
            const std::size_t after = n + 2 < d.length ? b + d.stride : b;
            const float left = 1.5F * u[a] - 0.5F * u[before];
            const float right = 1.5F * u[b] - 0.5F * u[after];
            const float rangeA = 1000.0F / u[a];
            const float rangeB = 1000.0F / u[b];
            float step = std::abs(rangeA - rangeB);
            if (left > 0 && right > 0) step = std::min(step, std::abs(1000.0F / left - 1000.0F / right));
            const float slope = 0.5F * (std::abs(rangeA - 1000.0F / u[before]) + std::abs(1000.0F / u[after] - rangeB));
            jump[a] = step / (tuning.jumpMm + tuning.growth * std::min(rangeA, rangeB) + tuning.grazing * slope);
        }
    }
    return jump;
}

// Step 4, one pass along one direction: only where neither crack is a break.
void smoothAlong(Grid<float>& u, const Grid<float>& jump, const Grid<Support>& support, const Direction& d) {
    const Grid<float> from = u;
    for (int m = 0; m < d.runs; ++m) {
        for (int n = 1; n + 1 < d.length; ++n) {
            const std::size_t k = d.cell(m, n);
            if (jump[k] > 1 || jump[k - d.stride] > 1 || support[k] == Support::Void) continue;
            u[k] = from[k] + (from[k - d.stride] + from[k + d.stride] - 2 * from[k]) * 0.25F;
        }
    }
}

struct Side {
    int cells = 0;    // beyond the cell itself
    float slope = 0;  // of u per index, towards higher indices
    float atCell = 0; // the line's u at the cell
};

// Least-squares line through the cell and up to `reach` cells on one side, stopping at a break.
Side fitSide(const Grid<float>& u, const Grid<float>& jump, const Grid<Support>& support, const Direction& d, std::size_t k, int n,
             int sign, int reach) {
    Side side;
    float sumY = u[k];
    float sumXY = 0;
    for (int c = 1; c <= reach; ++c) {
        if (n + sign * c < 0 || n + sign * c >= d.length) break;
        const std::size_t there = sign > 0 ? k + static_cast<std::size_t>(c) * d.stride : k - static_cast<std::size_t>(c) * d.stride;
        const std::size_t crack = sign > 0 ? there - d.stride : there;
        if (jump[crack] > 1 || support[there] == Support::Void) break;
        side.cells = c;
        sumY += u[there];
        sumXY += static_cast<float>(sign * c) * u[there];
    }
    const auto count = static_cast<float>(side.cells + 1);
    const float meanX = static_cast<float>(sign * side.cells) * 0.5F;
    const float spread = count * (count * count - 1) / 12.0F;
    if (spread > 0) side.slope = (sumXY - meanX * sumY) / spread;
    side.atCell = sumY / count - side.slope * meanX;
    return side;
}

struct Crease {
    Grid<float> strength;
    Grid<std::uint8_t> convex;
};

// Step 5 along one direction; stepOf(k) is the angular step at a cell.
template <class StepOf>
Crease creasesAlong(const Grid<float>& u, const Grid<float>& jump, const Grid<Support>& support, const Direction& d, const Tuning& tuning,
                    StepOf stepOf) {
    constexpr float kDegPerRad = static_cast<float>(180.0 / std::numbers::pi);
    Crease crease{Grid<float>(u.lines, u.beams), Grid<std::uint8_t>(u.lines, u.beams)};
    for (int m = 0; m < d.runs; ++m) {
        for (int n = 0; n < d.length; ++n) {
            const std::size_t k = d.cell(m, n);
            if (support[k] == Support::Void) continue;
            const float step = stepOf(k);
            const float rangeM = 1.0F / u[k];
            const int reach = std::clamp(static_cast<int>(std::lround(tuning.windowMm / (1000.0F * rangeM * step))), 3, 6);
            const Side left = fitSide(u, jump, support, d, k, n, -1, reach);
            const Side right = fitSide(u, jump, support, d, k, n, 1, reach);
            const int cells = std::min(left.cells, right.cells);
            if (cells < 2) continue;
            const float scale = 1.0F / (u[k] * step);
            const float alphaLeft = std::atan(-left.slope * scale);
            const float alphaRight = std::atan(-right.slope * scale);
            const float fold = std::abs(alphaRight - alphaLeft) * kDegPerRad;
            const float misfit = std::abs(1000.0F / left.atCell - 1000.0F / right.atCell) / tuning.misfitMm;
            const auto count = static_cast<float>(cells + 1);
            const float flat = std::max(std::abs(alphaLeft), std::abs(alphaRight));
            const float cosine = std::cos(flat);
            const float sigma = kDegPerRad * 1.41F * static_cast<float>(tuning.noise.at(rangeM)) * 0.001F * 0.55F *
                                std::sqrt(12.0F / (count * (count * count - 1))) / (rangeM * step) * cosine * cosine;
            crease.strength[k] = fold / std::sqrt(1 + misfit * misfit) / std::max(tuning.creaseDeg, 4 * sigma);
            crease.convex[k] = right.slope < left.slope ? 1 : 0;
        }
    }
    return crease;
}

// Response of one channel in both directions.
struct Channel {
    Grid<float> alongBeams;
    Grid<float> alongLines;
    [[nodiscard]] float strongest(std::size_t k) const { return std::max(alongBeams[k], alongLines[k]); }
};

// The crack's response goes to its nearer cell.
Grid<float> onNearerCells(const Grid<float>& jump, const InverseRange& inverse, const Direction& d) {
    Grid<float> cells(jump.lines, jump.beams);
    for (int m = 0; m < d.runs; ++m) {
        for (int n = 0; n + 1 < d.length; ++n) {
            const std::size_t a = d.cell(m, n);
            const std::size_t b = a + d.stride;
            // Where the data end a rock may go on: the border of a hole is a break, but no edge (OPERATOR.md S3).
            if (inverse.support[a] == Support::Void || inverse.support[b] == Support::Void) continue;
            const std::size_t nearer = inverse.u[a] >= inverse.u[b] ? a : b;
            cells[nearer] = std::max(cells[nearer], jump[a]);
        }
    }
    return cells;
}

// Step 7: along the direction of the stronger response a cell must be no weaker than one neighbour and stronger than the other.
Grid<float> suppressed(const Channel& channel) {
    Grid<float> kept(channel.alongBeams.lines, channel.alongBeams.beams);
    for (int i = 0; i < kept.lines; ++i) {
        for (int j = 0; j < kept.beams; ++j) {
            const std::size_t k = kept.index(i, j);
            const bool beamwise = channel.alongBeams[k] >= channel.alongLines[k];
            const Grid<float>& response = beamwise ? channel.alongBeams : channel.alongLines;
            const std::size_t stride = beamwise ? 1 : static_cast<std::size_t>(kept.beams);
            const bool hasBefore = beamwise ? j > 0 : i > 0;
            const bool hasAfter = beamwise ? j + 1 < kept.beams : i + 1 < kept.lines;
            const float here = response[k];
            if (hasBefore && response[k - stride] > here) continue;
            if (hasAfter && response[k + stride] >= here) continue;
            kept[k] = here;
        }
    }
    return kept;
}

// Keeps chains (8 neighbours) of cells above `low` that reach `high` somewhere and have `minimum` cells at least.
Grid<std::uint8_t> linked(const Grid<float>& strength, float high, float low, int minimum) {
    Grid<std::uint8_t> state(strength.lines, strength.beams); // 1 = waiting, 255 = edge
    for (std::size_t k = 0; k < strength.size(); ++k) state[k] = strength[k] > low ? 1 : 0;
    const auto beams = static_cast<std::size_t>(strength.beams);
    std::vector<std::size_t> chain;
    for (std::size_t seed = 0; seed < state.size(); ++seed) {
        if (state[seed] != 1) continue;
        chain.assign(1, seed);
        state[seed] = 2;
        bool strong = false;
        for (std::size_t at = 0; at < chain.size(); ++at) {
            const std::size_t k = chain[at];
            strong = strong || strength[k] > high;
            const int line = static_cast<int>(k / beams);
            const int beam = static_cast<int>(k % beams);
            for (int i = line - 1; i <= line + 1; ++i) {
                for (int j = beam - 1; j <= beam + 1; ++j) {
                    if (!state.contains(i, j) || state.at(i, j) != 1) continue;
                    state.at(i, j) = 2;
                    chain.push_back(state.index(i, j));
                }
            }
        }
        const bool kept = strong && static_cast<int>(chain.size()) >= minimum;
        for (const std::size_t k : chain) state[k] = kept ? 255 : 0;
    }
    return state;
}

} // namespace

DepthEdges depthEdges(const Scan& scan, const DepthEdgeSettings& settings) {
    InverseRange inverse = inverseRange(scan);
    const AngularSteps steps = angularSteps(scan);
    const Tuning tuning = tune(inverse, settings);
    inverse = withoutVeil(std::move(inverse), tuning.jumpMm, tuning.growth);

    const Direction beamwise = alongBeams(inverse.u);
    const Direction linewise = alongLines(inverse.u);
    const Grid<float> jumpBeams = jumpsAlong(inverse, beamwise, linewise, tuning);
    const Grid<float> jumpLines = jumpsAlong(inverse, linewise, beamwise, tuning);

    Grid<float> u = inverse.u;
    for (int pass = 0; pass < tuning.passes; ++pass) {
        smoothAlong(u, jumpBeams, inverse.support, beamwise);
        smoothAlong(u, jumpLines, inverse.support, linewise);
    }
    const auto beams = static_cast<std::size_t>(scan.beams());
    const Crease creaseBeams =
        creasesAlong(u, jumpBeams, inverse.support, beamwise, tuning, [&](std::size_t k) { return steps.beam[k % beams]; });
    const Crease creaseLines = creasesAlong(u, jumpLines, inverse.support, linewise, tuning, [&](std::size_t k) { return steps.line[k]; });

    const Channel jump{onNearerCells(jumpBeams, inverse, beamwise), onNearerCells(jumpLines, inverse, linewise)};
    const Channel crease{creaseBeams.strength, creaseLines.strength};
    const Grid<float> jumpKept = suppressed(jump);
    const Grid<float> creaseKept = suppressed(crease);

    DepthEdges result{Grid<std::uint8_t>(), Grid<DepthEdge>(scan.lines(), scan.beams(), DepthEdge::None),
                      Grid<float>(scan.lines(), scan.beams()), tuning.noise};
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (inverse.support[k] != Support::Measured) continue;
        const bool convex = crease.alongBeams[k] >= crease.alongLines[k] ? creaseBeams.convex[k] != 0 : creaseLines.convex[k] != 0;
        const float j = settings.jumps ? jumpKept[k] : 0;
        const float c = (convex ? settings.convex : settings.concave) ? creaseKept[k] : 0;
        result.strength[k] = std::max(j, c);
        if (result.strength[k] > 0) result.kind[k] = j >= c ? DepthEdge::Jump : convex ? DepthEdge::Convex : DepthEdge::Concave;
    }
    const auto high = static_cast<float>(settings.sensitivity);
    result.mask = linked(result.strength, high, high * static_cast<float>(settings.hysteresisLow), settings.minimumLength);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (result.mask[k] == 0) result.kind[k] = DepthEdge::None;
    }
    return result;
}

} // namespace edgescan
