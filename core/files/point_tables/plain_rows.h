// Rows of plain numbers, read many bytes at once: nearly all rows of nearly all lists are such rows.
#pragma once

#include <cstddef>
#include <span>

namespace edgescan::files {

/// Bytes that must be there from the beginning of a row on.
inline constexpr std::size_t kPlainRowReach = 128;

struct PlainRow {
    const char* next = nullptr; ///< where the next row begins; null: this is not a plain row, and nothing was read
    std::size_t numbers = 0;
};

/// Reads the row at `from` into `numbers`; only as many as there is space for; the rest is not looked at. A plain row ends with LF or
/// CRLF, and holds nan and numbers of at most 15 digits, "-12.345678", with one `separator` between them, or blanks where that is ' '.
/// The numbers are what std::from_chars gives. Reads no further than `end`.
using PlainRowReader = PlainRow (*)(const char* from, const char* end, char separator, std::span<double> numbers);

/// Null where the processor has not what it takes (x86-64 with AVX2).
[[nodiscard]] PlainRowReader plainRowReader();

} // namespace edgescan::files
