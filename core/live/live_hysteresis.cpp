// Growing edges through weak cells.
#include "core/live/live_hysteresis.h"

#include <algorithm>

namespace edgescan {
namespace {

constexpr std::uint8_t kEdge = 255;

} // namespace

void LiveHysteresis::update(const Grid<EdgeClass>& classes, int settledNow) {
    for (const std::uint32_t k : borrowed_) mask_[k] = 0;
    borrowed_.clear();
    const auto wide = static_cast<std::size_t>(mask_.beams);
    classes_.cells.resize(static_cast<std::size_t>(settled_) * wide);
    classes_.cells.insert(classes_.cells.end(), classes.cells.begin(), classes.cells.end());
    classes_.lines = mask_.lines = settled_ + classes.lines;
    mask_.cells.resize(static_cast<std::size_t>(settled_) * wide);
    mask_.cells.resize(classes_.cells.size(), 0);

    const int before = settled_;
    settled_ = before + settledNow;
    seed(before, settled_);
    grow(settled_, true);
    seed(settled_, mask_.lines);
    grow(mask_.lines, false);
}

/// Strong cells, and weak cells beside what is an edge already, are edges.
void LiveHysteresis::seed(int firstRow, int lastRow) {
    for (int row = firstRow; row < lastRow; ++row) {
        const EdgeClass* classes = classes_.line(row);
        for (int beam = 0; beam < mask_.beams; ++beam) {
            if (classes[beam] == EdgeClass::None) continue;
            const std::size_t k = mask_.index(row, beam);
            if (mask_[k] != 0 || (classes[beam] == EdgeClass::Weak && !touchesEdge(row, beam, lastRow))) continue;
            mask_[k] = kEdge;
            pending_.push_back(static_cast<std::uint32_t>(k));
        }
    }
}

bool LiveHysteresis::touchesEdge(int row, int beam, int lastRow) const {
    for (int i = std::max(0, row - 1); i <= std::min(lastRow - 1, row + 1); ++i) {
        for (int j = std::max(0, beam - 1); j <= std::min(mask_.beams - 1, beam + 1); ++j) {
            if (mask_.at(i, j) != 0) return true;
        }
    }
    return false;
}

void LiveHysteresis::grow(int lastRow, bool forGood) {
    const auto beams = static_cast<std::uint32_t>(mask_.beams);
    while (!pending_.empty()) {
        const std::uint32_t cell = pending_.back();
        pending_.pop_back();
        const int row = static_cast<int>(cell / beams);
        const int beam = static_cast<int>(cell % beams);
        if (!forGood && row < settled_) borrowed_.push_back(cell);
        for (int i = std::max(0, row - 1); i <= std::min(lastRow - 1, row + 1); ++i) {
            for (int j = std::max(0, beam - 1); j <= std::min(mask_.beams - 1, beam + 1); ++j) {
                const std::size_t k = mask_.index(i, j);
                if (mask_[k] != 0 || classes_[k] == EdgeClass::None) continue;
                mask_[k] = kEdge;
                pending_.push_back(static_cast<std::uint32_t>(k));
            }
        }
    }
}

} // namespace edgescan
