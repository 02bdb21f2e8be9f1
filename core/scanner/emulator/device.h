// What an LMS511 answers to a request, without any socket.
#pragma once

#include "core/scanner/cola/commands.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <map>
#include <string>

namespace edgescan {
class ColaWriter;
}

namespace edgescan::sim {

/// Settings of the device and its answers. It takes no settings: whatever would change it is refused, as without logging in.
class EmulatedDevice {
public:
    /// Configured as the telegrams are; `likeThis` is the first of them. `refusals`: name -> code of sFA given whatever is asked.
    EmulatedDevice(const ScanTelegram& likeThis, std::map<std::string, int> refusals);

    /// The payload of the answer. Empty: this was "sRN LMDscandata", to be answered with a telegram. `subscribed`: whether the client
    /// that asks gets telegrams, before and after.
    [[nodiscard]] Bytes answer(ByteView request, Dialect dialect, bool& subscribed) const;

private:
    bool writeVariable(ColaWriter& writer, std::string_view name) const;

    std::map<std::string, int> refusals_;
    std::string location_;
    ScanConfiguration scan_;
    OutputRange range_;
    TelegramContent content_;
};

} // namespace edgescan::sim
