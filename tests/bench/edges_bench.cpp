// The cost of EdgeScan+, and of the rocks from its edges, relative to the thesis's Canny: thread CPU time, stage by stage, all interleaved
// in one run. build/release/bin/edgescan_edges_bench [SCAN [ROUNDS]]; without a scan, a simulated sweep of 1000 x 1141.
#include "app/lab/sim/simulate.h"
#include "core/edges/gray/canny.h"
#include "core/edges/gray/gray.h"
#include "core/edges/gray/smooth.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/files/open_save/open_scan.h"
#include "core/rocks/attributes/study.h"
#include "tests/bench/timing.h"

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace edgescan;
using namespace edgescan::bench;

namespace {

// The time that others are given as multiples of.
constexpr const char* kThesis = "thesis: gray levels, Gaussian, Canny";
constexpr const char* kResponses = "EdgeScan+ responses, from the scan on";
constexpr const char* kDecision = "EdgeScan+ decision";

// What a person waits for, with its goal.
struct WaitedFor {
    const char* stage;
    double goalMs; // wall time, a million cells on two threads
};
constexpr WaitedFor kRocks{"rocks from finished edges, rows included", 60}, kMap{"a move of the rocks' slider: map", 2},
    kMapAndRows{"- map and rows", 2};

Scan scanOf(int argc, char** argv) {
    auto scan = argc > 1 ? files::openScan(argv[1]) : Result<Scan>(Scan{});
    if (argc <= 1) {
        auto simulated = sim::simulate(sim::SimulationSettings{});
        if (simulated)
            scan = std::move(simulated->scan);
        else
            scan = simulated.error();
    }
    if (scan) return *std::move(scan);
    std::fprintf(stderr, "edgescan_edges_bench: %s\n", scan.error().sentence().c_str());
    std::exit(1);
}

} // namespace

int main(int argc, char** argv) {
    cv::setNumThreads(0);
    const Scan scan = scanOf(argc, argv);
    const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 15;
    const edges::Settings thesis = edges::findPreset("thesis")->settings;
    const edges::Settings depth;
    InverseRange inverse = inverseRange(scan);
    const edges::DepthSurface surface = edges::depthSurface(scan, {});
    const edges::DepthResponses responses = edges::depthResponses(surface, depth);
    const rocks::Inputs inputs =
        rocks::rockInputs(*edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{}, edges::KeepFor::Rocks));
    const rocks::Study rocks = rocks::studyRocks(inputs, {});
    double level = 0;
    const auto moved = [&] {
        level = level == 0 ? 0.5 : 0;
        rocks::RockSettings settings;
        settings.level = level;
        return settings;
    };
    std::vector<Candidate> stages{
        {kThesis, [&] { (void)edges::canny(edges::smooth(edges::grayImage(scan, thesis).levels, thesis), thesis); }},
        {kResponses, [&] { (void)edges::depthResponses(edges::depthSurface(scan, {}, 1), depth, nullptr, 1); }},
        {"- cleaned, in inverse range", [&] { inverse = inverseRange(scan); }},
        {"- slips of beams and lines", [&] { (void)straighten(inverse, 1); }},
        {"- noise", [&] { (void)rangeNoise(surface.inverse); }},
        {"- mixed pixels, jumps, folds (a slider)", [&] { (void)edges::depthResponses(surface, depth, nullptr, 1); }},
        {"- the same, this thread's half", [&] { (void)edges::depthResponses(surface, depth, nullptr, 2); }},
        {kDecision, [&] { (void)edges::decideDepthEdges(responses, depth); }},
        {kRocks.stage, [&] { (void)rocks::studyRocks(inputs, {}); }},
        {"- leaves and their borders", [&] { (void)rocks::segmentRocks(inputs); }},
        {"- tree of merges", [&] { (void)rocks::mergeTree(*rocks.segmentation); }},
        {"- rows", [&] { (void)rocks::rockRows(*rocks.segmentation, rocks.map); }},
        {kMap.stage, [&] { (void)rocks::rocksAt(*rocks.segmentation, *rocks.tree, moved()); }},
        {kMapAndRows.stage, [&] { (void)rocks::studyRocks(inputs, moved(), {}, &rocks); }},
    };
    measureInTurn(stages, rounds);
    const auto stageOf = [&](const char* stage) -> const Candidate& { return *std::ranges::find(stages, stage, &Candidate::name); };
    const auto msOf = [&](const char* stage) { return medianOf(stageOf(stage).cpuMs); };
    const double thesisMs = msOf(kThesis);
    const double plusMs = msOf(kResponses) + msOf(kDecision);
    std::printf("Medians of %d rounds, %d x %d.\n\n| stage | thread CPU, ms | x thesis's recipe | x EdgeScan+ |\n|---|---|---|---|\n",
                rounds, scan.lines(), scan.beams());
    for (const Candidate& stage : stages) {
        const double ms = medianOf(stage.cpuMs);
        std::printf("| %s | %.2f | %.2f | %.2f |\n", stage.name.c_str(), ms, ms / thesisMs, ms / plusMs);
    }
    std::printf("\n| rocks, on as many threads as make them faster | this thread's CPU, ms | measured (wall), ms | goal, ms | reached |\n"
                "|---|---|---|---|---|\n");
    for (const WaitedFor& waited : {kRocks, kMap, kMapAndRows}) {
        const double wallMs = medianOf(stageOf(waited.stage).wallMs);
        std::printf("| %s | %.2f | %.2f | %g | %s |\n", waited.stage, msOf(waited.stage), wallMs, waited.goalMs,
                    wallMs <= waited.goalMs ? "yes" : "no");
    }
    return 0;
}
