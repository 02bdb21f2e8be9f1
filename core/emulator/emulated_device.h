// The emulated scanner's brain: what an LMS511 answers to a request, without any socket.
#pragma once

#include "core/lms/cola_commands.h"
#include "core/lms/scan_telegram.h"

#include <map>
#include <string>
#include <vector>

namespace edgescan::sim {

/// What the device remembers of one connection.
struct Visitor {
    int accessLevel = 0;
    bool subscribed = false;
};

class ColaDeviceAnswers; // the handlers, in the .cpp

/// Settings of the device and its answers. Not for several threads at once.
class EmulatedDevice {
public:
    /// Configured as the telegrams are; `likeThis` is the first of them.
    explicit EmulatedDevice(const ScanTelegram& likeThis);

    /// The payload of the answer. Empty: this was "sRN LMDscandata", to be answered with a telegram.
    [[nodiscard]] Bytes answer(ByteView request, Dialect dialect, Visitor& visitor);

    std::map<std::string, int> refusals; ///< name -> code of sFA given whatever is asked
    std::string firmware = "V1.80    ";
    std::string location;
    ScanConfiguration scan;
    OutputRange range;
    TelegramContent content;
    int echoFilter = 2;
    bool measuring = true;
    bool stored = false; ///< mEEwriteall was called

private:
    friend class ColaDeviceAnswers;
    OutputRange widest_; ///< what the telegrams hold
};

} // namespace edgescan::sim
