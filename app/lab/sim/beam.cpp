// Forms the echo and adds the range noise.
#include "app/lab/sim/beam.h"

#include "app/lab/sim/random.h"

#include <algorithm>
#include <cmath>

namespace edgescan::sim {
namespace {

constexpr double kMergeM = 0.6;        // the receiver merges echoes closer than this into one pulse
constexpr double kReflectivity = 0.35; // of dry rock at 905 nm
constexpr double kWeakSignal = 0.02;   // below this, some echoes are lost
constexpr double kGrazingCosine = 0.10;

struct Return {
    double rangeM, power, cosine;
    int object;
    std::size_t lane;
};

struct Returns {
    std::array<Return, kSubRays> all;
    std::size_t count = 0;
};

Returns returnsOf(const RayBundle& bundle, const BundleHits& hits, const Scene& scene, const SimulationSettings& settings) {
    Returns returns;
    const std::size_t subRays = settings.footprint ? kSubRays : 1;
    for (std::size_t i = 0; i < subRays; ++i) {
        const double range = static_cast<double>(hits.distanceM[i]);
        if (hits.surface[i] < 0 || range > settings.maxRangeM) continue;
        const Surface surface = surfaceOf(scene, bundle, hits, i);
        const double cosine = cosineOf(scene, surface, bundle, hits, i);
        const double share = settings.footprint ? static_cast<double>(subRayPower()[i]) : 1.0;
        const double power = share * kReflectivity * cosine * 100.0 / (range * range);
        returns.all[returns.count++] = {range, power, cosine, surface.object, i};
    }
    return returns;
}

/// Power-weighted mean of a group of returns.
Echo merged(const Return* begin, const Return* end) {
    Echo echo;
    double range = 0.0;
    double cosine = 0.0;
    double most = 0.0;
    for (const Return* r = begin; r != end; ++r) {
        echo.signal += r->power;
        range += r->power * r->rangeM;
        cosine += r->power * r->cosine;
        if (r->power <= most) continue;
        most = r->power;
        echo.strongest = r->lane;
    }
    if (echo.signal <= 0.0) return {};
    echo.rangeM = range / echo.signal;
    echo.cosine = cosine / echo.signal;
    return echo;
}

/// The strongest of the groups of neighbouring returns; `together` decides whether two belong to one group.
template <class Together>
Echo strongestGroup(const Returns& returns, Together together) {
    Echo best;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= returns.count; ++i) {
        if (i < returns.count && together(returns.all[i - 1], returns.all[i])) continue;
        const Echo echo = merged(&returns.all[begin], returns.all.data() + i);
        if (echo.signal > best.signal) best = echo;
        begin = i;
    }
    return best;
}

} // namespace

double cosineOf(const Scene& scene, const Surface& surface, const RayBundle& bundle, const BundleHits& hits, std::size_t lane) {
    const Eigen::Vector3f direction(bundle.dx[lane], bundle.dy[lane], bundle.dz[lane]);
    return std::max(1e-4, static_cast<double>(-normalAt(scene, surface, placeOf(bundle, hits, lane)).dot(direction)));
}

Echo echoOf(const RayBundle& bundle, const BundleHits& hits, const Scene& scene, const SimulationSettings& settings) {
    Returns returns = returnsOf(bundle, hits, scene, settings);
    const auto begin = returns.all.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(returns.count);
    if (settings.mixedPixels) {
        std::sort(begin, end,
                  [](const Return& a, const Return& b) { return a.rangeM != b.rangeM ? a.rangeM < b.rangeM : a.lane < b.lane; });
        return strongestGroup(returns, [](const Return& a, const Return& b) { return b.rangeM - a.rangeM < kMergeM; });
    }
    std::sort(begin, end, [](const Return& a, const Return& b) { return a.object != b.object ? a.object < b.object : a.lane < b.lane; });
    return strongestGroup(returns, [](const Return& a, const Return& b) { return a.object == b.object; });
}

double rangeSigmaM(double rangeM, double cosine) {
    constexpr double kSteepest = 0.04; // at a smaller cosine the echo has the largest length that the receiver allows
    return 0.001 * (5.5 + 0.25 * rangeM) * (1.0 + 0.35 * (1.0 / std::max(cosine, kSteepest) - 1.0));
}

double measuredMm(const Echo& echo, std::size_t k, const SimulationSettings& settings) {
    const std::uint64_t seed = measurementSeed(settings);
    const auto chance = [&](Purpose purpose) { return uniformOf(hashOf(seed, purpose, k)); };
    const double step = settings.rangeStepMm;
    double range = echo.rangeM;
    if (echo.signal <= 0.0 || chance(Purpose::Dropout) < settings.dropouts) return 0.0;
    if (chance(Purpose::Dust) < settings.dust) {
        range = std::min(range, 0.5 + chance(Purpose::DustRange) * (range - 0.5));
    } else if (settings.echoLoss) {
        const double weak = 1.0 - echo.signal / kWeakSignal;
        const double grazing = 0.9 * (1.0 - echo.cosine / kGrazingCosine);
        if (chance(Purpose::EchoLoss) < std::max(weak, grazing)) return 0.0;
    }
    const double sigma = settings.noise * rangeSigmaM(echo.rangeM, echo.cosine);
    range += sigma * normalOf(hashOf(seed, Purpose::Noise, k));
    if (range > settings.maxRangeM) return 0.0;
    return std::max(1.0, std::round(1000.0 * range / step)) * step;
}

} // namespace edgescan::sim
