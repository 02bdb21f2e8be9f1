// Colours for the points of a cloud by what is measured: range, height, line.
#pragma once

#include "core/scan/grid/scan.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <QRgb>

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace edgescan::ui {

enum class ColourBy : std::uint8_t { Nothing, Range, Height, Line };

/// As it is kept in files: "gray", "range", "height", "line".
[[nodiscard]] const char* colourKey(ColourBy by);
/// Empty: no such key.
[[nodiscard]] std::optional<ColourBy> colourOfKey(std::string_view key);

/// The colour at `share` (0 .. 1) of the scale: from blue to ochre, all of one luminance, so that light and dark still mean form and edges
/// stand out as they do from gray; told apart by blue and yellow alone too.
[[nodiscard]] QRgb colourAt(double share);

struct CloudColours {
    ColourBy by = ColourBy::Nothing;
    std::shared_ptr<const CloudGeometry> of;
    std::shared_ptr<const std::vector<std::uint32_t>> points; ///< by cell, as CloudView::setFaces takes them
    double low = 0.0, high = 1.0; ///< what the ends of the scale stand for, metres, or lines; what lies beyond has the colour of the end
    bool mine = false;            ///< heights are elevations of the mine grid; else above the scanner
};

/// Nothing, or a cloud without a point: no colours. The ends are those of the middle 98 % of the points, of lines all. For the worker.
[[nodiscard]] CloudColours cloudColours(const Scan& scan, const std::shared_ptr<const CloudGeometry>& cloud, ColourBy by);

} // namespace edgescan::ui
