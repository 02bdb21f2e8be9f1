// One UTF-8 decoder, and the treatment of each character.
#include "core/base/foreign_text.h"

#include "core/base/result.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace edgescan {
namespace {

/// A character, or a byte that does not belong to a character.
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;
};

Character characterAt(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint32_t first = byte(at);
    if (first < 0x80) return {first, 1, true};
    const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || at + bytes > text.size()) return {first, 1, false};
    std::uint32_t code = first & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(at + i) & 0xC0U) != 0x80U) return {first, 1, false};
        code = code << 6U | (byte(at + i) & 0x3FU);
    }
    static constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < kLeast[bytes] || code > 0x10FFFF || surrogate) return {first, 1, false};
    return {code, bytes, true};
}

/// Control characters, invisible characters, and characters that change the direction of the following text (Unicode categories Cc, Cf, Zl,
/// Zp).
bool isHidden(std::uint32_t code) {
    struct Range {
        std::uint32_t first, last;
    };
    static constexpr std::array kHidden{Range{0x00, 0x1F},       Range{0x7F, 0x9F},       Range{0xAD, 0xAD},       Range{0x34F, 0x34F},
                                        Range{0x600, 0x605},     Range{0x61C, 0x61C},     Range{0x6DD, 0x6DD},     Range{0x70F, 0x70F},
                                        Range{0x115F, 0x1160},   Range{0x17B4, 0x17B5},   Range{0x180B, 0x180E},   Range{0x200B, 0x200F},
                                        Range{0x2028, 0x202E},   Range{0x2060, 0x206F},   Range{0x3164, 0x3164},   Range{0xFE00, 0xFE0F},
                                        Range{0xFEFF, 0xFEFF},   Range{0xFFA0, 0xFFA0},   Range{0xFFF0, 0xFFFB},   Range{0xFFFE, 0xFFFF},
                                        Range{0x110BD, 0x110BD}, Range{0x1BCA0, 0x1BCA3}, Range{0x1D173, 0x1D17A}, Range{0xE0000, 0xE0FFF}};
    for (const Range& range : kHidden) {
        if (code >= range.first && code <= range.last) return true;
    }
    return false;
}

// The characters of bytes that are not UTF-8: U+EF00 + byte.
constexpr std::uint32_t kFirstByteCharacter = 0xEF80, kLastByteCharacter = 0xEFFF;

bool isByteCharacter(const Character& c) { return c.valid && c.code >= kFirstByteCharacter && c.code <= kLastByteCharacter; }

std::string byteCharacter(char c) {
    const auto byte = static_cast<std::uint8_t>(c);
    return {static_cast<char>(0xEE), static_cast<char>(0xBC | byte >> 6U), static_cast<char>(0x80 | (byte & 0x3FU))};
}

std::string hex(std::uint32_t value, int digits) {
    std::string text;
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> static_cast<unsigned>(shift) & 15U];
    return text;
}

std::string shown(const Character& c, std::string_view bytes) {
    if (!c.valid) return "\\x" + hex(c.code, 2);
    if (!isHidden(c.code)) return std::string(bytes);
    if (c.code == '\n') return "\\n";
    if (c.code == '\r') return "\\r";
    if (c.code == '\t') return "\\t";
    if (c.code < 0x100) return "\\x" + hex(c.code, 2);
    return c.code < 0x10000 ? "\\u" + hex(c.code, 4) : "\\U" + hex(c.code, 8);
}

/// A character as JSON writes it in pure ASCII.
std::string jsonEscape(std::uint32_t code) {
    if (code < 0x10000) return "\\u" + hex(code, 4);
    const std::uint32_t rest = code - 0x10000;
    return "\\u" + hex(0xD800 + (rest >> 10U), 4) + "\\u" + hex(0xDC00 + (rest & 0x3FFU), 4);
}

} // namespace

std::string printable(std::string_view text, std::size_t mostCharacters) {
    // A character has four bytes at most. Text that is certainly cut off is not decoded.
    const std::size_t looked = 4 * mostCharacters;
    const auto charactersOf = [](std::string_view part) {
        std::vector<std::string> characters;
        for (std::size_t at = 0; at < part.size();) {
            const Character c = characterAt(part, at);
            characters.push_back(shown(c, part.substr(at, c.bytes)));
            at += c.bytes;
        }
        return characters;
    };
    const auto joined = [](const std::vector<std::string>& characters, std::size_t from, std::size_t to) {
        std::string result;
        for (std::size_t i = from; i < to; ++i) result += characters[i];
        return result;
    };
    const std::vector<std::string> head = charactersOf(text.substr(0, looked + 4));
    if (text.size() <= looked + 4 && head.size() <= mostCharacters) return joined(head, 0, head.size());
    const std::vector<std::string> tail = charactersOf(text.substr(text.size() > looked ? text.size() - looked : 0));
    const std::size_t kept = mostCharacters * 2 / 3;
    const std::size_t end = mostCharacters - kept;
    return joined(head, 0, kept) + " ... (" + std::to_string(text.size()) + " bytes, the middle is left out) ... " +
           joined(tail, tail.size() - std::min(end, tail.size()), tail.size());
}

std::string printableLines(std::string_view text) {
    std::string result;
    while (true) {
        const std::size_t end = text.find('\n');
        result += printable(text.substr(0, end));
        if (end == std::string_view::npos) return result;
        result += '\n';
        text.remove_prefix(end + 1);
    }
}

std::vector<std::uint32_t> charactersOf(std::string_view text) {
    std::vector<std::uint32_t> characters;
    for (std::size_t at = 0; at < text.size();) {
        const Character c = characterAt(text, at);
        characters.push_back(c.valid ? c.code : 0xFFFD);
        at += c.bytes;
    }
    return characters;
}

std::string escapedBytes(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size());
    for (std::size_t at = 0; at < bytes.size();) {
        const Character c = characterAt(bytes, at);
        const std::string_view own = bytes.substr(at, c.bytes);
        if (c.valid && !isByteCharacter(c))
            text += own;
        else
            for (const char byte : own) text += byteCharacter(byte);
        at += c.bytes;
    }
    return text;
}

std::string unescapedBytes(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const Character c = characterAt(text, at);
        if (isByteCharacter(c))
            bytes += static_cast<char>(c.code & 0xFFU);
        else
            bytes += text.substr(at, c.bytes);
        at += c.bytes;
    }
    return bytes;
}

std::string printableJson(std::string_view json) {
    std::string result;
    result.reserve(json.size());
    const auto isPlain = [](char c) { return (c >= ' ' && c <= '~') || c == '\n'; };
    for (std::size_t at = 0; at < json.size();) {
        const std::size_t from = at; // nearly all of the text is plain
        while (at < json.size() && isPlain(json[at])) ++at;
        result += json.substr(from, at - from);
        if (at == json.size()) break;
        const Character c = characterAt(json, at);
        if (!c.valid)
            result += "\\ufffd";
        else if (c.code != '\n' &&
                 (isHidden(c.code) || isByteCharacter(c))) // a line break can only be between values: JSON strings contain no line break
            result += jsonEscape(c.code);
        else
            result += json.substr(at, c.bytes);
        at += c.bytes;
    }
    return result;
}

std::string jsonWithoutFormulas(std::string_view json) {
    std::string result;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString && c == '\\') { // an existing escape is copied
            result += json.substr(i, 2);
            ++i;
            continue;
        }
        const bool beginsCell = i > 0 && std::string_view("\",; |").find(json[i - 1]) != std::string_view::npos;
        const bool afterEscape = i > 1 && json[i - 2] == '\\'; // some readers split text at \t and similar characters
        if (inString && (c == '=' || c == '@' || ((c == '+' || c == '-') && (beginsCell || afterEscape))))
            result += jsonEscape(static_cast<std::uint8_t>(c));
        else
            result += c;
        if (c == '"') inString = !inString;
    }
    return result;
}

std::string Error::sentence() const {
    std::string text = where.empty() ? printable(what) : printable(where) + ": " + printable(what);
    if (!hint.empty()) text += "; " + printable(hint);
    return text + ".";
}

} // namespace edgescan
