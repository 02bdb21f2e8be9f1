// The table of the settings for rocks.
#include "core/rocks/selection/rock_settings.h"

#include "core/base/json_fields.h"
#include "core/base/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace edgescan::rocks {
namespace {

constexpr int kMostLines = 1'000'000;
constexpr std::size_t kMostCorners = 1000;

constexpr std::array kRockParameters{
    RockParameter{"level", "Fine to coarse", "",
                  "How easily pieces are joined into one rock. Lower: more and smaller rocks. Higher: fewer and larger rocks.", -4, 4, 0.1,
                  1, EDGESCAN_NUMBER(RockSettings, level)},
    RockParameter{"min-cells", "Smallest rock", "cells", "Pieces with fewer measured cells are fines, not rocks.", 20, 100000, 1, 0,
                  EDGESCAN_NUMBER(RockSettings, minimumCells)},
    RockParameter{"farthest", "Farthest rock", "m", "A region farther away is not a rock.", 0.5, 100, 0.5, 1,
                  EDGESCAN_NUMBER(RockSettings, farthestM)},
    RockParameter{"largest", "Rarely longer than", "m",
                  "Longer pieces need better evidence that they are rocks and not walls. The length is about the visible length a.", 0.1,
                  50, 0.1, 1, EDGESCAN_NUMBER(RockSettings, largestM)},
    RockParameter{"oversize", "Oversize", "m", "The share of rocks whose visible width is larger is reported; 0 reports none.", 0, 50, 0.1,
                  2, EDGESCAN_NUMBER(RockSettings, oversizeM)},
};

/// Whether two sides of the polygon cross, so that which cells are inside is not what was drawn.
bool crosses(std::span<const RegionCorner> corners) {
    const auto side = [](const RegionCorner& a, const RegionCorner& b, const RegionCorner& c) {
        const std::int64_t turn = std::int64_t{b.line - a.line} * (c.beam - a.beam) - std::int64_t{b.beam - a.beam} * (c.line - a.line);
        return turn > 0 ? 1 : turn < 0 ? -1 : 0;
    };
    const auto corner = [&](std::size_t n) { return corners[n % corners.size()]; };
    for (std::size_t m = 0; m < corners.size(); ++m) {
        for (std::size_t n = m + 2; n < corners.size(); ++n) {
            const RegionCorner a = corner(m), b = corner(m + 1), c = corner(n), d = corner(n + 1);
            if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
        }
    }
    return false;
}

} // namespace

std::span<const RockParameter> rockParameters() { return kRockParameters; }

Result<std::vector<RegionCorner>> parseRegion(std::string_view text) {
    const Error error{"the region \"" + std::string(text) + "\" is not understood", "--region",
                      "give two corners or more as LINE,BEAM LINE,BEAM"};
    std::vector<RegionCorner> corners;
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto number = [&](int& value) {
        const auto [next, code] = std::from_chars(at, end, value);
        if (code != std::errc{} || value < 0 || value > kMostLines) return false;
        at = next;
        return true;
    };
    while (at < end) {
        if (*at == ' ') {
            ++at;
            continue;
        }
        RegionCorner corner;
        if (!number(corner.line) || at == end || *at++ != ',' || !number(corner.beam) || (at < end && *at != ' ')) return error;
        if (corners.size() == kMostCorners) return error;
        corners.push_back(corner);
    }
    if (corners.size() < 2) return error;
    const auto same = [&](int RegionCorner::*side) {
        return std::ranges::all_of(corners, [&](const RegionCorner& corner) { return corner.*side == corners.front().*side; });
    };
    if (same(&RegionCorner::line) || same(&RegionCorner::beam))
        return Error{"the region \"" + std::string(text) + "\" has no area", "--region", "give corners on several lines and beams"};
    if (crosses(corners))
        return Error{"the sides of the region \"" + std::string(text) + "\" cross", "--region",
                     "give the corners in their order around it"};
    return corners;
}

Result<bool> isRegionInside(std::span<const RegionCorner> corners, int lines, int beams) {
    const auto [firstLine, lastLine] = std::ranges::minmax(corners, {}, &RegionCorner::line);
    const auto [firstBeam, lastBeam] = std::ranges::minmax(corners, {}, &RegionCorner::beam);
    if (firstLine.line >= lines || firstBeam.beam >= beams)
        return Error{"the region is outside of the scan", "--region",
                     "lines run from 0 to " + std::to_string(lines - 1) + ", beams from 0 to " + std::to_string(beams - 1)};
    return lastLine.line < lines && lastBeam.beam < beams;
}

std::string rockSettingsFlags(const RockSettings& settings) {
    std::string text;
    for (const RockParameter& p : rockParameters()) {
        if (p.get(settings) == p.get(RockSettings{})) continue;
        text += (text.empty() ? "--" : " --") + std::string(p.key) + " " + shortestText(p.get(settings));
    }
    std::string corners;
    for (const RegionCorner& corner : settings.region)
        corners += (corners.empty() ? "" : " ") + std::to_string(corner.line) + "," + std::to_string(corner.beam);
    if (!corners.empty()) text += (text.empty() ? "--region '" : " --region '") + corners + "'";
    return text;
}

nlohmann::ordered_json rockSettingsToJson(const RockSettings& settings) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const RockParameter& p : rockParameters()) {
        const double value = p.get(settings);
        object[p.key] = value;
        if (value == std::floor(value)) object[p.key] = static_cast<std::int64_t>(value);
    }
    object["region"] = nlohmann::ordered_json::array();
    for (const RegionCorner& corner : settings.region) object["region"].push_back({corner.line, corner.beam});
    return object;
}

Result<RockSettings> rockSettingsFromJson(const nlohmann::json& object, const std::string& where) {
    if (!object.is_object()) return Error{"the settings of rocks are not a JSON object", where, "write {\"level\": 0, ...}"};
    JsonFields fields(object, where, "write {\"level\": 0, \"min-cells\": 100, ...}");
    RockSettings settings;
    for (const RockParameter& p : rockParameters()) p.set(settings, fields.number(p.key, p.get(settings), p.limits()));
    for (const nlohmann::json& corner : fields.value("region")) {
        const auto isIndex = [](const nlohmann::json& n) { return n.is_number_integer() && n >= 0 && n <= kMostLines; };
        const bool isPair = corner.is_array() && corner.size() == 2 && isIndex(corner[0]) && isIndex(corner[1]);
        if (!isPair || settings.region.size() == kMostCorners) {
            fields.refuse("region", "must be a list of [line, beam]");
            break;
        }
        settings.region.push_back({corner[0].get<int>(), corner[1].get<int>()});
    }
    if (settings.region.size() == 1) fields.refuse("region", "needs two corners or more");
    fields.done();
    if (fields.problem()) return *fields.problem();
    return settings;
}

} // namespace edgescan::rocks
