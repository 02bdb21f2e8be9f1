// The edges of a detector with one threshold on an image of levels.
#pragma once

#include "core/edges/pipeline/methods.h"

namespace edgescan::test {

/// 255 where the response is larger than settings.lower.
inline Grid<std::uint8_t> detectorMask(edges::Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing,
                                       const edges::Settings& settings) {
    const Grid<float> response = edges::rowOf(method).response(levels, missing, settings);
    Grid<std::uint8_t> mask(response.lines, response.beams);
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = static_cast<double>(response[k]) > settings.lower ? 255 : 0;
    return mask;
}

} // namespace edgescan::test
