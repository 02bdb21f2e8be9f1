// Compares each cell with its eight neighbours, a line at once.
#include "core/rocks/segmentation/inner_cells.h"

#include "core/base/bands.h"

namespace edgescan::rocks {
namespace {

EDGESCAN_INLINE void fillSolid(const std::uint32_t* segment, const Support* support, std::size_t beams, std::uint32_t* __restrict solid) {
    for (std::size_t j = 0; j < beams; ++j) solid[j] = support[j] != Support::Void ? segment[j] : kVoidCell;
}

EDGESCAN_INLINE void markInner(const std::uint32_t* solid, std::size_t step, std::size_t beams, std::uint32_t* __restrict inner) {
    for (std::size_t j = 0; j < beams; ++j) inner[j] = innerSegment(solid + j, step);
}

} // namespace

InnerCells::InnerCells(const InverseRange& inverse, const Grid<std::uint32_t>& segment, int threads)
    : lines_(segment.lines), gridBeams_(segment.beams), beams_(static_cast<std::size_t>(segment.beams + 2 * kPlaneReach)) {
    solid.assign(beams_ * static_cast<std::size_t>(lines_ + 2 * kPlaneReach) + kPlaneColumns, kVoidCell);
    inner.assign(solid.size(), kNoSegment);
    u.assign(solid.size(), 0.0F);
    const auto beams = static_cast<std::size_t>(gridBeams_);
    threads = bandsFor(segment.size(), threads);
    runInBands(lines_, threads, [&](int from, int end) {
        for (int i = from; i < end; ++i) {
            const std::size_t first = segment.index(i, 0), at = index(i, 0);
            std::copy_n(&inverse.u[first], beams, &u[at]);
            vectorised<fillSolid>(&segment[first], &inverse.support[first], beams, &solid[at]);
        }
    });
    runInBands(lines_, threads, [&](int from, int end) {
        for (int i = from; i < end; ++i) vectorised<markInner>(&solid[index(i, 0)], beams_, beams, &inner[index(i, 0)]);
    });
}

} // namespace edgescan::rocks
