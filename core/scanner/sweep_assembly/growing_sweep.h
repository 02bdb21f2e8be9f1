// One sweep while its lines arrive: the row of each line, lost lines, and the place where the motor reversed.
#pragma once

#include "core/scan/grid/scan.h"
#include "core/scanner/scan_line/scan_line.h"
#include "core/scanner/sweep_assembly/line_angles.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// Cells of one row, as many as `rangeMm` has; `intensity` is empty if there are none.
struct RowCells {
    const std::vector<float>& rangeMm;
    const std::vector<CellState>& state;
    const std::vector<float>& intensity;
};

/// A value type; copies share nothing.
class SweepGrid {
public:
    explicit SweepGrid(int beams = 0) : beams_(beams) {}

    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int beams() const { return beams_; }

    /// Grows to `count` rows; all cells of new rows are Lost.
    void grow(int count);
    /// Writes beam first + stride * i of the row for each i.
    void write(int row, int first, int stride, const RowCells& cells);
    /// Whether any of those beams of the row is not Lost.
    [[nodiscard]] bool holds(int row, int first, int stride, std::size_t count) const;
    /// Whether those beams hold exactly these values.
    [[nodiscard]] bool same(int row, int first, int stride, const std::vector<float>& rangeMm, const std::vector<CellState>& state) const;
    [[nodiscard]] std::uint32_t lostIn(int row) const {
        return rowCounts_[static_cast<std::size_t>(row)][static_cast<std::size_t>(CellState::Lost)];
    }
    /// Removes the rows from `row` on and returns them as a grid.
    SweepGrid cutFrom(int row);

    /// Number of cells by state in the first `rows` rows.
    [[nodiscard]] std::array<std::size_t, kCellStates> counts(int rows) const;

    /// A scan with the ranges, states and intensities of the first `rows` rows. Its other members are left from an earlier use. Scans that
    /// are not in use any more are reused, and only the rows that changed since are copied into them.
    std::shared_ptr<Scan> scan(int rows);

private:
    struct Copy { // a scan, and the state of the grid that it holds
        Scan scan;
        std::uint64_t change = 0;
        int rows = 0;
    };
    class Copies;
    /// Copying a grid makes a new, empty store.
    struct Store {
        Store();
        Store(const Store&);
        Store& operator=(const Store&);
        Store(Store&&) noexcept = default;
        Store& operator=(Store&&) noexcept = default;
        ~Store() = default;
        std::shared_ptr<Copies> copies;
    };

    [[nodiscard]] std::size_t index(int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(beams_); }
    /// Where the cells of the row begin below; kLostRow: it has none.
    [[nodiscard]] std::size_t at(int row) const { return at_[static_cast<std::size_t>(row)]; }
    void appendCells(const SweepGrid& other, int row, std::size_t to);

    int beams_ = 0;
    int rows_ = 0;
    bool hasIntensity_ = false;   // since the first row with intensities
    std::vector<std::size_t> at_; // per row
    // The cells of the rows that are not lost, in the order in which they arrived.
    std::vector<float> rangeMm_;
    std::vector<CellState> state_;
    std::vector<float> intensity_;                                  // empty without intensities
    std::vector<std::uint64_t> changed_;                            // per row: number of its last change
    std::vector<std::array<std::uint32_t, kCellStates>> rowCounts_; // per row
    std::uint64_t change_ = 0;
    Store store_;
};

/// The beams of a grid line that arrive in `parts` telegrams: beam p + parts * i of the line is beam i of part p.
struct InterlacedBeams {
    double startDeg = 0.0; ///< of part 0, the part with the smallest angle
    double stepDeg = 0.0;  ///< between beams of one part
    int parts = 1;
    int beams = 0; ///< of the whole line

    /// The part to which these beams belong; empty if they do not fit.
    [[nodiscard]] std::optional<int> partOf(const BeamGrid& grid) const;
    /// Number of beams of a part.
    [[nodiscard]] int beamsOf(int part) const { return part < beams ? (beams - part + parts - 1) / parts : 0; }
    [[nodiscard]] std::vector<double> beamDeg() const;

    bool operator==(const InterlacedBeams&) const = default;
};

/// The smallest number of parts that contains all these beams; empty if they cannot belong together.
[[nodiscard]] std::optional<InterlacedBeams> interlacedBeams(std::span<const BeamGrid> grids);

/// A value type. Lines that arrived before their interlacing was known are stored and placed again.
class GrowingSweep {
public:
    enum class Place : std::uint8_t {
        Added,
        Misfit, ///< other beams than those of this sweep
        Full,   ///< belongs behind the last row that the sweep can have
    };
    /// `lost`: telegrams lost since the last one.
    Place push(const SweepLine& line, std::int64_t lost, const SweepSettings& settings);

    /// Number of further telegrams that may be lost in this sweep: as many as it has measured ones, and 4 million cells. With more, a few
    /// telegrams whose counters are far apart would make a scan of any size.
    [[nodiscard]] std::int64_t mayBeLost() const;

    enum class Repeat : std::uint8_t {
        Filled,  ///< it was missing and is now in its place
        Same,    ///< the same line is already there
        Other,   ///< another line is there
        Outside, ///< the sweep does not contain this place
    };
    /// A line whose counters say that it came `behind` telegrams before the newest one.
    Repeat repeat(const SweepLine& line, std::int64_t behind);

    /// Number of rows that are final.
    [[nodiscard]] int wholeRows() const { return wholeRows_; }
    /// Call it after the last line: the last row is then final.
    void finish() { wholeRows_ = grid_.rows(); }

    /// Marks the missing rows up to `rows` as lost, as far as mayBeLost().
    void markRestLost(int rows);
    /// The same of so many telegrams behind the last one.
    void markNextLost(std::int64_t telegrams, const SweepSettings& settings);

    /// The first row after the motor reversed; empty if it did not.
    [[nodiscard]] std::optional<int> reversal(const SweepSettings& settings);
    /// Removes the rows from `row` on; they become the next sweep.
    GrowingSweep cutFrom(int row);

    [[nodiscard]] SweepGrid& grid() { return grid_; }
    [[nodiscard]] const SweepGrid& grid() const { return grid_; }
    [[nodiscard]] const InterlacedBeams& beams() const { return beams_; }
    /// For each part, the number of mirror rotations after the row's first part at which it is measured.
    [[nodiscard]] const std::vector<int>& turnsOf() const { return turns_; }
    [[nodiscard]] std::span<LineTiming> facts() { return facts_; }
    [[nodiscard]] std::span<const LineTiming> facts() const { return facts_; }
    /// Number of missing telegrams per row.
    [[nodiscard]] const std::vector<int>& missing() const { return missing_; }
    /// Whether a row is incomplete: a telegram is missing, or its telegram had too few beams.
    [[nodiscard]] bool isIncomplete(int row) const { return missing_[static_cast<std::size_t>(row)] != 0 || grid_.lostIn(row) > 0; }
    /// Number of telegrams in a row, and of those without a row because they came before the first whole row.
    [[nodiscard]] std::int64_t placed() const;
    [[nodiscard]] std::int64_t leftOut() const { return leftOut_; }
    /// Row of the newest telegram; -1 before the first.
    [[nodiscard]] int newestRow() const { return lastSlot_ < 0 ? -1 : rowOf(lastSlot_); }
    [[nodiscard]] double unitMm() const { return unitMm_; }
    [[nodiscard]] const std::vector<std::uint32_t>& statusCodes() const { return statusCodes_; }
    [[nodiscard]] const DeviceFlags& deviceEver() const { return deviceEver_; }
    /// The scanner's serial number according to the telegrams; 0 before the first.
    [[nodiscard]] std::uint32_t serialNumber() const { return serialNumber_; }
    /// First row whose telegram had any of the flags set; -1: no telegram had.
    [[nodiscard]] int firstFlagged() const { return firstFlagged_; }

private:
    struct Early {
        SweepLine line;
        std::int64_t slot = 0;
    };
    [[nodiscard]] int mostRows(const SweepSettings& settings) const;
    bool layOut(std::span<const BeamGrid> grids);
    void rebuild();
    void grow(int rows);
    void write(const SweepLine& line, std::int64_t slot, int part);
    [[nodiscard]] std::int64_t slotOf(int part, std::int64_t lost) const;
    [[nodiscard]] int rowOf(std::int64_t slot) const;
    void noteStatus(const SweepLine& line, int row);

    InterlacedBeams beams_;
    std::vector<int> turns_{0};
    std::int64_t origin_ = 0;    // slot of the first part of row 0
    std::int64_t lastSlot_ = -1; // a slot is the place of one telegram
    bool laidOut_ = false;
    std::deque<Early> early_;

    SweepGrid grid_;
    std::vector<LineTiming> facts_;
    std::vector<int> missing_;
    int wholeRows_ = 0;
    std::int64_t leftOut_ = 0;
    double unitMm_ = 1.0;
    std::vector<std::uint32_t> statusCodes_;
    DeviceFlags deviceEver_;
    int firstFlagged_ = -1;
    std::uint32_t serialNumber_ = 0;

    int examined_ = 0; // number of rows already checked for a reversal
    int direction_ = 0;
    std::optional<double> startDeg_;
    double extremeDeg_ = 0.0;
    int extremeRow_ = 0;
};

} // namespace edgescan::scanner
