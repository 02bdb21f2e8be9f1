// One value per cell of a sweep: lines x beams, row-major. Cell k = line * beams + beam is one pixel, one measurement and one point.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace edgescan {

template <class T>
struct Grid {
    int lines = 0;
    int beams = 0;
    std::vector<T> cells; ///< lines x beams, row-major

    Grid() = default;
    Grid(int lineCount, int beamCount, T fill = T{})
        : lines(lineCount), beams(beamCount), cells(static_cast<std::size_t>(lineCount) * static_cast<std::size_t>(beamCount), fill) {}
    Grid(int lineCount, int beamCount, std::vector<T> values) : lines(lineCount), beams(beamCount), cells(std::move(values)) {}

    [[nodiscard]] std::size_t size() const { return cells.size(); }
    [[nodiscard]] std::size_t index(int line, int beam) const {
        return static_cast<std::size_t>(line) * static_cast<std::size_t>(beams) + static_cast<std::size_t>(beam);
    }
    [[nodiscard]] bool contains(int line, int beam) const { return line >= 0 && line < lines && beam >= 0 && beam < beams; }

    T& at(int line, int beam) { return cells[index(line, beam)]; }
    const T& at(int line, int beam) const { return cells[index(line, beam)]; }
    T& operator[](std::size_t k) { return cells[k]; }
    const T& operator[](std::size_t k) const { return cells[k]; }
    T* line(int i) { return cells.data() + index(i, 0); }
    const T* line(int i) const { return cells.data() + index(i, 0); }

    bool operator==(const Grid&) const = default;
};

} // namespace edgescan
