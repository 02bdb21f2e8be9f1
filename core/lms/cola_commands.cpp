// Requests to a scanner as bytes, and the form of its answers.
#include "core/lms/cola_commands.h"

#include "core/base/number_text.h"
#include "core/lms/cola_fields.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace edgescan {

namespace {

struct Writing {
    ColaWriter& writer;
    void operator()(std::uint8_t value) const { writer.u8(value); }
    void operator()(std::uint16_t value) const { writer.u16(value); }
    void operator()(std::uint32_t value) const { writer.u32(value); }
    void operator()(std::int32_t value) const { writer.i32(value); }
    void operator()(float value) const { writer.real(value); }
    void operator()(const std::string& value) const { writer.text(value); }
};

struct InWords {
    std::string operator()(float value) const { return significantText(static_cast<double>(value), 6); }
    std::string operator()(const std::string& value) const { return value; }
    template <class Number>
    std::string operator()(Number value) const {
        return std::to_string(value);
    }
};

struct Form {
    std::string_view answer;  ///< first word of the answer
    std::string_view request; ///< first word of what it answers
    AnswerKind kind;
};
constexpr std::array<Form, 6> kForms{{{"sRA", "sRN", AnswerKind::Read},
                                      {"sWA", "sWN", AnswerKind::Written},
                                      {"sAN", "sMN", AnswerKind::Method},
                                      {"sEA", "sEN", AnswerKind::Event},
                                      {"sMA", "", AnswerKind::Accepted},
                                      {"sSN", "", AnswerKind::Telegram}}};

std::string_view characters(ByteView bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

Result<ColaAnswer> parseRefusal(ByteView payload, Dialect dialect) {
    // CoLa B puts the code behind the letters without a blank.
    ColaReader reader(payload.subspan(std::min<std::size_t>(payload.size(), dialect == Dialect::A ? 4 : 3)), dialect);
    ColaAnswer answer;
    answer.kind = AnswerKind::Refused;
    answer.dialect = dialect;
    answer.refusal = reader.u16("the code of a refusal");
    if (reader.failed()) return reader.error();
    return answer;
}

} // namespace

Bytes encodeRequest(const ColaRequest& request, Dialect dialect) {
    ColaWriter writer(dialect);
    writer.word(request.type);
    writer.word(request.name);
    for (const ColaArgument& argument : request.arguments) std::visit(Writing{writer}, argument);
    return std::move(writer).done();
}

std::string requestText(const ColaRequest& request) {
    std::string text = request.type + " " + request.name;
    for (const ColaArgument& argument : request.arguments) {
        text += ' ';
        text += std::visit(InWords{}, argument);
    }
    return text;
}

ColaRequest readRequest(std::string name) { return {"sRN", std::move(name), {}}; }

ColaRequest subscribeRequest(std::string name, bool on) { return {"sEN", std::move(name), {std::uint8_t{on}}}; }

std::uint32_t accessHash(AccessLevel level) {
    if (level == AccessLevel::Maintenance) return 0xB21ACE26;
    return level == AccessLevel::Service ? 0x81BE23AA : 0xF4724744;
}

ColaRequest logInRequest(AccessLevel level) { return {"sMN", "SetAccessMode", {static_cast<std::uint8_t>(level), accessHash(level)}}; }

ColaRequest scanConfigurationRequest(const ScanConfiguration& wanted) {
    return {"sMN", "mLMPsetscancfg", {wanted.frequency, wanted.sectors, wanted.step, wanted.startAngle, wanted.stopAngle}};
}

ColaRequest outputRangeRequest(const OutputRange& wanted) {
    return {"sWN", "LMPoutputRange", {wanted.sectors, wanted.step, wanted.startAngle, wanted.stopAngle}};
}

ColaRequest telegramContentRequest(const TelegramContent& wanted) {
    // Two masks are sent with the low byte first, unlike everything else.
    return {"sWN",
            "LMDscandatacfg",
            {wanted.channels, wanted.channelsHigh, std::uint8_t{wanted.remission}, std::uint8_t{wanted.remission16}, wanted.unit,
             wanted.encoder, wanted.encoderHigh, std::uint8_t{wanted.position}, std::uint8_t{wanted.deviceName},
             std::uint8_t{wanted.comment}, std::uint8_t{wanted.time}, wanted.everyNth}};
}

ColaRequest echoFilterRequest(EchoFilter wanted) { return {"sWN", "FREchoFilter", {static_cast<std::uint8_t>(wanted)}}; }

Result<ColaAnswer> parseAnswer(ByteView payload, Dialect dialect) {
    if (characters(payload).starts_with("sFA")) return parseRefusal(payload, dialect);
    ColaReader reader(payload, dialect);
    const std::string_view letters = reader.word();
    const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const Form& f) { return f.answer == letters; });
    if (form == kForms.end()) return Error{"this is no answer of a scanner", "byte 0 of the telegram", {}};
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
    const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const Form& f) { return f.kind == answer.kind; });
    return form != kForms.end() && form->request == request.type && answer.name == request.name;
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

std::string answerText(const ColaAnswer& answer) {
    if (answer.kind == AnswerKind::Refused) return "sFA " + std::to_string(answer.refusal) + " (" + refusalText(answer.refusal) + ")";
    const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const Form& f) { return f.kind == answer.kind; });
    std::string text = std::string(form->answer) + " " + answer.name;
    if (answer.arguments.empty()) return text;
    if (answer.dialect == Dialect::A) return text + " " + std::string(characters(answer.arguments));
    for (const std::uint8_t byte : answer.arguments) {
        char hex[4];
        std::snprintf(hex, sizeof hex, " %02X", byte);
        text += hex;
    }
    return text;
}

} // namespace edgescan
