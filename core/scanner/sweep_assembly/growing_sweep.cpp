// The rows of one sweep.
#include "core/scanner/sweep_assembly/growing_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <string_view>

namespace edgescan::scanner {
namespace {

constexpr float kNoIntensity = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kLostRow = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kKeptCopies = 4; // one copy is drawn, one is processed, one waits, and one is the next

constexpr int kMostParts = 8;
constexpr double kSameDeg = 1e-6; // angles are snapped or given in 1/10000 degree
constexpr double kAlignedPart = 0.01;

/// The part that starts `offset` steps after part 0, or -1.
int partAt(double offset, int parts) {
    const double part = offset * parts;
    const double nearest = std::round(part);
    if (std::abs(part - nearest) > kAlignedPart * parts || nearest < 0 || nearest >= parts) return -1;
    return static_cast<int>(nearest);
}

constexpr std::size_t kEarlyLines = 16;       // after this many lines the interlacing of lines is known
constexpr int kAnglesWaitedFor = 8;           // number of rows that a stepper reading may be late
constexpr int kMostCells = 50'000'000;        // of one sweep
constexpr std::int64_t kMostLost = 4'000'000; // cells of one sweep, and as many again as were measured

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

std::optional<int> InterlacedBeams::partOf(const BeamGrid& grid) const {
    if (std::abs(grid.stepDeg - stepDeg) > kSameDeg) return std::nullopt;
    const bool same = std::abs(grid.startDeg - startDeg) <= kSameDeg;
    const int part = same ? 0 : stepDeg > 0 ? partAt((grid.startDeg - startDeg) / stepDeg, parts) : -1;
    return part >= 0 && grid.beams <= beamsOf(part) ? std::optional(part) : std::nullopt;
}

std::vector<double> InterlacedBeams::beamDeg() const {
    std::vector<double> degrees;
    degrees.reserve(static_cast<std::size_t>(beams));
    // As in the telegram for part 0, and snapped to the grid for the starts of the other parts.
    for (int j = 0; j < beams; ++j) {
        const int part = j % parts;
        const double start = part == 0 ? startDeg : snappedDeg(startDeg + stepDeg * part / parts);
        degrees.push_back(start + j / parts * stepDeg);
    }
    return degrees;
}

std::optional<InterlacedBeams> interlacedBeams(std::span<const BeamGrid> grids) {
    if (grids.empty()) return std::nullopt;
    InterlacedBeams all{grids[0].startDeg, grids[0].stepDeg, 1, 0};
    for (const BeamGrid& grid : grids) all.startDeg = std::min(all.startDeg, grid.startDeg);
    const auto fits = [&](int parts) {
        return std::all_of(grids.begin(), grids.end(), [&](const BeamGrid& grid) {
            if (std::abs(grid.stepDeg - all.stepDeg) > kSameDeg) return false;
            if (std::abs(grid.startDeg - all.startDeg) <= kSameDeg) return true;
            return all.stepDeg > 0 && partAt((grid.startDeg - all.startDeg) / all.stepDeg, parts) >= 0;
        });
    };
    while (all.parts <= kMostParts && !fits(all.parts)) ++all.parts;
    if (all.parts > kMostParts) return std::nullopt;
    for (const BeamGrid& grid : grids) {
        const int part = all.parts == 1 ? 0 : partAt((grid.startDeg - all.startDeg) / all.stepDeg, all.parts);
        if (grid.beams > 0) all.beams = std::max(all.beams, part + (grid.beams - 1) * all.parts + 1);
    }
    return all;
}

int GrowingSweep::rowOf(std::int64_t slot) const {
    const std::int64_t place = slot - origin_;
    return place < 0 ? -1 : static_cast<int>(place / beams_.parts);
}

/// The slot for this part, after `lost` lost telegrams.
std::int64_t GrowingSweep::slotOf(int part, std::int64_t lost) const {
    std::int64_t slot = lastSlot_ + 1 + lost;
    if (!laidOut_ || beams_.parts == 1) return slot;
    const std::int64_t wanted = origin_ + turns_[static_cast<std::size_t>(part)];
    const std::int64_t ahead = (wanted - slot) % beams_.parts;
    return slot + (ahead < 0 ? ahead + beams_.parts : ahead);
}

GrowingSweep::Place GrowingSweep::push(const SweepLine& line, std::int64_t lost, const SweepSettings& settings) {
    auto part = beams_.partOf(line.beams);
    const bool early = lastSlot_ < 0 || (!early_.empty() && early_.size() < kEarlyLines);
    const std::int64_t next = lastSlot_ + 1 + lost;
    if (early && (!part || lastSlot_ < 0)) {
        std::vector<BeamGrid> grids{line.beams};
        for (const Early& other : early_) grids.push_back(other.line.beams);
        if (!layOut(grids)) return Place::Misfit;
        early_.push_back({line, next});
        lastSlot_ = next;
        rebuild();
        return Place::Added;
    }
    if (!part) return Place::Misfit;
    const std::int64_t slot = slotOf(*part, lost);
    if (slot - origin_ >= static_cast<std::int64_t>(mostRows(settings)) * beams_.parts) return Place::Full;
    if (early) early_.push_back({line, slot});
    write(line, slot, *part);
    return Place::Added;
}

int GrowingSweep::mostRows(const SweepSettings& settings) const {
    const int allowed = std::min(settings.mostLines, kMostCells / std::max(beams_.beams, 1));
    return settings.expectedLines > 0 ? std::min(settings.expectedLines, allowed) : allowed;
}

std::int64_t GrowingSweep::mayBeLost() const {
    const std::int64_t measured = placed();
    const std::int64_t lost = static_cast<std::int64_t>(grid_.rows()) * beams_.parts - measured;
    return std::max<std::int64_t>(0, measured - lost + kMostLost * beams_.parts / std::max(beams_.beams, 1));
}

GrowingSweep::Repeat GrowingSweep::repeat(const SweepLine& line, std::int64_t behind) {
    const std::int64_t slot = lastSlot_ - behind;
    if (lastSlot_ < 0 || behind < 0 || slot < origin_ || rowOf(slot) >= grid_.rows()) return Repeat::Outside;
    const auto part = beams_.partOf(line.beams);
    if (!part || (slot - origin_) % beams_.parts != turns_[static_cast<std::size_t>(*part)]) return Repeat::Other;
    const int row = rowOf(slot);
    if (grid_.holds(row, *part, beams_.parts, line.ranges.state.size()))
        return grid_.same(row, *part, beams_.parts, line.ranges.rangeMm, line.ranges.state) ? Repeat::Same : Repeat::Other;
    if (!early_.empty() && early_.size() < kEarlyLines) {
        const auto after = std::find_if(early_.begin(), early_.end(), [&](const Early& other) { return other.slot > slot; });
        early_.insert(after, {line, slot});
    }
    write(line, slot, *part);
    return Repeat::Filled;
}

std::int64_t GrowingSweep::placed() const {
    std::int64_t sum = 0;
    for (const int missing : missing_) sum += beams_.parts - missing;
    return sum;
}

bool GrowingSweep::layOut(std::span<const BeamGrid> grids) {
    const auto beams = interlacedBeams(grids);
    if (!beams) return false;
    beams_ = *beams;
    return true;
}

/// Places all early lines again after the beams have changed.
void GrowingSweep::rebuild() {
    const auto parts = static_cast<std::size_t>(beams_.parts);
    std::vector<std::int64_t> firstSlot(parts, -1);
    for (const Early& early : early_) {
        std::int64_t& first = firstSlot[static_cast<std::size_t>(beams_.partOf(early.line.beams).value_or(0))];
        if (first < 0) first = early.slot;
    }
    // A row begins with part 0. Telegrams before the first part 0 are not a whole row and are left out.
    origin_ = firstSlot[0];
    for (std::size_t part = 1; part < parts && origin_ < 0; ++part) {
        if (firstSlot[part] >= 0) origin_ = firstSlot[part] + static_cast<std::int64_t>(parts - part);
    }
    turns_.assign(parts, 0);
    for (std::size_t part = 0; part < parts; ++part) {
        const std::int64_t after = firstSlot[part] >= 0 ? firstSlot[part] - origin_ : static_cast<std::int64_t>(part);
        const auto count = static_cast<std::int64_t>(parts);
        turns_[part] = static_cast<int>((after % count + count) % count);
    }
    laidOut_ = true;
    grid_ = SweepGrid(beams_.beams);
    facts_.clear();
    missing_.clear();
    wholeRows_ = 0;
    leftOut_ = 0;
    firstFlagged_ = -1;
    for (const Early& early : early_) write(early.line, early.slot, beams_.partOf(early.line.beams).value_or(0));
}

void GrowingSweep::write(const SweepLine& line, std::int64_t slot, int part) {
    lastSlot_ = std::max(lastSlot_, slot);
    const int row = rowOf(slot);
    if (row >= 0) grow(row + 1);
    if (row < 0 || grid_.holds(row, part, beams_.parts, line.ranges.state.size())) {
        ++leftOut_;
        return;
    }
    grid_.write(row, part, beams_.parts, {line.ranges.rangeMm, line.ranges.state, line.intensity});
    --missing_[static_cast<std::size_t>(row)];
    LineTiming& facts = facts_[static_cast<std::size_t>(row)];
    if (!facts.received) {
        facts = line.facts;
        facts.received = true;
        facts.turns = turns_[static_cast<std::size_t>(part)];
    }
    wholeRows_ = std::max(wholeRows_, turns_[static_cast<std::size_t>(part)] == beams_.parts - 1 ? row + 1 : row);
    if (unitMm_ != line.unitMm && row == 0) unitMm_ = line.unitMm;
    noteStatus(line, row);
}

void GrowingSweep::grow(int rows) {
    if (rows <= grid_.rows()) return;
    grid_.grow(rows);
    facts_.resize(static_cast<std::size_t>(rows));
    missing_.resize(static_cast<std::size_t>(rows), beams_.parts);
}

void GrowingSweep::markRestLost(int rows) {
    grow(static_cast<int>(std::min<std::int64_t>(rows, grid_.rows() + mayBeLost() / beams_.parts)));
    finish();
}

void GrowingSweep::markNextLost(std::int64_t telegrams, const SweepSettings& settings) {
    if (telegrams <= 0 || lastSlot_ < 0) return;
    const std::int64_t last = origin_ + static_cast<std::int64_t>(mostRows(settings)) * beams_.parts - 1;
    lastSlot_ = std::max(lastSlot_, std::min(last, lastSlot_ + std::min(telegrams, mayBeLost())));
    markRestLost(rowOf(lastSlot_) + 1);
}

void GrowingSweep::noteStatus(const SweepLine& line, int row) {
    for (std::size_t i = 0; i < line.ranges.state.size(); ++i) {
        if (line.ranges.state[i] != CellState::DeviceStatus) continue;
        const auto code = static_cast<std::uint32_t>(std::lround(static_cast<double>(line.ranges.rangeMm[i]) / line.unitMm));
        const auto place = std::lower_bound(statusCodes_.begin(), statusCodes_.end(), code);
        if (place == statusCodes_.end() || *place != code) statusCodes_.insert(place, code);
    }
    if (line.serialNumber != 0) serialNumber_ = line.serialNumber;
    const DeviceFlags& now = line.device;
    if (firstFlagged_ < 0 && (now.error || now.contaminationWarning || now.contaminationError)) firstFlagged_ = row;
    deviceEver_.error |= now.error;
    deviceEver_.contaminationWarning |= now.contaminationWarning;
    deviceEver_.contaminationError |= now.contaminationError;
}

std::optional<int> GrowingSweep::reversal(const SweepSettings& settings) {
    const AngleSource source = angleSourceOf(facts_, settings);
    if (settings.reversalDeg <= 0 || (source != AngleSource::Encoder && source != AngleSource::Stepper)) return std::nullopt;
    for (; examined_ < wholeRows_; ++examined_) {
        const LineTiming& line = facts_[static_cast<std::size_t>(examined_)];
        const auto deg = measuredDeg(line, source, settings);
        if (!deg && line.received && wholeRows_ - examined_ < kAnglesWaitedFor) break;
        if (!deg) continue;
        if (!startDeg_) startDeg_ = extremeDeg_ = *deg;
        if (direction_ == 0 && std::abs(*deg - *startDeg_) > settings.reversalDeg) {
            direction_ = *deg > *startDeg_ ? 1 : -1;
            extremeDeg_ = *startDeg_;
        }
        const double onward = (*deg - extremeDeg_) * direction_;
        if (onward > 0 || direction_ == 0) {
            if (direction_ != 0) extremeDeg_ = *deg;
            extremeRow_ = examined_;
        } else if (-onward > settings.reversalDeg) {
            return extremeRow_ + 1;
        }
    }
    return std::nullopt;
}

GrowingSweep GrowingSweep::cutFrom(int row) {
    GrowingSweep rest;
    const auto first = static_cast<std::ptrdiff_t>(row);
    rest.beams_ = beams_;
    rest.turns_ = turns_;
    rest.origin_ = origin_ + static_cast<std::int64_t>(row) * beams_.parts;
    rest.lastSlot_ = lastSlot_;
    rest.laidOut_ = true;
    rest.grid_ = grid_.cutFrom(row);
    rest.facts_.assign(facts_.begin() + first, facts_.end());
    rest.missing_.assign(missing_.begin() + first, missing_.end());
    rest.wholeRows_ = std::max(0, wholeRows_ - row);
    rest.unitMm_ = unitMm_;
    rest.statusCodes_ = statusCodes_;
    rest.deviceEver_ = deviceEver_;
    rest.serialNumber_ = serialNumber_;
    rest.firstFlagged_ = firstFlagged_ >= 0 ? std::max(0, firstFlagged_ - row) : -1;
    facts_.resize(static_cast<std::size_t>(row));
    missing_.resize(static_cast<std::size_t>(row));
    wholeRows_ = std::min(wholeRows_, row);
    return rest;
}

} // namespace edgescan::scanner
