// Scan telegrams made in memory, for tests of the code behind the connection.
#pragma once

#include "core/files/recording/writer.h"
#include "core/scan/grid/scan.h"
#include "core/scanner/sick_lms/sweep_feed.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace edgescan::test {

inline constexpr std::int64_t kPeriodNs = 40'000'000;
inline constexpr std::int64_t kEpochNs = 1'700'000'000'000'000'000;

struct LineStyle {
    int beams = 61;
    int startAngle = -50000; ///< 1/10000 degree
    int step = 1667;
    std::uint16_t firstTelegram = 100;
    std::uint16_t firstScan = 200;
    std::uint32_t firstUs = 5'000'000;
    std::uint32_t frequency = 2500; ///< 1/100 Hz
};

/// Range of a cell in the tests: different for each line and beam.
inline std::uint16_t rawOf(int line, int beam) { return static_cast<std::uint16_t>(1000 + (line * 131 + beam * 17) % 9000); }

/// Line `n` as the scanner sends it.
inline scanner::ScanTelegram telegramOfLine(int n, const LineStyle& style = {}) {
    scanner::ScanTelegram telegram;
    telegram.serialNumber = 18110550;
    telegram.telegramCounter = static_cast<std::uint16_t>(style.firstTelegram + n);
    telegram.scanCounter = static_cast<std::uint16_t>(style.firstScan + n);
    const double periodUs = 1e8 / style.frequency;
    telegram.sinceStartUs = static_cast<std::uint32_t>(style.firstUs + static_cast<std::int64_t>(std::llround(n * periodUs)));
    telegram.transmittedUs = telegram.sinceStartUs + 40'600;
    telegram.scanFrequency = style.frequency;
    telegram.measurementFrequency = 540;
    scanner::ScanChannel channel;
    channel.content = "DIST1";
    channel.startAngle = style.startAngle;
    channel.step = static_cast<std::uint16_t>(style.step);
    for (int beam = 0; beam < style.beams; ++beam) channel.values.push_back(rawOf(n, beam));
    telegram.channels16.push_back(std::move(channel));
    return telegram;
}

inline std::int64_t hostNsOfLine(int n) { return kEpochNs + n * kPeriodNs + 41'000'000; }

/// True if row `row` of the scan holds line `line` of the sender, for every cell.
inline bool rowHolds(const Scan& scan, int row, int line) {
    for (int beam = 0; beam < scan.beams(); ++beam) {
        if (scan.state.at(row, beam) != CellState::Valid || scan.rangeMm.at(row, beam) != static_cast<float>(rawOf(line, beam)))
            return false;
    }
    return true;
}
inline bool rowIsLost(const Scan& scan, int row) {
    for (int beam = 0; beam < scan.beams(); ++beam) {
        if (scan.state.at(row, beam) != CellState::Lost) return false;
    }
    return true;
}

inline bool sameScan(const Scan& a, const Scan& b) {
    return a.rangeMm == b.rangeMm && a.state == b.state && std::get<PolarGeometry>(a.geometry) == std::get<PolarGeometry>(b.geometry);
}

/// Whether the states add up to lines x beams, in the scan and in the progress.
inline bool addsUp(const Scan& scan, const scanner::SweepProgress& progress) {
    std::size_t sum = 0;
    for (const std::size_t count : progress.cells) sum += count;
    return sum == scan.cells() && countCells(scan) == progress.cells && progress.lines == scan.lines() &&
           progress.received + static_cast<int>(progress.lost.size()) == progress.lines;
}

inline files::RecordingMessagePtr lineMessage(int n, const LineStyle& style = {}, scanner::Dialect dialect = scanner::Dialect::B) {
    return std::make_shared<const files::RecordingMessage>(
        files::RecordingMessage{files::RecordingTopic::ColaRx, hostNsOfLine(n),
                                scanner::framed(scanner::encodeScanTelegram(telegramOfLine(n, style), dialect), dialect)});
}

inline void pushTelegram(scanner::SweepAssembler& assembler, const scanner::ScanTelegram& telegram, std::int64_t hostNs) {
    assembler.push(scanner::sweepLine(telegram, assembler.settings().echo), hostNs);
}

} // namespace edgescan::test
