// One sweep while its lines arrive: which row a line belongs to, what was lost, where the motor turned back.
#pragma once

#include "core/scanner/sweep_assembly/interlaced_lines.h"
#include "core/scanner/sweep_assembly/line_angles.h"
#include "core/scanner/sweep_assembly/sweep_grid.h"

#include <deque>
#include <string>

namespace edgescan {

/// One telegram as the sweep wants it.
struct SweepLine {
    BeamGrid beams;
    ChannelRanges ranges;
    std::vector<float>
        intensity; ///< RSSI of each beam's echo as the telegram counts it, NaN where that echo has none; empty: it has no RSSI
    double unitMm = 1.0;
    LineFacts facts;
    DeviceFlags device;
    std::uint32_t serialNumber = 0;
    std::string echoes; ///< range channels in the telegram: "DIST1 DIST2", "DIST1 (DIST2)" where the second has unlike beams
};

/// The line in a telegram: ranges of the echo wanted, beams, device status. The facts hold nothing but the mirror's period.
[[nodiscard]] SweepLine sweepLine(const ScanTelegram& telegram, Echo echo);

/// A value. Lines that arrived before it was clear how they interlace are kept and placed anew.
class GrowingSweep {
public:
    enum class Place : std::uint8_t {
        Taken,
        Misfit, ///< other beams than this sweep's
        Full,   ///< belongs behind the last line that the sweep can have
    };
    /// `lost`: telegrams lost since the last one.
    Place push(const SweepLine& line, std::int64_t lost, const SweepSettings& settings);

    enum class Repeat : std::uint8_t {
        Filled,  ///< it was missing and is in its place now
        Same,    ///< it is there
        Other,   ///< something else is there
        Outside, ///< the sweep has no such place
    };
    /// A line whose counters say that it came `behind` telegrams before the newest one.
    Repeat repeat(const SweepLine& line, std::int64_t behind);

    /// Rows that nothing can be added to any more.
    [[nodiscard]] int wholeRows() const { return wholeRows_; }
    /// No more lines will come: the last row is as whole as it gets.
    void finish() { wholeRows_ = grid_.rows(); }

    /// The rows up to `rows` that did not come are lost.
    void loseRest(int rows);
    /// So many telegrams behind the last one are lost.
    void loseNext(std::int64_t telegrams, const SweepSettings& settings);

    /// First row after the motor turned back, when it did.
    [[nodiscard]] std::optional<int> reversal(const SweepSettings& settings);
    /// The rows from `row` on leave this sweep and are the next one.
    GrowingSweep cutFrom(int row);

    [[nodiscard]] SweepGrid& grid() { return grid_; }
    [[nodiscard]] const SweepGrid& grid() const { return grid_; }
    [[nodiscard]] const InterlacedBeams& beams() const { return beams_; }
    /// Mirror turns after the row's first part at which each part is measured.
    [[nodiscard]] const std::vector<int>& turnsOf() const { return turns_; }
    [[nodiscard]] std::span<LineFacts> facts() { return facts_; }
    [[nodiscard]] std::span<const LineFacts> facts() const { return facts_; }
    /// Telegrams missing per row.
    [[nodiscard]] const std::vector<int>& missing() const { return missing_; }
    /// Something of the row is missing: a telegram, or beams that its telegram did not have.
    [[nodiscard]] bool lacks(int row) const { return missing_[static_cast<std::size_t>(row)] != 0 || grid_.lostIn(row) > 0; }
    /// Telegrams that are in a row; and that belong into none, because they came before the first whole one.
    [[nodiscard]] std::int64_t placed() const;
    [[nodiscard]] std::int64_t leftOut() const { return leftOut_; }
    /// Of the newest telegram; -1 before the first.
    [[nodiscard]] int newestRow() const { return lastSlot_ < 0 ? -1 : rowOf(lastSlot_); }
    [[nodiscard]] double unitMm() const { return unitMm_; }
    [[nodiscard]] const std::vector<std::uint32_t>& statusCodes() const { return statusCodes_; }
    [[nodiscard]] const DeviceFlags& deviceEver() const { return deviceEver_; }
    /// What the telegrams say the scanner's number is; 0 before the first.
    [[nodiscard]] std::uint32_t serialNumber() const { return serialNumber_; }
    /// First row whose telegram had any of the flags; -1 when none had.
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
    std::vector<LineFacts> facts_;
    std::vector<int> missing_;
    int wholeRows_ = 0;
    std::int64_t leftOut_ = 0;
    double unitMm_ = 1.0;
    std::vector<std::uint32_t> statusCodes_;
    DeviceFlags deviceEver_;
    int firstFlagged_ = -1;
    std::uint32_t serialNumber_ = 0;

    int examined_ = 0; // rows whose angle was looked at for a reversal
    int direction_ = 0;
    std::optional<double> startDeg_;
    double extremeDeg_ = 0.0;
    int extremeRow_ = 0;
};

} // namespace edgescan
