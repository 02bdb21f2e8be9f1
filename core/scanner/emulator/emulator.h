// An emulated LMS511 on a TCP port: answers like one, sends telegrams like one, and fails like one when asked to.
#pragma once

#include "core/base/result.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// Failures to provoke. "Every n": at every n-th telegram, or by chance once in n when `byChance`; 0: never.
struct ScannerFaults {
    bool splitSends = false; ///< telegrams go out in pieces of random length
    bool mergeSends = false; ///< several telegrams go out at once
    int loseEvery = 0;       ///< not sent, but counted
    int loseBurst = 1;       ///< how many in a row
    int duplicateEvery = 0;
    int garbageEvery = 0; ///< random bytes before the telegram
    int corruptEvery = 0; ///< one bit of the telegram is wrong
    int stallEvery = 0;   ///< silence, connection kept
    double stallS = 0.0;
    int dropEvery = 0;      ///< all connections are closed
    int narrowEvery = 0;    ///< the telegram has half of its beams
    int counterStep = 1;    ///< what both counters go on by from line to line
    double clockRate = 1.0; ///< of the device clock: 0 it stands, -1 it runs backward
    bool mute = false;      ///< accepts connections, answers nothing
    bool byChance = false;
    unsigned seed = 1;
};

enum class AtEnd : std::uint8_t {
    Stop,    ///< no more telegrams
    Again,   ///< from the first line
    Reverse, ///< back again, as a sweeping stepper does
};

struct EmulatedScannerSettings {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;       ///< 0: any that is free
    std::optional<Dialect> only;  ///< answers nothing in the other dialect, like a real device; empty: both
    double linesPerSecond = 25.0; ///< 0: as fast as the client reads
    AtEnd atEnd = AtEnd::Again;
    bool keepTurning = false; ///< lines pass while nobody is subscribed
    double silentS = 5.0;     ///< of eight clients the one that did nothing for so long gives way to a ninth
    bool contaminationWarning = false;
    bool contaminationError = false;
    std::map<std::string, int> refusals; ///< name -> code of sFA, whatever is asked
    ScannerFaults faults;
};

struct EmulatedScannerStatistics {
    std::uint64_t lines = 0; ///< measured: sent or lost on purpose
    std::uint64_t sent = 0;  ///< telegrams written for a subscriber
    std::uint64_t lost = 0;  ///< left out on purpose, or because the client did not read
    std::uint64_t corrupted = 0;
    std::uint64_t duplicated = 0;
    std::uint64_t garbage = 0; ///< pieces of rubbish
    std::uint64_t stalls = 0;
    std::uint64_t drops = 0;
    std::uint64_t clients = 0; ///< connections accepted
    std::uint64_t writes = 0;  ///< requests other than reads and subscriptions
    bool finished = false;     ///< AtEnd::Stop: the last telegram has left
};

/// Runs from creation to destruction on a thread of its own.
class EmulatedScanner {
public:
    ~EmulatedScanner();
    EmulatedScanner(const EmulatedScanner&) = delete;
    EmulatedScanner& operator=(const EmulatedScanner&) = delete;

    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] EmulatedScannerStatistics statistics() const;
    void setContamination(bool warning, bool error);
    /// Closes every connection, as a pulled plug would.
    void dropConnections();

private:
    friend Result<std::unique_ptr<EmulatedScanner>> serveTelegrams(std::shared_ptr<const std::vector<ScanTelegram>>,
                                                                   const EmulatedScannerSettings&);
    struct Server;
    explicit EmulatedScanner(std::unique_ptr<Server> server);
    std::unique_ptr<Server> server_;
};

/// Starts serving: counters and clocks run on from the first telegram however often the list is repeated.
/// Error: the address cannot be used, or there is nothing to serve.
[[nodiscard]] Result<std::unique_ptr<EmulatedScanner>> serveTelegrams(std::shared_ptr<const std::vector<ScanTelegram>> telegrams,
                                                                      const EmulatedScannerSettings& settings);

} // namespace edgescan
