// The settings for rocks and their table, from which flags, sliders, help and records are made.
#pragma once

#include "core/base/result.h"
#include "core/base/table_row.h"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::rocks {

/// A corner of the region of interest.
struct RegionCorner {
    int line = 0;
    int beam = 0;
    bool operator==(const RegionCorner&) const = default;
};

struct RockSettings {
    double level = 0.0;      ///< log odds up to which two pieces are joined to one rock: -4 fine .. 4 coarse
    int minimumCells = 100;  ///< fewer measured cells: fines
    double farthestM = 15.0; ///< m: a region farther away is not classified as a rock
    double largestM = 2.5;   ///< m: largest expected size on this site; a larger region needs stronger evidence to be a rock
    double oversizeM = 0.0;  ///< m: visible width above which a rock is oversize on this site; 0: not given
    /// Cells of a picture of lines x beams, including the corners. Empty: everything; two: opposite corners of a rectangle; more: a
    /// polygon. Regions mostly outside are not classified at all.
    std::vector<RegionCorner> region = {};

    bool operator==(const RockSettings&) const = default;
};

using RockParameter = TableRow<RockSettings>;

/// All settings except the region, in the order in which they are shown.
[[nodiscard]] std::span<const RockParameter> rockParameters();

/// "LINE,BEAM LINE,BEAM ...": two or more corners. Error: the text has another form.
Result<std::vector<RegionCorner>> parseRegion(std::string_view text);
/// False: a part of the region is outside of a scan of lines x beams. Error: all of it is.
[[nodiscard]] Result<bool> isRegionInside(std::span<const RegionCorner> corners, int lines, int beams);

/// "--level 1 --region '0,0 9,9'": the settings that differ from the defaults, for a POSIX shell.
[[nodiscard]] std::string rockSettingsFlags(const RockSettings& settings);

/// {"level": 0, ..., "region": [[line, beam], ...]}; and back. Error: unknown key, outside the limits; the error names `where`.
[[nodiscard]] nlohmann::ordered_json rockSettingsToJson(const RockSettings& settings);
Result<RockSettings> rockSettingsFromJson(const nlohmann::json& object, const std::string& where);

} // namespace edgescan::rocks
