// The rows of a growing sweep.
#include "core/scanner/sweep_assembly/sweep_grid.h"

#include <algorithm>
#include <limits>
#include <mutex>

namespace edgescan::scanner {
namespace {

constexpr float kNoIntensity = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kLostRow = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kKeptCopies = 4; // one copy is drawn, one is processed, one waits, and one is the next

} // namespace

/// Scans that can be reused. The thread that releases the last pointer gives a scan back.
class SweepGrid::Copies {
public:
    std::unique_ptr<Copy> popFree() {
        const std::lock_guard lock(mutex_);
        if (free_.empty()) return std::make_unique<Copy>();
        // The copy that follows the grid most closely needs the fewest rows to be copied.
        const auto best = std::max_element(free_.begin(), free_.end(), [](const auto& a, const auto& b) { return a->change < b->change; });
        std::unique_ptr<Copy> copy = std::move(*best);
        free_.erase(best);
        return copy;
    }
    void give(std::unique_ptr<Copy> copy) {
        const std::lock_guard lock(mutex_);
        if (free_.size() < kKeptCopies) free_.push_back(std::move(copy));
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Copy>> free_;
};

SweepGrid::Store::Store() : copies(std::make_shared<Copies>()) {}
SweepGrid::Store::Store(const Store&) : Store() {}
SweepGrid::Store& SweepGrid::Store::operator=(const Store& other) {
    if (this != &other) copies = std::make_shared<Copies>();
    return *this;
}

void SweepGrid::grow(int count) {
    if (count <= rows_) return;
    std::array<std::uint32_t, kCellStates> lost{};
    lost[static_cast<std::size_t>(CellState::Lost)] = static_cast<std::uint32_t>(beams_);
    at_.resize(static_cast<std::size_t>(count), kLostRow);
    rowCounts_.resize(static_cast<std::size_t>(count), lost);
    changed_.resize(static_cast<std::size_t>(count), ++change_);
    rows_ = count;
}

void SweepGrid::write(int row, int first, int stride, const RowCells& cells) {
    const auto& [rangeMm, state, intensity] = cells;
    if (at(row) == kLostRow) {
        at_[static_cast<std::size_t>(row)] = state_.size();
        rangeMm_.resize(rangeMm_.size() + static_cast<std::size_t>(beams_), 0.0F);
        state_.resize(rangeMm_.size(), CellState::Lost);
    }
    hasIntensity_ = hasIntensity_ || !intensity.empty();
    if (hasIntensity_) intensity_.resize(rangeMm_.size(), kNoIntensity);
    auto& counts = rowCounts_[static_cast<std::size_t>(row)];
    std::size_t k = at(row) + static_cast<std::size_t>(first);
    const std::size_t end = at(row) + static_cast<std::size_t>(beams_);
    for (std::size_t i = 0; i < rangeMm.size() && k < end; ++i, k += static_cast<std::size_t>(stride)) {
        --counts[static_cast<std::size_t>(state_[k])];
        ++counts[static_cast<std::size_t>(state[i])];
        rangeMm_[k] = rangeMm[i];
        state_[k] = state[i];
        if (!intensity.empty()) intensity_[k] = intensity[i];
    }
    changed_[static_cast<std::size_t>(row)] = ++change_;
}

bool SweepGrid::holds(int row, int first, int stride, std::size_t count) const {
    if (at(row) == kLostRow) return false;
    std::size_t k = at(row) + static_cast<std::size_t>(first);
    const std::size_t end = at(row) + static_cast<std::size_t>(beams_);
    for (std::size_t i = 0; i < count && k < end; ++i, k += static_cast<std::size_t>(stride)) {
        if (state_[k] != CellState::Lost) return true;
    }
    return false;
}

bool SweepGrid::same(int row, int first, int stride, const std::vector<float>& rangeMm, const std::vector<CellState>& state) const {
    if (at(row) == kLostRow) return state.empty();
    std::size_t k = at(row) + static_cast<std::size_t>(first);
    const std::size_t end = at(row) + static_cast<std::size_t>(beams_);
    for (std::size_t i = 0; i < rangeMm.size() && k < end; ++i, k += static_cast<std::size_t>(stride)) {
        if (state_[k] != state[i] || rangeMm_[k] != rangeMm[i]) return false;
    }
    return true;
}

/// Appends the cells of a row of `other`, which this grid does not have yet, as the cells of its row `to`.
void SweepGrid::appendCells(const SweepGrid& other, int row, std::size_t to) {
    if (other.at(row) == kLostRow) return;
    const auto from = static_cast<std::ptrdiff_t>(other.at(row));
    at_[to] = state_.size();
    const auto append = [&](auto& mine, const auto& theirs) {
        mine.insert(mine.end(), theirs.begin() + from, theirs.begin() + from + beams_);
    };
    append(rangeMm_, other.rangeMm_);
    append(state_, other.state_);
    if (hasIntensity_) append(intensity_, other.intensity_);
}

SweepGrid SweepGrid::cutFrom(int row) {
    SweepGrid rest(beams_), stays(beams_);
    rest.hasIntensity_ = stays.hasIntensity_ = hasIntensity_;
    rest.rows_ = rows_ - row;
    rest.rowCounts_.assign(rowCounts_.begin() + row, rowCounts_.end());
    rest.changed_.assign(static_cast<std::size_t>(rest.rows_), ++rest.change_);
    rest.at_.assign(static_cast<std::size_t>(rest.rows_), kLostRow);
    stays.at_.assign(static_cast<std::size_t>(row), kLostRow);
    for (int r = 0; r < rows_; ++r) (r < row ? stays : rest).appendCells(*this, r, static_cast<std::size_t>(r < row ? r : r - row));
    at_ = std::move(stays.at_);
    rangeMm_ = std::move(stays.rangeMm_);
    state_ = std::move(stays.state_);
    intensity_ = std::move(stays.intensity_);
    rowCounts_.resize(static_cast<std::size_t>(row));
    changed_.resize(static_cast<std::size_t>(row));
    rows_ = row;
    return rest;
}

std::array<std::size_t, kCellStates> SweepGrid::counts(int rows) const {
    std::array<std::size_t, kCellStates> sum{};
    for (int row = 0; row < rows; ++row) {
        for (std::size_t s = 0; s < sum.size(); ++s) sum[s] += rowCounts_[static_cast<std::size_t>(row)][s];
    }
    return sum;
}

std::shared_ptr<Scan> SweepGrid::scan(int rows) {
    std::unique_ptr<Copy> copy = store_.copies->popFree();
    Scan& scan = copy->scan;
    if (scan.rangeMm.beams != beams_) {
        scan.rangeMm.beams = scan.state.beams = beams_;
        copy->rows = 0;
    }
    if ((scan.intensity.size() > 0) != hasIntensity_) { // the first row with intensities came since
        scan.intensity = {};
        copy->rows = 0;
    }
    if (hasIntensity_) {
        scan.intensity.lines = rows;
        scan.intensity.beams = beams_;
        scan.intensity.cells.resize(index(rows));
    }
    scan.rangeMm.lines = scan.state.lines = rows;
    scan.rangeMm.cells.resize(index(rows));
    scan.state.cells.resize(index(rows));
    const auto wide = static_cast<std::size_t>(beams_);
    for (int row = 0; row < rows; ++row) {
        if (row < copy->rows && changed_[static_cast<std::size_t>(row)] <= copy->change) continue;
        if (at(row) == kLostRow) {
            std::fill_n(scan.rangeMm.line(row), wide, 0.0F);
            std::fill_n(scan.state.line(row), wide, CellState::Lost);
            if (hasIntensity_) std::fill_n(scan.intensity.line(row), wide, kNoIntensity);
            continue;
        }
        const auto from = static_cast<std::ptrdiff_t>(at(row));
        std::copy_n(rangeMm_.begin() + from, wide, scan.rangeMm.line(row));
        std::copy_n(state_.begin() + from, wide, scan.state.line(row));
        if (hasIntensity_) std::copy_n(intensity_.begin() + from, wide, scan.intensity.line(row));
    }
    copy->rows = rows;
    copy->change = change_;
    const std::shared_ptr<Copies> copies = store_.copies;
    const std::shared_ptr<Copy> shared(copy.release(), [copies](Copy* done) { copies->give(std::unique_ptr<Copy>(done)); });
    return {shared, &shared->scan};
}

} // namespace edgescan::scanner
