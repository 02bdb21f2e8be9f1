// Samples of pairs of bodies of which the truth is known, for the trees of core/rocks/segmentation/merge_price.h, and of regions, for the
// weights of R (docs/method/rocks.md, "Step 5" and "Step 7").
#pragma once

#include "app/lab/learning/boosting.h"
#include "app/lab/learning/logistic.h"
#include "app/lab/score/rock_score.h"
#include "app/lab/sim/truth/truth_files.h"
#include "core/rocks/segmentation/merge_tree.h"
#include "core/rocks/selection/rock_map.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace edgescan::lab {

/// A scan whose segments and true rocks are known.
struct RockLesson {
    rocks::Segmentation segments;
    Grid<std::uint8_t> counts; ///< 1 where a range was measured
    Grid<std::uint32_t> rock;  ///< the true rock, from 1; 0 background
    /// By segment: its measured cells by true rock, ascending.
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> cells;
};
/// `object`: of the truth, lines x beams.
[[nodiscard]] RockLesson rockLesson(const std::shared_ptr<const Scan>& scan, const Grid<std::uint16_t>& object);

/// The price that trees give; null: the mean z of the border.
[[nodiscard]] rocks::MergeTree treeBy(const RockLesson& lesson, const LearntTrees* trees);

/// Adds every n-th of the pairs that are met while segments are merged by the price of `trees`, `share` of them.
void addPairSamples(const RockLesson& lesson, const LearntTrees* trees, double share, TreeSamples& samples);

/// The numbers of a region on which R depends. right: it is a rock.
using RegionSample = LogisticSample<rocks::kScoreInputs>;
/// Regions of 100 cells and more at level 0 that are mostly one rock, or mostly background, each with `weight`.
void addRegionSamples(const RockLesson& lesson, const rocks::MergeTree& tree, double weight, std::vector<RegionSample>& samples);
/// The constant, then one weight per input.
[[nodiscard]] std::array<double, 1 + rocks::kScoreInputs> fittedScore(const std::vector<RegionSample>& samples);

/// How the regions at `level` score strictly, when the truth says which of them are rocks.
[[nodiscard]] RockCounts scoreByTruth(const RockLesson& lesson, const rocks::MergeTree& tree, double level);
/// How rocksAt() scores strictly.
[[nodiscard]] RockCounts scoreAsSet(const RockLesson& lesson, const rocks::MergeTree& tree);

} // namespace edgescan::lab
