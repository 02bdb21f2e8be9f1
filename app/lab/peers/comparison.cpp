// Runs every method on one scan.
#include "app/lab/peers/comparison.h"

#include "core/base/order_statistic.h"
#include "core/edges/gray/canny.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/scan/angle_correction/interlace.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::lab {
namespace {

// Thread CPU time of one step, milliseconds.
template <class Step>
auto timed(double& milliseconds, Step step) {
    const double start = edges::threadCpuMilliseconds();
    auto result = step();
    milliseconds += edges::threadCpuMilliseconds() - start;
    return result;
}

struct Run {
    ComparedSteps steps;
    Grid<std::uint8_t> mask;
    Grid<std::uint8_t> classes;
};

// Assigns the stages of the pipeline to the steps of the thesis's table. Only methods on gray levels need the gray image.
ComparedSteps stepsOf(const edges::Detection& detection) {
    ComparedSteps steps;
    for (const edges::StageTime& time : detection.timings) {
        if (time.of == edges::Stage::Gray)
            steps.conversion += edges::reads(detection.settings.method, edges::kReadsGray) ? time.cpuMilliseconds : 0.0;
        else if (time.of == edges::Stage::Mask || time.of == edges::Stage::Smoothing)
            steps.noiseRemoval += time.cpuMilliseconds;
        else if (time.of != edges::Stage::Threshold)
            steps.edges += time.cpuMilliseconds;
    }
    return steps;
}

Run runOnce(const std::shared_ptr<const Scan>& scan, const edges::Settings& settings) {
    const auto detection = edges::detectEdges(scan, settings);
    Run run{stepsOf(*detection), *detection->mask, {}};
    if (detection->classes) {
        run.classes = Grid<std::uint8_t>(scan->lines(), scan->beams());
        for (const std::uint32_t k : *detection->edges) run.classes[k] = static_cast<std::uint8_t>((*detection->classes)[k]);
    }
    const auto points = timed(run.steps.merge, [&] {
        const CartesianTables tables(*scan);
        std::vector<Eigen::Vector3d> all;
        for (const std::uint32_t k : edges::edgeCells(run.mask)) all.push_back(tables.point(std::size_t{k}));
        return all;
    });
    return run;
}

ComparedMethod ownMethod(std::string name, std::string key, const edges::Settings& settings) {
    ComparedMethod method;
    method.name = std::move(name);
    method.key = std::move(key);
    method.settings = settings;
    return method;
}

std::vector<ComparedMethod> ownMethods() {
    std::vector<ComparedMethod> methods{ownMethod("Canny, thesis to the letter", "thesis", edges::findPreset("thesis")->settings)};
    const edges::Parameter& method = *edges::findParameter("method");
    const edges::Parameter& mask = *edges::findParameter("log-mask");
    // In the order of the thesis's chapter, EdgeScan's own last.
    std::vector<edges::Method> order;
    for (const edges::MethodTraits& traits : edges::methodTraits()) order.push_back(traits.method);
    std::ranges::stable_sort(order, {}, [](edges::Method m) {
        return edges::reads(m, edges::kReadsSurface) ? -static_cast<int>(m) : edges::hasOneThreshold(m) ? -100 : -99;
    });
    for (const edges::Method m : order) {
        edges::Settings settings;
        settings.method = m;
        settings.lower = edges::lowerWithSameStep(edges::cannySettings(), settings);
        const std::string key = edges::formatValue(method, method.get(settings));
        if (m == edges::Method::EdgeScanPlus) {
            edges::Settings asMeasured = settings;
            asMeasured.straighten = false;
            methods.push_back(ownMethod("EdgeScan+, angles as measured", kAsMeasuredKey, asMeasured));
        }
        if (!edges::reads(m, edges::kReadsLaplacianMask)) {
            methods.push_back(ownMethod(m == edges::Method::Canny ? "Canny, logarithmic gray levels" : edges::choiceLabel(method, settings),
                                        key, settings));
            continue;
        }
        for (const edges::LogMask one : {edges::LogMask::FourNeighbours, edges::LogMask::EightNeighbours, edges::LogMask::FiveByFive}) {
            settings.logMask = one;
            settings.lower = edges::lowerWithSameStep(edges::cannySettings(), settings);
            const bool first = one == edges::LogMask::FourNeighbours;
            methods.push_back(ownMethod(edges::choiceLabel(method, settings) + ", " + edges::choiceLabel(mask, settings),
                                        first ? key : key + "-" + edges::formatValue(mask, mask.get(settings)), settings));
        }
    }
    return methods;
}

// Whether the beams are interlaced or lines slipped, and EdgeScan+ corrects this.
bool isDisplaced(const Scan& scan) {
    InverseRange inverse = inverseRange(scan);
    const SweepSlips slips = straighten(inverse);
    return slips.interlaced || slips.slipCount > 0;
}

// The methods in `only`; if it is empty, all that are meaningful for the scan.
std::vector<ComparedMethod> wantedMethods(const Scan& scan, const std::vector<std::string>& only) {
    std::vector<ComparedMethod> methods = ownMethods();
    const bool displaced = !only.empty() || isDisplaced(scan);
    std::erase_if(methods, [&](const ComparedMethod& m) {
        return only.empty() ? m.key == kAsMeasuredKey && !displaced : std::ranges::find(only, m.key) == only.end();
    });
    return methods;
}

void medianSteps(ComparedMethod& method, const std::vector<ComparedSteps>& all) {
    for (double ComparedSteps::*step :
         {&ComparedSteps::conversion, &ComparedSteps::noiseRemoval, &ComparedSteps::edges, &ComparedSteps::merge}) {
        std::vector<double> values;
        for (const ComparedSteps& one : all) values.push_back(one.*step);
        method.steps.*step = median(std::move(values));
    }
}

// Tries the threshold of the settings, and those that give a third to three times as many edges as the truth has.
std::optional<BestThreshold> bestThreshold(const std::shared_ptr<const Scan>& scan, const edges::Settings& settings,
                                           const sim::TruthSet& truth, double tolerance) {
    const edges::ThresholdMap map = edges::thresholdMapOf(*edges::detectEdges(scan, settings));
    const edges::Parameter& swept = edges::sweptParameter(settings.method);
    std::vector<double> highest;
    for (const double value : map.highest.cells) {
        if (value >= 0 && std::isfinite(value)) highest.push_back(value);
    }
    std::ranges::sort(highest, std::greater<>());
    const auto wanted = static_cast<double>(std::ranges::count_if(truth.edges.edgeClass.cells, [](std::uint8_t c) { return c != 0; }));
    std::vector<double> thresholds{swept.get(settings)};
    for (const double share : {0.35, 0.5, 0.65, 0.8, 0.95, 1.1, 1.3, 1.6, 2.0, 3.0}) {
        const auto place = static_cast<std::size_t>(share * wanted);
        if (place >= highest.size()) break;
        thresholds.push_back(highest[place]);
    }
    std::optional<BestThreshold> best;
    for (const double threshold : thresholds) {
        Grid<std::uint8_t> mask = edges::edgesAt(map, threshold);
        const Evaluation score = evaluateMask(mask, truth, scan.get(), tolerance);
        if (best && best->score.score.all.f() >= score.score.all.f()) continue;
        best = BestThreshold{swept.key, threshold, score, std::move(mask)};
    }
    return best;
}

// The time to compute a point for every cell, which PCL needs first.
double millisecondsOfPoints(const Scan& scan) {
    double milliseconds = 0.0;
    const auto points = timed(milliseconds, [&] {
        const CartesianTables tables(scan);
        std::vector<Eigen::Vector3f> all(scan.cells());
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = tables.point(k).cast<float>();
        return all;
    });
    return milliseconds;
}

ComparedMethod peerMethod(PclMethod peer, const Scan& scan) {
    ComparedMethod method;
    method.name = method.key = pclMethodName(peer);
    method.mask = Grid<std::uint8_t>(scan.lines(), scan.beams());
    return method;
}

ComparedMethod comparedPeer(PclMethod peer, const Scan& scan, const PclScan& seen, const ComparisonSettings& settings) {
    ComparedMethod method = peerMethod(peer, scan);
    const Result<PclEdges> found = runPclMethod(peer, seen, settings.pclLimits);
    if (!found) {
        method.note = found.error().sentence();
        return method;
    }
    method.steps.conversion = millisecondsOfPoints(scan);
    for (const edges::StageTime& step : found->steps) {
        const bool conversion = step.stage == "conversion" || step.stage == "range image";
        (conversion ? method.steps.conversion : step.stage == "merge" ? method.steps.merge : method.steps.edges) += step.milliseconds;
    }
    method.mask = found->mask;
    for (const PclClass& kind : found->classes)
        method.kinds.emplace_back(kind.name, kind.mask.size() - static_cast<std::size_t>(std::ranges::count(kind.mask.cells, 0)));
    method.share = found->share;
    if (peer == PclMethod::BoundaryRadius)
        method.name += " " + edges::formatValue(*edges::findParameter("lower"), settings.pclLimits.radiusM) + " m";
    if (method.share < 1.0) {
        method.note = "stopped after " + std::to_string(static_cast<int>(std::lround(100 * method.share))) +
                      " % of the points; its times are worked out for all of them, --slow lets it end";
        method.steps.edges /= method.share;
    }
    return method;
}

} // namespace

std::vector<std::string> comparedKeys() {
    std::vector<std::string> keys;
    for (const ComparedMethod& method : ownMethods()) keys.push_back(method.key);
    return keys;
}

std::vector<ComparedMethod> compareMethods(const std::shared_ptr<const Scan>& scan, const sim::TruthSet* truth,
                                           const ComparisonSettings& settings, const ComparisonProgress& progress) {
    std::vector<ComparedMethod> methods = wantedMethods(*scan, settings.only);
    const std::size_t own = methods.size();
    const int repeats = std::max(1, settings.repeats);
    const auto total = static_cast<double>(repeats) * static_cast<double>(own) + (settings.withPcl ? kPclEdgeMethods : 0);
    double done = 0;
    const auto goesOn = [&](const std::string& name) { return !progress || progress(name.c_str(), done++ / total); };
    std::vector<std::vector<ComparedSteps>> steps(own);
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t n = 0; n < own; ++n) {
            if (!goesOn(methods[n].name)) return {};
            Run run = runOnce(scan, *methods[n].settings);
            steps[n].push_back(run.steps);
            methods[n].mask = std::move(run.mask);
            methods[n].classes = std::move(run.classes);
        }
    }
    for (std::size_t n = 0; n < own; ++n) medianSteps(methods[n], steps[n]);

    if (settings.withPcl) {
        const Result<Done> present = checkPclIsAvailable();
        const PclScan seen = present ? pclScan(*scan) : PclScan{};
        for (int n = 0; n < kPclEdgeMethods; ++n) {
            const PclMethod peer = static_cast<PclMethod>(n);
            if (!goesOn(pclMethodName(peer))) return {};
            if (present) {
                methods.push_back(comparedPeer(peer, *scan, seen, settings));
                continue;
            }
            methods.push_back(peerMethod(peer, *scan));
            methods.back().share = 0.0;
            methods.back().note = present.error().sentence();
        }
    }
    for (ComparedMethod& method : methods) {
        method.edges = edges::edgeCells(method.mask).size();
        if (truth == nullptr || method.share < 1.0 || (!method.settings && !method.note.empty())) continue;
        method.score = evaluateMask(method.mask, *truth, scan.get(), settings.tolerance);
        if (settings.bestThreshold && method.settings) method.best = bestThreshold(scan, *method.settings, *truth, settings.tolerance);
    }
    return methods;
}

} // namespace edgescan::lab
