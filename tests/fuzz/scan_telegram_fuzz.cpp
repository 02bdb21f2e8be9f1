// libFuzzer: any bytes as a scan telegram. What decodes must survive encoding in both dialects and give ranges that are numbers.
#include "core/scanner/sick_lms/scan_telegram.h"
#include "tests/support/beam_angles.h"

#include <cmath>
#include <cstdlib>

using namespace edgescan;

namespace {

constexpr std::string_view kStart = "sSN LMDscandata ";

void check(ByteView payload, Dialect dialect) {
    const auto telegram = decodeScanTelegram(payload, dialect);
    if (!telegram) {
        if (telegram.error().sentence().empty()) std::abort();
        return;
    }
    for (const ScanChannel& channel : telegram->channels16) {
        const ChannelRanges ranges = rangesMm(channel);
        for (const float range : ranges.rangeMm) {
            if (!std::isfinite(range) || range < 0.0F) std::abort();
        }
        (void)beamAnglesDeg(beamGrid(channel));
    }
    for (const Dialect target : {Dialect::A, Dialect::B}) {
        const Bytes once = encodeScanTelegram(*telegram, target);
        const auto back = decodeScanTelegram(once, target);
        // Compared as bytes: a scale may be "not a number", which is unequal to itself.
        if (!back || encodeScanTelegram(*back, target) != once) std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    if (size < 1) return 0;
    const Dialect dialect = bytes[0] % 2 == 0 ? Dialect::A : Dialect::B;
    const ByteView input(bytes + 1, size - 1);
    if (isScanTelegram(input)) {
        check(input, dialect);
        return 0;
    }
    Bytes payload(kStart.begin(), kStart.end());
    payload.insert(payload.end(), input.begin(), input.end());
    check(payload, dialect);
    return 0;
}
