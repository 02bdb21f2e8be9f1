// What the operator can turn about rocks, and its table: flags, sliders, help and records follow.
#pragma once

#include "core/base/result.h"

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
    double level = 0.0;      ///< log odds up to which two pieces are one rock: -4 fine .. 4 coarse
    int minimumCells = 100;  ///< measured cells; smaller ones are fines
    double farthestM = 15.0; ///< what lies farther away is no rock
    double largestM = 2.5;   ///< largest size expected on this site; what is larger needs better signs of being a rock
    double oversizeM = 0.0;  ///< visible width over which a rock is too large for this site; 0: not said
    /// Cells of a picture of lines x beams, corners included. Empty: everything; two: opposite corners of a rectangle; more: a polygon.
    /// What lies mostly outside counts neither as rock nor as anything else.
    std::vector<RegionCorner> region = {};

    bool operator==(const RockSettings&) const = default;
};

struct RockParameter {
    const char* key; ///< flag without "--", key in records
    const char* label;
    const char* unit;
    const char* help; ///< one sentence
    double minimum;
    double maximum;
    double step;
    int decimals;
    double (*get)(const RockSettings&);
    void (*set)(RockSettings&, double);
};

/// All but the region, in the order in which they are shown.
[[nodiscard]] std::span<const RockParameter> rockParameters();

/// "LINE,BEAM LINE,BEAM ...": two corners or more. Error: something else.
Result<std::vector<RegionCorner>> parseRegion(std::string_view text);

/// "--level 1 --region '0,0 9,9'": what is not as usual, for a POSIX shell.
[[nodiscard]] std::string rockSettingsFlags(const RockSettings& settings);

/// {"level": 0, ..., "region": [[line, beam], ...]}; and back. Error: unknown key, outside the limits; `where` goes into it.
[[nodiscard]] nlohmann::ordered_json rockSettingsToJson(const RockSettings& settings);
Result<RockSettings> rockSettingsFromJson(const nlohmann::json& object, const std::string& where);

} // namespace edgescan::rocks
