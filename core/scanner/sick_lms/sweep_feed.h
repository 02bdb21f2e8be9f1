// The one path from received frames to a sweep: live, replayed and opened.
#pragma once

#include "core/scanner/cola/frames.h"
#include "core/scanner/sick_lms/scan_telegram.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <cstdint>
#include <string>

namespace edgescan::scanner {

/// The telegram's counters and clocks.
[[nodiscard]] LineCount countOf(const ScanTelegram& telegram);

/// The line in a telegram: ranges of the requested echo, beams, counters, device status.
[[nodiscard]] SweepLine sweepLine(const ScanTelegram& telegram, Echo echo);

/// Decodes what was received and pushes it into an assembler.
class SweepFeed {
public:
    explicit SweepFeed(const SweepSettings& settings) : assembler_(settings) {}

    /// One received frame; bytes that are not a scan telegram are ignored. True if it contained a line.
    bool frame(const ColaFrame& frame, std::int64_t hostNs);
    /// Bytes that should be whole frames, as a recording stores them. True if one of them contained a line.
    bool frames(ByteView bytes, std::int64_t hostNs);

    [[nodiscard]] SweepAssembler& assembler() { return assembler_; }
    [[nodiscard]] const SweepAssembler& assembler() const { return assembler_; }
    /// Scan telegrams that could not be decoded.
    [[nodiscard]] std::int64_t undecodable() const { return undecodable_; }
    /// Calls of frames() with bytes that are not a whole frame.
    [[nodiscard]] std::int64_t torn() const { return torn_; }
    /// What was wrong with the first undecodable telegram.
    [[nodiscard]] const std::string& whyUndecodable() const { return whyUndecodable_; }

private:
    ColaStream stream_;
    SweepAssembler assembler_;
    std::int64_t undecodable_ = 0, torn_ = 0;
    std::string whyUndecodable_;
};

} // namespace edgescan::scanner
