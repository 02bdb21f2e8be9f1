// One slider of each kind: those that measure, the crease angle with stored folds, and those that only decide.
#include "tests/bench/sliders.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/edgescan_plus/stored_folds.h"
#include "core/edges/gray/canny.h"

#include <string>

namespace edgescan::bench {
namespace {

constexpr Goal kJumpSlider{"slider of jump, growth or grazing / full EdgeScan+", Good::AtMost, 0.5, 0.75};
constexpr Goal kCreaseSlider{"slider of the crease angle / full EdgeScan+", Good::AtMost, 0.15, 0.18};
constexpr Goal kFirstMove{"its first move, which stores folds / full EdgeScan+", Good::AtMost, 1, 1.25};
constexpr Goal kFoldBytes{"folds that it stores, bytes per cell", Good::AtMost, 12, 10.5};
constexpr Goal kDecision{"slider that only decides / full EdgeScan+", Good::AtMost, 0.08, 0.07};

} // namespace

void runPlus(const Scan& scan, int threads) {
    const edges::Settings settings;
    const edges::DepthEdges found = edges::decideDepthEdges(
        edges::depthResponses(edges::depthSurface(scan, settings, threads), settings, nullptr, threads), settings, threads);
    (void)edges::edgeCells(found.mask);
}

void measureSliders(const Scan& scan, int rounds, Table& table) {
    const edges::Settings plus;
    edges::Settings sharper = plus;
    sharper.creaseDeg += 1;
    const edges::DepthSurface surface = edges::depthSurface(scan, {});
    edges::StoredFolds folds, first;
    const edges::DepthResponses responses = edges::depthResponses(surface, plus, nullptr, 0, &folds);
    const auto decided = [](const edges::DepthResponses& by, const edges::Settings& settings) {
        (void)edges::decideDepthEdges(by, settings);
    };
    enum { kAll, kMeasure, kFold, kFirstFold, kDecide };
    std::vector<Candidate> runs{
        {"EdgeScan+, one thread", [&] { runPlus(scan, 1); }},
        {"its sliders of jump, growth and grazing", [&] { decided(edges::depthResponses(surface, plus, nullptr, 1), plus); }},
        {"its slider of the crease angle", [&] { decided(edges::withCreaseAngle(responses, folds, surface, sharper, 1), sharper); }},
        {"- the first move", [&] { decided(edges::depthResponses(surface, sharper, nullptr, 1, &first), sharper); }},
        {"its sliders that decide", [&] { decided(responses, plus); }}};
    measureInTurn(runs, rounds);
    const auto share = [&](std::size_t n) { return medianOf(runs[n].cpuMs) / medianOf(runs[kAll].cpuMs); };
    const std::string title = std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) + " beams, sliders";
    table.begin(title.c_str());
    table.row(kJumpSlider, share(kMeasure));
    table.row(kCreaseSlider, share(kFold));
    table.row(kFirstMove, share(kFirstFold));
    table.row(kFoldBytes, static_cast<double>(folds.bytes()) / static_cast<double>(scan.cells()));
    table.row(kDecision, share(kDecide));
    printCandidates(runs, scan);
}

} // namespace edgescan::bench
