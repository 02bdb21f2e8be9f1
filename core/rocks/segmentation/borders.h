// Evidence on each crack between two segments: does a rock end there? (docs/method/rocks.md, "Step 4".) A crack is the side between two
// neighbouring cells.
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/segments.h"

namespace edgescan::rocks {

/// Evidence on one crack.
struct CrackEvidence {
    double e1 = 0.0;       ///< 0..1: jump at the crack, or valley across it
    double e2 = 0.0;       ///< 0..1: an edge (after suppression) is at most two cells away
    double valleyMm = 0.0; ///< mm: depth below a chord of up to 120 mm on each side; negative: a ridge
    double v = 0.0;        ///< -2..2: the same, in units of 30 mm
    double wideMm = 0.0;   ///< mm: depth below a chord of up to 500 mm on each side
    double w = 0.0;        ///< -2..2: the same, in units of 125 mm
    double z = 0.0;        ///< log odds "two rocks"
};

/// The inputs of the evidence on cracks.
class CrackMeasure {
public:
    CrackMeasure(const Inputs& inputs, const Grid<std::uint32_t>& segment);

    /// The evidence on the crack between cell (line, beam) and the next one along `along`; both must belong to segments.
    [[nodiscard]] CrackEvidence at(int line, int beam, edges::Along along) const;
    /// S_J of that crack (docs/method/edges.md, "Step 3").
    [[nodiscard]] float jump(std::size_t k, edges::Along along) const {
        return (along == edges::Along::Beams ? cracks_.jumpBeams : cracks_.jumpLines)[k];
    }
    /// True without a jump and with a clear valley across the crack.
    [[nodiscard]] bool isContact(std::size_t p, std::size_t q, edges::Along along) const;
    [[nodiscard]] bool isNearer(std::size_t p, std::size_t q) const { return cracks_.smoothed[p] >= cracks_.smoothed[q]; }

private:
    /// A chord across the crack, and its largest possible length.
    struct Chord;
    [[nodiscard]] Chord chordAt(int line, int beam, edges::Along along) const;
    [[nodiscard]] double depthMm(const Chord& chord, int cells) const;

    const Inputs& inputs_;
    const edges::DepthCracks& cracks_;
    const Grid<std::uint32_t>& segment_;
};

/// Where a segment ends after the refinement of its borders.
struct SegmentOutlines {
    std::vector<OutlineSums> borders; ///< as many as there are borders
    std::vector<std::int64_t> outer;  ///< by segment, as Segmentation::outer
};
/// `borders`: ascending by (a, b). Cracks between other segments are left out.
[[nodiscard]] SegmentOutlines segmentOutlines(const Inputs& inputs, const Grid<std::uint32_t>& segment,
                                              std::span<const SegmentBorder> borders, std::uint32_t count);

/// All borders, ascending by (a, b).
[[nodiscard]] std::vector<SegmentBorder> segmentBorders(const Inputs& inputs, const Grid<std::uint32_t>& segment);

} // namespace edgescan::rocks
