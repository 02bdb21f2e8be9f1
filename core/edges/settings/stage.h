// The stages of the pipeline.
#pragma once

#include <cstdint>

namespace edgescan::edges {

/// The stages of a run, in order. Gray levels, mask, smoothed levels: for methods on gray levels; surface, responses: for EdgeScan+.
enum class Stage : std::uint8_t {
    Gray,
    Mask,
    Smoothing, ///< uses Gray, without Mask
    Surface,
    Responses, ///< uses Surface
    Edges,     ///< uses all others; for every threshold
    Threshold, ///< the edges at one threshold
};

} // namespace edgescan::edges
