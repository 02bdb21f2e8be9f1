// Chooses the colours of rock faces.
#include "core/rocks/attributes/faces.h"

#include <algorithm>

namespace edgescan::rocks {
namespace {

constexpr int kHatchesAcross = 70; // number of hatch stripes across the picture ...
constexpr int kNarrowestHatch = 6; // ... but each at least this many cells wide
constexpr int kDarkOfTen = 4;      // tenths of a hatch that are dark

} // namespace

std::vector<std::uint8_t> rockColours(const RegionMap& map) {
    constexpr std::uint8_t kNone = 255;
    const std::size_t count = map.rocks + std::size_t{1};
    std::vector<std::vector<std::uint32_t>> neighbours(count);
    for (const RegionBorder& border : map.borders) {
        if (border.a == 0 || border.b > map.rocks) continue;
        neighbours[border.a].push_back(border.b);
        neighbours[border.b].push_back(border.a);
    }
    std::vector<std::uint8_t> colours(count, kNone);
    for (std::size_t rock = 1; rock < count; ++rock) {
        std::array<int, kRockColourCount> taken{};
        for (const std::uint32_t other : neighbours[rock]) {
            if (colours[other] != kNone) ++taken[colours[other]];
        }
        // The first choice depends only on the rock's first segment. If more than seven rocks meet, the least used colour follows.
        const std::size_t first = map.regions[rock].firstSegment * 2654435761U % kRockColourCount;
        std::size_t best = first;
        for (std::size_t step = 1; step < kRockColourCount; ++step) {
            const std::size_t next = (first + step) % kRockColourCount;
            if (taken[next] < taken[best]) best = next;
        }
        colours[rock] = static_cast<std::uint8_t>(best);
    }
    return colours;
}

bool isRockBorder(const Grid<std::uint32_t>& labels, int line, int beam) {
    const std::uint32_t own = labels.at(line, beam);
    if (own == 0) return false;
    const auto other = [&](int i, int j) { return !labels.contains(i, j) || labels.at(i, j) != own; };
    const auto none = [&](int i, int j) { return !labels.contains(i, j) || labels.at(i, j) == 0; };
    return other(line, beam + 1) || other(line + 1, beam) || none(line, beam - 1) || none(line - 1, beam);
}

std::optional<Rgb> Faces::at(int line, int beam) const {
    const std::uint32_t label = labels.at(line, beam);
    if (label == 0) return std::nullopt;
    if (isRockBorder(labels, line, beam)) return Rgb{8, 8, 8};
    const Rgb face = kRockFaceColours[colours[label]];
    if (hatched[label] == 0 || (line + beam) % hatchCells * 10 >= kDarkOfTen * hatchCells) return face;
    return Rgb{static_cast<std::uint8_t>(face.red / 3), static_cast<std::uint8_t>(face.green / 3),
               static_cast<std::uint8_t>(face.blue / 3)};
}

Faces rockFaces(const Study& study) {
    Faces faces{rockLabels(*study.segmentation, study.map), rockColours(study.map),
                std::vector<std::uint8_t>(study.map.rocks + std::size_t{1}), 6};
    for (const Rock& rock : study.rocks) faces.hatched[rock.label] = isDoubtful(rock) ? 1 : 0;
    faces.hatchCells = std::max(kNarrowestHatch, faces.labels.beams / kHatchesAcross);
    return faces;
}

} // namespace edgescan::rocks
