// Bytes per cell that the kinds of work were seen to take.
#include "core/edges/pipeline/work_memory.h"

#include "core/base/checked_size.h"
#include "core/base/memory.h"

#include <array>

namespace edgescan {

Result<Done> checkMemoryFor(Work work, const Scan& scan) {
    // Peaks on a sweep of 4.6 million cells, above the scan itself: 17, 96 and 55 bytes per cell (120 with pictures); and a half more.
    // Rocks hold cracks, distance, leaves and their borders beside what detection holds.
    static constexpr std::array<std::uint64_t, 4> kBytesPerCell{26, 150, 180, 160};
    return checkMemory(productOf({scan.cells(), kBytesPerCell[static_cast<std::size_t>(work)]}), scan.path);
}

} // namespace edgescan
