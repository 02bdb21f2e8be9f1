// Phases of lines, from the slopes along the lines.
#include "core/scan/angle_correction/line_phases.h"

#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/scan/angle_correction/slip_votes.h"
#include "core/scan/angle_correction/sureness.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/mean_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace edgescan {
namespace {

constexpr int kMostPhases = 8;
constexpr std::size_t kFewestVotes = 40; // fewest votes of a line
constexpr int kFewestTurns = 5;
constexpr int kFewestPhasedLines = 20;
constexpr double kLeastOff = 0.15; // beam steps: the least offset, from the mean of its neighbours, of the line with the largest offset
constexpr double kLinesAgree = 0.12;
constexpr double kMostLines = 0.85; // share of the lines that must agree
constexpr double kRound = 0.25;     // largest deviation from phases that divide a beam step evenly
constexpr float kNear = 0.07F;      // less than half of kLeastOff, so that the medians of such lines cannot differ by kLeastOff

struct LineOff {
    int line;
    double steps;
};

/// Slants along the beams, of a line and its two neighbouring lines.
EDGESCAN_INLINE void slantsAlongBeams(const float* u, std::ptrdiff_t stride, int beams, float* __restrict slants,
                                      std::uint8_t* __restrict slanted) {
    for (int j = 1; j < beams - 1; ++j) {
        const auto change = [&](std::ptrdiff_t n) { return (u[n + 1] - u[n - 1]) / 6.0F; };
        const float slant = change(j - stride) + change(j) + change(j + stride);
        const float share = std::abs(slant) / u[j];
        slants[j] = slant;
        slanted[j] = static_cast<std::uint8_t>((share >= kLeastSlant) & (share <= kMostSlant));
    }
}

/// How far the beams of a line are ahead of the mean of both neighbouring lines, in beam steps: one vote per cell.
void voteOnNeighbours(const InverseRange& inverse, int line, LineSlants& slants, std::vector<SlipVote>& votes) {
    const Grid<float>& u = inverse.u;
    votes.clear();
    vectorised<slantsAlongBeams>(u.line(line), u.beams, u.beams, slants.slant.data(), slants.slanted.data());
    slants.forEach([&](int j, float slant) {
        if (!measuredAround(inverse, line, j)) return;
        const float off = u.at(line, j) - 0.5F * (u.at(line - 1, j) + u.at(line + 1, j));
        votes.push_back({off / slant, std::abs(slant) / u.at(line, j), slant});
    });
}

struct LineNear {
    int line;
    bool isNear; // less than kNear from the mean of its neighbours
};

/// Whether more than half of the lines at each position of a cycle are near their neighbours, for cycles of 2 to `most` lines. If so,
/// offsInTurn() finds nothing in any of them, and the exact offsets need not be computed.
bool areMostNear(const std::vector<LineNear>& lines, int most) {
    for (int phases = 2; phases <= most; ++phases) {
        std::vector<int> surplus(static_cast<std::size_t>(phases)); // surplus of near lines over the others
        for (const LineNear& line : lines) surplus[static_cast<std::size_t>(line.line % phases)] += line.isNear ? 1 : -1;
        if (std::ranges::any_of(surplus, [](int near) { return near <= 0; })) return false;
    }
    return true;
}

/// The medians of the lines at the same position of a cycle, without their common part, which is the curvature of the scene. Empty unless
/// nearly all lines agree with these medians and one position is off by more than chance explains. `steps` are these offsets.
LinePhases offsInTurn(const std::vector<LineOff>& lines, int phases) {
    std::vector<std::vector<double>> places(static_cast<std::size_t>(phases));
    for (const LineOff& line : lines) places[static_cast<std::size_t>(line.line % phases)].push_back(line.steps);
    std::vector<double> offs;
    std::size_t fewest = lines.size();
    for (std::vector<double>& place : places) {
        if (static_cast<int>(place.size()) < kFewestTurns) return {};
        fewest = std::min(fewest, place.size());
        offs.push_back(median(std::move(place)));
    }
    std::vector<double> apart;
    for (const LineOff& line : lines) apart.push_back(line.steps - offs[static_cast<std::size_t>(line.line % phases)]);
    const auto agreeing = std::ranges::count_if(apart, [](double off) { return std::abs(off) <= kLinesAgree; });
    if (static_cast<double>(agreeing) < kMostLines * static_cast<double>(lines.size())) return {};
    const double common = std::accumulate(offs.begin(), offs.end(), 0.0) / phases;
    for (double& off : offs) off -= common;
    double most = 0;
    for (const double off : offs) most = std::max(most, std::abs(off));
    const double surest = most / sdOfMedian(std::move(apart), fewest);
    return most >= kLeastOff && surest >= kSignificantSds ? LinePhases{std::move(offs), surest} : LinePhases{};
}

/// Converts the offset of each line from the mean of its neighbours (in a ring) to its lead over the line that is farthest behind.
std::vector<double> phasesOf(const std::vector<double>& offs) {
    const std::size_t count = offs.size();
    // With g(k) = phase(k + 1) - phase(k): off(k) = (g(k - 1) - g(k)) / 2, and all g add up to 0.
    std::vector<double> rise(count);
    double before = 0;
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
        rise[k] = before - 2 * offs[k];
        before = rise[k];
        sum += rise[k];
    }
    std::vector<double> phases(count);
    for (std::size_t k = 1; k < count; ++k) phases[k] = phases[k - 1] + rise[k - 1] - sum / static_cast<double>(count);
    const double least = *std::ranges::min_element(phases);
    const double even = 1.0 / static_cast<double>(count);
    for (double& phase : phases) phase -= least;
    const bool isEven =
        std::ranges::all_of(phases, [&](double phase) { return std::abs(phase / even - std::round(phase / even)) <= kRound; });
    for (double& phase : phases) phase = isEven ? std::round(phase / even) * even : std::round(phase * 100) / 100;
    return phases;
}

/// Whether the phases of a cycle fit between one beam and the next, and no two of them coincide.
bool areApart(std::vector<double> phases) {
    std::ranges::sort(phases);
    for (std::size_t k = 0; k + 1 < phases.size(); ++k) {
        if (phases[k + 1] - phases[k] < 0.02) return false;
    }
    return phases.back() < 0.98;
}

} // namespace

LinePhases linePhases(const InverseRange& inverse) {
    constexpr int kBlock = 96; // consecutive lines that are examined, in three places of a large sweep
    std::vector<LineNear> measured;
    const int lines = inverse.u.lines;
    LineSlants slants(inverse.u.beams);
    std::vector<SlipVote> votes;
    const auto isLookedAt = [&](int line) { return lines <= 4 * kBlock || line % (lines / 3) < kBlock; };
    int looked = 0;
    for (int i = 1; i + 1 < lines; ++i) {
        if (!isLookedAt(i)) continue;
        ++looked;
        voteOnNeighbours(inverse, i, slants, votes);
        if (votes.size() >= kFewestVotes) measured.push_back({i, isMedianWithin(kNear, votes)});
    }
    const auto measuredLines = static_cast<int>(measured.size());
    if (measuredLines < kFewestPhasedLines || 2 * measuredLines < looked) return {};
    const int most = std::min(kMostPhases, measuredLines / kFewestTurns);
    if (areMostNear(measured, most)) return {};
    std::vector<LineOff> offs;
    for (const LineNear& line : measured) {
        voteOnNeighbours(inverse, line.line, slants, votes);
        offs.push_back({line.line, static_cast<double>(weightedMedian(votes))});
    }
    for (int count = 2; count <= most; ++count) {
        const LinePhases found = offsInTurn(offs, count);
        if (found.steps.empty()) continue;
        std::vector<double> phases = phasesOf(found.steps);
        return areApart(phases) ? LinePhases{std::move(phases), found.significance} : LinePhases{};
    }
    return {};
}

Scan withPhasesFolded(const Scan& scan, const std::vector<double>& phases) {
    const auto& polar = std::get<PolarGeometry>(scan.geometry);
    const int count = static_cast<int>(phases.size());
    const int rows = (scan.lines() + count - 1) / count;
    const int beams = scan.beams();
    std::vector<int> order(phases.size()); // the lines of a cycle, ordered by phase
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int k) { return phases[static_cast<std::size_t>(k)]; });
    const double stepDeg = meanStepDeg(polar.lineDeg);
    const double beamStepDeg = meanStepDeg(polar.beamDeg);

    Scan folded = scan;
    PolarGeometry angles = polar;
    angles.beamDeg.clear();
    angles.lineSkewDeg.clear();
    angles.lineDeg.clear();
    for (int j = 0; j < beams; ++j) {
        const auto beam = static_cast<std::size_t>(j);
        const double toNext = j + 1 < beams ? polar.beamDeg[beam + 1] - polar.beamDeg[beam] : beamStepDeg;
        const double skew = polar.lineSkewDeg.empty() ? 0.0 : polar.lineSkewDeg[beam];
        for (const int k : order) {
            angles.beamDeg.push_back(polar.beamDeg[beam] + phases[static_cast<std::size_t>(k)] * toNext);
            angles.lineSkewDeg.push_back(skew + (k - 0.5 * (count - 1)) * stepDeg);
        }
    }
    for (int row = 0; row < rows; ++row) {
        double sum = 0;
        for (int k = 0; k < count; ++k) {
            const auto line = static_cast<std::size_t>(row * count + k);
            sum += line < polar.lineDeg.size() ? polar.lineDeg[line]
                                               : polar.lineDeg.back() + stepDeg * (static_cast<double>(line + 1 - polar.lineDeg.size()));
        }
        angles.lineDeg.push_back(sum / count);
    }
    folded.rangeMm = Grid<float>(rows, beams * count);
    folded.state = Grid<CellState>(rows, beams * count, CellState::Lost);
    const bool bright = scan.intensity.size() > 0;
    if (bright) folded.intensity = Grid<float>(rows, beams * count, std::numeric_limits<float>::quiet_NaN());
    for (int i = 0; i < scan.lines(); ++i) {
        const int place = static_cast<int>(std::ranges::find(order, i % count) - order.begin());
        for (int j = 0; j < beams; ++j) {
            folded.rangeMm.at(i / count, j * count + place) = scan.rangeMm.at(i, j);
            folded.state.at(i / count, j * count + place) = scan.state.at(i, j);
            if (bright) folded.intensity.at(i / count, j * count + place) = scan.intensity.at(i, j);
        }
    }
    folded.geometry = std::move(angles);
    if (scan.acquisition && !scan.acquisition->lineTimesS.empty()) {
        auto acquisition = std::make_shared<Acquisition>(*scan.acquisition);
        acquisition->lineTimesS.clear();
        for (int row = 0; row < rows; ++row)
            acquisition->lineTimesS.push_back(scan.acquisition->lineTimesS[static_cast<std::size_t>(row * count)]);
        folded.acquisition = std::move(acquisition);
    }
    return folded;
}

} // namespace edgescan
