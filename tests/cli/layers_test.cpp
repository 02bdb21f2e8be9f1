// The order of the rooms: app -> ui -> core, and inside core and ui the order of their CMakeLists.txt. What a room includes is what it
// says it uses, and what it uses lies lower: so no circle and no arrow upwards can come about.
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = EDGESCAN_SOURCE_DIR;

bool isSource(const fs::path& path) { return path.extension() == ".h" || path.extension() == ".cpp"; }

// What the files of a folder itself include with quotes, file by file.
std::map<std::string, std::set<std::string>> includesOf(const fs::path& folder) {
    static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::map<std::string, std::set<std::string>> found;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (!isSource(entry.path())) continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);) {
            if (std::regex_search(line, match, include)) found[entry.path().string()].insert(match[1]);
        }
    }
    return found;
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

// The rooms of core/ or ui/ in the order of its CMakeLists.txt, lowest first.
std::vector<std::string> roomsInOrder(const std::string& storey) {
    const std::string text = test::fileText((kSource / storey / "CMakeLists.txt").string());
    std::smatch match;
    if (!std::regex_search(text, match, std::regex(R"(foreach\(room\s+([^)]*)\))"))) return {};
    return words(match[1]);
}

// What a room says it uses: "gray" for core/gray out of a room of the core, "core" and the names of ui rooms out of one of ui.
std::set<std::string> usedBy(const std::string& storey, const std::string& room) {
    const std::string text = test::fileText((kSource / storey / room / "CMakeLists.txt").string());
    std::smatch match;
    if (!std::regex_search(text, match, std::regex(R"(USES\s+([a-z0-9_\s]*))"))) return {};
    const std::vector<std::string> names = words(match[1]);
    return {names.begin(), names.end()};
}

// "gray" of "core/gray/canny.h" for storey "core"; empty for anything else.
std::string roomOf(const std::string& include, const std::string& storey) {
    if (!include.starts_with(storey + "/")) return {};
    const std::string rest = include.substr(storey.size() + 1);
    return rest.substr(0, rest.find('/'));
}

void checkStorey(const std::string& storey) {
    const std::vector<std::string> rooms = roomsInOrder(storey);
    ASSERT_GE(rooms.size(), 6U);
    for (const auto& entry : fs::directory_iterator(kSource / storey)) {
        if (!entry.is_directory()) continue;
        EXPECT_NE(std::ranges::find(rooms, entry.path().filename().string()), rooms.end()) << entry.path() << " is no room in the list";
    }
    std::set<std::string> lower;
    for (const std::string& room : rooms) {
        const std::set<std::string> uses = usedBy(storey, room);
        for (const std::string& used : uses)
            EXPECT_TRUE(lower.contains(used)) << storey << '/' << room << " uses " << used << ", which is not below it";
        std::set<std::string> included;
        for (const auto& [file, includes] : includesOf(kSource / storey / room)) {
            for (const std::string& include : includes) {
                const std::string other = roomOf(include, storey);
                if (other.empty() || other == room) continue;
                included.insert(other);
                EXPECT_TRUE(uses.contains(other))
                    << file << " includes " << include << ", but " << room << " does not say that it uses " << other;
            }
        }
        for (const std::string& used : uses)
            EXPECT_TRUE(included.contains(used)) << storey << '/' << room << " says that it uses " << used << " and does not";
        lower.insert(room);
    }
}

// Every #include below `folder` that matches `forbidden`.
void expectNone(const std::string& folder, const std::regex& forbidden) {
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
        if (!entry.is_directory()) continue;
        for (const auto& [file, includes] : includesOf(entry.path())) {
            ++files;
            for (const std::string& include : includes)
                EXPECT_FALSE(std::regex_search(include, forbidden)) << file << " includes " << include;
        }
    }
    EXPECT_GT(files, 20);
}

TEST(Layers, TheRoomsOfTheCoreUseOnlyLowerOnesAndSayWhich) { checkStorey("core"); }

TEST(Layers, TheRoomsOfTheUserInterfaceUseOnlyLowerOnesAndSayWhich) { checkStorey("ui"); }

TEST(Layers, TheCoreIncludesNoQtNoVtkAndNothingAboveIt) { expectNone("core", std::regex("^(Q[A-Z]|Qt|vtk|ui/|app/|tests/)")); }

TEST(Layers, TheUserInterfaceIncludesNothingOfTheApplications) { expectNone("ui", std::regex("^(app/|tests/)")); }

TEST(Layers, TheCommandLineLinksNeitherQtNorVtkNorOpenGl) {
    const test::TemporaryFolder folder;
    const std::string list = (folder / "ldd").string();
    ASSERT_EQ(std::system(("ldd " + std::string(EDGESCAN_BIN_DIR) + "/edgescan-cli >" + list).c_str()), 0);
    const std::string libraries = test::fileText(list);
    EXPECT_NE(libraries.find("libopencv_core"), std::string::npos);
    for (const char* forbidden : {"libQt", "libvtk", "libGL.", "libpcl"})
        EXPECT_EQ(libraries.find(forbidden), std::string::npos) << forbidden;
}

} // namespace
} // namespace edgescan
