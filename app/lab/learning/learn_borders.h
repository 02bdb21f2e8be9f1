// Trains the network of borders on scans whose objects are known (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/border_choice.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace edgescan::lab {

/// Cells between two segments of different true objects.
struct BorderSamples {
    std::vector<float> features; ///< rocks::kBorderFeatures per sample
    std::vector<float> belongs;  ///< 1: to the other segment, 0: to its own one

    [[nodiscard]] std::size_t count() const { return belongs.size(); }
};

/// The questions of one scan of which the answer is known.
class BorderLesson {
public:
    /// `object`: of the truth, lines x beams.
    BorderLesson(const std::shared_ptr<const Scan>& scan, Grid<std::uint16_t> object);
    /// Adds one of `every` questions about the borders that `network` leaves.
    void ask(const rocks::BorderNetwork& network, int every, BorderSamples& samples) const;

private:
    rocks::Inputs inputs_;
    rocks::FittedSegments fitted_;
    std::vector<std::uint32_t> groups_;
    Grid<std::uint16_t> object_;          ///< the true one of each cell
    std::vector<std::uint16_t> objectOf_; ///< that of most cells of a segment
};

struct BorderTraining {
    int epochs = 22;
    std::uint32_t seed = 1; ///< of the first weights and of the order
};
/// Adam on the logistic loss. The same samples give the same network.
[[nodiscard]] rocks::BorderNetwork trainedBorders(const BorderSamples& samples, const BorderTraining& training);

/// Share of the samples that the network answers rightly.
[[nodiscard]] double rightShare(const rocks::BorderNetwork& network, const BorderSamples& samples);

/// The text of core/rocks/segmentation/border_weights.inc.
[[nodiscard]] std::string borderWeightsText(const rocks::BorderNetwork& network, const std::string& madeBy);

} // namespace edgescan::lab
