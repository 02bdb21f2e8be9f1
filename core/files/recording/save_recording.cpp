// Writing a scan as a recording.
#include "core/files/recording/save_recording.h"
#include "core/base/translated_text.h"

#include "core/files/point_tables/description.h"
#include "core/files/recording/recorded_grid.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/writer.h"
#include "core/scan/grid/count_states.h"
#include "core/scan/grid/scan_time.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

namespace edgescan::files {
namespace {

constexpr std::int64_t kPeriodUs = 40'000;              // 25 Hz
constexpr std::int64_t kTransmittedUs = 40'600;         // docs/developer/protocol.md, "Time of a beam": 329/360 of a turn + 4.05 ms
constexpr std::int64_t kUnknownStartNs = 1'000'000'000; // no date is known; the same scan gives the same bytes
constexpr std::int64_t kDelayNs = 500'000;              // on the wire
constexpr int kMostBeams = 32'000;                      // in a payload of 64 KiB
constexpr int kMostLost = 1000;                         // lines left out in one go; more would start a new sweep
const char* const kUsePcd = "save it as PCD, which carries every scan";

bool lineIsLost(const Scan& scan, int line) {
    const CellState* states = scan.state.line(line);
    return std::all_of(states, states + scan.beams(), [](CellState s) { return s == CellState::Lost; });
}

/// Lines that are left out as if their telegrams were lost; the first and the last are always there.
std::vector<bool> linesLeftOut(const Scan& scan) {
    std::vector<bool> out(static_cast<std::size_t>(scan.lines()), false);
    int run = 0;
    for (int line = 1; line + 1 < scan.lines(); ++line) {
        run = lineIsLost(scan, line) && run < kMostLost ? run + 1 : 0;
        out[static_cast<std::size_t>(line)] = run > 0;
    }
    for (int line = scan.lines() - 2; line > 0 && lineIsLost(scan, line + 1); --line) out[static_cast<std::size_t>(line)] = false;
    return out;
}

scanner::ScanTelegram emptyTelegram(const Scan& scan, const PolarGeometry& polar) {
    scanner::ScanTelegram telegram;
    telegram.deviceNumber = 1;
    telegram.scanFrequency = 2500;
    telegram.measurementFrequency = 540;
    scanner::ScanChannel channel;
    channel.content = "DIST1";
    channel.scale = static_cast<float>(scan.unitMm);
    const auto tenThousandths = [](double degrees, double minimum, double maximum) {
        return std::clamp(std::round(degrees * 1e4), minimum, maximum);
    };
    const double step =
        polar.beamDeg.size() > 1 ? (polar.beamDeg.back() - polar.beamDeg.front()) / static_cast<double>(polar.beamDeg.size() - 1) : 0;
    channel.startAngle = static_cast<std::int32_t>(tenThousandths(polar.beamDeg.front(), -2e9, 2e9));
    channel.step = static_cast<std::uint16_t>(tenThousandths(step, 0.0, 65535.0));
    channel.values.resize(polar.beamDeg.size());
    telegram.channels16.push_back(std::move(channel));
    return telegram;
}

/// The count of a cell. A cell without a range counts as its own number when that says so, else as the first code for it.
Result<std::uint16_t> countOf(const Scan& scan, const CountStates& states, std::size_t k, const std::string& where) {
    const double raw = static_cast<double>(scan.rangeMm[k]) / scan.unitMm;
    const bool whole = raw > -0.5 && raw < 65535.5 && std::abs(raw - std::round(raw)) <= 1e-3;
    const auto count = static_cast<std::uint16_t>(whole ? std::lround(raw) : 0);
    const CellState state = scan.state[k];
    if (state == CellState::NoReturn && !(whole && states[count] == CellState::NoReturn))
        return static_cast<std::uint16_t>(scan.noReturnCodes.empty() ? 0 : scan.noReturnCodes.front());
    if (whole || (state != CellState::Valid && state != CellState::DeviceStatus)) return count;
    const auto beams = static_cast<std::size_t>(scan.beams());
    return Error{withValues("a recording holds whole counts of its unit up to 65535, and the range at line %1, beam %2 is none",
                            {k / beams, k % beams}),
                 where, kUsePcd};
}

/// The description with every status code that occurs.
std::string gridDescription(const Scan& scan) {
    Scan complete = scan;
    std::set<std::uint32_t> known(scan.statusCodes.begin(), scan.statusCodes.end());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::DeviceStatus) continue;
        const auto count = static_cast<std::uint32_t>(std::lround(static_cast<double>(scan.rangeMm[k]) / scan.unitMm));
        if (known.insert(count).second) complete.statusCodes.push_back(count);
    }
    return descriptionText(complete, "", -1);
}

Result<std::vector<RecordingMessagePtr>> messagesOf(const Scan& scan, const PolarGeometry& polar, const std::string& where) {
    std::vector<RecordingMessagePtr> messages;
    const std::vector<bool> leftOut = linesLeftOut(scan);
    scanner::ScanTelegram telegram = emptyTelegram(scan, polar);
    const auto start = startOfScan(scan);
    const std::int64_t startNs = start ? std::llround(*start * 1e6) * 1000 : kUnknownStartNs;
    const auto states = std::make_unique<const CountStates>(countStates(scan.noReturnCodes, {}));
    for (int line = 0; line < scan.lines(); ++line) {
        if (leftOut[static_cast<std::size_t>(line)]) continue;
        telegram.telegramCounter = telegram.scanCounter = static_cast<std::uint16_t>(line);
        telegram.sinceStartUs = static_cast<std::uint32_t>(line * kPeriodUs);
        telegram.transmittedUs = static_cast<std::uint32_t>(line * kPeriodUs + kTransmittedUs);
        for (int beam = 0; beam < scan.beams(); ++beam) {
            const auto count = countOf(scan, *states, scan.rangeMm.index(line, beam), where);
            if (!count) return count.error();
            telegram.channels16.front().values[static_cast<std::size_t>(beam)] = *count;
        }
        const std::int64_t receivedNs = startNs + (line * kPeriodUs + kTransmittedUs) * 1000 + kDelayNs;
        Bytes frame = scanner::framed(scanner::encodeScanTelegram(telegram, scanner::Dialect::B), scanner::Dialect::B);
        messages.push_back(
            std::make_shared<const RecordingMessage>(RecordingMessage{RecordingTopic::ColaRx, receivedNs, std::move(frame)}));
        messages.push_back(stepperMessage({line, polar.lineDeg[static_cast<std::size_t>(line)], 0.0, false, receivedNs}));
    }
    return messages;
}

bool sameCells(const Scan& a, const Scan& b) {
    if (a.lines() != b.lines() || a.beams() != b.beams() || a.state != b.state) return false;
    for (std::size_t k = 0; k < a.cells(); ++k) {
        const bool counts = a.state[k] == CellState::Valid || a.state[k] == CellState::DeviceStatus;
        if (counts && a.rangeMm[k] != b.rangeMm[k]) return false;
    }
    return std::get<PolarGeometry>(a.geometry) == std::get<PolarGeometry>(b.geometry);
}

} // namespace

Result<Bytes> recordingOf(const Scan& scan, const std::string& where) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return Error{"a recording needs beam and line angles and this cloud has none", where, kUsePcd};
    scanner::SweepSettings settings;
    if (scan.cells() == 0) return Error{"the scan has no cells", where, "open a scan first"};
    if (scan.beams() > kMostBeams || scan.lines() > settings.mostLines) {
        return Error{withValues("a recording holds at most %1 lines of %2 beams", {settings.mostLines, kMostBeams}), where, kUsePcd};
    }
    settings.axis = polar->axis;
    settings.lineDirection = polar->lineDirection;
    settings.continuous = false; // the angles are exact: nothing is to be reckoned from a speed
    settings.reversalDeg = 0.0;
    settings.expectedLines = scan.lines();
    settings.outputInterval = 1;
    scanner::SweepMetadata metadata = scanner::metadataOf(settings);
    metadata["lidar.dialect"] = "cola-b";
    metadata[kMadeFromKey] = scan.format;
    if (!scan.note.empty()) metadata["note"] = scan.note;
    const auto messages = messagesOf(scan, *polar, where);
    if (!messages) return messages.error();
    // What telegrams cannot say (uneven beams, masked cells ...) is described in the metadata.
    const bool more = scan.placement != nullptr || scan.acquisition != nullptr;
    for (const bool described : {false, true}) {
        if (more && !described) continue;
        if (described) metadata[kRecordedGridKey] = gridDescription(scan);
        Bytes bytes = recordingBytes(metadata, *messages);
        const auto recording = Recording::fromBytes(bytes, where);
        if (!recording) return recording.error();
        const auto opened = scanOf(*recording, where);
        if (opened && sameCells(scan, *opened)) return bytes;
    }
    return Error{"telegrams cannot describe this scan", where, kUsePcd};
}

} // namespace edgescan::files
