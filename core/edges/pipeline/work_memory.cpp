// Measured memory use per cell for each kind of work.
#include "core/edges/pipeline/work_memory.h"

#include "core/base/checked_size.h"
#include "core/base/memory.h"

#include <array>

namespace edgescan::edges {

Result<Done> checkMemoryFor(Work work, const Scan& scan) {
    // Peaks on a sweep of 4.6 million cells, in addition to the scan itself: 17, 96 and 55 bytes per cell (120 with pictures); plus a half
    // as reserve. Rocks also hold cracks, distances, segments and their borders. Stored folds are 6 to 11 bytes per cell, more where
    // ranges are all noise. The sums of rock borders are 20 bytes per cell, counted with the first.
    static constexpr std::array<std::uint64_t, 5> kBytesPerCell{46, 150, 180, 160, 26};
    return checkMemory(productOf({scan.cells(), kBytesPerCell[static_cast<std::size_t>(work)]}), scan.path);
}

} // namespace edgescan::edges
