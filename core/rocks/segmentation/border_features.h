// What the network of borders is asked about a cell between two segments (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/border_network.h"
#include "core/rocks/segmentation/inner_cells.h"

#include <span>

namespace edgescan::rocks {

/// A cell of the segment `own` next to the segment `other`.
struct BorderPlace {
    int line = 0, beam = 0;
    std::uint32_t own = 0, other = 0;
};

/// Measures cells. Reads the segments of `cells` as they are.
class BorderFeatures {
public:
    BorderFeatures(const Inputs& inputs, const InnerCells& cells) : inputs_(inputs), cells_(cells) {}

    /// Asks the processor to read early what of() reads of a place.
    void readEarly(const BorderPlace& place) const;
    /// The features of 1 to kCellsAtOnce places, each in its lane; the other lanes repeat the first place.
    [[nodiscard]] BorderFeatureLanes of(std::span<const BorderPlace> places) const;

private:
    const Inputs& inputs_;
    const InnerCells& cells_;
};

} // namespace edgescan::rocks
