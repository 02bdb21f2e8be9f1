// Walks a message's bytes along its definition.
#include "core/robots/bags/message.h"
#include "core/base/translated_text.h"

#include <algorithm>
#include <array>
#include <bit>

namespace edgescan::robots {
namespace {

template <class T>
T plainNumber(const std::uint8_t* at, bool bigEndian) {
    std::array<std::uint8_t, sizeof(T)> bytes{};
    std::copy_n(at, sizeof(T), bytes.begin());
    if (bigEndian) std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
}

double numberAt(const std::uint8_t* at, RosScalar scalar, bool bigEndian) {
    switch (scalar) {
    case RosScalar::Bool:
    case RosScalar::Uint8:
        return *at;
    case RosScalar::Int8:
        return static_cast<std::int8_t>(*at);
    case RosScalar::Int16:
        return plainNumber<std::int16_t>(at, bigEndian);
    case RosScalar::Uint16:
        return plainNumber<std::uint16_t>(at, bigEndian);
    case RosScalar::Int32:
        return plainNumber<std::int32_t>(at, bigEndian);
    case RosScalar::Uint32:
        return plainNumber<std::uint32_t>(at, bigEndian);
    case RosScalar::Int64:
        return static_cast<double>(plainNumber<std::int64_t>(at, bigEndian));
    case RosScalar::Uint64:
        return static_cast<double>(plainNumber<std::uint64_t>(at, bigEndian));
    case RosScalar::Float32:
        return static_cast<double>(plainNumber<float>(at, bigEndian));
    case RosScalar::Float64:
        return plainNumber<double>(at, bigEndian);
    default:
        return 0;
    }
}

/// Of the bytes of one message: byte order, and how numbers are aligned.
struct Layout {
    bool bigEndian = false;
    std::size_t largestAlignment = 1; ///< 1: nothing is aligned (ROS 1), 8: PLAIN_CDR, 4: PLAIN_CDR2
    bool endsTexts = false;           ///< texts end with a byte of 0, which their length counts
    bool delimitsArrays = false;      ///< arrays of messages and texts begin with their length in bytes (PLAIN_CDR2)
    bool fillsEmpty = false;          ///< a message without fields takes one byte (CDR of ROS 2)
};

class Walk {
public:
    Walk(const RosDefinition& definition, Layout layout, ByteView bytes)
        : definition_(definition), layout_(layout), bytes_(bytes), mayHold_(kValuesOfAny + kValuesPerByte * bytes.size()) {}

    bool message(const RosType& type, RosValue& into) {
        into.type = &type;
        if (type.fields.empty() && layout_.fillsEmpty && at_++ >= bytes_.size()) return false;
        if (!holds(type.fields.size())) return false;
        into.inside.resize(type.fields.size());
        for (std::size_t n = 0; n < type.fields.size(); ++n) {
            if (!field(type.fields[n], into.inside[n])) return false;
        }
        return true;
    }
    [[nodiscard]] std::size_t used() const { return at_; }

private:
    // Values of a definition may take no byte at all: their number is limited.
    static constexpr std::size_t kValuesOfAny = 4096, kValuesPerByte = 4;
    bool holds(std::size_t values) {
        if (values > mayHold_) return false;
        mayHold_ -= values;
        return true;
    }

    bool field(const RosField& field, RosValue& into) {
        into.field = &field;
        into.bigEndian = layout_.bigEndian;
        if (field.length == RosLength::One) return one(field, into);
        const bool ofNumbers = bytesOf(field.scalar) > 0;
        if (!ofNumbers && layout_.delimitsArrays && !number32()) return false;
        into.count = field.count;
        if (field.length == RosLength::Counted) {
            const auto count = number32();
            if (!count) return false;
            into.count = *count;
        }
        if (ofNumbers) return numbers(field.scalar, into.count, into);
        if (!holds(into.count)) return false;
        for (std::size_t n = 0; n < into.count; ++n) {
            RosValue& element = into.inside.emplace_back();
            element.field = &field;
            element.bigEndian = layout_.bigEndian;
            if (!one(field, element)) return false;
        }
        return true;
    }

    bool one(const RosField& field, RosValue& into) {
        if (field.scalar == RosScalar::Message) return message(definition_.types[field.type], into);
        if (field.scalar == RosScalar::String) return text(into);
        return numbers(field.scalar, 1, into);
    }

    bool numbers(RosScalar scalar, std::size_t count, RosValue& into) {
        const std::size_t size = bytesOf(scalar);
        if (count == 0) return true;
        if (!align(scalar == RosScalar::Time ? 4 : size) || count > (bytes_.size() - at_) / size) return false;
        into.bytes = bytes_.subspan(at_, count * size);
        at_ += count * size;
        return true;
    }

    bool text(RosValue& into) {
        const auto length = number32();
        if (!length || *length > bytes_.size() - at_) return false;
        into.bytes = bytes_.subspan(at_, *length);
        at_ += *length;
        if (layout_.endsTexts && !into.bytes.empty() && into.bytes.back() == 0) into.bytes = into.bytes.first(into.bytes.size() - 1);
        return true;
    }

    std::optional<std::uint32_t> number32() {
        if (!align(4) || bytes_.size() - at_ < 4) return std::nullopt;
        const auto value = plainNumber<std::uint32_t>(bytes_.data() + at_, layout_.bigEndian);
        at_ += 4;
        return value;
    }

    bool align(std::size_t size) {
        const std::size_t to = std::min(size, layout_.largestAlignment);
        at_ += (to - at_ % to) % to;
        return at_ <= bytes_.size();
    }

    const RosDefinition& definition_;
    Layout layout_;
    ByteView bytes_;
    std::size_t mayHold_; // further values
    std::size_t at_ = 0;
};

/// Of the encapsulation in front of a message (DDS-XTypes 1.3, table 59; the second number of a kind is that of RTPS 2.5).
std::optional<Layout> cdrLayout(std::uint8_t kind) {
    switch (kind) {
    case 0x00:
    case 0x01:
        return Layout{kind == 0x00, 8, true, false, true};
    case 0x06:
    case 0x07:
    case 0x10:
    case 0x11:
        return Layout{kind == 0x06 || kind == 0x10, 4, true, true, true};
    default:
        return std::nullopt;
    }
}

} // namespace

const RosValue* RosValue::at(std::string_view path) const {
    const RosValue* value = this;
    while (!path.empty()) {
        const std::string_view name = path.substr(0, path.find('.'));
        path.remove_prefix(std::min(name.size() + 1, path.size()));
        if (value->type == nullptr) return nullptr;
        const auto found = std::ranges::find(value->type->fields, name, &RosField::name);
        if (found == value->type->fields.end()) return nullptr;
        value = &value->inside[static_cast<std::size_t>(found - value->type->fields.begin())];
    }
    return value;
}

std::optional<double> RosValue::number(std::string_view path) const {
    const RosValue* value = at(path);
    if (value == nullptr || value->field == nullptr || value->field->length != RosLength::One || value->type != nullptr)
        return std::nullopt;
    const RosScalar scalar = value->field->scalar;
    if (scalar == RosScalar::String || scalar == RosScalar::Time || value->bytes.empty()) return std::nullopt;
    return numberAt(value->bytes.data(), scalar, value->bigEndian);
}

std::string_view RosValue::text(std::string_view path) const {
    const RosValue* value = at(path);
    if (value == nullptr || value->field == nullptr || value->field->scalar != RosScalar::String || value->field->length != RosLength::One)
        return {};
    return {reinterpret_cast<const char*>(value->bytes.data()), value->bytes.size()};
}

double RosValue::element(std::size_t n) const { return numberAt(bytes.data() + n * bytesOf(field->scalar), field->scalar, bigEndian); }

std::vector<double> RosValue::numbers(std::string_view path) const {
    const RosValue* value = at(path);
    std::vector<double> all;
    if (value == nullptr || value->field == nullptr || value->field->length == RosLength::One) return all;
    const std::size_t size = bytesOf(value->field->scalar);
    if (size == 0 || value->field->scalar == RosScalar::Time) return all;
    all.reserve(value->count);
    for (std::size_t n = 0; n < value->bytes.size() / size; ++n) all.push_back(value->element(n));
    return all;
}

Result<RosValue> rosMessage(const RosDefinition& definition, RosEncoding encoding, ByteView bytes, const std::string& where) {
    constexpr std::size_t kEncapsulation = 4;
    Layout layout;
    if (encoding == RosEncoding::Cdr) {
        const auto known = bytes.size() >= kEncapsulation && bytes[0] == 0 ? cdrLayout(bytes[1]) : std::nullopt;
        if (!known)
            return Error{withValues("a message of type %1 is encoded in a way that is not read (PLAIN_CDR and PLAIN_CDR2 are)",
                                    {definition.types.front().name}),
                         where, "record it with another middleware, or convert the bag"};
        layout = *known;
        bytes = bytes.subspan(kEncapsulation);
    }
    RosValue value;
    Walk walk(definition, layout, bytes);
    if (!walk.message(definition.types.front(), value))
        return Error{withValues("a message of type %1 ends too early or does not fit its definition", {definition.types.front().name}),
                     where, "copy the bag again"};
    return value;
}

std::optional<std::int64_t> stampNs(const RosValue& value, std::string_view path) {
    constexpr std::int64_t kNsPerS = 1'000'000'000;
    const RosValue* stamp = value.at(path);
    if (stamp == nullptr) return std::nullopt;
    if (stamp->field != nullptr && stamp->field->scalar == RosScalar::Time && stamp->bytes.size() == 8) {
        const auto seconds = plainNumber<std::uint32_t>(stamp->bytes.data(), stamp->bigEndian);
        return seconds * kNsPerS + plainNumber<std::uint32_t>(stamp->bytes.data() + 4, stamp->bigEndian);
    }
    const auto seconds = stamp->number("sec"), nanoseconds = stamp->number("nanosec");
    if (!seconds || !nanoseconds) return std::nullopt;
    return static_cast<std::int64_t>(*seconds) * kNsPerS + static_cast<std::int64_t>(*nanoseconds);
}

} // namespace edgescan::robots
