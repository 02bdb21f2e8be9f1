// Extra bytes of LAS points: further columns by name (ASPRS LAS 1.4 R15, "Extra Bytes").
#include "core/files/formats/las_layout.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace edgescan::files::las {
namespace {

constexpr std::size_t kDescriptor = 192;
constexpr std::size_t kTypeAt = 2, kOptionsAt = 3, kNameAt = 4, kNameBytes = 32;
constexpr std::uint16_t kExtraBytes = 4; // record id, of user LASF_Spec

constexpr std::array<Scalar, 10> kTypes{Scalar::UInt8, Scalar::Int8,   Scalar::UInt16, Scalar::Int16,   Scalar::UInt32,
                                        Scalar::Int32, Scalar::UInt64, Scalar::Int64,  Scalar::Float32, Scalar::Float64};

template <class T>
T valueAt(std::span<const std::byte> bytes, std::uint64_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

std::string nameIn(std::span<const std::byte> descriptor) {
    std::string name(reinterpret_cast<const char*>(descriptor.data() + kNameAt), kNameBytes);
    return name.substr(0, name.find('\0'));
}

/// The fields of one record of descriptors; those of types that are not a single number only move the next ones on.
std::vector<RecordField> fieldsIn(std::span<const std::byte> record, std::size_t from, std::size_t pointBytes) {
    std::vector<RecordField> fields;
    for (std::size_t at = 0; at + kDescriptor <= record.size() && from < pointBytes; at += kDescriptor) {
        const auto descriptor = record.subspan(at, kDescriptor);
        const auto type = std::to_integer<std::size_t>(descriptor[kTypeAt]);
        if (type == 0) { // so many undescribed bytes
            from += std::to_integer<std::size_t>(descriptor[kOptionsAt]);
            continue;
        }
        if (type > 3 * kTypes.size()) break;
        const Scalar scalar = kTypes[(type - 1) % kTypes.size()];
        const std::size_t count = (type - 1) / kTypes.size() + 1; // two or three of them, in old files
        if (count == 1 && from + sizeOf(scalar) <= pointBytes) fields.push_back({nameIn(descriptor), scalar, 0, from, pointBytes});
        from += count * sizeOf(scalar);
    }
    return fields;
}

} // namespace

std::vector<RecordField> extraFields(std::span<const std::byte> file, std::uint64_t recordsAt, std::uint64_t records,
                                     std::uint64_t recordsEnd, std::size_t from, std::size_t pointBytes) {
    std::uint64_t at = recordsAt;
    const std::uint64_t end = std::min<std::uint64_t>(recordsEnd, file.size());
    for (std::uint64_t n = 0; n < records && at + kRecordHeader <= end; ++n) {
        const std::uint64_t length = valueAt<std::uint16_t>(file, at + kRecordLength);
        const std::uint64_t content = at + kRecordHeader;
        if (content + length > end) break;
        std::array<char, 17> user{};
        std::memcpy(user.data(), file.data() + at + kRecordUser, 16);
        if (std::strcmp(user.data(), "LASF_Spec") == 0 && valueAt<std::uint16_t>(file, at + kRecordId) == kExtraBytes)
            return fieldsIn(file.subspan(content, length), from, pointBytes);
        at = content + length;
    }
    return {};
}

} // namespace edgescan::files::las
