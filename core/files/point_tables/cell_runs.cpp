// Runs of cells as numbers in one line of text.
#include "core/files/point_tables/cell_runs.h"
#include "core/scan/grid/marked_cells.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace edgescan::files {

namespace {

/// Grows by one cell after the other.
class RunsText {
public:
    void add(std::uint32_t cell) {
        if (cells_ > 0 && cell == first_ + cells_) return void(++cells_);
        close();
        first_ = cell;
        cells_ = 1;
    }
    std::string text() {
        close();
        return std::move(text_);
    }

private:
    void close() {
        if (cells_ == 0) return;
        if (!text_.empty()) text_ += ' ';
        text_ += std::to_string(first_ - end_);
        text_ += ' ';
        text_ += std::to_string(cells_);
        end_ = first_ + cells_;
    }

    std::string text_;
    std::int64_t first_ = 0, cells_ = 0, end_ = 0; // of the run that grows; behind the run before
};

} // namespace

std::string cellRunsText(const Scan& scan, const Grid<std::uint8_t>* edgeMask, bool withAttached) {
    const auto chosen = [&](std::size_t k) { return scan.state[k] == CellState::Valid && (edgeMask == nullptr || (*edgeMask)[k] != 0); };
    RunsText runs;
    const auto addChosen = [&](std::size_t k) {
        if (chosen(k)) runs.add(static_cast<std::uint32_t>(k));
    };
    if (edgeMask != nullptr) {
        forEachNotZero(edgeMask->cells, addChosen);
    } else {
        for (std::size_t k = 0; k < scan.cells(); ++k) addChosen(k);
    }
    for (std::size_t n = 0; withAttached && n < scan.attached.size(); ++n) {
        if (chosen(scan.attached[n].cell)) runs.add(scan.attached[n].cell);
    }
    return runs.text();
}

std::optional<std::vector<std::uint32_t>> cellsOfRuns(std::string_view text, std::size_t points, std::size_t gridCells) {
    constexpr std::int64_t kMost = std::int64_t{1} << 32U; // sums of two stay far from the ends
    std::vector<std::uint32_t> cells;
    cells.reserve(std::min(points, gridCells));
    const char* at = text.data();
    const char* const textEnd = at + text.size();
    const auto number = [&]() -> std::optional<std::int64_t> {
        while (at < textEnd && *at == ' ') ++at;
        std::int64_t value = 0;
        const auto [end, problem] = std::from_chars(at, textEnd, value);
        at = end;
        if (problem != std::errc{} || value < -kMost || value > kMost) return std::nullopt;
        return value;
    };
    std::int64_t end = 0;
    while (at < textEnd) {
        const auto step = number(), count = number();
        if (!step || !count || *count < 1) return std::nullopt;
        const std::int64_t first = end + *step;
        end = first + *count;
        if (first < 0 || end > static_cast<std::int64_t>(gridCells)) return std::nullopt;
        if (cells.size() + static_cast<std::size_t>(*count) > points) return std::nullopt;
        for (std::int64_t k = first; k < end; ++k) cells.push_back(static_cast<std::uint32_t>(k));
    }
    if (cells.size() != points) return std::nullopt;
    return cells;
}

} // namespace edgescan::files
