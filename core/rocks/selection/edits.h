// Changes by the user: constraints given by cell and kind, which are applied again after any change of settings (docs/method/rocks.md,
// "Edits").
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

namespace edgescan::rocks {

enum class EditKind : std::uint8_t {
    Join,    ///< the pieces at these cells are one rock
    Part,    ///< the pieces at these two cells are never one rock
    Cut,     ///< a stroke through these cells: pieces are cut along it, and its two sides are never one rock
    Rock,    ///< the region at this cell is a rock
    NotRock, ///< it is not a rock
    Whole,   ///< the pieces at these cells are one rock, at every level: nothing else belongs to it
};

/// Cells are given by index k = line * beams + beam, never by the number of a region.
struct Edit {
    EditKind kind = EditKind::Join;
    std::vector<std::uint32_t> cells = {}; ///< number of cells: Join 2 or more; Part 2; Cut 2 or more; Rock, NotRock 1; Whole 1 or more

    bool operator==(const Edit&) const = default;
};

/// "join", "part", "cut", "rock", "not_rock", "whole".
[[nodiscard]] const char* rockEditName(EditKind kind);

/// How many changes an operator made: the parts of a cut belong to it.
[[nodiscard]] std::size_t changesByHand(std::span<const Edit> edits);

/// What two windows made of one list of edits: those of `theirs` without what `mine` took back, then what `mine` added. @param base what
/// both began with
[[nodiscard]] std::vector<Edit> mergedEdits(std::span<const Edit> base, std::span<const Edit> mine, std::span<const Edit> theirs);

/// The strokes among the edits.
[[nodiscard]] std::vector<CutLine> cutsOf(std::span<const Edit> edits);
/// Decisions of the edits about pairs of segments; a cell without a segment has no effect. `segments` must have been made with the same
/// strokes.
[[nodiscard]] std::vector<SegmentPair> pairsOf(const Segmentation& segments, std::span<const Edit> edits);
[[nodiscard]] std::vector<RockCall> rockCallsOf(const Segmentation& segments, std::span<const Edit> edits);

/// The map with the numbers that its rocks have in `plain`, the map of the segments `uncut` without edits: the rock that shares the most
/// cells keeps a number. The others get the next ones behind those of `plain`, in the order of the edits that made them.
[[nodiscard]] RegionMap withKeptNumbers(RegionMap map, const Segmentation& segments, const RegionMap& plain, const Segmentation& uncut,
                                        std::span<const Edit> edits);

/// All pieces of the regions at these cells are one rock. It names a cell of each segment: at the same level nothing of the regions is
/// outside the joined one. Empty for fewer than two regions.
[[nodiscard]] std::optional<Edit> joinOf(const Segmentation& segments, const RegionMap& map, std::span<const std::uint32_t> cells);

/// These segments are one rock; it names the first cell of each. Empty for fewer than two segments with a cell.
[[nodiscard]] std::optional<Edit> joinOfSegments(const Segmentation& segments, std::span<const std::uint32_t> group);

/// A cell in the middle of each segment, by segment; UINT32_MAX: it has no cell.
[[nodiscard]] std::vector<std::uint32_t> middleCells(const Grid<std::uint32_t>& segment, std::size_t segments);

/// Smaller pieces are not useful as rocks.
inline constexpr std::uint32_t kFewestSplit = 50;

/// A piece around a cell: a region at some level.
struct NestedPiece {
    std::vector<std::uint32_t> segments; ///< ascending
    std::uint32_t cells = 0;             ///< measured cells
    /// difference of the levels at which it appears and at which it is merged; 0 for pieces larger than the region
    double life = 0.0;
    /// the edit that makes it a rock: separates it from the piece it was merged with, or joins its parts
    Edit edit;
};

/// The pieces around a cell, from its segment on, each inside the next.
struct NestedPieces {
    std::vector<NestedPiece> pieces;
    /// index of the region at the current level, whose `part` has no cells; before it are smaller pieces, behind it larger ones
    std::size_t region = 0;
};
/// Empty if the cell does not belong to a segment. At most `mostLarger` pieces are larger than the region.
[[nodiscard]] NestedPieces nestedPieces(const Segmentation& segments, const MergeTree& tree, double level, std::uint32_t k,
                                        std::size_t mostLarger);

/// Index of the piece that a click splits off: of those with 50 or more cells the one with the longest life; the region's index if there is
/// no such piece.
[[nodiscard]] std::size_t bestSplit(const NestedPieces& line);
/// The edit of that piece. Empty if there is no such piece.
[[nodiscard]] std::optional<Edit> splitAt(const Segmentation& segments, const MergeTree& tree, double level, std::uint32_t k);

/// {"format": "edgescan-rock-edits/1", "lines": N, "beams": N, "edits": [{"kind": "join", "cells": [[line, beam], ...]}, ...]}
[[nodiscard]] nlohmann::ordered_json rockEditsToJson(std::span<const Edit> edits, int lines, int beams);
/// Error: damaged text, another format, another grid than lines x beams, unknown kinds, cells outside of the grid.
Result<std::vector<Edit>> rockEditsFromJson(const nlohmann::json& object, int lines, int beams, const std::string& where);

} // namespace edgescan::rocks
