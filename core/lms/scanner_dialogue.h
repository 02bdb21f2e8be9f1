// Question and answer with a scanner, one at a time, and finding out who it is. Reads only unless writing is allowed.
// (docs/protocol.md, "Dialect", "Requests and answers".)
#pragma once

#include "core/lms/cola_commands.h"
#include "core/lms/cola_link.h"
#include "core/lms/scan_telegram.h"

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
struct ScannerPatience {
    std::chrono::milliseconds connect{5000};
    std::chrono::milliseconds detect{1000};
    std::chrono::milliseconds answer{2000};
    std::chrono::milliseconds slowAnswer{20000}; ///< mEEwriteall and Run
    std::chrono::milliseconds ready{30000};      ///< from Run to measuring
    std::chrono::milliseconds firstScan{5000};
    std::chrono::milliseconds leastWatchdog{1000};
    std::vector<std::chrono::milliseconds> backOff{std::chrono::milliseconds(500), std::chrono::milliseconds(1000),
                                                   std::chrono::milliseconds(2000), std::chrono::milliseconds(4000),
                                                   std::chrono::milliseconds(5000)};
};

class ScannerDialogue {
public:
    /// `onFrame`: every frame that arrives while an answer is awaited; scans keep coming. Must outlive this: `link`.
    ScannerDialogue(ColaLink& link, const ScannerPatience& patience, std::function<void(const ColaFrame&)> onFrame)
        : link_(link), patience_(patience), onFrame_(std::move(onFrame)) {}

    /// Which dialect the scanner answers in; `first` is tried first (docs/protocol.md, "Dialect"). Its state is the answer.
    Result<int> detect(Dialect first, bool onlyThat);
    [[nodiscard]] Dialect dialect() const { return dialect_; }

    /// The only way to anything that changes the scanner.
    void allowWriting() { mayWrite_ = true; }

    /// The answer, which may be a refusal. Error: none came, the connection is gone, or writing is not allowed.
    Result<ColaAnswer> ask(const ColaRequest& request);

    [[nodiscard]] ColaLink& link() { return link_; }
    [[nodiscard]] const ScannerPatience& patience() const { return patience_; }

private:
    Result<std::optional<ColaAnswer>> await(const ColaRequest& request, std::chrono::milliseconds patience);

    ColaLink& link_;
    const ScannerPatience& patience_;
    std::function<void(const ColaFrame&)> onFrame_;
    Dialect dialect_ = Dialect::B;
    bool mayWrite_ = false;
};

/// Reads everything that tells who and how the scanner is. A refused read is no error.
[[nodiscard]] Result<ScannerIdentity> identify(ScannerDialogue& dialogue, int deviceState);

} // namespace edgescan
