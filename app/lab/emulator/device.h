// The answers of an emulated LMS511 to requests, without a socket.
#pragma once

#include "core/scanner/cola/commands.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <map>
#include <string>

namespace edgescan::scanner {
class ColaWriter;
}

namespace edgescan::scanner {

/// The settings of the device and its answers. The device accepts no new settings: it refuses every change, as a scanner does without a
/// login.
class EmulatedDevice {
public:
    /// The configuration is that of the telegrams; `likeThis` is the first of them. `refusals`: variable name -> code of sFA, which is sent
    /// for every request of that variable.
    EmulatedDevice(const ScanTelegram& likeThis, std::map<std::string, int> refusals);

    /// The payload of the answer. Empty if the request was "sRN LMDscandata", which must be answered with a telegram. `subscribed`: whether
    /// the client receives telegrams, before and after the request.
    [[nodiscard]] Bytes answer(ByteView request, Dialect dialect, bool& subscribed) const;

private:
    bool writeVariable(ColaWriter& writer, std::string_view name) const;

    std::map<std::string, int> refusals_;
    std::string location_;
    ScanConfiguration scan_;
    OutputRange range_;
    TelegramContent content_;
};

} // namespace edgescan::scanner
