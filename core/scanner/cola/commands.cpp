// Encodes requests to a scanner and parses its answers.
#include "core/scanner/cola/commands.h"

#include "core/scanner/cola/fields.h"

#include <algorithm>
#include <array>

namespace edgescan::scanner {

namespace {

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

} // namespace

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
