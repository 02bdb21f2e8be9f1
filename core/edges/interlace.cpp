// Displacements of beams and lines.
#include "core/edges/interlace.h"

#include "core/edges/marks.h"
#include "core/edges/vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace edgescan {
namespace {

constexpr float kLeastSlant = 0.005F; // change of u per line, share of u
constexpr float kMostSlant = 0.1F;    // steeper is an edge rather than a slant
constexpr std::size_t kFewestCells = 16;
constexpr float kLeastParity = 0.15F; // index steps
constexpr float kLeastExtra = 0.5F;
constexpr float kAgree = 0.35F; // spread of the values of a line, index steps or share of the slip
constexpr int kFewestLines = 10;
constexpr int kSampledLines = 64;
constexpr float kExplained = 0.5F; // of the deviations on a line

struct Slip {
    float steps;
    float weight;
    float slant = 0; // of u per line
};

// How much smaller the deviations from straight get when the slip is taken out, 0..1: noise does not shrink.
float explained(const std::vector<Slip>& slips, float steps) {
    double with = 0;
    double without = 0;
    for (const Slip& slip : slips) {
        with += static_cast<double>(std::abs((slip.steps - steps) * slip.slant));
        without += static_cast<double>(std::abs(slip.steps * slip.slant));
    }
    return without > 0 ? static_cast<float>(1 - with / without) : 0.0F;
}

// Whether the weighted median lies between -limit and limit, as it does on most lines.
bool isMiddleWithin(float limit, const std::vector<Slip>& slips) {
    double total = 0;
    double below = 0;
    double upTo = 0;
    for (const Slip& slip : slips) {
        const auto weight = static_cast<double>(slip.weight);
        total += weight;
        below += slip.steps <= -limit ? weight : 0.0;
        upTo += slip.steps < limit ? weight : 0.0;
    }
    return 2 * below < total && 2 * upTo >= total;
}

// The weighted median: the least value up to which half of the weight lies. Sums of so few bits are exact in double, so that the order in
// which they are added does not matter.
float weightedMiddle(std::vector<Slip> slips) {
    const auto add = [](double sum, const Slip& slip) { return sum + static_cast<double>(slip.weight); };
    const double total = std::accumulate(slips.begin(), slips.end(), 0.0, add);
    double below = 0;
    auto first = slips.begin();
    auto end = slips.end();
    while (first != end) {
        const auto middle = first + (end - first) / 2;
        std::nth_element(first, middle, end, [](const Slip& a, const Slip& b) { return a.steps < b.steps; });
        const double before = std::accumulate(first, middle, below, add);
        const double upTo = add(before, *middle);
        if (2 * before >= total) {
            end = middle;
        } else if (2 * upTo >= total) {
            return middle->steps;
        } else {
            below = upTo;
            first = middle + 1;
        }
    }
    return 0;
}

// Weighted median distance from `value`.
float spreadAround(float value, std::vector<Slip> slips) {
    for (Slip& slip : slips) slip.steps = std::abs(slip.steps - value);
    return weightedMiddle(std::move(slips));
}

bool measured(const InverseRange& inverse, int line, int beam) { return inverse.support.at(line, beam) == Support::Measured; }

bool measuredAround(const InverseRange& inverse, int line, int beam) {
    for (int i = line - 1; i <= line + 1; ++i) {
        for (int j = beam - 1; j <= beam + 1; ++j) {
            if (!measured(inverse, i, j)) return false;
        }
    }
    return true;
}

// What the cells of a line tell of its slant.
struct LineSlants {
    explicit LineSlants(int beams) : slant(static_cast<std::size_t>(beams)), slanted(slant.size()) {}
    std::vector<float> slant;          ///< change of u per line
    std::vector<std::uint8_t> slanted; ///< 1 where it is slanted enough and no edge

    /// Calls visit(beam, slant) where the line is slanted.
    template <class Visit>
    void forEach(Visit visit) const {
        forEachMarked(slanted, [&](std::size_t beam) { visit(static_cast<int>(beam), slant[beam]); });
    }
};

// From the lines before and after.
EDGESCAN_VECTORS void slantsAround(const float* u, std::ptrdiff_t stride, int beams, float* __restrict slants,
                                   std::uint8_t* __restrict slanted) {
    for (int j = 1; j < beams - 1; ++j) {
        const auto change = [&](int n) { return (u[n + stride] - u[n - stride]) / 6.0F; };
        const float slant = change(j - 1) + change(j) + change(j + 1);
        const float share = std::abs(slant) / u[j];
        slants[j] = slant;
        slanted[j] = static_cast<std::uint8_t>((share >= kLeastSlant) & (share <= kMostSlant));
    }
}

// Of a step to the next line, from the slants before and after it; the lines at the step itself are not in them, for their noise would
// tell against it.
EDGESCAN_VECTORS void slantsBesideStep(const float* u, std::ptrdiff_t stride, int beams, float* __restrict slants,
                                       std::uint8_t* __restrict slanted) {
    for (int j = 0; j < beams; ++j) {
        const float before = 0.5F * (u[j - stride] - u[j - 3 * stride]);
        const float after = 0.5F * (u[j + 4 * stride] - u[j + 2 * stride]);
        const float slant = 0.5F * (before + after);
        const float share = std::abs(slant) / u[j];
        slants[j] = slant;
        slanted[j] =
            static_cast<std::uint8_t>((share >= kLeastSlant) & (share <= kMostSlant) & (std::abs(before - after) <= std::abs(slant)));
    }
}

// Odd beams against even ones on one line.
void addParity(const InverseRange& inverse, int line, LineSlants& slants, std::vector<Slip>& slips) {
    const float* u = inverse.u.line(line);
    slantsAround(u, inverse.u.beams, inverse.u.beams, slants.slant.data(), slants.slanted.data());
    slants.forEach([&](int j, float slant) {
        if (!measuredAround(inverse, line, j)) return;
        const float off = (u[j] - 0.5F * (u[j - 1] + u[j + 1])) / slant;
        slips.push_back({j % 2 == 1 ? off : -off, std::abs(slant) / u[j]});
    });
}

// The step from a line to the next for the beams of both parities.
using StepSlips = std::array<std::vector<Slip>, 2>;

void addExtra(const InverseRange& inverse, int line, LineSlants& slants, StepSlips& slips) {
    const float* u = inverse.u.line(line);
    const float* next = inverse.u.line(line + 1);
    slantsBesideStep(u, inverse.u.beams, inverse.u.beams, slants.slant.data(), slants.slanted.data());
    slants.forEach([&](int j, float slant) {
        for (int i = line - 3; i <= line + 4; ++i) {
            if (!measured(inverse, i, j)) return;
        }
        slips[static_cast<std::size_t>(j % 2)].push_back({(next[j] - u[j]) / slant - 1, std::abs(slant) / u[j], slant});
    });
}

// The smaller one where the slants on both sides agree in sign; 0 at an edge.
float slantAt(const InverseRange& inverse, int line, int beam) {
    const Grid<float>& u = inverse.u;
    const bool hasBefore = line > 0 && measured(inverse, line - 1, beam);
    const bool hasAfter = line + 1 < u.lines && measured(inverse, line + 1, beam);
    const float before = hasBefore ? u.at(line, beam) - u.at(line - 1, beam) : 0;
    const float after = hasAfter ? u.at(line + 1, beam) - u.at(line, beam) : 0;
    if (!hasBefore || !hasAfter) return 0;
    if (before * after <= 0) return 0;
    // Much unlike: one of them crosses a jump.
    const float smaller = std::abs(before) < std::abs(after) ? before : after;
    const float larger = std::abs(before) < std::abs(after) ? after : before;
    return std::abs(larger) > 3 * std::abs(smaller) ? smaller : 0.5F * (before + after);
}

// How far odd beams are ahead on every so many lines; all 0 unless most of these tell of it.
std::vector<float> parities(const InverseRange& inverse, int every) {
    std::vector<float> parity(static_cast<std::size_t>(inverse.u.lines));
    int told = 0;
    int shifted = 0;
    std::vector<Slip> slips;
    LineSlants slants(inverse.u.beams);
    for (int i = 1; i + 1 < inverse.u.lines; i += every) {
        slips.clear();
        addParity(inverse, i, slants, slips);
        if (slips.size() < kFewestCells) continue;
        ++told;
        if (isMiddleWithin(kLeastParity, slips)) continue;
        const float steps = weightedMiddle(slips);
        if (spreadAround(steps, slips) > kAgree) continue;
        ++shifted;
        parity[static_cast<std::size_t>(i)] = steps;
    }
    if (told < kFewestLines || 2 * shifted <= told) std::fill(parity.begin(), parity.end(), 0.0F);
    return parity;
}

// The slip that the beams of one parity tell of; 0 when there is none that explains what is seen.
float extraStep(const std::vector<Slip>& slips, int beams) {
    if (slips.size() < std::max<std::size_t>(kFewestCells, static_cast<std::size_t>(beams) / 25)) return 0;
    if (isMiddleWithin(kLeastExtra, slips)) return 0;
    const float steps = weightedMiddle(slips);
    if (spreadAround(steps, slips) > kAgree * std::max(1.0F, std::abs(steps))) return 0;
    return explained(slips, steps) < kExplained ? 0 : steps;
}

void moveBeams(InverseRange& inverse, const std::vector<float>& parity) {
    Grid<float> straight = inverse.u;
    for (int i = 0; i < straight.lines; ++i) {
        const float half = 0.5F * parity[static_cast<std::size_t>(i)];
        if (half == 0) continue;
        for (int j = 0; j < straight.beams; ++j) {
            if (!measured(inverse, i, j)) continue;
            const float ahead = j % 2 == 1 ? half : -half;
            straight.at(i, j) = std::max(inverse.u.at(i, j) - ahead * slantAt(inverse, i, j), 1e-4F);
        }
    }
    inverse.u = std::move(straight);
}

} // namespace

SweepSlips noSlips(int lines) {
    const std::vector<float> none(static_cast<std::size_t>(lines));
    return {none, {none, none}, false, 0};
}

SweepSlips straighten(InverseRange& inverse) {
    const int lines = inverse.u.lines;
    // A sample of the lines tells whether it is worth looking at all of them.
    SweepSlips result{parities(inverse, std::max(1, lines / kSampledLines)), {}, false, 0};
    result.extra.fill(std::vector<float>(static_cast<std::size_t>(lines)));
    result.interlaced = std::any_of(result.parity.begin(), result.parity.end(), [](float steps) { return steps != 0; });
    if (result.interlaced) {
        result.parity = parities(inverse, 1);
        moveBeams(inverse, result.parity);
    }
    LineSlants slants(inverse.u.beams);
    StepSlips slips;
    for (int i = 3; i + 4 < lines; ++i) {
        addExtra(inverse, i, slants, slips);
        for (std::size_t parity = 0; parity < 2; ++parity) {
            const float steps = extraStep(slips[parity], inverse.u.beams);
            result.extra[parity][static_cast<std::size_t>(i)] = steps;
            result.slips += steps != 0 ? 1 : 0;
            slips[parity].clear();
        }
    }
    return result;
}

} // namespace edgescan
