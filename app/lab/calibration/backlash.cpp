// Estimates one parameter by Gauss-Newton with Tukey's weights, on inverse ranges.
#include "app/lab/calibration/backlash.h"

#include "app/lab/calibration/twice_seen.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/scan/grid/inverse_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr int kSlopeLines = 2;     // number of lines on either side
constexpr double kMostBentMm = 60; // if its lines bend by more than this, the place is an edge
constexpr std::size_t kFewestSame = 1000;
constexpr int kBacklashRounds = 20;
constexpr double kTukeyReach = 4.685;
constexpr double kMostSdDeg = 0.05;
constexpr double kSystematicSdDeg = 0.002; // in simulations the errors exceed the effect of noise by this much; the cause is unknown
constexpr double kSameBeamDeg = 0.01;

// A pass with its lines in the order of their angles.
struct SortedPass {
    explicit SortedPass(const Scan& scan, const PolarGeometry& polar)
        : inverse(inverseRange(scan)), line(polar.lineDeg.size()), deg(polar.lineDeg.size()) {
        std::iota(line.begin(), line.end(), 0);
        std::ranges::sort(line, {}, [&](int n) { return polar.lineDeg[static_cast<std::size_t>(n)]; });
        std::ranges::transform(line, deg.begin(), [&](int n) { return polar.lineDeg[static_cast<std::size_t>(n)]; });
    }

    // Inverse range and its change per degree at an angle, from the nearest line and kSlopeLines lines on either side; false if these are
    // not on one surface.
    [[nodiscard]] bool at(double atDeg, int beam, double& u, double& slope) const {
        const std::ptrdiff_t middle = nearestAngle(deg, atDeg);
        const std::ptrdiff_t first = middle - kSlopeLines, last = middle + kSlopeLines;
        if (first < 0 || last >= static_cast<std::ptrdiff_t>(deg.size())) return false;
        if (std::abs(deg[static_cast<std::size_t>(middle)] - atDeg) >
            deg[static_cast<std::size_t>(last)] - deg[static_cast<std::size_t>(middle)])
            return false;
        double n = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (std::ptrdiff_t k = first; k <= last; ++k) {
            const int of = line[static_cast<std::size_t>(k)];
            if (!inverse.isMeasured(of, beam)) return false;
            const double off = deg[static_cast<std::size_t>(k)] - atDeg, value = static_cast<double>(inverse.u.at(of, beam));
            n += 1, x += off, y += value, xx += off * off, xy += off * value;
        }
        const double spread = n * xx - x * x;
        if (!(spread > 0)) return false;
        slope = (n * xy - x * y) / spread;
        u = (y - slope * x) / n;
        if (!(u > 0)) return false;
        for (std::ptrdiff_t k = first; k <= last; ++k) {
            const double off = deg[static_cast<std::size_t>(k)] - atDeg;
            const double value = static_cast<double>(inverse.u.at(line[static_cast<std::size_t>(k)], beam));
            if (std::abs(value - u - slope * off) / (u * u) * 1000 > kMostBentMm) return false;
        }
        return true;
    }

    InverseRange inverse;
    std::vector<int> line;
    std::vector<double> deg;
};

struct SamePlace {
    double offMm, slopeThereMm, slopeBackMm; // the slopes are per degree
    std::size_t line;
};

// Both passes are fitted in the same way, so that the smoothing by the fit is the same on both sides. The return pass is fitted at its own
// lines. There the errors of height and slope are independent, so its slope converts the distance without bias; the slope of the forward
// pass would not.
std::vector<SamePlace> samePlaces(const SortedPass& there, const SortedPass& back, double backlashDeg) {
    std::vector<SamePlace> places;
    for (std::size_t k = 0; k < back.deg.size(); ++k) {
        for (int j = 0; j < back.inverse.u.beams; ++j) {
            double u1 = 0, u2 = 0, slope1 = 0, slope2 = 0;
            if (!back.at(back.deg[k], j, u2, slope2) || !there.at(back.deg[k] + backlashDeg, j, u1, slope1)) continue;
            const double mmPerU = 1000 / (u2 * u2);
            places.push_back({(u1 - u2) * mmPerU, slope1 * mmPerU, slope2 * mmPerU, k});
        }
    }
    return places;
}

// The contribution of each block of lines to the normal equation.
class Blocks {
public:
    explicit Blocks(std::size_t lines) : lines_(lines) {}
    void add(const SamePlace& place, double information, double gradient) {
        const std::size_t block = place.line * kBlocks / lines_;
        information_[block] += information;
        gradient_[block] += gradient;
    }
    [[nodiscard]] double information() const { return std::accumulate(information_.begin(), information_.end(), 0.0); }
    [[nodiscard]] double gradient() const { return std::accumulate(gradient_.begin(), gradient_.end(), 0.0); }
    // By leaving out one block after the other (Efron 1982, the jackknife). The beams of a line share the stepper's jitter, and
    // neighbouring lines share a surface and its faults, so their errors are correlated; those of blocks hardly are.
    [[nodiscard]] double sd() const {
        std::vector<double> without;
        for (std::size_t n = 0; n < kBlocks; ++n) {
            const double rest = information() - information_[n];
            if (information_[n] != 0 && rest > 0) without.push_back(-(gradient() - gradient_[n]) / rest);
        }
        if (without.size() < kFewestBlocks) return kMostSdDeg;
        const auto count = static_cast<double>(without.size());
        const double mean = std::accumulate(without.begin(), without.end(), 0.0) / count;
        double sum = 0;
        for (const double one : without) sum += (one - mean) * (one - mean);
        return std::sqrt((count - 1) / count * sum);
    }

private:
    static constexpr std::size_t kBlocks = 16, kFewestBlocks = 8;
    std::size_t lines_;
    std::array<double, kBlocks> information_{}, gradient_{};
};

double medianOff(const std::vector<SamePlace>& places) {
    std::vector<double> sizes;
    for (const SamePlace& place : places) sizes.push_back(std::abs(place.offMm));
    return median(std::move(sizes));
}

std::optional<Error> unlike(const PolarGeometry* a, const PolarGeometry* b) {
    if (a == nullptr || b == nullptr) return Error{"a pass has no line angles", "", "give sweeps of a scanner on a stepper"};
    bool same = a->beamDeg.size() == b->beamDeg.size() && a->axis == b->axis && a->lineDirection == b->lineDirection;
    for (std::size_t j = 0; same && j < a->beamDeg.size(); ++j) same = std::abs(a->beamDeg[j] - b->beamDeg[j]) < kSameBeamDeg;
    if (!same) return Error{"the two passes do not have the same beams", "", "give two passes of one scanner on one stepper"};
    return std::nullopt;
}

} // namespace

Result<Backlash> backlashOf(const Scan& there, const Scan& back) {
    const auto* a = std::get_if<PolarGeometry>(&there.geometry);
    const auto* b = std::get_if<PolarGeometry>(&back.geometry);
    if (const auto error = unlike(a, b)) return *error;
    const SortedPass first(there, *a), second(back, *b);
    Backlash found;
    for (int round = 0; round < kBacklashRounds; ++round) {
        const std::vector<SamePlace> places = samePlaces(first, second, found.deg);
        if (places.size() < kFewestSame)
            return Error{"only " + std::to_string(places.size()) + " cells of the two passes see the same smooth surface", "",
                         "give two passes over the same lines, there and back"};
        const double apart = medianOff(places);
        if (round == 0) found.apartBeforeMm = apart;
        found.apartAfterMm = apart;
        found.cells = places.size();
        const double reach = kTukeyReach * std::max(0.3, 1.4826 * apart);
        Blocks blocks(second.deg.size());
        for (const SamePlace& place : places) {
            const double t = place.offMm / reach;
            if (std::abs(t) >= 1) continue;
            const double weight = (1 - t * t) * (1 - t * t);
            blocks.add(place, weight * place.slopeBackMm * place.slopeThereMm, weight * place.slopeBackMm * place.offMm);
        }
        const double information = blocks.information();
        if (!(information > 0))
            return Error{"no surface slants across the lines, so a turn of the stepper does not show", "", "scan rocks or a corner"};
        const double step = std::clamp(-blocks.gradient() / information, -0.5, 0.5);
        found.deg += step;
        found.sdDeg = std::hypot(blocks.sd(), kSystematicSdDeg);
        if (std::abs(step) < 1e-6) break;
    }
    if (!(found.sdDeg < kMostSdDeg))
        return Error{"the two passes give the backlash to no better than " + fixedText(2 * found.sdDeg, 3) + " degrees", "",
                     "scan rocks or a corner, in fine steps"};
    return found;
}

} // namespace edgescan::inspect
