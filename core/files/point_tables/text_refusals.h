// Why a text is not a list of points, in a sentence that names the cause and the remedy.
#pragma once

#include "core/files/point_tables/number_groups.h"
#include "core/files/point_tables/source.h"

#include <cstddef>
#include <string_view>

namespace edgescan::files {

inline constexpr const char* kChooseScan =
    "choose a scan: E57, LAS, PTX, PCD, PLY, OBJ, CSV, XYZ, .3d, .str, .npy, a raw grid (.json), a range picture (.png, .tif), a "
    "recording (.mcap), a ROS bag or a network capture (.pcap)";

/// Text in which no row of numbers was found.
[[nodiscard]] Error textWithoutNumbers(const Source& source);

[[nodiscard]] Error thousandsApart(const Source& source, const GroupedNumber& number);

/// A cell that is not a number, in a line (from 1) of the text.
[[nodiscard]] Error noNumber(const Source& source, std::size_t line, std::string_view cell);

} // namespace edgescan::files
