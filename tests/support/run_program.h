// Runs one of EdgeScan's programs and stores its output.
#pragma once

#include "tests/support/folders.h"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace edgescan::test {

struct ProgramRun {
    int code = -1;
    std::string out;
    std::string err;
};

inline std::string fileText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A temporary folder, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "edgescan-test-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// `arguments` as typed in a shell.
inline ProgramRun runProgram(const std::string& name, const std::string& arguments) {
    const TemporaryFolder folder;
    const std::string command = programFolder() + "/" + name + " " + arguments + " >" + (folder / "out").string() + " 2>" +
                                (folder / "err").string() + " </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), fileText(folder / "out"), fileText(folder / "err")};
}

inline ProgramRun runCli(const std::string& arguments) { return runProgram("edgescan-cli", arguments); }
inline ProgramRun runLab(const std::string& arguments) { return runProgram("edgescan-lab", arguments); }

} // namespace edgescan::test
