// Comments and messages are in plain English: no comment of core, ui, app, tests or packaging and no message, label or help text of core,
// ui or app contains a word of the list in plain_words.h.
#include "tests/support/folders.h"
#include "tests/support/plain_words.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

const fs::path kTree = test::sourceFolder();

/// Consecutive comment lines of a file, joined by line feeds.
struct CommentBlock {
    std::size_t line = 0; ///< its first line, from 1
    std::string text;
};

/// The column at which a comment begins in a line of C++, or npos. `raw` is the end of an open raw string literal, or empty.
std::size_t commentColumn(const std::string& line, std::string& raw) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!raw.empty()) {
            const std::size_t end = line.find(raw, i);
            if (end == std::string::npos) return end;
            i = end + raw.size() - 1;
            raw.clear();
        } else if (line.compare(i, 2, "//") == 0) {
            return i;
        } else if (line.compare(i, 2, "R\"") == 0 && line.find('(', i) != std::string::npos) {
            const std::size_t open = line.find('(', i);
            raw = ")" + line.substr(i + 2, open - i - 2) + "\"";
            i = open;
        } else if (line[i] == '"' || (line[i] == '\'' && (i == 0 || std::isalnum(static_cast<unsigned char>(line[i - 1])) == 0))) {
            for (const char quote = line[i++]; i < line.size() && line[i] != quote; ++i)
                if (line[i] == '\\') ++i;
        }
    }
    return std::string::npos;
}

/// The same for a line of Python or CMake: a number sign outside of quotes, at the beginning or behind a blank.
std::size_t hashColumn(const std::string& line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '#' && (i == 0 || line[i - 1] == ' '))
            return i;
    }
    return std::string::npos;
}

std::vector<CommentBlock> commentsOf(const std::string& source, bool isCpp) {
    std::vector<CommentBlock> blocks;
    std::istringstream lines(source);
    std::string line, raw;
    bool continues = false;
    for (std::size_t n = 1; std::getline(lines, line); ++n) {
        const std::size_t column = isCpp ? commentColumn(line, raw) : hashColumn(line);
        const bool whole = column != std::string::npos && line.find_first_not_of(' ') == column;
        if (column != std::string::npos) {
            if (!continues || !whole) blocks.push_back({n, {}});
            CommentBlock& block = blocks.back();
            if (n > block.line) block.text += '\n';
            block.text += line.substr(std::min(line.find_first_not_of("/#<", column), line.size()));
        }
        continues = column != std::string::npos;
    }
    return blocks;
}

/// The string literals with a blank of a line of code without its comment: these are the ones that people read.
std::vector<std::string> sentencesOf(const std::string& code) {
    static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
    std::vector<std::string> sentences;
    for (std::sregex_iterator it(code.begin(), code.end(), literal), end; it != end; ++it)
        if ((*it)[1].str().find(' ') != std::string::npos) sentences.push_back(std::regex_replace((*it)[1].str(), std::regex("&"), ""));
    return sentences;
}

TEST(CommentWords, TheTestFindsABannedWord) {
    for (const char* comment : {"The cell tells the line.", "It is no edge.", "A rock, or none.", "Nobody knows.", "They lie beside it.",
                                "none\nof them", "what the file\nTold"})
        EXPECT_NE(test::bannedWord(comment).first, "") << comment;
    for (const char* comment : {"There is no range.", "0 if there\nare no cells", "`told` is a member", "\"the beams lie beside it\"",
                                "an understanding", "satellites", "a standard deviation", "belies", "\"two\nlines told\" apart"})
        EXPECT_EQ(test::bannedWord(comment).first, "") << comment;
    EXPECT_EQ(test::bannedWord("one\ntwo\nthree sits").second, 2U);
}

TEST(CommentWords, TheTestFindsComments) {
    const auto blocks =
        commentsOf("int a; // one\n// two\n  /// three\nf(\"// four\", '\"', R\"x(// five\n// six)x\"); ///< seven\n\n// eight\n", true);
    ASSERT_EQ(blocks.size(), 3U);
    EXPECT_EQ(blocks[0].text, " one\n two\n three");
    EXPECT_EQ(blocks[1].line, 5U);
    EXPECT_EQ(blocks[1].text, " seven");
    EXPECT_EQ(blocks[2].text, " eight");
    const auto hashes = commentsOf("# one\nset(A \"#two\") # three\n", false);
    ASSERT_EQ(hashes.size(), 2U);
    EXPECT_EQ(hashes[1].text, " three");
}

TEST(CommentWords, EveryCommentIsInPlainEnglish) {
    std::size_t comments = 0;
    const auto check = [&](const fs::path& path) {
        const std::string extension = path.extension().string();
        const bool isCpp = extension == ".h" || extension == ".cpp";
        if (!isCpp && extension != ".py" && extension != ".cmake" && path.filename() != "CMakeLists.txt") return;
        for (const CommentBlock& block : commentsOf(test::fileText(path), isCpp)) {
            ++comments;
            const auto [word, line] = test::bannedWord(block.text);
            EXPECT_EQ(word, "") << fs::relative(path, kTree).string() << ':' << block.line + line << ": the comment contains \"" << word
                                << "\" (CONTRIBUTING.md, \"Rules\")";
        }
    };
    check(kTree / "CMakeLists.txt");
    for (const char* folder : {"core", "ui", "app", "tests", "packaging"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kTree / folder))
            if (entry.is_regular_file()) check(entry.path());
    }
    EXPECT_GT(comments, 5000U);
}

TEST(CommentWords, TheTestFindsMessages) {
    EXPECT_EQ(sentencesOf(R"x(f("key", "It is \"one\"", tr("&Why no")))x"), (std::vector<std::string>{R"(It is \"one\")", "Why no"}));
}

TEST(CommentWords, EveryMessageIsInPlainEnglish) {
    std::size_t messages = 0;
    const auto check = [&](const fs::path& path) {
        std::istringstream lines(test::fileText(path));
        std::string line, raw;
        for (std::size_t n = 1; std::getline(lines, line); ++n) {
            for (const std::string& sentence : sentencesOf(line.substr(0, commentColumn(line, raw)))) {
                ++messages;
                const auto word = test::bannedWord(std::regex_replace(sentence, std::regex(R"(\\")"), "'")).first;
                EXPECT_EQ(word, "") << fs::relative(path, kTree).string() << ':' << n << ": the message contains \"" << word << '"';
            }
        }
    };
    for (const char* folder : {"core", "ui", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kTree / folder))
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") check(entry.path());
    }
    EXPECT_GT(messages, 2000U);
}

} // namespace
} // namespace edgescan
