// Foreign text made printable, JSON with any bytes, CSV that a spreadsheet never computes.
#include "core/base/bounded_json.h"
#include "core/base/csv_text.h"
#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/result.h"
#include "core/base/shell_quoted.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>

namespace edgescan {
namespace {

// Written without the function under test: valid UTF-8, without control characters, without characters that change the text direction.
bool harmless(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (c < 0x20 || c == 0x7F) return false;
        if (c < 0x80) {
            ++i;
            continue;
        }
        const std::size_t length = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : 2;
        if (c < 0xC2 || c > 0xF4 || i + length > text.size()) return false;
        for (std::size_t j = 1; j < length; ++j) {
            if ((static_cast<unsigned char>(text[i + j]) & 0xC0U) != 0x80U) return false;
        }
        const std::string character = text.substr(i, length);
        if (character >= "\xC2\x80" && character <= "\xC2\x9F") return false;
        for (const char* turned : {"\u200e", "\u200f", "\u202a", "\u202b", "\u202c", "\u202d", "\u202e", "\u2066", "\u2067", "\u2068",
                                   "\u2069", "\u061c", "\u2028", "\u2029", "\ufeff", "\u200b"}) {
            if (character == turned) return false;
        }
        i += length;
    }
    return true;
}

TEST(ForeignText, WhatCanBeSeenStaysAsItIs) {
    for (const char* text : {"", "scan 12.json", "Größe Ωμέγα 岩 🪨", "C:\\a\\b", "50 % of 'it' & <b>"})
        EXPECT_EQ(printable(text), text);
}

TEST(ForeignText, ControlsBecomeVisible) {
    EXPECT_EQ(printable("a\x1b[31mb"), "a\\x1b[31mb");
    EXPECT_EQ(printable("a\nb\r\tc"), "a\\nb\\r\\tc");
    EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
    EXPECT_EQ(printable("\u009b31m"), "\\x9b31m");
    EXPECT_EQ(printable("x\u202egpj"), "x\\u202egpj");
    EXPECT_EQ(printable("\U000E0041"), "\\U000e0041");
    EXPECT_EQ(printable("a\xff\xc3"), "a\\xff\\xc3");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80"); // a surrogate is not a character
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");          // an overlong encoding is not one either
}

TEST(ForeignText, LongTextIsShortAndKeepsBothEnds) {
    const std::string shown = printable("begin" + std::string(100000, 'x') + "end");
    EXPECT_LT(shown.size(), kMostShown + 100);
    EXPECT_TRUE(shown.starts_with("begin")) << shown;
    EXPECT_TRUE(shown.ends_with("end")) << shown;
    EXPECT_NE(shown.find("100008 bytes"), std::string::npos) << shown;
    EXPECT_EQ(printable(std::string(kMostShown, 'x')), std::string(kMostShown, 'x'));
    // For wide characters and escapes, the length of the printed text counts.
    std::string rocks;
    for (int i = 0; i < 5000; ++i) rocks += "岩";
    EXPECT_LT(printable(rocks).size(), 3 * kMostShown + 100);
    EXPECT_LT(printable(std::string(50000, '\x1b')).size(), 4 * kMostShown + 100);
}

TEST(ForeignText, AnyBytesComeOutHarmless) {
    std::mt19937 random(11);
    for (int n = 0; n < 3000; ++n) {
        std::string text;
        for (auto i = random() % 40; i > 0; --i) text += static_cast<char>(random());
        EXPECT_TRUE(harmless(printable(text)));
        const std::string json = jsonText(nlohmann::json{{"name", text}});
        EXPECT_TRUE(harmless(json)) << json;
        EXPECT_TRUE(nlohmann::json::accept(json)) << json;
        const Error error{text, text, text};
        EXPECT_TRUE(harmless(error.sentence()));
    }
}

TEST(ForeignText, JsonKeepsTheValue) {
    const std::string text = "a\x1b[31m\u202e\u009b\x7f\U000E0041\n\"\\ Größe";
    const std::string json = jsonText(nlohmann::json{{"name", text}}, 2);
    EXPECT_EQ(nlohmann::json::parse(json)["name"], text) << json;
    EXPECT_EQ(nlohmann::json::parse(asciiJsonText(nlohmann::ordered_json{{"name", text}}))["name"], text);
    EXPECT_LT(shortJsonText(nlohmann::ordered_json{{"a", {{"b", std::string(100000, 'x')}}}}).size(), 5000U);
}

TEST(ForeignText, AnyBytesComeBackFromJson) {
    EXPECT_EQ(escapedBytes("Größe 岩 🪨 \\xff %FF \ufffd"), "Größe 岩 🪨 \\xff %FF \ufffd"); // valid UTF-8 stays as it is
    EXPECT_EQ(escapedBytes("a\xff\xc3"), "a\uefff\uefc3");
    EXPECT_EQ(escapedBytes("\uefff"), "\uefee\uefbf\uefbf"); // a name with such a character is not the name with the byte
    EXPECT_EQ(jsonText(nlohmann::json{{"a\xff", {"b\xfe"}}}), "{\"a\\uefff\":[\"b\\ueffe\"]}");
    std::mt19937 random(13);
    for (int n = 0; n < 3000; ++n) {
        std::string bytes;
        const int most = n % 2 == 0 ? 256 : 4; // any bytes, or often the three bytes of such a character
        for (auto i = random() % 40; i > 0; --i) bytes += most == 256 ? static_cast<char>(random()) : "\xee\xbe\xbf\x80"[random() % 4];
        const std::string text = escapedBytes(bytes);
        EXPECT_EQ(escapedBytes(unescapedBytes(text)), text);
        EXPECT_EQ(unescapedBytes(text), bytes);
        const nlohmann::json json{{bytes, {1, bytes}}};
        const nlohmann::ordered_json ordered{{bytes, {1, bytes}}};
        EXPECT_EQ(*parseJson(jsonText(json), ""), json);
        EXPECT_EQ(*parseOrderedJson(jsonText(ordered, 2), ""), ordered);
        EXPECT_EQ(*parseOrderedJson(asciiJsonText(ordered), ""), ordered);
    }
}

TEST(CsvText, NoSeparatorMakesAFormulaOfACell) {
    EXPECT_EQ(csvCell("plain text = 3 - 1"), "plain text = 3 - 1");
    EXPECT_EQ(csvCell("-3.5"), "-3.5");
    EXPECT_EQ(csvCell("+2e3"), "+2e3");
    EXPECT_EQ(csvCell("=1+1"), "'=1+1");
    EXPECT_EQ(csvCell("-inf"), "'-inf");
    EXPECT_EQ(csvCell("a;=cmd|' /C calc'!A0"), "a;'=cmd|' /C calc'!A0");
    EXPECT_EQ(csvCell("\t=1"), "\\t=1");
    EXPECT_EQ(csvCell("a,\"b\""), "\"a,\"\"b\"\"\"");
    EXPECT_EQ(csvCell("a\xff"), "a\uefff");
    EXPECT_EQ(csvCell("Block 7, -120 m"), "\"Block 7, -120 m\"");
    EXPECT_EQ(csvCell("=1, -2"), "\"'=1, -2\"");
    std::mt19937 random(14);
    for (int n = 0; n < 5000; ++n) {
        std::string text;
        for (auto i = random() % 12; i > 0; --i) text += "=+-@,;|\t\r\n \"'ab1"[random() % 16];
        if (const auto number = numberOf(text)) continue;
        const std::string cell = csvCell(text);
        EXPECT_TRUE(cell.find(',') == std::string::npos || cell.front() == '"') << cell; // at a comma a quoted cell is not separated
        for (const char separator : {';', '\t', '|'}) {
            for (std::size_t at = 0; at <= cell.size();) {
                const std::size_t end = std::min(cell.find(separator, at), cell.size());
                std::string part = cell.substr(at, end - at);
                part.erase(0, std::min(part.find_first_not_of(" \""), part.size()));
                EXPECT_TRUE(part.empty() || std::string("=+-@\t\r").find(part[0]) == std::string::npos) << text << " -> " << cell;
                at = end + 1;
            }
        }
    }
}

TEST(ForeignText, NoCellOfACommentIsAFormula) {
    const nlohmann::json json{{"note", "=1+1,=cmd|' /C calc'!A0;@SUM(1),+2,-3\t=4\n=5\\=6"},
                              {"warnings", {"=HYPERLINK(\"http://x\")", "-2", "+2", "@x", "plain - text + more"}},
                              {"depth", -3.5}};
    const std::string text = jsonWithoutFormulas(jsonText(json));
    EXPECT_EQ(nlohmann::json::parse(text), json) << text;
    EXPECT_EQ(text.find('='), std::string::npos) << text;
    EXPECT_EQ(text.find('@'), std::string::npos) << text;
    // Every cell, split at any separator and without its quotes, is a number or does not begin like a formula.
    for (const char separator : {',', ';', '\t'}) {
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find(separator, at), text.size());
            std::string cell = text.substr(at, end - at);
            cell.erase(0, std::min(cell.find_first_not_of(" \"["), cell.size()));
            const bool sign = !cell.empty() && (cell[0] == '-' || cell[0] == '+');
            EXPECT_TRUE(!sign || (cell[1] >= '0' && cell[1] <= '9')) << cell;
            at = end + 1;
        }
    }
    EXPECT_EQ(text.find("\"-2"), std::string::npos) << text;
}

TEST(ShellQuoted, AShellReadsTheSameWord) {
    std::mt19937 random(12);
    for (int n = 0; n < 30; ++n) {
        std::string text = n == 0 ? "it's \\ \x1b[31m\n\u202e" : std::string();
        for (auto i = random() % 12; i > 0; --i) text += static_cast<char>(1 + random() % 255);
        const std::string quoted = shellQuoted(text);
        for (const char c : quoted) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) << quoted;
        const test::TemporaryFolder folder;
        const std::string command = "printf %s " + quoted + " >" + (folder / "out").string() + "\n";
        std::ofstream(folder / "script") << command;
        ASSERT_EQ(std::system(("bash " + (folder / "script").string()).c_str()), 0);
        EXPECT_EQ(test::fileText(folder / "out"), text) << quoted;
    }
}

TEST(NumberText, NumbersAreReadWhole) {
    EXPECT_EQ(numberOf("12"), 12.0);
    EXPECT_EQ(numberOf("+2.5"), 2.5);
    EXPECT_EQ(numberOf("-1e3"), -1000.0);
    EXPECT_EQ(numberOf("1e999"), INFINITY);
    EXPECT_EQ(numberOf("-1e999"), -INFINITY);
    EXPECT_EQ(numberOf("1e-999"), 0.0);
    EXPECT_TRUE(std::isnan(*numberOf("nan")));
    for (const char* none : {"", "+", "-", "1,5", "1.5x", " 1", "1 ", "+-1", "++1", "0x10"}) EXPECT_FALSE(numberOf(none)) << none;
    EXPECT_EQ(asciiLower("TITLE ÄI"), "title Äi");
}

} // namespace
} // namespace edgescan
