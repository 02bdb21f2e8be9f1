// Reads the arguments of a scanner's answers.
#include "core/base/translated_text.h"
#include "core/scanner/cola/commands.h"

#include "core/scanner/cola/fields.h"

namespace edgescan::scanner {

namespace {

/// Reads one value with `read`; the error's sentence names the answer that could not be read.
template <class Read>
auto parsed(const ColaAnswer& answer, Read read) -> Result<decltype(read(std::declval<ColaReader&>()))> {
    if (answer.kind == AnswerKind::Refused) return Error{refusalText(answer.refusal), "the scanner", {}};
    ColaReader reader(answer.arguments, answer.dialect);
    auto value = read(reader);
    if (!reader.failed()) return value;
    Error error = reader.error();
    error.where = withValues("the scanner's answer to %1", {answer.name});
    return error;
}

} // namespace

Result<int> parseNumber8(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) { return int{reader.u8("the value")}; });
}

Result<std::uint32_t> parseNumber32(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) { return reader.u32("the value"); });
}

Result<std::string> parseText(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) { return reader.text("the text"); });
}

Result<ScanConfiguration> parseScanConfiguration(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) {
        ScanConfiguration configuration;
        configuration.frequency = reader.u32("the scan frequency");
        configuration.sectors = reader.u16("the number of sectors");
        configuration.step = reader.u32("the angle step");
        configuration.startAngle = reader.i32("the start angle");
        configuration.stopAngle = reader.i32("the stop angle");
        return configuration;
    });
}

Result<OutputRange> parseOutputRange(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) {
        OutputRange range;
        range.sectors = reader.u16("the number of sectors");
        range.step = reader.u32("the angle step");
        range.startAngle = reader.i32("the start angle");
        range.stopAngle = reader.i32("the stop angle");
        return range;
    });
}

Result<TelegramContent> parseTelegramContent(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) {
        TelegramContent content;
        content.channels = reader.u8("the channels");
        content.channelsHigh = reader.u8("the channels");
        content.remission = reader.u8("the remission switch") != 0;
        content.remission16 = reader.u8("the remission width") != 0;
        content.unit = reader.u8("the unit");
        content.encoder = reader.u8("the encoders");
        content.encoderHigh = reader.u8("the encoders");
        content.position = reader.u8("the position switch") != 0;
        content.deviceName = reader.u8("the name switch") != 0;
        content.comment = reader.u8("the comment switch") != 0;
        content.time = reader.u8("the time switch") != 0;
        content.everyNth = reader.u16("the output interval");
        return content;
    });
}

Result<DeviceIdentity> parseDeviceIdentity(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) {
        DeviceIdentity identity;
        identity.name = reader.text("the name");
        identity.version = reader.text("the version");
        return identity;
    });
}

Result<MeasuringState> parseMeasuringState(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) {
        MeasuringState state;
        state.state = reader.u16("the state");
        (void)reader.u8("the temperature range");
        state.time = reader.text("the time");
        state.date = reader.text("the date");
        return state;
    });
}

const char* deviceStateText(int state) {
    if (state == 0) return "busy";
    if (state == 1) return "ready";
    return state == 2 ? "error" : "unknown";
}

} // namespace edgescan::scanner
