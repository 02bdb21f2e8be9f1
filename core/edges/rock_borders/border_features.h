// The numbers that distinguish the border of a rock from a fold within one (docs/method/edges.md, "Rock border or fold").
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace edgescan::edges {

/// What a group of features is about.
enum class BorderEvidence : std::uint8_t {
    Steps,    ///< jumps at the cell and around it, voids
    Fold,     ///< the fold at the cell
    Across,   ///< the course of the surface across the edge
    Along,    ///< the same along the edge
    Height,   ///< how much nearer the cell is than its surroundings
    Folds,    ///< folds and other edges around it
    Distance, ///< range, distance of points, noise
};
inline constexpr int kBorderEvidences = 7;

inline constexpr int kBorderFeatures = 54;
/// Lengths across and along the edge are in distances between neighbouring points.
using BorderFeatures = std::array<float, kBorderFeatures>;

[[nodiscard]] BorderEvidence evidenceOf(int feature);

/// Sums over the rectangle from the first cell on. Differences of four of them give the sum over any window.
template <class T>
class WindowSums {
public:
    WindowSums() = default;
    /// `valueOf(k)`: the value of a cell.
    template <class ValueOf>
    WindowSums(int lines, int beams, ValueOf valueOf) : lines_(lines), beams_(beams), sums_(lines + 1, beams + 1) {
        for (int i = 0; i < lines; ++i) {
            T sum = 0;
            const T* above = sums_.line(i);
            T* to = sums_.line(i + 1);
            const std::size_t first = static_cast<std::size_t>(i) * static_cast<std::size_t>(beams);
            for (int j = 0; j < beams; ++j) {
                sum += valueOf(first + static_cast<std::size_t>(j));
                to[j + 1] = above[j + 1] + sum;
            }
        }
    }
    /// The sum within `reach` lines and beams of a cell, and the number of cells there.
    struct Window {
        T sum = 0;
        int cells = 0;
    };
    [[nodiscard]] Window around(int line, int beam, int reach) const {
        const int up = std::max(0, line - reach), down = std::min(lines_, line + reach + 1);
        const int left = std::max(0, beam - reach), right = std::min(beams_, beam + reach + 1);
        return {sums_.at(down, right) - sums_.at(up, right) - sums_.at(down, left) + sums_.at(up, left), (down - up) * (right - left)};
    }

private:
    int lines_ = 0, beams_ = 0;
    Grid<T> sums_;
};

/// Measures the features of single cells. The references must outlive it; several threads may use it.
class BorderMeasure {
public:
    BorderMeasure(const DepthSurface& surface, const DepthResponses& responses, const Settings& settings);
    /// False if the grid ends within 4 cells across the edge, or the cell has no range up to 60 m: then `features` are undefined.
    [[nodiscard]] bool measure(std::size_t cell, BorderFeatures& features) const;

private:
    struct Course;
    [[nodiscard]] float rangeAt(int line, int beam) const;
    [[nodiscard]] Course courseAt(int line, int beam) const;
    [[nodiscard]] float heightAt(int line, int beam, int reach) const;
    [[nodiscard]] float largestJump(int line, int beam, int reach) const;

    const DepthSurface& surface_;
    const DepthResponses& responses_;
    float creases_;                           // crease angle of the settings in units of 30 degrees
    WindowSums<std::uint64_t> inverseRanges_; // of u in kUnitOfU
    WindowSums<std::uint64_t> edges_;         // cells that fold, and in the upper half candidates of edges
    WindowSums<std::uint32_t> folds_;         // of folds in kUnitOfFold
};

} // namespace edgescan::edges
