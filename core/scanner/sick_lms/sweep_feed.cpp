// Decodes received frames for the sweep.
#include "core/scanner/sick_lms/sweep_feed.h"

#include "core/scanner/sick_lms/telegram_line.h"

namespace edgescan::scanner {

bool SweepFeed::frame(const ColaFrame& frame, std::int64_t hostNs) {
    if (!isScanTelegram(frame.payload())) return false;
    const auto telegram = decodeScanTelegram(frame);
    if (!telegram) {
        if (++undecodable_ == 1) whyUndecodable_ = telegram.error().what;
        return false;
    }
    assembler_.push(sweepLine(*telegram, assembler_.settings().echo), hostNs);
    return true;
}

bool SweepFeed::frames(ByteView bytes, std::int64_t hostNs) {
    bool line = false;
    const std::uint64_t skipped = stream_.counts().skipped;
    for (const ColaFrame& received : stream_.push(bytes)) line = frame(received, hostNs) || line;
    if (stream_.waiting() > 0 || stream_.counts().skipped > skipped) ++torn_;
    if (stream_.waiting() > 0) stream_ = ColaStream(); // the bytes should be whole frames: the rest of them is damaged
    return line;
}

} // namespace edgescan::scanner
