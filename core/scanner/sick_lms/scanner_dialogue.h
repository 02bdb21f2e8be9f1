// Requests and answers, one at a time, and identification of the scanner. Nothing that EdgeScan sends changes the scanner
// (docs/developer/protocol.md, "Dialect", "Requests and answers").
#pragma once

#include "core/scanner/cola/commands.h"
#include "core/scanner/cola/link.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// The scanner's description of itself. A value that it refused is empty and listed in `refused`.
struct ScannerIdentity {
    Dialect dialect = Dialect::B;
    std::optional<int> deviceState; ///< SCdevicestate
    std::optional<DeviceIdentity> device;
    std::optional<std::string> firmware;
    std::optional<std::string> location;          ///< the name that the operator gave the scanner
    std::optional<std::uint32_t> operatingTenths; ///< tenths of an hour
    std::optional<std::uint32_t> powerOns;
    std::optional<MeasuringState> measuring;
    std::optional<ScanConfiguration> scan;
    std::optional<OutputRange> range;
    std::optional<TelegramContent> content;
    std::optional<int> echoFilter;
    std::vector<std::string> refused; ///< "DeviceIdent: the variable is not known"

    /// For people: "SN 18110550, firmware V1.80, CoLa B, 25 Hz, 0.1667 degrees from -5 to 185".
    [[nodiscard]] std::string words() const;
};

/// Waiting times.
struct ScannerTimeouts {
    std::chrono::milliseconds connect{5000};
    std::chrono::milliseconds detect{1000};
    std::chrono::milliseconds answer{2000};
    std::chrono::milliseconds firstScan{5000};
    std::chrono::milliseconds startUp{30000}; ///< first scan of a scanner that is still starting
    std::chrono::milliseconds silence{1000};  ///< between two scans; at least ten scan periods
    /// Pauses before connecting again; the last one is repeated.
    std::vector<std::chrono::milliseconds> rests{std::chrono::milliseconds(500), std::chrono::milliseconds(1000),
                                                 std::chrono::milliseconds(2000), std::chrono::milliseconds(4000),
                                                 std::chrono::milliseconds(5000)};
};

class ScannerDialogue {
public:
    /// `onFrame`: called with every frame that arrives during the wait for an answer, because scans keep arriving. `link` must outlive this
    /// object.
    ScannerDialogue(ColaLink& link, const ScannerTimeouts& timeouts, std::function<void(const ColaFrame&)> onFrame)
        : link_(link), timeouts_(timeouts), onFrame_(std::move(onFrame)) {}

    /// Finds the dialect in which the scanner answers, trying `first` first. Returns the device state, or -1 if it cannot be read.
    Result<int> detect(Dialect first, bool onlyThat);
    [[nodiscard]] Dialect dialect() const { return dialect_; }

    /// The answer, which may be a refusal. Error: no answer came, or the connection is gone.
    Result<ColaAnswer> ask(const ColaRequest& request);

private:
    Result<std::optional<ColaAnswer>> await(const ColaRequest& request, std::chrono::milliseconds timeout);

    ColaLink& link_;
    const ScannerTimeouts& timeouts_;
    std::function<void(const ColaFrame&)> onFrame_;
    Dialect dialect_ = Dialect::B;
};

/// Reads everything that describes the scanner and its configuration. A refused read is not an error.
[[nodiscard]] Result<ScannerIdentity> identify(ScannerDialogue& dialogue, int deviceState);

} // namespace edgescan::scanner
