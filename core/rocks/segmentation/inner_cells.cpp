// Compares each cell with its eight neighbours, a line at once.
#include "core/rocks/segmentation/inner_cells.h"

namespace edgescan::rocks {
InnerCells::InnerCells(const InverseRange& inverse, const Grid<std::uint32_t>& segment)
    : lines_(segment.lines), gridBeams_(segment.beams), beams_(static_cast<std::size_t>(segment.beams + 2 * kPlaneReach)) {
    solid.assign(beams_ * static_cast<std::size_t>(lines_ + 2 * kPlaneReach) + kPlaneColumns, kVoidCell);
    inner.assign(solid.size(), kNoSegment);
    u.assign(solid.size(), 0.0F);
    const auto beams = static_cast<std::size_t>(gridBeams_);
    for (int i = 0; i < lines_; ++i) {
        const std::size_t first = segment.index(i, 0), at = index(i, 0);
        std::copy_n(&inverse.u[first], beams, &u[at]);
        for (std::size_t j = 0; j < beams; ++j)
            solid[at + j] = inverse.support[first + j] != Support::Void ? segment[first + j] : kVoidCell;
    }
    for (int i = 0; i < lines_; ++i) vectorised<markInner>(&solid[index(i, 0)], beams_, beams, &inner[index(i, 0)]);
}

std::uint32_t InnerCells::innerAt(std::size_t at) const {
    std::uint32_t result = kNoSegment;
    markInner(&solid[at], beams_, 1, &result);
    return result;
}

} // namespace edgescan::rocks
