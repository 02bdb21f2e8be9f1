// What the network of borders is asked about a cell between two segments (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/border_network.h"
#include "core/rocks/segmentation/inner_cells.h"

namespace edgescan::rocks {

/// One segment as a cell sees it.
struct BorderSide {
    std::uint32_t segment = 0;
    FittedPlane plane;
    float around = 0;     ///< of its cells within two, their number
    float neighbours = 0; ///< of its cells next to the cell, the weights
    float adjacent = 0;   ///< of the four neighbours, those in it
    float jump = -1, valley = -1;
    float closest = 60, mean = 0; ///< of the neighbours' ranges from the cell's, standard deviations
    float off = 61;               ///< of the cell's range from the plane, standard deviations; 61 without a plane
    float smoothOff = 61;         ///< the same of the smoothed range
    float rangeM = 0;             ///< of the plane at the cell; 0 without a plane
};

/// Measures cells. Reads the segments of `cells` as they are.
class BorderFeatures {
public:
    BorderFeatures(const Inputs& inputs, const InnerCells& cells) : inputs_(inputs), cells_(cells) {}

    /// The side of one segment.
    [[nodiscard]] BorderSide side(int line, int beam, std::uint32_t segment) const;
    [[nodiscard]] std::array<float, kBorderFeatures> of(int line, int beam, const BorderSide& own, const BorderSide& other) const;

private:
    struct Noise {
        float rangeM, perM; ///< of the cell; standard deviations per metre
    };
    [[nodiscard]] Noise noiseAt(std::size_t at) const;

    const Inputs& inputs_;
    const InnerCells& cells_;
};

} // namespace edgescan::rocks
