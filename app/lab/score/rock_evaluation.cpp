// Scores the rocks of a scene.
#include "app/lab/score/rock_evaluation.h"

#include "core/scan/grid/inverse_range.h"

#include <algorithm>

namespace edgescan::lab {
namespace {

constexpr std::size_t kRockCells = 100;
constexpr std::size_t kLargeCells = 400;

Grid<std::uint8_t> scoredCells(const Scan& scan) {
    const InverseRange inverse = inverseRange(scan);
    Grid<std::uint8_t> counts(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < counts.size(); ++k)
        counts[k] = scan.state[k] == CellState::Valid && inverse.support[k] != Support::Void ? 1 : 0;
    return counts;
}

/// The confidence of a region counts as right if the rock was found, and as wrong if the region is false; other regions are left out.
std::vector<ConfidenceSample> confidenceOf(const RockDetection& answer, const RockMatch& match) {
    std::vector<ConfidenceSample> samples;
    const auto add = [&](std::uint32_t region, bool right) {
        if (region < answer.claims.size() && answer.claims[region]) samples.push_back({answer.claims[region]->confidence, right});
    };
    for (const RockVerdict& rock : match.rocks) {
        if (rock.found) add(rock.region, true);
    }
    for (const std::uint32_t region : match.falseRegions) add(region, false);
    return samples;
}

std::vector<SpanSample> spansOf(const RockScene& scene, const RockDetection& answer, const RockMatch& match) {
    std::vector<SpanSample> samples;
    for (const RockVerdict& rock : match.rocks) {
        if (!rock.found || rock.region >= answer.claims.size() || !answer.claims[rock.region]) continue;
        const RockClaim& told = *answer.claims[rock.region];
        if (told.uncertaintyM <= 0.0) continue;
        const VisibleSpans& seen = scene.spans[rock.rock - 1];
        const TrueRock& whole = scene.truth.rocks[rock.rock - 1];
        samples.push_back({told.aM, told.bM, seen.aM, seen.bM, whole.spansM[0], whole.spansM[1], told.uncertaintyM});
    }
    return samples;
}

} // namespace

Result<RockScene> rockScene(const Scan& scan, TrueRocks truth, const std::string& where) {
    if (scan.lines() != truth.rock.lines || scan.beams() != truth.rock.beams)
        return Error{"the scan has " + std::to_string(scan.lines()) + " x " + std::to_string(scan.beams()) + " cells and its truth " +
                         std::to_string(truth.rock.lines) + " x " + std::to_string(truth.rock.beams),
                     where, "give each file the truth that was written with it"};
    RockScene scene{scan.name, std::move(truth), scoredCells(scan), {}, {}, {}};
    scene.parts = visibleParts(scene.truth.rock);
    scene.spans = trueSpans(scan, scene.truth);
    scene.pairs = truePairs(scene.truth);
    return scene;
}

RockSceneScore scoreRocks(const RockScene& scene, const RockDetection& answer) {
    const Overlaps rocks = overlapsOf(scene.counts, scene.truth.rock, answer.region);
    RockSceneScore score;
    score.lenient = matchRocks(rocks, answer.isRock, {kRockCells, false});
    score.strict = matchRocks(rocks, answer.isRock, {kRockCells, true});
    score.lenientLarge = matchRocks(rocks, answer.isRock, {kLargeCells, false});
    score.strictLarge = matchRocks(rocks, answer.isRock, {kLargeCells, true});
    score.parts = matchRocks(overlapsOf(scene.counts, scene.parts, answer.region), answer.isRock, {kRockCells, false});
    score.spans = spansOf(scene, answer, score.strict);
    score.confidence = confidenceOf(answer, score.strict);
    for (const auto& claim : answer.claims) {
        if (claim && claim->uncertaintyM > 0.0) score.shownB.push_back(claim->bM);
    }
    for (const RockVerdict& rock : score.strict.rocks) score.trueB.push_back(scene.spans[rock.rock - 1].bM);
    score.pairs = scorePairs(scene.pairs, answer.pairs, score.strict);
    score.milliseconds = answer.milliseconds;
    return score;
}

} // namespace edgescan::lab
