// Sends requests to a scanner, waits for answers, and identifies the scanner.
#include "core/scanner/sick_lms/scanner_dialogue.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"

namespace edgescan::scanner {

namespace {

std::string trimmed(std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::string degrees(double tenThousandths) { return significantText(tenThousandths / 1e4, 4); }

/// Reads one variable and stores its value. A refusal or an unreadable answer is noted; it is not an error.
template <class Value, class Parse>
Result<Done> readInto(ScannerDialogue& dialogue, const char* name, Parse parse, std::optional<Value>& value,
                      std::vector<std::string>& refused) {
    const auto answer = dialogue.ask({ColaRequest::Kind::Read, name});
    if (!answer) return answer.error();
    if (auto parsed = parse(*answer)) {
        value = std::move(*parsed);
    } else {
        refused.push_back(std::string(name) + ": " + parsed.error().what);
    }
    return Done{};
}

} // namespace

std::string ScannerIdentity::words() const {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (device) add(trimmed(device->name) + " " + trimmed(device->version));
    if (location && !trimmed(*location).empty()) add(trimmed(*location));
    if (firmware) add(withValues("firmware %1", {trimmed(*firmware)}));
    add(dialectName(dialect));
    if (scan) add(degrees(scan->frequency * 100.0) + " Hz");
    if (range) add(withValues("%1 degrees from %2 to %3", {degrees(range->step), degrees(range->startAngle), degrees(range->stopAngle)}));
    if (deviceState && *deviceState != 1) add(deviceStateText(*deviceState));
    return text;
}

Result<std::optional<ColaAnswer>> ScannerDialogue::await(const ColaRequest& request, std::chrono::milliseconds timeout) {
    const auto deadline = ColaLink::Clock::now() + timeout;
    std::optional<ColaAnswer> found;
    do {
        const auto frames = link_.receive(deadline);
        if (!frames) return frames.error();
        for (const ColaFrame& frame : *frames) {
            if (link_.interrupted()) break;
            onFrame_(frame);
            auto answer = parseAnswer(frame.payload(), frame.dialect);
            if (!found && answer && answers(*answer, request)) found = std::move(*answer);
        }
    } while (!found && !link_.interrupted() && ColaLink::Clock::now() < deadline);
    return found;
}

Result<int> ScannerDialogue::detect(Dialect first, bool onlyThat) {
    const ColaRequest request{ColaRequest::Kind::Read, "SCdevicestate"};
    const Dialect second = first == Dialect::B ? Dialect::A : Dialect::B;
    for (const Dialect dialect : {first, second}) {
        if (onlyThat && dialect != first) break;
        if (const auto sent = link_.send(encodeRequest(request, dialect), dialect, timeouts_.answer); !sent) return sent.error();
        const auto answer = await(request, timeouts_.detect);
        if (!answer) return answer.error();
        if (!*answer) continue;
        dialect_ = (*answer)->dialect; // a scanner set to CoLa A may accept a request in B, but it answers in A
        const auto state = parseNumber8(**answer);
        return state ? *state : -1;
    }
    return Error{
        "something accepts the connection but does not answer in CoLa", {}, "check that it is a SICK scanner and the port is 2111 or 2112"};
}

Result<ColaAnswer> ScannerDialogue::ask(const ColaRequest& request) {
    if (const auto sent = link_.send(encodeRequest(request, dialect_), dialect_, timeouts_.answer); !sent) return sent.error();
    auto answer = await(request, timeouts_.answer);
    if (!answer) return answer.error();
    if (!*answer) return Error{withValues("no answer to \"%1\"", {requestText(request)}), {}, "check the connection"};
    return std::move(**answer);
}

Result<ScannerIdentity> identify(ScannerDialogue& dialogue, int deviceState) {
    ScannerIdentity who;
    who.dialect = dialogue.dialect();
    if (deviceState >= 0) who.deviceState = deviceState;
    std::optional<Error> gone;
    const auto read = [&](const char* name, auto parse, auto& value) {
        if (gone) return;
        if (const auto done = readInto(dialogue, name, parse, value, who.refused); !done) gone = done.error();
    };
    read("DeviceIdent", parseDeviceIdentity, who.device);
    read("FirmwareVersion", parseText, who.firmware);
    read("LocationName", parseText, who.location);
    read("ODoprh", parseNumber32, who.operatingTenths);
    read("ODpwrc", parseNumber32, who.powerOns);
    read("STlms", parseMeasuringState, who.measuring);
    read("LMPscancfg", parseScanConfiguration, who.scan);
    read("LMPoutputRange", parseOutputRange, who.range);
    read("LMDscandatacfg", parseTelegramContent, who.content);
    read("FREchoFilter", parseNumber8, who.echoFilter);
    if (gone) return *gone;
    return who;
}

} // namespace edgescan::scanner
