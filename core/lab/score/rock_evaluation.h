// All figures of rocks found in simulated scenes (docs/method.md, "Truth and score").
#pragma once

#include "core/lab/score/rock_pairs.h"
#include "core/lab/score/rock_score.h"
#include "core/lab/score/rock_truth.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// What is told of one region that is called a rock.
struct RockClaim {
    double aM = 0.0, bM = 0.0; ///< visible spans
    double uncertaintyM = 0.0; ///< u_r: the spans are shown with twice this to either side; 0 where no spans are told
    double confidence = 0.0;   ///< probability that it is one whole rock
};

/// One way's answer for one scene.
struct RockAnswer {
    std::string name;
    Grid<std::uint32_t> region;                   ///< lines x beams, 0 = none
    std::vector<std::uint8_t> isRock;             ///< by region's number; empty where the way tells no rock from a wall
    std::vector<std::optional<RockClaim>> claims; ///< by region's number; empty where the way tells nothing of them
    std::vector<RockPair> pairs;                  ///< of regions
    double milliseconds = 0.0;                    ///< thread CPU time
    std::string note;                             ///< why there is no answer, or what to know about it
};

/// A scene made ready for any number of answers.
struct RockScene {
    std::string name;
    TrueRocks truth;
    Grid<std::uint8_t> counts;       ///< 1 where a range was measured and the cell is not void: these cells are scored
    Grid<std::uint32_t> parts;       ///< visible parts of rocks, from 1
    std::vector<VisibleSpans> spans; ///< true, by place in truth.rocks
    std::vector<RockPair> pairs;     ///< true
};
/// Error: the shapes differ. `where` goes into it.
Result<RockScene> rockScene(const Scan& scan, TrueRocks truth, const std::string& where);

struct SpanSample {
    double a = 0.0, b = 0.0, trueA = 0.0, trueB = 0.0, wholeA = 0.0, wholeB = 0.0, u = 0.0; ///< metres
};
struct ConfidenceSample {
    double told = 0.0;
    bool right = false;
};

/// One answer on one scene.
struct RockSceneScore {
    RockMatch lenient, strict;           ///< rocks of 100 cells and more
    RockMatch lenientLarge, strictLarge; ///< of 400 and more
    RockMatch parts;                     ///< lenient, every visible part a rock
    std::vector<SpanSample> spans;       ///< of those found strictly
    std::vector<ConfidenceSample> confidence;
    std::vector<double> shownB, trueB; ///< of all that is shown as a rock; of all true rocks of 100 cells and more
    PairScore pairs;
    double milliseconds = 0.0;
};
[[nodiscard]] RockSceneScore scoreRocks(const RockScene& scene, const RockAnswer& answer);

/// Sums over the scenes and means of them.
[[nodiscard]] nlohmann::ordered_json rockScoreJson(const std::vector<RockSceneScore>& scenes);

} // namespace edgescan
