// Runs the method stage by stage.
#include "core/edges/pipeline/pipeline.h"

#include "core/base/instruction_set.h"
#include "core/edges/edgescan_plus/stored_folds.h"
#include "core/edges/gray/canny.h"
#include "core/edges/gray/gray.h"
#include "core/edges/gray/smooth.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/edges/rock_borders/rock_borders.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "core/scan/grid/missing_cells.h"

#include <limits>
#include <opencv2/core/utility.hpp>

#include <chrono>
#include <ctime>

namespace edgescan::edges {
namespace {

/// lines x beams: 255 where the gray methods ignore a cell under these settings; empty (0 x 0) if they use all cells.
Grid<std::uint8_t> maskedCells(const Scan& scan, const Settings& settings) {
    if (!settings.maskMissing) return {};
    Grid<std::uint8_t> masked = missingCells(scan);
    if (!settings.maskIsolated) return masked;
    const Grid<std::uint8_t> isolated = isolatedCells(scan);
    for (std::size_t k = 0; k < masked.size(); ++k) masked[k] |= isolated[k];
    return masked;
}

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

// Runs one stage and stores its times.
template <class Run>
void timed(Detection& detection, Stage stage, const char* name, Run run) {
    const auto start = Clock::now();
    const double cpuStart = threadCpuMilliseconds();
    run();
    detection.timings.push_back({name, millisecondsSince(start), threadCpuMilliseconds() - cpuStart, stage});
}

// Made from copies of the pointers: the detection that holds it is not in it.
MadeWhenRead<std::vector<BorderPercent>> bordersOf(const Detection& detection) {
    return MadeWhenRead<std::vector<BorderPercent>>(
        [surface = detection.surface, responses = detection.responses, edges = detection.edges, settings = detection.settings] {
            return borderPercents(*surface, *responses, settings, *edges, 0);
        });
}

} // namespace

double threadCpuMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Pipeline::Pipeline(KeepFor keep) : keep_(keep) {
    cv::setNumThreads(0);
    if (instructionSet() < InstructionSet::Avx2) cv::setUseOptimized(false); // OpenCV has SSE3, and all that the processor has
}

// Runs the stage again only if a setting changed that affects this stage or one before it.
template <class T, class Make>
std::shared_ptr<const T> Pipeline::upToDate(Kept<T>& kept, Stage stage, const char* name, Detection& detection, Make make) {
    if (kept.made && sameUpTo(stage, kept.with, detection.settings)) return kept.made;
    timed(detection, stage, name, [&] { kept.made = std::make_shared<const T>(make()); });
    kept.with = detection.settings;
    return kept.made;
}

// Runs the stages before the decision.
void Pipeline::runStages(Detection& d) {
    const Settings& settings = d.settings;
    const bool sameGray = last_ && sameUpTo(Stage::Gray, last_->settings, settings) &&
                          reads(last_->settings.method, kReadsGray) == reads(settings.method, kReadsGray);
    d.gray = sameGray ? last_->gray : MadeWhenRead<GrayImage>([scan = d.scan, settings] { return grayImage(*scan, settings); });
    if (reads(settings.method, kReadsGray | kReadsKernel) && !d.gray.isMade()) timed(d, Stage::Gray, "gray", [&] { (void)*d.gray; });
    if (reads(settings.method, kReadsGray) && settings.maskMissing)
        d.masked = upToDate(masked_, Stage::Mask, "mask", d, [&] { return maskedCells(*d.scan, settings); });
    if (reads(settings.method, kReadsGray | kReadsKernel)) {
        const Grid<std::uint8_t>& levels = d.gray->levels;
        d.smoothed = upToDate(smoothed_, Stage::Smoothing, "smooth", d,
                              [&] { return d.masked ? smoothAroundHoles(levels, *d.masked, settings) : smooth(levels, settings); });
    }
    if (settings.fillCells > 0)
        d.filled = upToDate(filled_, Stage::Surface, "gaps", d, [&] { return fillGaps(*d.scan, settings.fillCells); });
    if (!reads(settings.method, kReadsSurface)) return;
    const GapFilling* wanted = settings.fillEdges ? d.filled.get() : nullptr;
    d.surface = upToDate(surface_, Stage::Surface, "surface", d, [&] { return withFilledGaps(depthSurface(*d.scan, settings), wanted); });
    d.responses = upToDate(responses_, Stage::Responses, "jumps and creases", d, [&] { return responsesOf(d); });
    d.cracks = cracks_;
}

// While only the crease angle changes, the first change stores what the next ones need, the folds at any angle, if there is memory.
DepthResponses Pipeline::responsesOf(const Detection& d) {
    Settings same = responses_.with;
    same.creaseDeg = d.settings.creaseDeg;
    const bool onlyCrease = responses_.made && sameUpTo(Stage::Responses, same, d.settings);
    if (!onlyCrease) folds_ = nullptr;
    if (onlyCrease && keep_ == KeepFor::Edges && StoredFolds::covers(d.settings.creaseDeg, d.scan->beams())) {
        if (folds_) return withCreaseAngle(*responses_.made, *folds_, *d.surface, d.settings);
        if (checkMemoryFor(Work::StoreFolds, *d.scan)) {
            const auto folds = std::make_shared<StoredFolds>();
            DepthResponses responses = depthResponses(*d.surface, d.settings, nullptr, 0, folds.get());
            folds_ = folds;
            return responses;
        }
    }
    const auto cracks = keep_ == KeepFor::Rocks ? std::make_shared<DepthCracks>() : nullptr;
    DepthResponses responses = depthResponses(*d.surface, d.settings, cracks.get());
    cracks_ = cracks;
    return responses;
}

// If only the threshold changed since the last run: one map, and then one comparison per cell. Classes need the decision itself.
void Pipeline::decide(Detection& d) {
    const Decision& decision = rowOf(d.settings.method).decision;
    const bool onlyThreshold = last_ && !last_->classes && sameUpTo(Stage::Edges, last_->settings, d.settings);
    if (onlyThreshold) {
        const auto map = upToDate(thresholds_, Stage::Edges, "threshold map", d, [&] { return SweptEdges(decision.thresholds(d)); });
        timed(d, Stage::Threshold, "threshold", [&] {
            const double threshold = sweptParameter(d.settings.method).get(d.settings);
            d.mask = std::make_shared<const Grid<std::uint8_t>>(map->at(threshold));
        });
        return;
    }
    thresholds_ = {};
    timed(d, Stage::Edges, decision.stage, [&] {
        FoundEdges found = decision.edges(d);
        d.mask = std::make_shared<const Grid<std::uint8_t>>(std::move(found.mask));
        if (d.responses) d.classes = std::make_shared<const Grid<DepthEdge>>(std::move(found.classes));
    });
}

std::shared_ptr<const Detection> Pipeline::run(const std::shared_ptr<const Scan>& scan, const Settings& settings) {
    const auto start = Clock::now();
    if (last_ && last_->scan != scan) *this = Pipeline(keep_);
    if (last_ && last_->settings == settings) return last_;
    Detection detection;
    detection.scan = scan;
    detection.settings = settings;
    runStages(detection);
    decide(detection);
    timed(detection, Stage::Threshold, "edge cells",
          [&] { detection.edges = std::make_shared<const std::vector<std::uint32_t>>(edgeCells(*detection.mask)); });
    if (detection.responses) detection.borders = bordersOf(detection);
    detection.totalMs = millisecondsSince(start);
    last_ = std::make_shared<const Detection>(std::move(detection));
    return last_;
}

Measured measuredOf(const Detection& detection) {
    Measured measured;
    if (const GrayScale& scale = detection.gray->scale; scale.farMm > 0) {
        measured.nearMm = scale.nearMm;
        measured.farMm = scale.farMm;
    }
    if (detection.responses) {
        measured.jumpMm = detection.responses->jumpMm;
        measured.noiseMm = detection.responses->noise.at(5.0);
    }
    return measured;
}

std::array<std::size_t, kDepthEdges> countClasses(const Detection& detection) {
    std::array<std::size_t, kDepthEdges> counts{};
    if (!detection.classes) return counts;
    for (const std::uint32_t k : *detection.edges) ++counts[static_cast<std::size_t>((*detection.classes)[k])];
    return counts;
}

BorderCounts countBorders(const Detection& detection) {
    BorderCounts counts;
    if (!detection.borders) return counts;
    for (const BorderPercent percent : *detection.borders)
        ++(percent == kUnknownBorder  ? counts.unknown
           : percent >= kStrongBorder ? counts.strong
           : percent >= kWeakBorder   ? counts.weak
                                      : counts.folds);
    return counts;
}

std::optional<std::size_t> nearestEdge(const Grid<std::uint8_t>& mask, std::size_t cell, int reach) {
    return nearestEdge(mask, cell, reach, reach, 1.0);
}

std::optional<std::size_t> nearestEdge(const Grid<std::uint8_t>& mask, std::size_t cell, int lines, int beams, double lineByBeam) {
    const int line = static_cast<int>(cell) / mask.beams, beam = static_cast<int>(cell) % mask.beams;
    std::optional<std::size_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (int i = std::max(0, line - lines); i <= std::min(mask.lines - 1, line + lines); ++i) {
        for (int j = std::max(0, beam - beams); j <= std::min(mask.beams - 1, beam + beams); ++j) {
            const double down = (i - line) * lineByBeam, along = j - beam, away = down * down + along * along;
            if (away >= least || mask.at(i, j) == 0) continue;
            least = away;
            nearest = mask.index(i, j);
        }
    }
    return nearest;
}

std::shared_ptr<const Detection> detectEdges(const std::shared_ptr<const Scan>& scan, const Settings& settings, KeepFor keep) {
    return Pipeline(keep).run(scan, settings);
}

} // namespace edgescan::edges
