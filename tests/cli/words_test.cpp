// No text of the program makes a promise (docs/reference/rules.md, "S14"): checks every string in the sources, every help text, every
// document. Comments are plain English: no word of the list in CONTRIBUTING.md, "Words".
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = test::sourceFolder();

// The promising word in `text`, or empty.
std::string promiseIn(const std::string& text) {
    static const std::regex words(
        R"(\b(safe(ly|ty|r|st)?|unsafe|stabl[ey]|stabili[sz]ed|stability|cleared|clear to|guarant\w+|certif\w+|risk[- ]free|no danger|harmless)\b)",
        std::regex::icase);
    static const std::regex level(R"(\bSIL\b)"); // safety integrity level
    std::smatch match;
    if (std::regex_search(text, match, words) || std::regex_search(text, match, level)) return match[0];
    return {};
}

// String literals of C++ source, without comments; adjacent literals are joined.
std::vector<std::string> stringsOf(const std::string& source) {
    std::vector<std::string> strings;
    bool joins = false; // only white space since the last string
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i];
        if (c == '/' && source.compare(i, 2, "//") == 0) {
            i = std::min(source.find('\n', i), source.size());
        } else if (c == '\'' && (i == 0 || std::isalnum(static_cast<unsigned char>(source[i - 1])) == 0)) {
            i = source[i + 1] == '\\' ? i + 3 : i + 2;
            joins = false;
        } else if (source.compare(i, 3, "R\"(") == 0) {
            const std::size_t end = source.find(")\"", i);
            strings.push_back(source.substr(i + 3, end - i - 3));
            i = end + 1;
        } else if (c == '"') {
            std::string text;
            for (++i; i < source.size() && source[i] != '"'; ++i) {
                if (source[i] == '\\') text += source[i++];
                text += source[i];
            }
            if (joins)
                strings.back() += text;
            else
                strings.push_back(text);
            joins = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            joins = false;
        }
    }
    return strings;
}

TEST(Words, TheTestKnowsAPromiseWhenItSeesOne) {
    for (const char* text :
         {"The rock is safe.", "Stable from 3 to 4", "CLEARED", "guaranteed", "This is certified", "SIL 2", "unsafe", "safety"})
        EXPECT_NE(promiseIn(text), "") << text;
    for (const char* text : {"a safeguard", "unstablefoo", "silt", "the constable", "clear the list"})
        EXPECT_EQ(promiseIn(text), "") << text;
    const auto strings = stringsOf("f(\"one \\\"two\\\" \"\n   \"three\", '\"', \"four\"); // \"five\"\ng(R\"(si\"x)\");");
    EXPECT_EQ(strings, (std::vector<std::string>{"one \\\"two\\\" three", "four", "si\"x"}));
}

TEST(Words, NoStringOfTheProgramPromises) {
    std::size_t strings = 0;
    for (const char* folder : {"core", "ui", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
            for (const std::string& text : stringsOf(test::fileText(entry.path()))) {
                ++strings;
                // A keyword of Content-Security-Policy is not a promise.
                EXPECT_EQ(promiseIn(std::regex_replace(text, std::regex("'unsafe-inline'"), "")), "")
                    << entry.path() << ": \"" << text << '"';
            }
        }
    }
    EXPECT_GT(strings, 3000U);
}

TEST(Words, NoHelpPromises) {
    for (const char* command : {"", "info", "detect", "convert", "verify", "record", "replay", "why"}) {
        const std::string help = test::runCli(std::string(command) + " --help").out;
        EXPECT_GT(help.size(), 100U) << command;
        EXPECT_EQ(promiseIn(help), "") << command;
    }
    EXPECT_EQ(promiseIn(test::runProgram("edgescan", "--help").out), "");
    for (const char* command : {"", "benchmark", "repeatability", "evaluate", "simulate", "emulate", "calibrate"})
        EXPECT_EQ(promiseIn(test::runLab(std::string(command) + " --help").out), "") << command;
}

TEST(Words, NoDocumentPromises) {
    int documents = 0;
    const auto check = [&](const fs::path& path) {
        std::string text = test::fileText(path);
        // The rule itself contains the words.
        if (const std::size_t rule = text.find("## S14"); rule != std::string::npos) text.erase(rule, text.find("\n## ", rule) - rule);
        ++documents;
        EXPECT_EQ(promiseIn(text), "") << path;
    };
    for (const char* folder : {"docs", "resources", "packaging", "core", "ui", "app", "examples"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".md" || extension == ".json" || extension == ".desktop" || extension == ".xml" || extension == ".svg")
                check(entry.path());
        }
    }
    for (const char* name : {"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"}) check(kRoot / name);
    EXPECT_GT(documents, 30);
}

} // namespace
} // namespace edgescan
