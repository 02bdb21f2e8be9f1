// Any text as a definition and any bytes as a message of it. The first byte chooses the serialization, the next two are the length of the
// text.
#include "core/robots/bags/message.h"
#include "tests/fuzz/open_bytes.h"

#include <algorithm>

namespace {

/// Values in the tree, each looked at by all ways there are.
std::size_t valuesIn(const edgescan::robots::RosValue& value) {
    std::size_t values = 1;
    static_cast<void>(value.number("header.stamp.sec"));
    static_cast<void>(value.numbers(value.field != nullptr ? value.field->name : std::string()));
    for (const auto& inside : value.inside) values += valuesIn(inside);
    return values;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace edgescan;
    if (size < 3) return 0;
    const std::size_t length = std::min<std::size_t>(size - 3, bytes[1] + 256U * bytes[2]);
    const std::string text(reinterpret_cast<const char*>(bytes) + 3, length);
    const auto definition = robots::rosDefinition("fuzz/Message", text, "fuzz");
    if (!definition) {
        fuzz::hold(definition.error().sentence().find('\n') == std::string::npos);
        return 0;
    }
    const ByteView message(bytes + 3 + length, size - 3 - length);
    const auto encoding = bytes[0] % 2 == 0 ? robots::RosEncoding::Ros1 : robots::RosEncoding::Cdr;
    const auto value = robots::rosMessage(*definition, encoding, message, "fuzz");
    if (!value) return 0;
    static_cast<void>(robots::stampNs(*value, "header.stamp"));
    fuzz::hold(valuesIn(*value) <= 4097 + 4 * message.size());
    return 0;
}
