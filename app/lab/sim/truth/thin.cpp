// Thinning.
#include "app/lab/sim/truth/thin.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace edgescan::sim {
namespace {

// The eight neighbours, north first, clockwise.
constexpr std::array<std::array<int, 2>, 8> kSteps{{{-1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}}};

constexpr bool removable(unsigned neighbours, bool secondPass) {
    const auto set = [&](unsigned n) { return ((neighbours >> n) & 1U) != 0; };
    const bool n = set(0), ne = set(1), e = set(2), se = set(3), south = set(4), sw = set(5), w = set(6), nw = set(7);
    const int runs = (!n && (ne || e)) + (!e && (se || south)) + (!south && (sw || w)) + (!w && (nw || n));
    const int pairsOne = (nw || n) + (ne || e) + (se || south) + (sw || w);
    const int pairsTwo = (n || ne) + (e || se) + (south || sw) + (w || nw);
    const int pairs = std::min(pairsOne, pairsTwo);
    const bool kept = secondPass ? (n || ne || !se) && e : (south || sw || !nw) && w;
    return runs == 1 && pairs >= 2 && pairs <= 3 && !kept;
}

// For each of the two passes: removable() of every neighbourhood.
constexpr std::array<std::array<bool, 256>, 2> kRemovable = [] {
    std::array<std::array<bool, 256>, 2> table{};
    for (unsigned neighbours = 0; neighbours < 256; ++neighbours) {
        table[0][neighbours] = removable(neighbours, false);
        table[1][neighbours] = removable(neighbours, true);
    }
    return table;
}();

// A mask with a border of empty cells.
class Thinning {
public:
    explicit Thinning(const Grid<std::uint8_t>& mask)
        : width_(mask.beams + 2), set_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(mask.lines + 2)),
          asked_(set_.size(), -1) {
        for (std::size_t n = 0; n < kSteps.size(); ++n) offset_[n] = kSteps[n][0] * width_ + kSteps[n][1];
        for (int i = 0; i < mask.lines; ++i) {
            for (int j = 0; j < mask.beams; ++j) set_[place(i, j)] = mask.at(i, j) != 0 ? 1 : 0;
        }
    }

    [[nodiscard]] std::size_t place(int line, int beam) const {
        return static_cast<std::size_t>(line + 1) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(beam + 1);
    }
    [[nodiscard]] bool isSet(std::size_t k) const { return set_[k] != 0; }

    void run() {
        std::vector<std::size_t> all;
        for (std::size_t k = 0; k < set_.size(); ++k) {
            if (isSet(k)) all.push_back(k);
        }
        std::vector<std::size_t> before; // removed by the pass before
        std::vector<std::size_t> gone = removed(all, 0);
        for (int idle = gone.empty() ? 1 : 0, pass = 1; idle < 2; ++pass) {
            // A pass decides about a cell as it did two passes before, unless a neighbour was removed since.
            std::vector<std::size_t> next = pass == 1 ? removed(all, pass) : removed(neighboursOf(before, gone, pass), pass);
            before = std::move(gone);
            gone = std::move(next);
            idle = gone.empty() ? idle + 1 : 0;
        }
    }

private:
    [[nodiscard]] std::vector<std::size_t> removed(const std::vector<std::size_t>& candidates, int pass) {
        std::vector<std::size_t> gone;
        for (const std::size_t k : candidates) {
            unsigned neighbours = 0;
            for (unsigned n = 0; n < kSteps.size(); ++n) neighbours |= static_cast<unsigned>(set_[neighbour(k, n)]) << n;
            if (isSet(k) && kRemovable[static_cast<std::size_t>(pass % 2)][neighbours]) gone.push_back(k);
        }
        for (const std::size_t k : gone) set_[k] = 0;
        return gone;
    }

    [[nodiscard]] std::vector<std::size_t> neighboursOf(const std::vector<std::size_t>& one, const std::vector<std::size_t>& other,
                                                        int pass) {
        std::vector<std::size_t> cells;
        for (const auto* gone : {&one, &other}) {
            for (const std::size_t k : *gone) {
                for (unsigned n = 0; n < kSteps.size(); ++n) {
                    const std::size_t b = neighbour(k, n);
                    if (!isSet(b) || asked_[b] == pass) continue;
                    asked_[b] = pass;
                    cells.push_back(b);
                }
            }
        }
        return cells;
    }

    [[nodiscard]] std::size_t neighbour(std::size_t k, unsigned n) const { return k + static_cast<std::size_t>(offset_[n]); }

    int width_;
    std::vector<std::uint8_t> set_;
    std::vector<int> asked_; // the pass that has the cell on its list
    std::array<std::ptrdiff_t, 8> offset_{};
};

} // namespace

Grid<std::uint8_t> thinned(Grid<std::uint8_t> mask) {
    Thinning thinning(mask);
    thinning.run();
    for (int i = 0; i < mask.lines; ++i) {
        for (int j = 0; j < mask.beams; ++j) {
            if (!thinning.isSet(thinning.place(i, j))) mask.at(i, j) = 0;
        }
    }
    return mask;
}

} // namespace edgescan::sim
