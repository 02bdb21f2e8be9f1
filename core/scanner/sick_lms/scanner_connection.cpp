// Connects to a scanner and reconnects after a loss.
#include "core/scanner/sick_lms/scanner_connection.h"

#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include <algorithm>

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

/// A scan is counted before its event is called, so that statistics() inside or after the event includes it.
ColaLink::Hooks hooksOf(const ConnectionEvents& events, std::atomic<std::uint64_t>& scans) {
    const auto received = [&scans, frameReceived = events.frameReceived](const ColaFrame& frame) {
        if (isScanTelegram(frame.payload())) ++scans;
        if (frameReceived) frameReceived(frame);
    };
    return {received, events.frameSent};
}

std::string seconds(std::chrono::duration<double> duration) { return fixedText(duration.count(), 1) + " s"; }

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

const char* connectionPhaseName(ConnectionPhase phase) {
    constexpr const char* kNames[] = {"CONNECTING", "IDENTIFYING", "LIVE", "STALE", "LOST", "STOPPED"};
    return kNames[static_cast<std::size_t>(phase)];
}

Error noLinesError(const ConnectionState& state, const std::string& address) {
    if (state.problem) return *state.problem;
    if (address.starts_with("ws://"))
        return {"no line was received", address, "check that foxglove_bridge runs there; a scanner of SICK is HOST without ws://"};
    return {"no line was received", address, "check cable, address and port"};
}

LiveConnection::LiveConnection(ConnectionSettings settings, std::function<void(const ConnectionState&)> stateChanged)
    : settings_(std::move(settings)), firstScanTimeout_(settings_.timeouts.firstScan), stateChanged_(std::move(stateChanged)) {}

void LiveConnection::begin() {
    thread_ = std::thread([this] { run(); });
}

void LiveConnection::stop() {
    link().interrupt();
    if (thread_.joinable() && std::this_thread::get_id() != thread_.get_id()) thread_.join();
}

ConnectionState LiveConnection::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

ConnectionStatistics LiveConnection::statistics() const {
    const std::uint64_t connections = connections_;
    return {counts(), scans_, connections, connections > 0 ? connections - 1 : 0};
}

void LiveConnection::enter(ConnectionPhase phase, std::string sentence, std::optional<Error> problem) {
    ConnectionState state{phase, std::move(sentence), hostNow(), std::move(problem)};
    {
        const std::lock_guard lock(mutex_);
        if (!state.problem && phase != ConnectionPhase::Live) state.problem = state_.problem;
        state_ = state;
    }
    if (stateChanged_) stateChanged_(state);
}

void LiveConnection::run() {
    std::size_t failures = 0;
    while (true) {
        scansHere_ = 0;
        Error end = connection();
        link().close();
        if (link().interrupted()) return enter(ConnectionPhase::Stopped, withValues("%1: disconnected.", {where()}));
        if (end.where.empty()) end.where = where();
        if (scansHere_ > 0) failures = 0;
        const auto& rests = settings_.timeouts.rests;
        const auto rest = rests.empty() ? std::chrono::milliseconds(0) : rests[std::min(failures, rests.size() - 1)];
        ++failures;
        enter(ConnectionPhase::Lost, withValues("%1 Trying again in %2.", {end.sentence(), seconds(rest)}), end);
        link().pause(rest);
    }
}

Error LiveConnection::connection() {
    enter(ConnectionPhase::Connecting, withValues("Connecting to %1.", {where()}));
    if (const auto connected = link().connect(settings_.host, settings_.port, settings_.timeouts.connect); !connected)
        return connected.error();
    ++connections_;
    if (const auto started = start(); !started) return started.error();
    return watch();
}

LiveConnection::Clock::duration LiveConnection::watchdog() const {
    const auto tenPeriods = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(10.0 * periodS_));
    return std::max<Clock::duration>(settings_.timeouts.silence, tenPeriods);
}

/// Receives until the connection ends or no more scans arrive.
Error LiveConnection::watch() {
    const auto enterLive = [&](const char* sending) {
        enter(ConnectionPhase::Live, where() + sending + (note_.empty() ? "" : " " + note_));
    };
    const Clock::time_point subscribed = Clock::now();
    if (scansHere_ > 0) enterLive(" is sending.");
    while (!link().interrupted()) {
        const bool begun = scansHere_ > 0;
        const auto timeout = begun ? watchdog() : firstScanTimeout_;
        const auto silentSince = begun ? lastScan_ : subscribed;
        const auto phase = state().phase;
        const bool live = phase == ConnectionPhase::Live;
        const std::uint64_t before = scansHere_;
        if (const auto received = receive(silentSince + (live ? timeout / 2 : timeout)); !received) return received.error();
        if (scansHere_ > before) {
            if (!live) enterLive(phase == ConnectionPhase::Stale ? " is sending again." : " is sending.");
            continue;
        }
        const auto silence = Clock::now() - silentSince;
        if (silence >= timeout) return silent(seconds(timeout));
        if (live && silence >= timeout / 2) enter(ConnectionPhase::Stale, withValues("%1: no scan for %2.", {where(), seconds(silence)}));
    }
    return {"interrupted", where(), {}};
}

ScannerConnection::ScannerConnection(ConnectionSettings settings, ConnectionEvents events)
    : LiveConnection(std::move(settings), events.stateChanged), events_(std::move(events)),
      dialect_(settings_.dialect.value_or(Dialect::B)), link_(hooksOf(events_, scans_)) {
    begin();
}

Result<Done> ScannerConnection::start() {
    enter(ConnectionPhase::Identifying, withValues("%1 accepts the connection; asking what it is.", {where()}));
    ScannerDialogue dialogue(link_, settings_.timeouts, [this](const ColaFrame& frame) { noticeScan(frame); });
    const auto deviceState = dialogue.detect(dialect_, settings_.dialect.has_value());
    if (!deviceState) return deviceState.error();
    dialect_ = dialogue.dialect();
    const auto who = identify(dialogue, *deviceState);
    if (!who) return who.error();
    if (link_.interrupted()) return Error{"interrupted", where(), {}};
    everyNth_ = who->content ? std::max<std::uint16_t>(who->content->everyNth, 1) : std::uint16_t{1};
    // A scanner that is still starting gets more time.
    const bool ready = *deviceState == 1 || (who->measuring && who->measuring->state == 7);
    firstScanTimeout_ = ready ? settings_.timeouts.firstScan : std::max(settings_.timeouts.firstScan, settings_.timeouts.startUp);
    if (events_.identified) events_.identified(*who);
    const auto answer = dialogue.ask({ColaRequest::Kind::Subscribe, "LMDscandata"});
    if (!answer) return answer.error();
    if (answer->kind == AnswerKind::Refused)
        return Error{withValues("the scanner refuses to send scans: %1", {std::string(refusalText(answer->refusal))}), where(),
                     "check what else uses it"};
    return Done{};
}

void ScannerConnection::noticeScan(const ColaFrame& frame) {
    if (!isScanTelegram(frame.payload())) return;
    ++scansHere_;
    lastScan_ = Clock::now();
    if (scansHere_ > 1) return;
    // The session itself needs only the scan frequency.
    const auto telegram = decodeScanTelegram(frame);
    const double hertz = telegram ? scanFrequencyHz(*telegram) : 0.0;
    periodS_ = hertz > 0.0 ? std::min(everyNth_ / hertz, 60.0) : 0.0;
}

Result<Done> ScannerConnection::receive(Clock::time_point deadline) {
    const auto frames = link_.receive(deadline);
    if (!frames) return frames.error();
    for (const ColaFrame& frame : *frames) noticeScan(frame);
    return Done{};
}

Error ScannerConnection::silent(const std::string& time) const {
    return {withValues("no scan for %1", {time}), where(), "check the cable and whether the scanner's mirror turns"};
}

} // namespace edgescan::scanner
