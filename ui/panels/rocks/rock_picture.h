// The picture of the rocks of one detection, made off the GUI thread.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/rocks/attributes/study.h"

#include <QImage>
#include <QLine>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace edgescan::ui {

/// Colour of points that belong to no rock: bytes red, green, blue, 255.
inline constexpr std::uint32_t kOutsideRocks = 0xff5c5c5cU;

/// Names that the operator gave to targets, by the cell of the target.
using RockNames = std::vector<std::pair<std::size_t, QString>>;

/// The rocks that the table lists and the views colour.
struct RockFilter {
    double smallestM = 0.0; ///< least visible width b, metres
    bool sureOnly = false;  ///< none with an uncertain outline

    [[nodiscard]] bool shows(const rocks::Rock& rock) const;
    bool operator==(const RockFilter&) const = default;
};

/// Immutable after construction. In the window all members are replaced together.
struct RockPicture {
    std::shared_ptr<const edges::Detection> detection;
    rocks::Study study;
    Grid<std::uint32_t> labels;        ///< lines x beams: 0 = not a rock, else Rock::label
    std::vector<std::uint8_t> colours; ///< per label: index into kRockFaceColours
    RockFilter filter;                 ///< other rocks have no face
    std::shared_ptr<const QImage>
        faces; ///< beams x lines: translucent, dark between rocks, hatched for uncertain outlines, striped outside the region
    std::shared_ptr<const std::vector<std::uint32_t>> points; ///< per cell, four bytes: red, green, blue, 255; gray outside rocks

    [[nodiscard]] std::uint32_t labelAt(std::size_t cell) const { return cell < labels.size() ? labels[cell] : 0; }
    /// The rock at the cell; null outside rocks.
    [[nodiscard]] const rocks::Rock* rockAt(std::size_t cell) const;
    [[nodiscard]] const rocks::Rock* rock(std::uint32_t label) const { return rocks::rockOf(study.rocks, label); }
    /// All names on the rock, as in the files (RockRows); empty without one.
    [[nodiscard]] QString nameOf(std::uint32_t label, const RockNames& names) const;
    /// The region at the cell, rock or not; null for cells that were not measured or belong to no segment.
    [[nodiscard]] const rocks::Region* regionAt(std::size_t cell) const;
};

[[nodiscard]] std::shared_ptr<const RockPicture> rockPicture(const std::shared_ptr<const edges::Detection>& detection, rocks::Study study,
                                                             const RockFilter& filter = {});

/// The outline of a rock: sides of cells, with ends at corners of cells (x = beam, y = line); and the cells along it, ascending.
struct RockOutline {
    std::vector<QLine> sides;
    std::vector<std::uint32_t> cells;
};
[[nodiscard]] RockOutline outlineOf(const Grid<std::uint32_t>& labels, std::uint32_t label);

/// "4 · visible a × b: 2.51 × 1.83 m ± 0.10 m · at 4.98 m", with a warning if the outline is uncertain.
[[nodiscard]] QString rockTip(const rocks::Rock& rock);
/// "▲ 2 parts that do not touch, 1.34 m apart"; empty for a rock in one piece.
[[nodiscard]] QString partsText(const rocks::Rock& rock);

/// "12 and 15", "12, 15 and 20".
[[nodiscard]] QString rocksText(const std::vector<std::uint32_t>& labels, QString (*one)(std::uint32_t label));
/// "≈ may be one with 12 and 15"; empty for a rock of its own.
[[nodiscard]] QString likelyText(const rocks::Rock& rock);

/// The caveat of every result about rocks: once on the screen, and in every text that leaves it.
[[nodiscard]] QString rockCaveat();

} // namespace edgescan::ui
