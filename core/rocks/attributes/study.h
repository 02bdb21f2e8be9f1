// The rocks of a scan with everything that they are made from.
#pragma once

#include "core/rocks/attributes/attributes.h"
#include "core/rocks/selection/edits.h"

#include <memory>
#include <vector>

namespace edgescan {

/// Made once, never changed. What a move of the level makes anew: map and rocks; what an edit does: tree, and with a stroke the leaves.
struct RockStudy {
    std::shared_ptr<const RockLeaves> leaves;
    std::shared_ptr<const MergeTree> tree;
    RockMap map;
    std::vector<Rock> rocks;
    RockSettings settings;
    std::vector<RockEdit> edits;
};

/// Same scan, settings and edits: same labels and rows, on every machine. `before` may be null: what it holds of the same inputs is
/// not made again.
[[nodiscard]] RockStudy studyRocks(const RockInputs& inputs, const RockSettings& settings, const std::vector<RockEdit>& edits = {},
                                   const RockStudy* before = nullptr);

} // namespace edgescan
