// At how many of some ascending thresholds each cell can be an edge, and the number of edges at each of them.
#pragma once

#include "core/base/grid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace edgescan::edges {

/// At most this many thresholds.
inline constexpr std::size_t kMostLevels = 255;

/// Of linked cells: a chain is an edge if all its cells are weak, one of them is strong, and it is long enough (8 neighbours).
struct EdgeLevels {
    Grid<std::uint8_t> weak;            ///< at how many thresholds, from the first one on, the cell is weak
    Grid<std::uint8_t> strong;          ///< the same for strong; never more than weak
    int minimumLength = 1;              ///< cells
    std::vector<std::uint32_t> apart{}; ///< cells that link chains but are not counted with them, ascending, each once
    std::size_t atEach = 0;             ///< number of cells that are edges at every threshold; they are apart
};

/// Number of edge cells at each of so many thresholds.
[[nodiscard]] std::vector<std::size_t> edgeCounts(const EdgeLevels& levels, std::size_t thresholds);

/// How many of some limits a value exceeds.
class LevelScale {
public:
    /// Ascending, from 0, at least one.
    explicit LevelScale(std::vector<double> limits);
    [[nodiscard]] double least() const { return limits_.front(); }
    [[nodiscard]] std::uint8_t of(double value) const {
        if (!(value > least())) return 0;
        std::size_t level = before_[placeOf(value)];
        while (level < limits_.size() && value > limits_[level]) ++level;
        return static_cast<std::uint8_t>(level);
    }

private:
    static constexpr std::size_t kPlaces = 1024;
    // Never less for a larger value, so that limits at lower places are exceeded.
    [[nodiscard]] std::size_t placeOf(double value) const {
        return static_cast<std::size_t>(std::min(static_cast<double>(kPlaces), value * perUnit_));
    }

    std::vector<double> limits_;
    double perUnit_;
    std::array<std::uint8_t, kPlaces + 1> before_{}; // number of limits at lower places
};

/// A cell is weak at a threshold if its value exceeds the weak limit there, and strong if it exceeds the strong one, too.
/// `valuesOfLine(line)` gives a pointer to the values of a line, valid until the next call.
template <class ValuesOfLine>
[[nodiscard]] EdgeLevels edgeLevels(int lines, int beams, ValuesOfLine valuesOfLine, std::vector<double> weakLimits,
                                    std::vector<double> strongLimits, int minimumLength = 1) {
    const LevelScale weak(std::move(weakLimits)), strong(std::move(strongLimits));
    EdgeLevels levels{Grid<std::uint8_t>(lines, beams), Grid<std::uint8_t>(lines, beams), minimumLength};
    for (int line = 0; line < lines; ++line) {
        const auto* values = valuesOfLine(line);
        const auto least = static_cast<std::remove_cvref_t<decltype(*values)>>(weak.least()); // no value is between it and the limit
        std::uint8_t* const weakOfLine = levels.weak.line(line);
        std::uint8_t* const strongOfLine = levels.strong.line(line);
        for (int j = 0; j < beams; ++j) {
            if (!(values[j] >= least)) continue;
            weakOfLine[j] = weak.of(static_cast<double>(values[j]));
            strongOfLine[j] = std::min(weakOfLine[j], strong.of(static_cast<double>(values[j])));
        }
    }
    return levels;
}

template <class T>
[[nodiscard]] EdgeLevels edgeLevels(const Grid<T>& values, std::vector<double> weakLimits, std::vector<double> strongLimits,
                                    int minimumLength = 1) {
    return edgeLevels(
        values.lines, values.beams, [&values](int line) { return values.line(line); }, std::move(weakLimits), std::move(strongLimits),
        minimumLength);
}

} // namespace edgescan::edges
