// Runs of cells as numbers in one line of text.
#include "core/files/point_tables/cell_runs.h"

#include <algorithm>
#include <charconv>

namespace edgescan::files {

std::string cellRunsText(std::span<const std::uint32_t> cells) {
    std::string text;
    std::int64_t end = 0; // of the run before
    for (std::size_t n = 0, next = 0; n < cells.size(); n = next) {
        next = n + 1;
        while (next < cells.size() && cells[next] == cells[next - 1] + 1) ++next;
        if (n > 0) text += ' ';
        text += std::to_string(static_cast<std::int64_t>(cells[n]) - end);
        text += ' ';
        text += std::to_string(next - n);
        end = static_cast<std::int64_t>(cells[next - 1]) + 1;
    }
    return text;
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
