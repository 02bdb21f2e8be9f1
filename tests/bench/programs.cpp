// Starts programs and waits for them; the system reports their cost.
#include "tests/bench/programs.h"

#include "core/files/open_save/save_scan.h"
#include "tests/bench/timing.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace edgescan::bench {
namespace {

namespace fs = std::filesystem;

struct Cost {
    double cpuMs, wallMs;
};

std::optional<Cost> costOf(const std::string& program, const std::vector<std::string>& arguments) {
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO}) posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const bool started = posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    rusage used{};
    int status = 0;
    if (!started || wait4(child, &status, 0, &used) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
    const auto ms = [](const timeval& time) { return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec); };
    return Cost{ms(used.ru_utime) + ms(used.ru_stime),
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count()};
}

struct Task {
    ProgramRow row;
    std::vector<std::string> arguments;
};

std::vector<Task> tasksIn(const fs::path& folder) {
    const auto at = [&folder](const char* name) { return (folder / name).string(); };
    return {{{"`--version`", {}}, {"--version"}},
            {{"`info` of a raw grid", {}}, {"info", at("scan.json")}},
            {{"raw grid to edge PCD, thesis's recipe", 2.5}, {"detect", at("scan.json"), "--preset", "thesis", "--edges", at("e.pcd")}},
            {{"raw grid to edge PCD, EdgeScan+", {}}, {"detect", at("scan.json"), "--edges", at("e.pcd")}},
            {{"text cloud loaded", 3}, {"info", at("whole.xyz")}},
            {{"PCD loaded", 2.5}, {"info", at("whole.pcd")}},
            {{"PCD written", 4}, {"convert", at("scan.json"), at("w.pcd")}},
            {{"XYZ written", 2.5}, {"convert", at("scan.json"), at("w.xyz"), "--comments"}}};
}

} // namespace

std::vector<ProgramRow> programRows(const std::string& previous, const std::string& present, const Scan& scan, int rounds) {
    std::string pattern = (fs::temp_directory_path() / "edgescan-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(pattern.data());
    files::SaveOptions withGrid;
    withGrid.choices.comments = true;
    std::vector<ProgramRow> rows;
    if (files::saveScan(scan, folder / "scan.json") && files::saveScan(scan, folder / "whole.pcd") &&
        files::saveScan(scan, folder / "whole.xyz", withGrid)) {
        for (Task& task : tasksIn(folder)) {
            std::vector<double> cpu[2], wall[2];
            for (int run = 0; run < 2 * rounds; ++run) {
                auto cost = costOf(run % 2 == 0 ? previous : present, task.arguments);
                if (!cost && task.arguments.back() == "--comments") { // version 0.1 always wrote comments and does not know the flag
                    cost = costOf(run % 2 == 0 ? previous : present, {task.arguments.begin(), task.arguments.end() - 1});
                }
                if (!cost) {
                    std::fprintf(stderr, "edgescan-bench: %s failed: %s\n", (run % 2 == 0 ? previous : present).c_str(),
                                 task.row.what.c_str());
                    break;
                }
                cpu[run % 2].push_back(cost->cpuMs);
                wall[run % 2].push_back(cost->wallMs);
            }
            if (cpu[1].size() < static_cast<std::size_t>(rounds)) continue;
            task.row.presentMs = medianOf(cpu[1]);
            task.row.cpuRatio = medianOf(cpu[0]) / task.row.presentMs;
            task.row.wallRatio = medianOf(wall[0]) / medianOf(wall[1]);
            rows.push_back(task.row);
        }
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return rows;
}

} // namespace edgescan::bench
