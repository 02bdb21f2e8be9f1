// An emulated LMS511 on a TCP port. It answers and sends telegrams like a real one, and produces faults on request.
#pragma once

#include "core/base/result.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// Faults to produce. "Every n": at every n-th telegram, or by chance once in n if `byChance`; 0: never.
struct ScannerFaults {
    bool splitSends = false; ///< telegrams are sent in pieces of random length
    bool mergeSends = false; ///< several telegrams are sent at once
    int loseEvery = 0;       ///< the telegram is not sent, but counted
    int loseBurst = 1;       ///< number of consecutive lost telegrams
    int duplicateEvery = 0;
    int garbageEvery = 0; ///< random bytes before the telegram
    int corruptEvery = 0; ///< one bit of the telegram is wrong
    int stallEvery = 0;   ///< silence, while the connection stays open
    double stallS = 0.0;
    int dropEvery = 0;      ///< all connections are closed
    int narrowEvery = 0;    ///< the telegram has half of the beams
    int counterStep = 1;    ///< increase of both counters from line to line
    double clockRate = 1.0; ///< of the device clock: 0 stopped, -1 backward
    bool mute = false;      ///< accepts connections but does not answer
    bool byChance = false;
    unsigned seed = 1;
};

enum class AtEnd : std::uint8_t {
    Stop,    ///< no further telegrams
    Again,   ///< from the first line again
    Reverse, ///< in reverse order, as with a sweeping stepper
};

struct EmulatedScannerSettings {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;       ///< 0: any free port
    std::optional<Dialect> only;  ///< the only dialect that is answered, as by a real device; empty: both
    double linesPerSecond = 25.0; ///< 0: as fast as the client reads
    AtEnd atEnd = AtEnd::Again;
    bool keepTurning = false; ///< lines also pass while no client is subscribed
    double silentS = 5.0;     ///< if all eight places are taken, a client that was inactive for this time is closed for a ninth
    bool contaminationWarning = false;
    bool contaminationError = false;
    std::map<std::string, int> refusals; ///< variable name -> code of sFA
    ScannerFaults faults;
};

struct EmulatedScannerStatistics {
    std::uint64_t lines = 0; ///< lines measured: sent or lost on purpose
    std::uint64_t sent = 0;  ///< telegrams written for a subscribed client
    std::uint64_t lost = 0;  ///< left out on purpose, or because the client did not read
    std::uint64_t corrupted = 0;
    std::uint64_t duplicated = 0;
    std::uint64_t garbage = 0; ///< insertions of random bytes
    std::uint64_t stalls = 0;
    std::uint64_t drops = 0;
    std::uint64_t clients = 0;       ///< connections accepted
    std::uint64_t failedAccepts = 0; ///< tries to accept one that the system refused: no free descriptor, no memory
    std::uint64_t writes = 0;        ///< requests other than reads and subscriptions
    bool finished = false;           ///< AtEnd::Stop: the last telegram was sent
};

/// Runs on its own thread from construction to destruction.
class EmulatedScanner {
public:
    ~EmulatedScanner();
    EmulatedScanner(const EmulatedScanner&) = delete;
    EmulatedScanner& operator=(const EmulatedScanner&) = delete;

    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] EmulatedScannerStatistics statistics() const;
    void setContamination(bool warning, bool error);
    /// Closes every connection, like a pulled cable.
    void dropConnections();

private:
    friend Result<std::unique_ptr<EmulatedScanner>> serveTelegrams(std::shared_ptr<const std::vector<ScanTelegram>>,
                                                                   const EmulatedScannerSettings&);
    struct Server;
    explicit EmulatedScanner(std::unique_ptr<Server> server);
    std::unique_ptr<Server> server_;
};

/// Starts serving. Counters and clocks continue from the first telegram, however often the list is repeated. Error: the address cannot be
/// used, or the list is empty.
[[nodiscard]] Result<std::unique_ptr<EmulatedScanner>> serveTelegrams(std::shared_ptr<const std::vector<ScanTelegram>> telegrams,
                                                                      const EmulatedScannerSettings& settings);

} // namespace edgescan::scanner
