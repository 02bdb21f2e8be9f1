// The rocks of a scan with all their intermediate results.
#pragma once

#include "core/rocks/attributes/attributes.h"
#include "core/rocks/selection/edits.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::rocks {

/// Immutable after construction. A change of the level changes map and rocks only; an edit also changes the tree; a cutting stroke also
/// changes the segments.
struct Study {
    std::shared_ptr<const Segmentation> segmentation;
    std::shared_ptr<const Segmentation> uncut; ///< without the strokes of the edits
    std::shared_ptr<const MergeTree> tree;
    RegionMap map;
    std::vector<Rock> rocks;
    RockSettings settings;
    std::vector<Edit> edits;
    /// Labels of the rocks that tables, outlines and hulls list, in their order; nothing: all of them.
    std::optional<std::vector<std::uint32_t>> listed{};
};

/// Labels that the study does not have are left out.
[[nodiscard]] std::vector<const Rock*> rocksToList(const Study& study);

/// The same scan, settings and edits give the same labels and rows on every machine. `before` may be null; its results for unchanged inputs
/// are reused.
[[nodiscard]] Study studyRocks(const Inputs& inputs, const RockSettings& settings, const std::vector<Edit>& edits = {},
                               const Study* before = nullptr);

} // namespace edgescan::rocks
