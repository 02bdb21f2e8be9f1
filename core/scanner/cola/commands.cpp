// Encodes requests to a scanner and parses its answers.
#include "core/scanner/cola/commands.h"
#include "core/base/translated_text.h"

#include "core/scanner/cola/fields.h"

#include <algorithm>
#include <array>

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

struct Form {
    std::string_view letters; ///< the first word of the answer
    AnswerKind kind;
};
constexpr std::array<Form, 6> kForms{{{"sRA", AnswerKind::Read},
                                      {"sEA", AnswerKind::Subscribed},
                                      {"sSN", AnswerKind::Telegram},
                                      {"sWA", AnswerKind::Other},
                                      {"sAN", AnswerKind::Other},
                                      {"sMA", AnswerKind::Other}}};

std::string_view characters(ByteView bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

Result<ColaAnswer> parseRefusal(ByteView payload, Dialect dialect) {
    // CoLa B puts the code directly behind the letters, without a blank.
    ColaReader reader(payload.subspan(std::min<std::size_t>(payload.size(), dialect == Dialect::A ? 4 : 3)), dialect);
    ColaAnswer answer;
    answer.kind = AnswerKind::Refused;
    answer.dialect = dialect;
    answer.refusal = reader.u16("the code of a refusal");
    if (reader.failed()) return reader.error();
    return answer;
}

/// What a scan configuration and an output range have alike.
template <class Angles>
void readSectors(ColaReader& reader, Angles& angles) {
    angles.sectors = reader.u16("the number of sectors");
    angles.step = reader.u32("the angle step");
    angles.startAngle = reader.i32("the start angle");
    angles.stopAngle = reader.i32("the stop angle");
}

} // namespace

// Reads the arguments of a scanner's answers.

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
        readSectors(reader, configuration);
        return configuration;
    });
}

Result<OutputRange> parseOutputRange(const ColaAnswer& answer) {
    return parsed(answer, [](ColaReader& reader) {
        OutputRange range;
        readSectors(reader, range);
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

Bytes encodeRequest(const ColaRequest& request, Dialect dialect) {
    const bool read = request.kind == ColaRequest::Kind::Read;
    ColaWriter writer(dialect);
    writer.word(read ? "sRN" : "sEN");
    writer.word(request.name);
    if (!read) writer.u8(1);
    return std::move(writer).done();
}

std::string requestText(const ColaRequest& request) {
    const Bytes text = encodeRequest(request, Dialect::A);
    return {text.begin(), text.end()};
}

Result<ColaAnswer> parseAnswer(ByteView payload, Dialect dialect) {
    if (characters(payload).starts_with("sFA")) return parseRefusal(payload, dialect);
    ColaReader reader(payload, dialect);
    const std::string_view letters = reader.word();
    const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const Form& f) { return f.letters == letters; });
    if (form == kForms.end()) return Error{"this is not an answer of a scanner", "byte 0 of the telegram", {}};
    ColaAnswer answer;
    answer.kind = form->kind;
    answer.dialect = dialect;
    answer.name = reader.word();
    if (answer.name.empty()) return Error{"an answer without a name", "byte 4 of the telegram", {}};
    answer.arguments.assign(reader.rest().begin(), reader.rest().end());
    return answer;
}

bool answers(const ColaAnswer& answer, const ColaRequest& request) {
    if (answer.kind == AnswerKind::Refused) return true;
    const AnswerKind wanted = request.kind == ColaRequest::Kind::Read ? AnswerKind::Read : AnswerKind::Subscribed;
    return answer.kind == wanted && answer.name == request.name;
}

const char* refusalText(int code) {
    constexpr std::array<const char*, 0x21> kTexts{nullptr,
                                                   "access to the method is denied, log in first",
                                                   "the method is not known",
                                                   "the variable is not known",
                                                   "not possible now, or a value is out of its range",
                                                   "the arguments are wrong in number or form",
                                                   "unknown error",
                                                   "the telegram is too long",
                                                   "the telegram is too short",
                                                   "the type is not known",
                                                   "writing the variable is denied, log in first",
                                                   "the command is not known to the name server",
                                                   "the CoLa command is not known",
                                                   "the method is still busy",
                                                   "an array is out of its bounds",
                                                   "the event is not known",
                                                   "a CoLa A value is too large",
                                                   "a CoLa A character is invalid",
                                                   "no message",
                                                   "no answer",
                                                   "internal error",
                                                   "hub address is corrupted",
                                                   "hub address cannot be decoded",
                                                   "hub address is out of range",
                                                   "hub address expected",
                                                   "asynchronous methods are suppressed"};
    if (code == 0x20) return "complex arrays are not supported";
    const bool known = code > 0 && code < static_cast<int>(kTexts.size()) && kTexts[static_cast<std::size_t>(code)] != nullptr;
    return known ? kTexts[static_cast<std::size_t>(code)] : "a reason that is not documented";
}

} // namespace edgescan::scanner
