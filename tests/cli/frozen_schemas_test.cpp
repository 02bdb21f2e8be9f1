// Every schema that the programs write or read is in docs/reference/compatibility.md, with its number: 1.x does not change it. No page but
// the change log names a version, so that a release changes CMakeLists.txt and the change log only.
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

std::set<std::string> allIn(const std::string& text, const std::regex& pattern, const std::string& before = "",
                            const std::string& after = "") {
    std::set<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) found.insert(before + (*at)[1].str() + after);
    return found;
}

TEST(Compatibility, ThePageHasEverySchemaOfTheSources) {
    static const std::regex named(R"re("(edgescan-[a-z0-9-]+/[0-9]+)")re"), made(R"re((?:document|refusal)\("([a-z-]+)")re");
    static const std::regex comment(R"(//[^\n]*)");
    static const std::regex inPage(R"(`(edgescan-[a-z0-9-]+/[0-9]+)`)");
    std::set<std::string> schemas;
    for (const char* folder : {"core", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(test::sourceFolder()) / folder)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
            const std::string text = std::regex_replace(test::fileText(entry.path()), comment, "");
            schemas.merge(allIn(text, named));
            schemas.merge(allIn(text, made, "edgescan-", "/1"));
        }
    }
    EXPECT_GT(schemas.size(), 25U);
    EXPECT_EQ(allIn(test::fileText(fs::path(test::sourceFolder()) / "docs/reference/compatibility.md"), inPage), schemas);
}

TEST(Compatibility, NoPageNamesTheVersion) {
    const fs::path root = test::sourceFolder();
    static const std::regex project(R"(project\(EdgeScan VERSION ([0-9.]+))");
    const std::set<std::string> version = allIn(test::fileText(root / "CMakeLists.txt"), project);
    ASSERT_EQ(version.size(), 1U);
    const auto check = [&](const fs::path& page) {
        EXPECT_EQ(test::fileText(page).find("EdgeScan " + *version.begin()), std::string::npos) << page;
    };
    check(root / "README.md");
    for (const auto& entry : fs::recursive_directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md") check(entry.path());
}

} // namespace
} // namespace edgescan
