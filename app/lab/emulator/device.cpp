// The answers of an emulated LMS511 to requests (docs/developer/protocol.md, "Requests and answers").
#include "app/lab/emulator/device.h"

#include "core/scanner/cola/fields.h"

#include <algorithm>
#include <cmath>

namespace edgescan::scanner {

namespace {

enum Refusal : int { MethodDenied = 1, UnknownVariable = 3, WrongArguments = 5, WriteDenied = 10, UnknownCommand = 12, UnknownEvent = 15 };

int refusalOf(std::string_view type) {
    if (type == "sRN") return UnknownVariable;
    if (type == "sWN") return WriteDenied;
    if (type == "sMN") return MethodDenied;
    return type == "sEN" ? UnknownEvent : UnknownCommand;
}

Bytes refusal(int code, Dialect dialect) {
    ColaWriter writer(dialect);
    if (dialect == Dialect::A) {
        writer.word("sFA");
    } else {
        writer.fixed("sFA"); // the code follows without a blank
    }
    writer.u16(static_cast<std::uint16_t>(code));
    return std::move(writer).done();
}

void writeScan(ColaWriter& writer, const ScanConfiguration& scan) {
    writer.u32(scan.frequency);
    writer.u16(scan.sectors);
    writer.u32(scan.step);
    writer.i32(scan.startAngle);
    writer.i32(scan.stopAngle);
}

void writeRange(ColaWriter& writer, const OutputRange& range) {
    writer.u16(range.sectors);
    writer.u32(range.step);
    writer.i32(range.startAngle);
    writer.i32(range.stopAngle);
}

void writeContent(ColaWriter& writer, const TelegramContent& c) {
    for (const std::uint8_t byte :
         {c.channels, c.channelsHigh, std::uint8_t{c.remission}, std::uint8_t{c.remission16}, c.unit, c.encoder, c.encoderHigh,
          std::uint8_t{c.position}, std::uint8_t{c.deviceName}, std::uint8_t{c.comment}, std::uint8_t{c.time}})
        writer.u8(byte);
    writer.u16(c.everyNth);
}

void writeMeasuringState(ColaWriter& writer) {
    writer.u16(7);
    writer.u8(0);
    writer.text("00:00:00");
    writer.text("01.01.1970");
    for (int led = 0; led < 3; ++led) writer.u16(0);
}

} // namespace

EmulatedDevice::EmulatedDevice(const ScanTelegram& likeThis, std::map<std::string, int> refusals)
    : refusals_(std::move(refusals)), location_("SN " + std::to_string(likeThis.serialNumber)) {
    scan_.frequency = likeThis.scanFrequency > 0 ? likeThis.scanFrequency : 2500;
    if (!likeThis.channels16.empty()) {
        const ScanChannel& channel = likeThis.channels16.front();
        const BeamGrid grid = beamGrid(channel);
        scan_.step = channel.step;
        scan_.startAngle = channel.startAngle;
        scan_.stopAngle = static_cast<std::int32_t>(std::lround((grid.startDeg + grid.stepDeg * std::max(grid.beams - 1, 0)) * 1e4));
    }
    range_ = {1, scan_.step, scan_.startAngle, scan_.stopAngle};
    content_.remission = !likeThis.channels8.empty();
    content_.encoder = likeThis.encoders.empty() ? 0 : 1;
    content_.deviceName = likeThis.deviceName.has_value();
    content_.comment = likeThis.comment.has_value();
    content_.position = likeThis.position.has_value();
    content_.time = likeThis.clock.has_value();
}

/// Returns false if the variable does not exist.
bool EmulatedDevice::writeVariable(ColaWriter& writer, std::string_view name) const {
    constexpr std::uint8_t kReady = 1, kLastEcho = 2;
    if (name == "LMPscancfg") return writeScan(writer, scan_), true;
    if (name == "LMPoutputRange") return writeRange(writer, range_), true;
    if (name == "LMDscandatacfg") return writeContent(writer, content_), true;
    if (name == "FREchoFilter") return writer.u8(kLastEcho), true;
    if (name == "DeviceIdent") return writer.text("LMS511 emulated"), writer.text("EdgeScan"), true;
    if (name == "FirmwareVersion") return writer.text("V1.80    "), true;
    if (name == "LocationName") return writer.text(location_), true;
    if (name == "SCdevicestate") return writer.u8(kReady), true;
    if (name == "STlms") return writeMeasuringState(writer), true;
    if (name == "ODoprh" || name == "ODpwrc") return writer.u32(1085), true;
    return false;
}

Bytes EmulatedDevice::answer(ByteView request, Dialect dialect, bool& subscribed) const {
    ColaReader reader(request, dialect);
    ColaWriter writer(dialect);
    const std::string type(reader.word());
    const std::string name(reader.word());
    if (const auto refused = refusals_.find(name); refused != refusals_.end()) return refusal(refused->second, dialect);
    if (type == "sRN" && name == "LMDscandata") return {};
    if (type == "sRN") {
        writer.word("sRA");
        writer.word(name);
        if (writeVariable(writer, name)) return std::move(writer).done();
    }
    if (type == "sEN" && (name == "LMDscandata" || name == "LFErec" || name == "LIDoutputstate" || name == "LIDinputstate")) {
        const int on = reader.u8("switch");
        if (reader.failed() || on > 1) return refusal(WrongArguments, dialect);
        if (name == "LMDscandata") subscribed = on == 1;
        writer.word("sEA");
        writer.word(name);
        writer.u8(static_cast<std::uint8_t>(on));
        return std::move(writer).done();
    }
    return refusal(refusalOf(type), dialect);
}

} // namespace edgescan::scanner
