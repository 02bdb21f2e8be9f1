// Prints a hash of every mask, class, response and strength that the methods compute for simulated sweeps, for sweeps of noise, and for the
// scans given as arguments; the same of the rocks, and of EdgeScan+ on one, two and four threads. A faster program must print the same, and
// so must every instruction set (EDGESCAN_LOOPS). build/release/bin/edgescan_edge_hashes [--quick] [--set N] [SCAN...] > new; the same with
// an older build > old; diff old new. --quick: smaller sweeps. --set N: everything on the default settings of version N, so that a build
// whose defaults are others prints the same.
#include "app/lab/sim/simulate.h"
#include "core/base/instruction_set.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/presets.h"
#include "core/files/open_save/open_scan.h"
#include "core/rocks/attributes/study.h"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace edgescan;

namespace {

// FNV-1a over the bytes of values without padding.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325U;
    template <class T>
    void add(const std::vector<T>& values) {
        for (const std::byte byte : std::as_bytes(std::span(values))) value = (value ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3U;
    }
};

struct Run {
    bool quick = false;
    edges::Settings base;
};

std::vector<std::pair<std::string, edges::Settings>> allSettings(const edges::Settings& base) {
    std::vector<std::pair<std::string, edges::Settings>> all{{"default", base}};
    for (const char* gray : {"log", "thesis", "window"}) all.emplace_back(gray, edges::findPreset(gray)->settings);
    for (int n = 0; n <= static_cast<int>(edges::Method::Log); ++n) {
        edges::Settings settings = base;
        settings.method = static_cast<edges::Method>(n);
        all.emplace_back("method " + std::to_string(n), settings);
    }
    const auto turned = [&](const char* name, const std::function<void(edges::Settings&)>& turn) {
        edges::Settings settings = base;
        turn(settings);
        all.emplace_back(name, settings);
    };
    turned("noise 1", [](edges::Settings& s) { s.noiseMm = 1; });
    turned("noise 20", [](edges::Settings& s) { s.noiseMm = 20; });
    turned("jump 5", [](edges::Settings& s) { s.jumpMm = 5; });
    turned("grazing 1", [](edges::Settings& s) { s.grazing = 1; });
    turned("fold 5", [](edges::Settings& s) { s.creaseDeg = 5; });
    turned("sensitive", [](edges::Settings& s) { s.sensitivity = 0.3, s.hysteresisPercent = 20, s.minimumLength = 1; });
    turned("rules 4", [](edges::Settings& s) { s.rules = 4; });
    turned("rock borders", [](edges::Settings& s) { s.rockBorders = true; });
    turned("not straightened", [](edges::Settings& s) { s.straighten = false; });
    turned("concave and border", [](edges::Settings& s) { s.classes = edges::kClassConcave | edges::kClassBorder; });
    turned("convex", [](edges::Settings& s) { s.classes = edges::kClassConvex; });
    turned("all", [](edges::Settings& s) { s.classes = edges::kClassRock | edges::kClassBorder; });
    return all;
}

void printRocks(const std::string& name, const std::shared_ptr<const Scan>& scan, const edges::Settings& base) {
    const auto found = edges::detectEdges(scan, base, edges::KeepFor::Rocks);
    const rocks::Study study = rocks::studyRocks(rocks::rockInputs(*found), {});
    Hash labels, rest;
    labels.add(rocks::rockLabels(*study.segmentation, study.map).cells);
    rest.add(rocks::regionLabels(*study.segmentation, study.map).cells);
    std::vector<double> numbers;
    for (const rocks::Region& region : study.map.regions) {
        for (const double number : {region.bulge, region.nearShare, region.edgeShare, region.depthRatio, region.boxShare, region.evidence,
                                    region.longM, region.score, region.confidence})
            numbers.push_back(number);
    }
    rest.add(numbers);
    std::printf("%s, rocks: %u, labels %016llx, rest %016llx\n", name.c_str(), study.map.rocks,
                static_cast<unsigned long long>(labels.value), static_cast<unsigned long long>(rest.value));
}

void printWithThreads(const std::string& name, const Scan& scan, const edges::Settings& settings, int threads) {
    const edges::DepthResponses responses = edges::depthResponses(edges::depthSurface(scan, settings, threads), settings, nullptr, threads);
    const edges::DepthEdges found = edges::decideDepthEdges(responses, settings, threads);
    Hash mask, rest;
    mask.add(found.mask.cells);
    rest.add(found.kind.cells);
    rest.add(responses.jump->cells);
    rest.add(responses.crease.cells);
    rest.add(responses.border);
    rest.add(responses.silhouettes);
    std::printf("%s, %d threads: mask %016llx, rest %016llx\n", name.c_str(), threads, static_cast<unsigned long long>(mask.value),
                static_cast<unsigned long long>(rest.value));
}

void print(const std::string& name, const Scan& scan, const edges::Settings& base) {
    const auto shared = std::make_shared<const Scan>(scan);
    for (const auto& [title, settings] : allSettings(base)) {
        const auto found = edges::detectEdges(shared, settings);
        Hash mask, rest;
        mask.add(found->mask->cells);
        rest.add(*found->edges);
        if (found->classes) rest.add(found->classes->cells);
        if (found->responses) {
            rest.add(found->responses->jump->cells);
            rest.add(found->responses->crease.cells);
            rest.add(found->responses->border);
            rest.add(edges::requestedStrength(*found->responses, settings).cells);
            rest.add(found->surface->inverse.u.cells);
            rest.add(found->surface->slips.remaining[0]);
            rest.add(found->surface->slips.remaining[1]);
            rest.add(*found->borders);
            edges::DepthCracks cracks;
            (void)edges::depthResponses(*found->surface, settings, &cracks);
            for (const Grid<float>* grid : {&cracks.smoothed, &cracks.jumpBeams, &cracks.jumpLines, &cracks.foldBeams, &cracks.foldLines})
                rest.add(grid->cells);
        }
        std::printf("%s, %s: %zu edges, mask %016llx, rest %016llx\n", name.c_str(), title.c_str(), found->edges->size(),
                    static_cast<unsigned long long>(mask.value), static_cast<unsigned long long>(rest.value));
    }
    printRocks(name, shared, base);
    for (const int threads : {1, 2, 4}) printWithThreads(name, scan, base, threads);
}

void printSimulated(const char* name, const Run& run, const std::function<void(sim::SimulationSettings&)>& set) {
    sim::SimulationSettings settings;
    settings.lines = 300;
    settings.beams = 571;
    set(settings);
    if (run.quick) {
        settings.lines = 120 + static_cast<int>(settings.seed);
        settings.beams = 160 + static_cast<int>(settings.seed);
    }
    const auto simulated = sim::simulate(settings);
    if (simulated) print(name, simulated->scan, run.base);
}

// Ranges without any surface, in all sizes from one cell on.
Scan noise(int lines, int beams) {
    std::mt19937 random(static_cast<unsigned>(1000 * lines + beams));
    Scan scan;
    scan.rangeMm = Grid<float>(lines, beams);
    scan.state = Grid<CellState>(lines, beams, CellState::NoReturn);
    PolarGeometry polar;
    for (int j = 0; j < beams; ++j) polar.beamDeg.push_back(90 + 0.1667 * j);
    for (int i = 0; i < lines; ++i) polar.lineDeg.push_back(0.18 * i);
    scan.geometry = polar;
    const std::uint32_t share = random() % 8;
    const std::uint32_t most = 1U << (1 + random() % 14U);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (random() % 8 < share) continue;
        scan.state[k] = CellState::Valid;
        scan.rangeMm[k] = 1000.0F + static_cast<float>(random() % most) + 200.0F * static_cast<float>(k / 97 % 5);
    }
    return scan;
}

} // namespace

int main(int argc, char** argv) {
    if (const auto set = wantedInstructionSet(); !set) {
        std::fprintf(stderr, "edgescan_edge_hashes: %s\n", set.error().sentence().c_str());
        return 2;
    }
    Run run;
    int next = 1;
    for (; next < argc && std::string_view(argv[next]).starts_with("--"); ++next) {
        run.quick |= std::string_view(argv[next]) == "--quick";
        if (std::string_view(argv[next]) == "--set" && next + 1 < argc) run.base = edges::defaultSettings(std::stoi(argv[++next]));
    }
    printSimulated("full", run, [](sim::SimulationSettings& s) { s.lines = 1000, s.beams = 1141; });
    printSimulated("fine", run, [](sim::SimulationSettings& s) { s.seed = 2, s.noise = 0.1, s.rangeStepMm = 0.1; });
    printSimulated("noisy", run, [](sim::SimulationSettings& s) { s.seed = 3, s.noise = 4; });
    printSimulated("interlaced", run, [](sim::SimulationSettings& s) { s.seed = 4, s.interlaceDeg = 0.4; });
    printSimulated("slipped", run, [](sim::SimulationSettings& s) { s.seed = 5, s.slips = 0.05, s.lines = 700; });
    printSimulated("spin", run, [](sim::SimulationSettings& s) { s.seed = 6, s.axis = Axis::Spin, s.statusCodes = 0.01; });
    printSimulated("holes", run, [](sim::SimulationSettings& s) { s.seed = 7, s.dropouts = 0.2, s.dust = 0.02; });
    for (const auto& [lines, beams] : {std::pair{1, 1},
                                       {1, 2},
                                       {2, 1},
                                       {1, 70},
                                       {70, 1},
                                       {3, 3},
                                       {5, 17},
                                       {17, 16},
                                       {40, 33},
                                       {64, 128},
                                       {97, 129},
                                       {130, 255},
                                       {200, 40}})
        print("noise of " + std::to_string(lines) + " x " + std::to_string(beams), noise(lines, beams), run.base);
    for (int n = next; n < argc; ++n) {
        const auto scan = files::openScan(argv[n]);
        if (scan)
            print(argv[n], *scan, run.base);
        else
            std::fprintf(stderr, "edgescan_edge_hashes: %s\n", scan.error().sentence().c_str());
    }
    return 0;
}
