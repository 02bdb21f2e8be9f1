// The order of the modules: app -> ui -> core, and inside core and ui the order of the groups and of the modules in each group. A module
// includes only the modules that its CMakeLists.txt names, and all of them are lower in the order. Therefore a circle or an upward include
// is impossible.
#include "tests/support/folders.h"
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

const fs::path kSource = test::sourceFolder();

bool isSource(const fs::path& path) { return path.extension() == ".h" || path.extension() == ".cpp"; }

// The quoted includes of the files directly in a folder, per file.
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

// A module and the modules of its storey that it may include, both as group/folder: "edges/gray"; a group's own files are "base".
struct Module {
    std::string name;
    std::set<std::string> uses;
};

std::string matched(const std::string& text, const std::string& pattern) {
    std::smatch match;
    return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

// The modules of core/ or ui/, lowest first: the groups in the order of the storey's CMakeLists.txt, in each the order of its own. "app":
// the one group app/lab.
std::vector<Module> modulesInOrder(const std::string& storey) {
    static const std::regex call(R"(edgescan(?:_ui)?_module\(([^)]*)\))");
    std::vector<Module> modules;
    const std::string groups =
        storey == "app" ? "lab" : matched(test::fileText((kSource / storey / "CMakeLists.txt").string()), R"(foreach\(group\s+([^)]*)\))");
    for (const std::string& group : words(groups)) {
        const std::string list = test::fileText((kSource / storey / group / "CMakeLists.txt").string());
        for (std::sregex_iterator at(list.begin(), list.end(), call), end; at != end; ++at) {
            const std::string arguments = (*at)[1];
            const std::string folder = words(arguments).front();
            const std::vector<std::string> uses = words(matched(arguments, R"(USES\s+([a-z0-9_/\s]*))"));
            modules.push_back({folder == "." ? group : group + '/' + folder, {uses.begin(), uses.end()}});
        }
    }
    return modules;
}

// "edges/gray" of "core/edges/gray/canny.h", "base" of "core/base/result.h"; empty for a file of another storey.
std::string moduleOf(const std::string& include, const std::string& storey) {
    if (!include.starts_with(storey + "/")) return {};
    return fs::path(include.substr(storey.size() + 1)).parent_path().string();
}

// A folder of sources that is not listed in a CMakeLists.txt would escape this test.
void expectEveryFolderListed(const std::string& storey, const std::vector<Module>& modules) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / storey)) {
        if (!entry.is_directory() || includesOf(entry.path()).empty()) continue;
        const std::string name = fs::relative(entry.path(), kSource / storey).string();
        if (fs::exists(entry.path() / "CMakeLists.txt") && name.find('/') != name.rfind('/')) continue; // a separate program
        EXPECT_TRUE(std::ranges::any_of(modules, [&](const Module& m) { return m.name == name; }))
            << storey << '/' << name << " is not in the list";
    }
}

void checkStorey(const std::string& storey) {
    const std::vector<Module> modules = modulesInOrder(storey);
    ASSERT_GE(modules.size(), 6U);
    std::set<std::string> lower;
    if (storey == "app") { // its modules name those of the core too
        for (const Module& module : modulesInOrder("core")) lower.insert(module.name);
    } else {
        expectEveryFolderListed(storey, modules);
    }
    for (const auto& [module, uses] : modules) {
        for (const std::string& used : uses)
            EXPECT_TRUE(lower.contains(used)) << storey << '/' << module << " uses " << used << ", which is not below it";
        std::set<std::string> included;
        for (const auto& [file, includes] : includesOf(kSource / storey / module)) {
            for (const std::string& include : includes) {
                const std::string other = moduleOf(include, storey == "app" && include.starts_with("core/") ? "core" : storey);
                if (other.empty() || other == module) continue;
                included.insert(other);
                EXPECT_TRUE(uses.contains(other))
                    << file << " includes " << include << ", but the uses of " << module << " do not name " << other;
            }
        }
        for (const std::string& used : uses)
            EXPECT_TRUE(included.contains(used))
                << "the uses of " << storey << '/' << module << " name " << used << ", which it does not include";
        lower.insert(module);
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

TEST(Layers, TheModulesOfTheCoreUseOnlyLowerOnes) { checkStorey("core"); }

TEST(Layers, TheModulesOfTheLaboratoryUseOnlyLowerOnes) { checkStorey("app"); }

TEST(Layers, TheModulesOfTheUserInterfaceUseOnlyLowerOnes) { checkStorey("ui"); }

TEST(Layers, TheCoreIncludesNoQtNoVtkAndNothingAboveIt) { expectNone("core", std::regex("^(Q[A-Z]|Qt|vtk|ui/|app/|tests/)")); }

TEST(Layers, TheUserInterfaceIncludesNothingOfTheApplications) { expectNone("ui", std::regex("^(app/|tests/)")); }

TEST(Layers, TheCommandLineLinksNeitherQtNorVtkNorOpenGl) {
    const test::TemporaryFolder folder;
    const std::string list = (folder / "ldd").string();
    ASSERT_EQ(std::system(("ldd " + test::programFolder() + "/edgescan-cli >" + list).c_str()), 0);
    const std::string libraries = test::fileText(list);
    EXPECT_NE(libraries.find("libopencv_core"), std::string::npos);
    for (const char* forbidden : {"libQt", "libvtk", "libGL.", "libpcl"})
        EXPECT_EQ(libraries.find(forbidden), std::string::npos) << forbidden;
}

// A library of app/lab that `program` (a path below the build folder) links: named in the statement of build.ninja that makes it.
std::string labLinkedBy(const std::string& program, const std::string& allowed = "nothing") {
    static const std::string build = test::fileText((fs::path(test::programFolder()).parent_path() / "build.ninja").string());
    const std::size_t at = build.find("build " + program + ":");
    if (at == std::string::npos) return "there is no " + program;
    const std::string statement = build.substr(at, build.find("\n\n", at) - at);
    return matched(statement, "(libedgescan_lab_(?!" + allowed + ")[a-z_]*)");
}

TEST(Layers, OnlyTheLabLinksTheLab) {
    const fs::path build = fs::path(test::programFolder()).parent_path();
    if (!fs::exists(build / "build.ninja")) GTEST_SKIP() << "the link lines are read from build.ninja, and this build has none";
    EXPECT_EQ(labLinkedBy("bin/edgescan-cli"), "");
    EXPECT_NE(labLinkedBy("bin/edgescan-lab"), "");
    const std::string all = test::fileText((build / "build.ninja").string());
    if (all.find("build bin/edgescan:") != std::string::npos) {
        EXPECT_EQ(labLinkedBy("bin/edgescan"), "");
    }
    const std::string module = matched(all, R"(build (python/edgescan/_edgescan[^:\s]*):)");
    if (!module.empty()) {
        EXPECT_EQ(labLinkedBy(module, "sim"), "");
    }
}

} // namespace
} // namespace edgescan
