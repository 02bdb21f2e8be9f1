// All figures for rocks found in simulated scenes (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/score/rock_pairs.h"
#include "app/lab/score/rock_score.h"
#include "app/lab/score/rock_truth.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::lab {

/// The reported values of one region classified as a rock.
struct RockClaim {
    double aM = 0.0, bM = 0.0; ///< visible spans
    double uncertaintyM = 0.0; ///< u_r: the spans are reported with a tolerance of twice this; 0 if spans are not reported
    double confidence = 0.0;   ///< probability that the region is one whole rock
};

/// The result of one method for one scene.
struct RockDetection {
    std::string name;
    Grid<std::uint32_t> region;                   ///< lines x beams, 0 = no region
    std::vector<std::uint8_t> isRock;             ///< by the region's number; empty if the method does not distinguish rocks from walls
    std::vector<std::optional<RockClaim>> claims; ///< by the region's number; empty if the method does not report them
    std::vector<RockPair> pairs;                  ///< of regions
    double milliseconds = 0.0;                    ///< thread CPU time
    std::string note;                             ///< why there is no result, or a remark about it
};

/// A scene prepared for any number of results.
struct RockScene {
    std::string name;
    TrueRocks truth;
    Grid<std::uint8_t> counts;       ///< 1 where a range was measured and the cell is not void: these cells are scored
    Grid<std::uint32_t> parts;       ///< visible parts of rocks, from 1
    std::vector<VisibleSpans> spans; ///< true spans, by index of truth.rocks
    std::vector<RockPair> pairs;     ///< true pairs
};
/// Error: the shapes differ. The error names `where`.
Result<RockScene> rockScene(const Scan& scan, TrueRocks truth, const std::string& where);

/// One found rock: its reported spans, the true visible and the true whole ones, and its u_r.
struct SpanSample {
    double a = 0.0, b = 0.0, trueA = 0.0, trueB = 0.0, wholeA = 0.0, wholeB = 0.0, u = 0.0; ///< metres
};
/// One reported confidence, and whether the region was right.
struct ConfidenceSample {
    double reported = 0.0;
    bool right = false;
};

/// The score of one result on one scene.
struct RockSceneScore {
    RockMatch lenient, strict;           ///< rocks with at least 100 cells
    RockMatch lenientLarge, strictLarge; ///< with at least 400 cells
    RockMatch parts;                     ///< lenient, with every visible part counted as a rock
    std::vector<SpanSample> spans;       ///< of the rocks found strictly
    std::vector<ConfidenceSample> confidence;
    std::vector<double> shownB, trueB; ///< of all regions shown as a rock; of all true rocks with at least 100 cells
    PairScore pairs;
    double milliseconds = 0.0;
};
[[nodiscard]] RockSceneScore scoreRocks(const RockScene& scene, const RockDetection& answer);

/// Sums and means over the scenes.
[[nodiscard]] nlohmann::ordered_json rockScoreJson(const std::vector<RockSceneScore>& scenes);

} // namespace edgescan::lab
