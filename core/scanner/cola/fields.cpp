// Reads and writes the fields of a CoLa payload in order.
#include "core/scanner/cola/fields.h"
#include "core/base/translated_text.h"

#include <algorithm>
#include <charconv>

namespace edgescan::scanner {

std::string_view ColaReader::characters(std::size_t from, std::size_t count) const {
    return {reinterpret_cast<const char*>(payload_.data()) + from, count};
}

std::uint32_t ColaReader::fail(const char* field, const std::string& why) {
    if (!error_) error_ = Error{std::string(field) + " " + why, withValues("byte %1 of the telegram", {at_}), {}};
    return 0;
}

std::string_view ColaReader::word() {
    const std::string_view rest = characters(at_, left());
    const std::string_view found = rest.substr(0, rest.find(' '));
    at_ += std::min(found.size() + 1, rest.size());
    return found;
}

std::uint32_t ColaReader::number(unsigned bits, bool isSigned, const char* field) {
    if (error_) return 0;
    return dialect_ == Dialect::B ? binaryNumber(bits, field) : textNumber(bits, isSigned, field);
}

std::uint32_t ColaReader::binaryNumber(unsigned bits, const char* field) {
    const std::size_t bytes = bits / 8;
    if (left() < bytes) return fail(field, "is cut off");
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8U | payload_[at_ + i];
    at_ += bytes;
    return value;
}

std::uint32_t ColaReader::textNumber(unsigned bits, bool isSigned, const char* field) {
    if (left() == 0) return fail(field, "is cut off");
    const std::string_view rest = characters(at_, left());
    const std::string_view token = rest.substr(0, rest.find(' '));
    // A sign means decimal; without a sign the number is hexadecimal two's complement.
    const bool decimal = token.starts_with('+') || token.starts_with('-');
    const std::string_view digits = token.starts_with('+') ? token.substr(1) : token;
    std::int64_t value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value, decimal ? 10 : 16);
    const bool whole = !digits.empty() && problem == std::errc() && end == digits.data() + digits.size() &&
                       !(token.starts_with('+') && digits.starts_with('-'));
    const std::int64_t beyond = std::int64_t{1} << (decimal && isSigned ? bits - 1 : bits);
    if (!whole || value >= beyond || value < (decimal && isSigned ? -beyond : 0))
        return fail(field, withValues("is not a number of %1 bits", {bits}));
    at_ += std::min(token.size() + 1, rest.size());
    return static_cast<std::uint32_t>(value);
}

std::string ColaReader::fixed(std::size_t length, const char* field) {
    if (error_) return {};
    if (left() < length) {
        fail(field, "is cut off");
        return {};
    }
    std::string text(characters(at_, length));
    if (dialect_ == Dialect::B) {
        at_ += length;
        return text;
    }
    const bool last = left() == length;
    if (!last && length > 0 && payload_[at_ + length] != ' ') {
        fail(field, withValues("does not end after %1 characters", {length}));
        return {};
    }
    // Behind an empty text some scanners write its blank, others do not.
    if (!last && payload_[at_ + length] == ' ') ++length;
    at_ += length;
    return text;
}

std::string ColaReader::text(const char* field) {
    const std::size_t length = u16(field);
    return fixed(length, field);
}

std::vector<std::uint16_t> ColaReader::values(std::size_t count, unsigned bits, const char* field) {
    std::vector<std::uint16_t> values;
    // Each token but the last also needs a blank: never reserve more values than the bytes can hold.
    const std::size_t most = dialect_ == Dialect::B ? left() / (bits / 8) : (left() + 1) / 2;
    if (error_ || count > most) {
        fail(field, "are cut off");
        return values;
    }
    values.reserve(count);
    for (std::size_t i = 0; i < count && !error_; ++i) values.push_back(static_cast<std::uint16_t>(number(bits, false, field)));
    return values;
}

void ColaWriter::append(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }

void ColaWriter::separate() {
    if ((dialect_ == Dialect::A && !bytes_.empty()) || afterWord_) bytes_.push_back(' ');
    afterWord_ = false;
}

void ColaWriter::word(std::string_view text) {
    separate();
    append(text);
    afterWord_ = dialect_ == Dialect::B;
}

void ColaWriter::number(std::uint32_t value, unsigned bits) {
    separate();
    if (dialect_ == Dialect::B) {
        for (unsigned shift = bits; shift > 0; shift -= 8) bytes_.push_back(static_cast<std::uint8_t>(value >> (shift - 8)));
        return;
    }
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    unsigned shift = 28;
    while (shift > 0 && value >> shift == 0) shift -= 4;
    for (;; shift -= 4) {
        bytes_.push_back(static_cast<std::uint8_t>(kDigits[value >> shift & 0xFU]));
        if (shift == 0) return;
    }
}

void ColaWriter::real(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    if (dialect_ == Dialect::B) return number(bits, 32);
    ColaWriter digits(Dialect::A);
    digits.number(bits, 32);
    separate();
    bytes_.insert(bytes_.end(), 8 - digits.bytes_.size(), '0');
    bytes_.insert(bytes_.end(), digits.bytes_.begin(), digits.bytes_.end());
}

void ColaWriter::fixed(std::string_view text) {
    separate();
    append(text);
}

void ColaWriter::text(std::string_view text) {
    const std::string_view kept = text.substr(0, 0xFFFF);
    u16(static_cast<std::uint16_t>(kept.size()));
    fixed(kept);
}

void ColaWriter::values(const std::vector<std::uint16_t>& values, unsigned bits) {
    for (const std::uint16_t value : values) number(bits == 8 ? value & 0xFFU : value, bits);
}

} // namespace edgescan::scanner
