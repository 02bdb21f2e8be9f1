// Edits as JSON.
#include "core/rocks/selection/edits.h"

#include <nlohmann/json.hpp>

#include <array>
#include <limits>

namespace edgescan::rocks {
namespace {

constexpr const char* kEditsFormat = "edgescan-rock-edits/1";
constexpr std::size_t kMostEdits = 100'000;
constexpr std::size_t kMostCells = 100'000; // of one edit

struct EditRow {
    EditKind kind;
    const char* name;
    std::size_t fewest, most; // number of cells
};
constexpr std::array kEdits{
    EditRow{EditKind::Join, "join", 2, kMostCells}, EditRow{EditKind::Part, "part", 2, 2},
    EditRow{EditKind::Cut, "cut", 2, kMostCells},   EditRow{EditKind::Rock, "rock", 1, 1},
    EditRow{EditKind::NotRock, "not_rock", 1, 1},   EditRow{EditKind::Whole, "whole", 1, kMostCells},
};

using Json = nlohmann::json;

// Empty if it is not a cell of the grid.
std::optional<std::uint32_t> cellOf(const Json& pair, int lines, int beams) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number_integer() || !pair[1].is_number_integer()) return std::nullopt;
    if (pair[0] < 0 || pair[0] >= lines || pair[1] < 0 || pair[1] >= beams) return std::nullopt;
    return pair[0].get<std::uint32_t>() * static_cast<std::uint32_t>(beams) + pair[1].get<std::uint32_t>();
}

// Reads an edit. Returns an empty text, or the fault.
std::string read(const Json& object, int lines, int beams, Edit& edit) {
    if (!object.is_object() || object.size() != 2 || !object.contains("kind") || !object.contains("cells"))
        return "is not {\"kind\": ..., \"cells\": ...}";
    const auto row = std::find_if(kEdits.begin(), kEdits.end(), [&](const EditRow& r) { return object["kind"] == r.name; });
    if (row == kEdits.end()) return "has a kind that is not join, part, cut, rock, not_rock or whole";
    edit.kind = row->kind;
    const Json& cells = object["cells"];
    if (!cells.is_array() || cells.size() < row->fewest || cells.size() > row->most) return "has too few or too many cells for its kind";
    for (const Json& pair : cells) {
        const auto k = cellOf(pair, lines, beams);
        if (!k) return "names a cell that does not exist in the scan";
        edit.cells.push_back(*k);
    }
    return {};
}

} // namespace

const char* rockEditName(EditKind kind) { return kEdits[static_cast<std::size_t>(kind)].name; }

nlohmann::ordered_json rockEditsToJson(std::span<const Edit> edits, int lines, int beams) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const auto width = static_cast<std::uint32_t>(beams);
    for (const Edit& edit : edits) {
        nlohmann::ordered_json cells = nlohmann::ordered_json::array();
        for (const std::uint32_t k : edit.cells) cells.push_back({k / width, k % width});
        list.push_back({{"kind", rockEditName(edit.kind)}, {"cells", cells}});
    }
    return {{"format", kEditsFormat}, {"lines", lines}, {"beams", beams}, {"edits", list}};
}

Result<std::vector<Edit>> rockEditsFromJson(const Json& object, int lines, int beams, const std::string& where) {
    const auto refused = [&](const std::string& what) { return Error{what, where, "give edits that were made on this scan"}; };
    if (!object.is_object() || !object.contains("format") || object["format"] != kEditsFormat)
        return refused(std::string("these are not edits of rocks (") + kEditsFormat + ")");
    for (const auto& [key, value] : object.items()) {
        if (key != "format" && key != "lines" && key != "beams" && key != "edits")
            return refused("there is no key \"" + key + "\" in edits of rocks");
    }
    if (!object.contains("lines") || !object.contains("beams") || object["lines"] != lines || object["beams"] != beams)
        return refused("the edits are not for a grid of " + std::to_string(lines) + " lines x " + std::to_string(beams) + " beams");
    if (!object.contains("edits") || !object["edits"].is_array() || object["edits"].size() > kMostEdits)
        return refused("the edits hold no list \"edits\" of at most " + std::to_string(kMostEdits));
    std::vector<Edit> edits;
    for (const Json& item : object["edits"]) {
        Edit edit;
        const std::string wrong = read(item, lines, beams, edit);
        if (!wrong.empty()) return refused("edit " + std::to_string(edits.size()) + " " + wrong);
        edits.push_back(std::move(edit));
    }
    return edits;
}

} // namespace edgescan::rocks
