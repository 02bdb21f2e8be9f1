// Reads the fields of a CoLa payload in order, in the same way for both dialects (docs/developer/protocol.md, "Numbers").
#pragma once

#include "core/base/result.h"
#include "core/scanner/cola/frames.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::scanner {

/// Reads forward. After the first missing field every read returns zero; call error() at the end. `field` is the name of the field for the
/// error's sentence.
class ColaReader {
public:
    ColaReader(ByteView payload, Dialect dialect) : payload_(payload), dialect_(dialect) {}

    /// The text up to the next blank: command letters and names are text in both dialects. Empty at the end.
    std::string_view word();

    std::uint8_t u8(const char* field) { return static_cast<std::uint8_t>(number(8, false, field)); }
    std::uint16_t u16(const char* field) { return static_cast<std::uint16_t>(number(16, false, field)); }
    std::uint32_t u32(const char* field) { return number(32, false, field); }
    std::int16_t i16(const char* field) { return static_cast<std::int16_t>(number(16, true, field)); }
    std::int32_t i32(const char* field) { return static_cast<std::int32_t>(number(32, true, field)); }
    float real(const char* field) { return std::bit_cast<float>(number(32, false, field)); }
    /// Exactly `length` characters.
    std::string fixed(std::size_t length, const char* field);
    /// A length, followed by that many characters, which may be blanks.
    std::string text(const char* field);
    /// `count` numbers of 8 or 16 bits.
    std::vector<std::uint16_t> values(std::size_t count, unsigned bits, const char* field);

    [[nodiscard]] bool failed() const { return error_.has_value(); }
    /// Only when failed(). `where` is "byte 34 of the telegram".
    [[nodiscard]] const Error& error() const { return *error_; }
    [[nodiscard]] std::size_t left() const { return payload_.size() - at_; }
    /// The bytes that were not read yet.
    [[nodiscard]] ByteView rest() const { return payload_.subspan(at_); }

private:
    std::uint32_t number(unsigned bits, bool isSigned, const char* field);
    std::uint32_t binaryNumber(unsigned bits, const char* field);
    std::uint32_t textNumber(unsigned bits, bool isSigned, const char* field);
    std::string_view characters(std::size_t from, std::size_t count) const;
    std::uint32_t fail(const char* field, const std::string& why);

    ByteView payload_;
    Dialect dialect_;
    std::size_t at_ = 0;
    std::optional<Error> error_;
};

/// Writes the same fields in the canonical form: upper-case hex without leading zeros, reals with 8 digits.
class ColaWriter {
public:
    explicit ColaWriter(Dialect dialect) : dialect_(dialect) {}

    /// Writes command letters or a name.
    void word(std::string_view text);
    void u8(std::uint8_t value) { number(value, 8); }
    void u16(std::uint16_t value) { number(value, 16); }
    void u32(std::uint32_t value) { number(value, 32); }
    void i16(std::int16_t value) { number(static_cast<std::uint16_t>(value), 16); }
    void i32(std::int32_t value) { number(static_cast<std::uint32_t>(value), 32); }
    void real(float value);
    void fixed(std::string_view text);
    void text(std::string_view text);
    void values(const std::vector<std::uint16_t>& values, unsigned bits);

    /// The payload so far. A name at the end is not followed by a blank.
    [[nodiscard]] Bytes done() && { return std::move(bytes_); }

private:
    void number(std::uint32_t value, unsigned bits);
    void separate();
    void append(std::string_view text);

    Dialect dialect_;
    bool afterWord_ = false; ///< CoLa B: write a blank before the next field
    Bytes bytes_;
};

} // namespace edgescan::scanner
