// Unpacks by content; most files are not packed and stay where they are.
#include "core/files/open_save/unpack.h"

#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/result.h"
#include "core/containers/compression/chunks.h"
#include "core/containers/compression/gunzip.h"
#include "core/files/point_tables/source.h"
#include "core/files/point_tables/text_words.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {
namespace {

/// A text that was written in another way.
struct PlainText {
    std::vector<std::byte> converted;  ///< the text as UTF-8; empty where a part of the bytes of the file is the text
    std::span<const std::byte> bytes;  ///< the text: `converted`, or a part of the file
    std::vector<std::string> warnings; ///< sentences about what was done
};

enum class Order : std::uint8_t { Little, Big };

std::string_view viewOf(std::span<const std::byte> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

bool isTextByte(std::byte b) {
    return b == std::byte{'\t'} || b == std::byte{'\n'} || b == std::byte{'\r'} || (b >= std::byte{32} && b < std::byte{127});
}

/// By its mark; without one where the first letters are of ASCII, each with a byte of zero.
std::optional<Order> orderOfUtf16(std::span<const std::byte> bytes) {
    constexpr std::size_t kLooked = 64, kFewest = 16;
    if (bytes.size() >= 4 && bytes[0] == std::byte{0xFF} && bytes[1] == std::byte{0xFE} &&
        (bytes[2] != std::byte{0} || bytes[3] != std::byte{0}))
        return Order::Little;
    if (bytes.size() >= 4 && bytes[0] == std::byte{0xFE} && bytes[1] == std::byte{0xFF}) return Order::Big;
    const std::size_t looked = std::min(bytes.size(), kLooked) / 2 * 2;
    if (looked < kFewest) return std::nullopt;
    bool little = true, big = true;
    for (std::size_t n = 0; n < looked; n += 2) {
        little = little && isTextByte(bytes[n]) && bytes[n + 1] == std::byte{0};
        big = big && isTextByte(bytes[n + 1]) && bytes[n] == std::byte{0};
    }
    return little ? std::optional(Order::Little) : big ? std::optional(Order::Big) : std::nullopt;
}

void appendUtf8(std::vector<std::byte>& text, std::uint32_t letter) {
    const auto put = [&](std::uint32_t value) { text.push_back(static_cast<std::byte>(value)); };
    const auto rest = [&](unsigned shift) { put(0x80U | (letter >> shift & 0x3FU)); };
    if (letter < 0x80) return put(letter);
    if (letter < 0x800) {
        put(0xC0U | letter >> 6U);
        return rest(0);
    }
    if (letter < 0x10000) {
        put(0xE0U | letter >> 12U);
        rest(6);
        return rest(0);
    }
    put(0xF0U | letter >> 18U);
    rest(12);
    rest(6);
    rest(0);
}

/// By its mark of byte order.
std::optional<Order> orderOfUtf32(std::span<const std::byte> bytes) {
    if (viewOf(bytes).starts_with(std::string_view("\xFF\xFE\0\0", 4))) return Order::Little;
    return viewOf(bytes).starts_with(std::string_view("\0\0\xFE\xFF", 4)) ? std::optional(Order::Big) : std::nullopt;
}

std::vector<std::byte> utf8OfUtf32(std::span<const std::byte> bytes, Order order) {
    constexpr std::uint32_t kMost = 0x10FFFF, kUnknown = 0xFFFD;
    std::vector<std::byte> text;
    for (std::size_t at = 4; at + 3 < bytes.size(); at += 4) {
        std::uint32_t letter = 0;
        for (std::size_t n = 0; n < 4; ++n)
            letter = letter << 8U | std::to_integer<std::uint32_t>(bytes[at + (order == Order::Big ? n : 3 - n)]);
        appendUtf8(text, letter <= kMost ? letter : kUnknown);
    }
    return text;
}

std::vector<std::byte> utf8Of(std::span<const std::byte> bytes, Order order) {
    constexpr std::uint32_t kMark = 0xFEFF, kUnknown = 0xFFFD;
    std::vector<std::byte> text;
    text.reserve(bytes.size() / 2 + 16);
    const auto unit = [&](std::size_t at) {
        const auto first = std::to_integer<std::uint32_t>(bytes[at]), second = std::to_integer<std::uint32_t>(bytes[at + 1]);
        return order == Order::Little ? second << 8U | first : first << 8U | second;
    };
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t letter = unit(at);
        if (at == 0 && letter == kMark) continue;
        if (letter >= 0xD800 && letter < 0xE000) {
            const std::uint32_t low = letter < 0xDC00 && at + 3 < bytes.size() ? unit(at + 2) : 0;
            const bool pair = low >= 0xDC00 && low < 0xE000;
            letter = pair ? 0x10000 + ((letter - 0xD800) << 10U) + (low - 0xDC00) : kUnknown;
            at += pair ? 2 : 0;
        }
        appendUtf8(text, letter);
    }
    return text;
}

/// Zeros behind a text whose last line has numbers, as they are left where the power failed while a list was written.
std::size_t zerosBehindRows(std::span<const std::byte> bytes) {
    const std::string_view text = viewOf(bytes);
    const std::size_t last = text.find_last_not_of('\0');
    if (last == std::string_view::npos || last + 1 == text.size()) return 0;
    const std::string_view rows = text.substr(0, last + 1);
    if (rows.find('\0') != std::string_view::npos || firstByteThatIsNoText(rows)) return 0;
    const std::size_t content = rows.find_last_not_of("\r\n \t");
    if (content == std::string_view::npos) return 0;
    const std::size_t before = rows.find_last_of("\r\n", content);
    if (before == std::string_view::npos || std::ranges::none_of(wordsIn(rows.substr(before + 1, content - before)), isNumber)) return 0;
    return text.size() - rows.size();
}

/// A CR ends the first line and no LF is near: the lines of old programs.
bool endsLinesWithCr(std::span<const std::byte> bytes) {
    constexpr std::size_t kLooked = std::size_t{1} << 16U;
    const std::string_view text = viewOf(bytes.first(std::min(bytes.size(), kLooked)));
    return text.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos && !firstByteThatIsNoText(text) &&
           viewOf(bytes).find('\n') == std::string_view::npos && viewOf(bytes).find('\0') == std::string_view::npos;
}

/// Leaves out a mark of byte order before the text and zeros behind its last row; converts UTF-16, with or without such a mark, and line
/// ends of a CR alone. Empty: nothing is to be done, as for all that is not text. Error: not enough memory.
Result<std::optional<PlainText>> plainText(const Source& source) {
    PlainText plain;
    plain.bytes = source.bytes;
    bool changed = false;
    if (const auto order = orderOfUtf16(source.bytes)) {
        if (auto enough = checkMemory(productOf({source.bytes.size(), 2}), source.path.string()); !enough) return enough.error();
        plain.converted = utf8Of(source.bytes, *order);
        plain.bytes = plain.converted;
        plain.warnings.emplace_back("The text has two bytes per character (UTF-16) and was read as such.");
        changed = true;
    }
    if (const auto order = orderOfUtf32(source.bytes)) {
        if (auto enough = checkMemory(source.bytes.size(), source.path.string()); !enough) return enough.error();
        plain.converted = utf8OfUtf32(source.bytes, *order);
        plain.bytes = plain.converted;
        plain.warnings.emplace_back("The text has four bytes per character (UTF-32) and was read as such.");
        changed = true;
    }
    constexpr std::size_t kMark = 3; // of UTF-8
    if (viewOf(plain.bytes).starts_with("\xEF\xBB\xBF")) {
        plain.bytes = plain.bytes.subspan(kMark);
        changed = true;
    }
    if (const std::size_t zeros = zerosBehindRows(plain.bytes); zeros > 0) {
        plain.bytes = plain.bytes.first(plain.bytes.size() - zeros);
        plain.warnings.push_back(
            counted(zeros, "byte of zero (NUL) follows the last row, as a power cut leaves them: rows that were not written are missing.",
                    "bytes of zero (NUL) follow the last row, as a power cut leaves them: rows that were not written are missing."));
        changed = true;
    }
    constexpr std::string_view kEndOfText = "\n\x1A"; // of CP/M and DOS
    if (viewOf(plain.bytes).ends_with(kEndOfText) && !firstByteThatIsNoText(viewOf(plain.bytes).substr(0, plain.bytes.size() - 1))) {
        plain.bytes = plain.bytes.first(plain.bytes.size() - 1);
        changed = true;
    }
    if (endsLinesWithCr(plain.bytes)) {
        if (auto enough = checkMemory(plain.bytes.size(), source.path.string()); !enough) return enough.error();
        std::vector<std::byte> lines(plain.bytes.begin(), plain.bytes.end());
        std::ranges::replace(lines, std::byte{'\r'}, std::byte{'\n'});
        plain.converted = std::move(lines);
        plain.bytes = plain.converted;
        changed = true;
    }
    return changed ? std::optional(std::move(plain)) : std::nullopt;
}

/// Of a zstd archive that says its size, and this is in reason; another one is named as a foreign file.
std::optional<std::uint64_t> zstdSizeOf(const Source& packed) {
    const ByteView bytes(reinterpret_cast<const std::uint8_t*>(packed.bytes.data()), packed.bytes.size());
    if (!containers::isZstd(bytes)) return std::nullopt;
    const auto size = containers::zstdSize(bytes);
    if (!size || *size > mostUnpackedBytes(bytes.size())) return std::nullopt;
    return size;
}

} // namespace

Error UnpackedSource::refused(const Error& error) const {
    const std::string path = source.path.string();
    if (!packed || !error.where.starts_with(path)) return error;
    return {error.what, path + " (unpacked)" + error.where.substr(path.size()), error.hint};
}

Result<UnpackedSource> unpack(const Source& packed) {
    UnpackedSource plain{packed, nullptr, false};
    if (containers::isGzip(packed.bytes)) {
        auto bytes = containers::gunzip(packed.bytes, packed.path.string(), [&](double done) { return packed.goOn("unpacking", done); });
        if (!bytes) return bytes.error();
        plain.bytes = std::make_shared<const std::vector<std::byte>>(std::move(*bytes));
        plain.source.bytes = *plain.bytes;
        plain.packed = true;
    }
    if (const auto size = zstdSizeOf(packed)) { // rosbag2 packs whole files so
        if (auto enough = checkMemory(*size, packed.path.string()); !enough) return enough.error();
        const ByteView bytes(reinterpret_cast<const std::uint8_t*>(packed.bytes.data()), packed.bytes.size());
        auto unpacked = containers::unpackChunk("zstd", bytes, *size, packed.path.string(), [&] { return packed.goOn("unpacking", 0.0); });
        if (!unpacked) return unpacked.error();
        const auto all = std::as_bytes(std::span(*unpacked));
        plain.bytes = std::make_shared<const std::vector<std::byte>>(all.begin(), all.end());
        plain.source.bytes = *plain.bytes;
        plain.packed = true;
    }
    if (plain.source.bytes.empty()) return plain.refused(packed.refused("the file is empty", "copy it again or choose another"));
    if (std::ranges::all_of(plain.source.bytes, [](std::byte b) { return b == std::byte{0}; }))
        return plain.refused(
            packed.refused("the file holds only zeros (NUL), as a power cut leaves them", "copy it again from the scanner"));
    auto text = plainText(plain.source);
    if (!text) return text.error();
    if (!*text) return plain;
    plain.warnings = std::move((*text)->warnings);
    plain.source.bytes = (*text)->bytes;
    if ((*text)->converted.empty()) return plain;
    const auto start = static_cast<std::size_t>((*text)->bytes.data() - (*text)->converted.data());
    const std::size_t length = (*text)->bytes.size();
    plain.bytes = std::make_shared<const std::vector<std::byte>>(std::move((*text)->converted));
    plain.source.bytes = std::span(*plain.bytes).subspan(start, length);
    return plain;
}

} // namespace edgescan::files
