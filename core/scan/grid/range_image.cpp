// The ranges of a scan as a 16-bit picture.
#include "core/scan/grid/range_image.h"

#include <algorithm>
#include <cmath>

namespace edgescan {

Grid<std::uint16_t> rangePicture(const Scan& scan) {
    Grid<std::uint16_t> picture(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) picture[k] = static_cast<std::uint16_t>(std::min(65535.0F, std::round(scan.rangeMm[k])));
    }
    return picture;
}

} // namespace edgescan
