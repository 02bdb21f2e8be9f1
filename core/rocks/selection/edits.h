// What a person changed by hand: constraints by cell and kind, applied anew whatever is turned (docs/rocks-method.md, "Edits").
#pragma once

#include "core/base/result.h"
#include "core/rocks/segmentation/cuts.h"
#include "core/rocks/selection/rock_map.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

enum class RockEditKind : std::uint8_t {
    Join,    ///< the pieces at these cells are one rock
    Part,    ///< the pieces at these two cells are never one rock
    Cut,     ///< a stroke through these cells: pieces are cut along it, and its two sides are never one rock
    Rock,    ///< what lies at this cell is a rock
    NotRock, ///< it is none
};

/// By cell index k = line * beams + beam, never by the number of a region.
struct RockEdit {
    RockEditKind kind = RockEditKind::Join;
    std::vector<std::uint32_t> cells = {}; ///< Join: 2 and more; Part: 2; Cut: 2 and more; Rock, NotRock: 1

    bool operator==(const RockEdit&) const = default;
};

/// "join", "part", "cut", "rock", "not_rock".
[[nodiscard]] const char* rockEditName(RockEditKind kind);

/// The strokes among the edits.
[[nodiscard]] std::vector<CutLine> cutsOf(std::span<const RockEdit> edits);
/// What the edits say of leaves; a cell without a leaf says nothing. `leaves` must have been made with the same strokes.
[[nodiscard]] std::vector<LeafPair> pairsOf(const RockLeaves& leaves, std::span<const RockEdit> edits);
[[nodiscard]] std::vector<CalledLeaf> calledOf(const RockLeaves& leaves, std::span<const RockEdit> edits);

/// Smaller pieces are no rocks that anybody would want.
inline constexpr std::uint32_t kFewestSplit = 50;

/// A piece round a cell: at some level it is a region.
struct RockAncestor {
    std::vector<std::uint32_t> leaves; ///< ascending
    std::uint32_t cells = 0;           ///< measured
    double life = 0.0;                 ///< levels between its making and its merging; 0 for what is larger than the region
    RockEdit part;                     ///< makes a rock of it: keeps it apart from what it was merged with, or joins it up
};

/// The pieces round a cell from its leaf on, each inside the next.
struct RockLine {
    std::vector<RockAncestor> pieces;
    std::size_t region =
        0; ///< place of the region at the level, whose `part` has no cells; before it what is smaller, behind what is larger
};
/// Empty where the cell belongs to no leaf. At most `mostLarger` pieces are larger than the region.
[[nodiscard]] RockLine rockLine(const RockLeaves& leaves, const MergeTree& tree, double level, std::uint32_t k, std::size_t mostLarger);

/// Place of the one that a click splits off: of 50 cells and more the one with the longest life; that of the region where there is none.
[[nodiscard]] std::size_t bestSplit(const RockLine& line);
/// Its edit. Empty where there is none.
[[nodiscard]] std::optional<RockEdit> splitAt(const RockLeaves& leaves, const MergeTree& tree, double level, std::uint32_t k);

/// {"format": "edgescan-rock-edits/1", "lines": N, "beams": N, "edits": [{"kind": "join", "cells": [[line, beam], ...]}, ...]}
[[nodiscard]] nlohmann::ordered_json rockEditsToJson(std::span<const RockEdit> edits, int lines, int beams);
/// Error: damaged, of another format, for another grid than lines x beams, unknown kinds, cells that do not exist.
Result<std::vector<RockEdit>> rockEditsFromJson(const nlohmann::json& object, int lines, int beams, const std::string& where);

} // namespace edgescan
