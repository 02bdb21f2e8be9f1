// The rocks of a scan with all their intermediate results.
#pragma once

#include "core/rocks/attributes/attributes.h"
#include "core/rocks/selection/edits.h"

#include <memory>
#include <vector>

namespace edgescan {

/// Immutable after construction. A change of the level changes map and rocks only; an edit also changes the tree; a cutting stroke also
/// changes the segments.
struct RockStudy {
    std::shared_ptr<const RockLeaves> leaves;
    std::shared_ptr<const MergeTree> tree;
    RockMap map;
    std::vector<Rock> rocks;
    RockSettings settings;
    std::vector<RockEdit> edits;
};

/// The same scan, settings and edits give the same labels and rows on every machine. `before` may be null; its results for unchanged inputs
/// are reused.
[[nodiscard]] RockStudy studyRocks(const RockInputs& inputs, const RockSettings& settings, const std::vector<RockEdit>& edits = {},
                                   const RockStudy* before = nullptr);

} // namespace edgescan
