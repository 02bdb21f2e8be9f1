// Citations in comments, messages and documents are valid: the document exists, and so does the heading named after it, as in
// docs/method/edges.md, "Step 3".
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <vector>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = test::sourceFolder();
const std::string kMark = ".md";

bool isText(const fs::path& path) {
    static const std::set<std::string> kinds{"", ".h", ".cpp", ".py", ".txt", ".cmake", ".md", ".in", ".json", ".yml"};
    return kinds.contains(path.extension().string());
}

std::vector<fs::path> filesThatCite() {
    std::vector<fs::path> files;
    for (const char* folder : {"core", "ui", "app", "tests", "packaging", "docs", "examples"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
            const bool found = entry.path().string().find("/tests/fuzz/found/") != std::string::npos; // fuzzer inputs, not text
            if (entry.is_regular_file() && isText(entry.path()) && !found) files.push_back(entry.path());
        }
    }
    for (const auto& entry : fs::directory_iterator(kRoot)) {
        if (entry.is_regular_file() && isText(entry.path())) files.push_back(entry.path());
    }
    return files;
}

// The text in one line, so that a citation may continue on the next comment line; escaped quotes become quotes.
std::string sentencesOf(const fs::path& path) {
    std::string text;
    std::istringstream lines(test::fileText(path));
    for (std::string line; std::getline(lines, line);) {
        line.erase(0, std::min(line.find_first_not_of(" \t/#"), line.size()));
        text += line + ' ';
    }
    for (std::size_t at = text.find("\\\""); at != std::string::npos; at = text.find("\\\"", at)) text.erase(at, 1);
    return text;
}

std::vector<std::string> headingsOf(const fs::path& document) {
    std::vector<std::string> headings;
    std::istringstream lines(test::fileText(document));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#')) headings.push_back(line.substr(line.find_first_not_of("# ")));
    }
    return headings;
}

// True for a whole heading, or its part before the colon: "Step 3" of "Step 3: jumps".
bool hasHeading(const std::vector<std::string>& headings, const std::string& cited) {
    return std::ranges::any_of(headings, [&](const std::string& h) { return h == cited || h.starts_with(cited + ":"); });
}

// The part of a link after '#': lower case, spaces as hyphens, only letters, digits and hyphens.
std::string anchorOf(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        if (c == ' ') anchor += '-';
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-')
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return anchor;
}

// Quoted headings after a citation that ends at `at`: , "A", "B" and "C" or "A" to "B".
std::vector<std::string> headingsCited(const std::string& text, std::size_t at) {
    std::vector<std::string> cited;
    for (bool more = true; more;) {
        more = false;
        for (const char* join : {", \"", " and \"", " to \""}) {
            if (text.compare(at, std::string(join).size(), join) != 0 || (cited.empty() && *join != ',')) continue;
            const std::size_t begin = at + std::string(join).size();
            const std::size_t end = text.find('"', begin);
            if (end == std::string::npos) return cited;
            cited.push_back(text.substr(begin, end - begin));
            at = end + 1;
            more = true;
        }
    }
    return cited;
}

// The file with this name in a text: relative to the root or, in documents and in the commands that make them, to their own folder. Empty
// if it does not exist.
fs::path documentNamed(const std::string& name, const fs::path& citing) {
    if (fs::is_regular_file(kRoot / name)) return kRoot / name;
    const fs::path sibling = citing.parent_path() / name;
    const bool isOfDocument = citing.extension() == kMark || fs::relative(citing, kRoot).string().starts_with("docs/");
    return isOfDocument && fs::is_regular_file(sibling) ? sibling : fs::path();
}

void checkCitations(const fs::path& file) {
    const std::string text = sentencesOf(file);
    const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
    for (std::size_t at = text.find(kMark); at != std::string::npos; at = text.find(kMark, at + 1)) {
        const std::size_t end = at + kMark.size();
        if (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])) != 0) continue;
        const std::size_t before = text.find_last_not_of(letters, at);
        const std::size_t begin = before == std::string::npos ? 0 : before + 1;
        const std::string name = text.substr(begin, end - begin);
        if (begin >= at || name.starts_with('/')) continue; // no name, or a web address
        const fs::path document = documentNamed(name, file);
        if (document.empty()) {
            ADD_FAILURE() << file << " cites " << name << ", which is not there";
            continue;
        }
        const std::vector<std::string> headings = headingsOf(document);
        for (const std::string& cited : headingsCited(text, end))
            EXPECT_TRUE(hasHeading(headings, cited)) << file << " cites " << name << ", \"" << cited << "\", and it has no such heading";
        if (end >= text.size() || text[end] != '#') continue;
        const std::string anchor = text.substr(end + 1, text.find_first_not_of(letters, end + 1) - end - 1);
        EXPECT_TRUE(std::ranges::any_of(headings, [&](const std::string& h) { return anchorOf(h) == anchor; }))
            << file << " links to " << name << '#' << anchor << ", and it has no such heading";
    }
}

TEST(Documents, WhatIsCitedIsThereWithItsHeading) {
    const std::vector<fs::path> files = filesThatCite();
    EXPECT_GT(files.size(), 300U);
    for (const fs::path& file : files) checkCitations(file);
}

TEST(Documents, LinksLeadToFilesThatAreThere) {
    int links = 0;
    for (const fs::path& file : filesThatCite()) {
        if (file.extension() != kMark) continue;
        const std::string text = test::fileText(file);
        for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
            const std::string target = text.substr(at + 2, text.find_first_of("#)", at + 2) - at - 2);
            if (target.empty() || target.find("://") != std::string::npos) continue;
            ++links;
            EXPECT_TRUE(fs::exists(file.parent_path() / target)) << file << " links to " << target;
        }
    }
    EXPECT_GT(links, 50);
}

TEST(Documents, EveryGroupHasAReadme) {
    int groups = 0;
    for (const char* storey : {"core", "ui"}) {
        for (const auto& entry : fs::directory_iterator(kRoot / storey)) {
            if (!entry.is_directory()) continue;
            ++groups;
            const std::string name = std::string(storey) + "/" + entry.path().filename().string();
            EXPECT_TRUE(test::fileText(entry.path() / "README.md").starts_with("# " + name + "\n"))
                << name << " needs a README.md with this heading: its modules, the purpose of each, and the header to start with";
        }
    }
    EXPECT_GT(groups, 15);
    for (const char* folder : {"app", "tests", "packaging", "docs", "examples"})
        EXPECT_TRUE(fs::is_regular_file(kRoot / folder / "README.md")) << folder;
}

// `core/edges/gray/canny.h` or `app/lab/sim/seam` in a document; NAME is a placeholder for a new file.
TEST(Documents, PathsNamedInDocumentsAreThere) {
    int paths = 0;
    for (const fs::path& file : filesThatCite()) {
        if (file.extension() != kMark) continue;
        const std::string text = test::fileText(file);
        for (const char* folder : {"`core/", "`ui/", "`app/", "`tests/", "`docs/", "`packaging/", "`examples/"}) {
            for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at + 1)) {
                const std::string path = text.substr(at + 1, text.find_first_of("` \n", at + 1) - at - 1);
                if (path.find("NAME") != std::string::npos) continue;
                ++paths;
                EXPECT_TRUE(fs::exists(kRoot / path) || fs::exists(kRoot / (path + ".h")))
                    << file << " names " << path << ", which is not there";
            }
        }
    }
    EXPECT_GT(paths, 50);
}

} // namespace
} // namespace edgescan
