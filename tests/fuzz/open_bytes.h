// The common part of every fuzzer of a reader: opens the bytes, and checks the scan.
#pragma once

#include "core/files/open_save/open_scan.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

namespace edgescan::fuzz {

inline void hold(bool promise) {
    if (!promise) std::abort();
}

inline int openBytes(const std::uint8_t* bytes, std::size_t size, const char* extension) {
    ReadingOptions options;
    options.beamStartDeg = 0; // pictures and tables of ranges have no angles of their own
    options.beamStepDeg = 0.5;
    options.lineStartDeg = 0;
    options.lineStepDeg = 0.5;
    const bool ranges = std::string(extension) == ".png" || std::string(extension) == ".tif" || std::string(extension) == ".csv" ||
                        std::string(extension) == ".npy";
    if (ranges) options.axis = Axis::Sweep; // for other files the axis would prevent the projection of clouds
    const auto scan = files::readScanBytes(std::as_bytes(std::span(bytes, size)), extension, options);
    if (!scan) {
        const std::string sentence = scan.error().sentence();
        hold(sentence.ends_with(".") && sentence.find('\n') == std::string::npos);
        return 0;
    }
    hold(scan->cells() == static_cast<std::size_t>(scan->lines()) * static_cast<std::size_t>(scan->beams()));
    hold(scan->state.size() == scan->cells());
    for (std::size_t k = 0; k < scan->cells(); ++k) hold(scan->state[k] != CellState::Valid || std::isfinite(scan->rangeMm[k]));
    for (const AttachedPoint& point : scan->attached) hold(point.cell < scan->cells() && point.pointM.allFinite());
    if (const auto* polar = std::get_if<PolarGeometry>(&scan->geometry)) {
        hold(polar->lineDeg.size() == static_cast<std::size_t>(scan->lines()));
        hold(polar->beamDeg.size() == static_cast<std::size_t>(scan->beams()));
    }
    return 0;
}

} // namespace edgescan::fuzz
