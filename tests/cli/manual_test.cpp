// All pages are short, plain sentences; in README and guide the commands have the flags that they name, and the examples work.
#include "tests/support/folders.h"
#include "tests/support/plain_words.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

const fs::path kManual = fs::path(test::sourceFolder()) / "docs";

std::vector<fs::path> pagesOfTheManual() {
    std::vector<fs::path> pages{fs::path(test::sourceFolder()) / "README.md", kManual / "README.md"};
    for (const auto& entry : fs::recursive_directory_iterator(kManual / "guide"))
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    return pages;
}

/// README, CHANGELOG, CONTRIBUTING, SECURITY, the page of the examples, and what is written by hand in docs, with the translations.
std::vector<fs::path> allPages() {
    const fs::path root = test::sourceFolder();
    std::vector<fs::path> pages{root / "README.md", root / "CHANGELOG.md", root / "CONTRIBUTING.md", root / "SECURITY.md",
                                root / "examples/README.md"};
    for (const auto& entry : fs::recursive_directory_iterator(kManual)) {
        const fs::path& page = entry.path();
        const bool isOfHelp = page.parent_path().filename() == "commands" || page.stem() == "settings"; // docs/make-commands
        if (page.extension() == ".md" && !isOfHelp) pages.push_back(page);
    }
    return pages;
}

// docs/guide/fr has a translation.
bool isEnglish(const fs::path& page) { return page.parent_path().parent_path().filename() != "guide"; }

/// A paragraph, an item of a list or a field of a table.
struct Passage {
    std::string text;
    bool isField = false;
};

/// The passages of a page, without headings and blocks of code.
std::vector<Passage> passagesOf(const std::string& page) {
    static const std::regex item(R"(^([*+-]|\d+\.)\s+)");
    std::vector<Passage> passages;
    bool code = false, ended = true;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
        if (line.starts_with("```")) code = !code;
        if (code || line.empty() || line.starts_with('#') || line.starts_with("```")) {
            ended = true;
        } else if (line.starts_with('|')) {
            std::istringstream fields(line.substr(1));
            for (std::string field; std::getline(fields, field, '|');) passages.push_back({field, true});
            ended = true;
        } else {
            std::smatch begin;
            const bool isItem = std::regex_search(line, begin, item);
            if (ended || isItem) passages.push_back({});
            passages.back().text += " " + (isItem ? std::string(begin.suffix()) : line);
            ended = false;
        }
    }
    return passages;
}

/// The text as read aloud: without pictures and addresses of links, code as one word.
std::string readAloud(const std::string& text) {
    static const std::regex picture(R"(!\[[^\]]*\]\([^)]*\))"), link(R"(\[([^\]]*)\]\([^)]*\))"), code("`[^`]*`");
    return std::regex_replace(std::regex_replace(std::regex_replace(text, picture, ""), link, "$1"), code, "code");
}

std::vector<std::string> sentencesIn(const std::string& text) {
    static const std::regex end(R"([.!?]["*)]*\s+)");
    const std::string read = readAloud(text) + " ";
    std::vector<std::string> sentences;
    std::sregex_iterator at(read.begin(), read.end(), end);
    auto begin = read.begin();
    for (; at != std::sregex_iterator(); ++at) {
        sentences.emplace_back(begin, (*at)[0].second);
        begin = (*at)[0].second;
    }
    sentences.emplace_back(begin, read.end());
    return sentences;
}

std::size_t wordsIn(const std::string& sentence) {
    std::istringstream tokens(sentence);
    std::size_t words = 0;
    for (std::string token; tokens >> token;)
        words += std::ranges::any_of(token, [](unsigned char c) { return std::isalnum(c) != 0 || c > 127; }) ? 1U : 0U;
    return words;
}

TEST(Manual, TheTestCountsWords) {
    const auto passages = passagesOf("# No\n\nOne `a b` two.\nThree, [four](page). Five\n* six\n\n```\nno\n```\n| seven | 8 9 |\n");
    ASSERT_EQ(passages.size(), 4U);
    const auto sentences = sentencesIn(passages[0].text);
    ASSERT_EQ(sentences.size(), 3U);
    EXPECT_EQ(wordsIn(sentences[0]), 3U);
    EXPECT_EQ(wordsIn(sentences[1]), 2U);
    EXPECT_EQ(passages[1].text, " six");
    EXPECT_TRUE(passages[3].isField);
}

TEST(Manual, SentencesAreShort) {
    std::size_t pages = 0;
    for (const fs::path& page : allPages()) {
        const bool fieldsAreSentences = page.parent_path().filename() != "measurements"; // there a field may be a list of figures
        double words = 0, sentences = 0;
        for (const Passage& passage : passagesOf(test::fileText(page))) {
            if (passage.isField && !fieldsAreSentences) continue;
            for (const std::string& sentence : sentencesIn(passage.text)) {
                const std::size_t count = wordsIn(sentence);
                EXPECT_LE(count, 35U) << page << ": " << sentence;
                if (passage.isField || count == 0) continue;
                words += static_cast<double>(count);
                ++sentences;
            }
        }
        ++pages;
        EXPECT_LE(words, 16 * sentences) << page << ": " << words / sentences << " words a sentence";
    }
    EXPECT_GT(pages, 50U);
}

// What the window shows, *in italics* or "in quotes", has the words that the window has.
TEST(Manual, EveryPageIsInPlainEnglish) {
    static const std::regex label(R"(\*[^*\s][^*]*\*)");
    const fs::path root = test::sourceFolder();
    std::vector<fs::path> pages{root / "README.md", root / "SECURITY.md", root / "examples/README.md"};
    for (const auto& entry : fs::recursive_directory_iterator(kManual))
        if (entry.path().extension() == ".md" && isEnglish(entry.path())) pages.push_back(entry.path());
    EXPECT_GT(pages.size(), 40U);
    for (const fs::path& page : pages) {
        for (const Passage& passage : passagesOf(test::fileText(page))) {
            const std::string text = std::regex_replace(passage.text, label, "_");
            EXPECT_EQ(test::bannedWord(text).first, "") << page << ": " << passage.text << " (CONTRIBUTING.md, \"Words\")";
        }
    }
}

// A reader must not take a simulated rock for a real one: the line after a picture says what it shows.
TEST(Manual, PicturesSayWhetherTheyAreSimulated) {
    std::size_t pictures = 0;
    for (const fs::path& page : pagesOfTheManual()) {
        const std::string text = test::fileText(page);
        for (std::size_t at = text.find("\n!["); at != std::string::npos; at = text.find("\n![", at + 1)) {
            const std::size_t caption = text.find_first_not_of('\n', text.find('\n', at + 1));
            const std::string line = text.substr(caption, text.find('\n', caption) - caption);
            ++pictures;
            EXPECT_TRUE(line.find("imul") != std::string::npos || line.find("Real scan") != std::string::npos)
                << page << ": a picture without its origin: " << line;
        }
    }
    EXPECT_GT(pictures, 15U);
}

TEST(Manual, LinksWithinAPageLeadToAHeading) {
    for (const fs::path& page : pagesOfTheManual()) {
        const std::string text = test::fileText(page);
        for (std::size_t at = text.find("](#"); at != std::string::npos; at = text.find("](#", at + 1)) {
            const std::string anchor = text.substr(at + 3, text.find(')', at) - at - 3);
            std::string heading = anchor;
            std::ranges::replace(heading, '-', ' ');
            std::string lower = text;
            std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            EXPECT_NE(lower.find("# " + heading + "\n"), std::string::npos) << page << " links to #" << anchor;
        }
    }
}

/// The names of the commands of a program, from its help.
std::set<std::string> commandNames(const std::string& help) {
    static const std::regex row(R"(\n  ([a-z]+)  +[A-Z])");
    std::set<std::string> names;
    for (std::sregex_iterator at(help.begin(), help.end(), row), end; at != end; ++at) names.insert((*at)[1]);
    return names;
}

/// Each line of code and each passage of code in a page.
std::vector<std::string> codeOf(const std::string& page) {
    static const std::regex inlined("`([^`\n]+)`");
    std::vector<std::string> all;
    bool code = false;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```"))
            code = !code;
        else if (code)
            all.push_back(line);
        else
            for (std::sregex_iterator at(line.begin(), line.end(), inlined), end; at != end; ++at) all.push_back((*at)[1]);
    }
    return all;
}

/// The help of every command, by "edgescan-cli detect" and its like.
std::map<std::string, std::string> helpOfAllCommands() {
    std::map<std::string, std::string> helps{{"edgescan", test::runProgram("edgescan", "--help").out}};
    for (const char* program : {"edgescan-cli", "edgescan-lab"})
        for (const std::string& name : commandNames(test::runProgram(program, "--help").out))
            helps[std::string(program) + " " + name] = test::runProgram(program, name + " --help").out;
    return helps;
}

/// The command that a piece of code calls: "edgescan-cli detect" of "edgescan-cli detect SCAN", and of "detect SCAN --edges E.dxf".
std::string commandIn(const std::string& code, const std::map<std::string, std::string>& helps) {
    std::istringstream words(code);
    std::string first, second;
    words >> first >> second;
    if (!second.empty() && helps.contains("edgescan-cli " + first)) return "edgescan-cli " + first;
    const bool hasCommand = first.starts_with("edgescan-") && !second.empty() && second != "COMMAND" && !second.starts_with("-");
    return hasCommand ? first + " " + second : first;
}

/// Flags of `code` that `help` does not list.
std::vector<std::string> unknownFlags(const std::string& code, const std::string& help) {
    static const std::regex flag(R"((^|\s)(--?[a-z][a-z0-9-]*))");
    std::vector<std::string> unknown;
    for (std::sregex_iterator at(code.begin(), code.end(), flag), end; at != end; ++at) {
        const std::string name = (*at)[2];
        if (!std::regex_search(help, std::regex("(^|[\\s,])" + name + "($|[\\s,:])"))) unknown.push_back(name);
    }
    return unknown;
}

TEST(Manual, EveryCommandAndFlagExists) {
    const std::map<std::string, std::string> helps = helpOfAllCommands();
    EXPECT_GT(helps.size(), 15U);
    std::size_t commands = 0;
    for (const fs::path& page : pagesOfTheManual()) {
        for (const std::string& code : codeOf(test::fileText(page))) {
            const std::string command = commandIn(code, helps);
            if (!helps.contains(command)) {
                EXPECT_EQ(command.find("edgescan-cli "), std::string::npos) << page << ": " << code;
                continue;
            }
            ++commands;
            for (const std::string& flag : unknownFlags(code, helps.at(command)))
                ADD_FAILURE() << page << ": " << code << ": " << command << " has no " << flag;
        }
    }
    EXPECT_GT(commands, 40U);
}

/// Files that the examples name: a small scan, one before a blast, and a placed recording.
void makeFilesOfExamples(const fs::path& folder) {
    const std::string small = " --lines 120 --beams 138 ", in = "simulate" + small + "-o " + folder.string() + "/";
    ASSERT_EQ(test::runLab(in + "my.json").code, 0);
    ASSERT_EQ(test::runCli("convert " + (folder / "my.json").string() + " " + (folder / "my.pcd").string()).code, 0);
    ASSERT_EQ(test::runLab(in + "SWEEP.mcap").code, 0);
    const std::string page = test::fileText(kManual.parent_path() / "docs/reference/coordinates.md"), fence = "```json\n";
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
        const std::string text = page.substr(at + fence.size(), page.find("```", at + fence.size()) - at - fence.size());
        const bool isPose = text.find("edgescan-pose") != std::string::npos; // the calibration of the sweep mounting is the second one
        std::ofstream(folder / (isPose ? "POSE.json" : "ROBOT.json")) << text;
    }
}

// Each line of each block of code that begins with a command, in the order of the page. Lines that need a scanner are left out.
TEST(Manual, TheExamplesWork) {
    std::size_t lines = 0;
    for (const char* name : {"quick-start", "rocks", "compare", "exports"}) {
        const test::TemporaryFolder folder;
        makeFilesOfExamples(folder.path());
        bool code = false;
        std::istringstream page(test::fileText(kManual / "guide" / (std::string(name) + ".md")));
        for (std::string line; std::getline(page, line);) {
            if (line.starts_with("```")) code = !code;
            if (!code || !(line.starts_with("edgescan-cli ") || line.starts_with("edgescan-lab simulate "))) continue;
            if (line.find("simulate") != std::string::npos) line += " --lines 120 --beams 138"; // a scan of full size takes seconds
            ++lines;
            // The program writes into the current folder, so the shell changes it first.
            const std::string run = "--version >/dev/null && cd " + folder.path().string() + " && " + test::programFolder() + "/" + line;
            const auto result = test::runCli(run);
            EXPECT_EQ(result.code, 0) << name << ": " << line << "\n" << result.err;
        }
    }
    EXPECT_GE(lines, 8U);
}

} // namespace
} // namespace edgescan
