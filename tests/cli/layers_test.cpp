// The rule app -> ui -> core, and a command line without Qt and VTK.
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

// Every #include line below `folder` that matches `forbidden`.
std::vector<std::string> offences(const std::string& folder, const std::regex& forbidden, int& files) {
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(EDGESCAN_SOURCE_DIR) / folder)) {
        const fs::path path = entry.path();
        if (path.extension() != ".h" && path.extension() != ".cpp") continue;
        ++files;
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            if (std::regex_search(line, forbidden)) found.push_back(path.string() + ": " + line);
        }
    }
    return found;
}

TEST(Layers, TheCoreIncludesNoQtNoVtkAndNothingAboveIt) {
    int files = 0;
    const auto found = offences("core", std::regex(R"(^\s*#\s*include\s*[<"](Q[A-Z]|Qt|vtk|ui/|app/|tests/))"), files);
    EXPECT_GT(files, 20);
    for (const std::string& line : found) ADD_FAILURE() << line;
}

TEST(Layers, TheUserInterfaceIncludesNothingOfTheApplications) {
    int files = 0;
    const auto found = offences("ui", std::regex(R"(^\s*#\s*include\s*[<"](app/|tests/))"), files);
    EXPECT_GT(files, 10);
    for (const std::string& line : found) ADD_FAILURE() << line;
}

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
