// libFuzzer: any bytes as a scan telegram. A decoded telegram must survive encoding in both dialects, and its ranges must be numbers.
#include "core/scanner/sick_lms/scan_telegram.h"
#include "tests/support/beam_angles.h"

#include <cmath>
#include <cstdlib>

using namespace edgescan;

namespace {

constexpr std::string_view kStart = "sSN LMDscandata ";

void check(ByteView payload, scanner::Dialect dialect) {
    const auto telegram = scanner::decodeScanTelegram(payload, dialect);
    if (!telegram) {
        if (telegram.error().sentence().empty()) std::abort();
        return;
    }
    for (const scanner::ScanChannel& channel : telegram->channels16) {
        const scanner::LineRanges ranges = scanner::rangesMm(channel);
        for (const float range : ranges.rangeMm) {
            if (!std::isfinite(range) || range < 0.0F) std::abort();
        }
        (void)beamAnglesDeg(scanner::beamGrid(channel));
    }
    for (const scanner::Dialect target : {scanner::Dialect::A, scanner::Dialect::B}) {
        const Bytes once = scanner::encodeScanTelegram(*telegram, target);
        const auto back = scanner::decodeScanTelegram(once, target);
        // Compared as bytes: a scale may be NaN, which is unequal to itself.
        if (!back || scanner::encodeScanTelegram(*back, target) != once) std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    if (size < 1) return 0;
    const scanner::Dialect dialect = bytes[0] % 2 == 0 ? scanner::Dialect::A : scanner::Dialect::B;
    const ByteView input(bytes + 1, size - 1);
    if (scanner::isScanTelegram(input)) {
        check(input, dialect);
        return 0;
    }
    Bytes payload(kStart.begin(), kStart.end());
    payload.insert(payload.end(), input.begin(), input.end());
    check(payload, dialect);
    return 0;
}
