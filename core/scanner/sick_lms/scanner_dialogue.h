// Question and answer with a scanner, one at a time, and finding out what it is. Nothing is sent that changes it
// (docs/protocol.md, "Dialect", "Requests and answers").
#pragma once

#include "core/scanner/cola/commands.h"
#include "core/scanner/cola/link.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// What a scanner says it is. What it would not tell is empty and listed in `refused`.
struct ScannerIdentity {
    Dialect dialect = Dialect::B;
    std::optional<int> deviceState; ///< SCdevicestate
    std::optional<DeviceIdentity> device;
    std::optional<std::string> firmware;
    std::optional<std::string> location;          ///< the name the operator gave it
    std::optional<std::uint32_t> operatingTenths; ///< of an hour
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

/// How long to wait for what.
struct ScannerTimeouts {
    std::chrono::milliseconds connect{5000};
    std::chrono::milliseconds detect{1000};
    std::chrono::milliseconds answer{2000};
    std::chrono::milliseconds firstScan{5000};
    std::chrono::milliseconds startUp{30000}; ///< the same of a scanner that is still starting
    std::chrono::milliseconds silence{1000};  ///< between two scans; at least ten of their periods
    /// Before connecting again, the last one over and over.
    std::vector<std::chrono::milliseconds> rests{std::chrono::milliseconds(500), std::chrono::milliseconds(1000),
                                                 std::chrono::milliseconds(2000), std::chrono::milliseconds(4000),
                                                 std::chrono::milliseconds(5000)};
};

class ScannerDialogue {
public:
    /// `onFrame`: every frame that arrives while an answer is awaited; scans keep coming. Must outlive this: `link`.
    ScannerDialogue(ColaLink& link, const ScannerTimeouts& timeouts, std::function<void(const ColaFrame&)> onFrame)
        : link_(link), timeouts_(timeouts), onFrame_(std::move(onFrame)) {}

    /// Finds out in which dialect the scanner answers, trying `first` first. Gives the device state, -1 where that is not to be read.
    Result<int> detect(Dialect first, bool onlyThat);
    [[nodiscard]] Dialect dialect() const { return dialect_; }

    /// The answer, which may be a refusal. Error: none came, or the connection is gone.
    Result<ColaAnswer> ask(const ColaRequest& request);

private:
    Result<std::optional<ColaAnswer>> await(const ColaRequest& request, std::chrono::milliseconds timeout);

    ColaLink& link_;
    const ScannerTimeouts& timeouts_;
    std::function<void(const ColaFrame&)> onFrame_;
    Dialect dialect_ = Dialect::B;
};

/// Reads everything that tells who and how the scanner is. A refused read is no error.
[[nodiscard]] Result<ScannerIdentity> identify(ScannerDialogue& dialogue, int deviceState);

} // namespace edgescan
