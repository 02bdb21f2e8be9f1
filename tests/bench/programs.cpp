// Starts programs and waits for them; the system reports their cost.
#include "tests/bench/programs.h"

#include "core/base/whole_file.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/column_rows.h"
#include "tests/bench/timing.h"
#include "tests/support/e57_writer.h"
#include "tests/support/run_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>

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

// A command line: the program, then its words.
using Words = std::vector<std::string>;

std::optional<Cost> costOf(const Words& command) { return costOf(command.front(), {command.begin() + 1, command.end()}); }

struct Task {
    std::string what;
    Words words;
};

std::vector<Task> tasksIn(const fs::path& folder) {
    const auto at = [&folder](const char* name) { return (folder / name).string(); };
    return {{"`--version`", {"--version"}},
            {"`info` of a raw grid", {"info", at("scan.json")}},
            {"raw grid to edge PCD, thesis's recipe", {"detect", at("scan.json"), "--preset", "thesis", "--edges", at("e.pcd")}},
            {"raw grid to edge PCD, EdgeScan+", {"detect", at("scan.json"), "--edges", at("e.pcd")}},
            {"text cloud loaded", {"info", at("whole.xyz")}},
            {"PCD loaded", {"info", at("whole.pcd")}},
            {"PCD written", {"convert", at("scan.json"), at("w.pcd")}},
            {"XYZ written", {"convert", at("scan.json"), at("w.xyz"), "--comments"}}};
}

bool writeScan(const Scan& scan, const fs::path& folder) {
    files::SaveOptions withGrid;
    withGrid.choices.comments = true;
    return files::saveScan(scan, folder / "scan.json") && files::saveScan(scan, folder / "whole.pcd") &&
           files::saveScan(scan, folder / "whole.xyz", withGrid);
}

// Rows and columns, as programs write the scans of a scanner.
std::string e57Of(const Scan& scan) {
    const files::CloudColumns cloud = files::everyCell(scan);
    test::E57Part part;
    part.bytesPerPacket = 8000;
    std::array<std::vector<double>, 5> values; // x y z, row, column
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const Eigen::Vector3d p = files::pointIn(cloud, k);
        for (std::size_t axis = 0; axis < 3; ++axis) values[axis].push_back(p[static_cast<Eigen::Index>(axis)]);
        values[3].push_back(static_cast<double>(k / static_cast<std::size_t>(scan.beams())));
        values[4].push_back(static_cast<double>(k % static_cast<std::size_t>(scan.beams())));
    }
    for (std::size_t n = 0; n < 3; ++n)
        part.columns.push_back(
            {std::array{"cartesianX", "cartesianY", "cartesianZ"}[n], test::E57Column::As::Single, std::move(values[n])});
    part.columns.push_back(test::e57Whole("rowIndex", std::move(values[3])));
    part.columns.push_back(test::e57Whole("columnIndex", std::move(values[4])));
    return test::e57Bytes({part});
}

// Medians of the processor time of commands that are run in turn; 0 where one fails.
std::vector<double> mediansInTurn(const std::vector<Words>& commands, int rounds) {
    std::vector<std::vector<double>> cpu(commands.size());
    std::vector<bool> failed(commands.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t n = 0; n < commands.size(); ++n) {
            if (const auto cost = costOf(commands[n]))
                cpu[n].push_back(cost->cpuMs);
            else
                failed[n] = true;
        }
    }
    std::vector<double> medians;
    for (std::size_t n = 0; n < commands.size(); ++n) {
        if (failed[n]) std::fprintf(stderr, "edgescan-bench: %s %s failed\n", commands[n][0].c_str(), commands[n][1].c_str());
        medians.push_back(failed[n] ? 0 : medianOf(cpu[n]));
    }
    return medians;
}

} // namespace

WholeRatios wholeRatios(const std::string& present, const Scan& scan, int rounds) {
    const test::TemporaryFolder folder;
    if (!writeScan(scan, folder.path()) || !writeWholeFile(folder / "whole.e57", e57Of(scan))) return {};
    const auto at = [&folder](const char* name) { return (folder / name).string(); };
    std::vector<Words> commands{{present, "--version"},
                                {present, "detect", at("scan.json"), "--preset", "thesis", "--edges", at("e.pcd")},
                                {present, "convert", at("scan.json"), at("w.pcd")}};
    for (const char* name : {"whole.pcd", "whole.xyz", "whole.e57"}) {
        commands.push_back({present, "info", at(name)});
        commands.push_back({"/usr/bin/sha256sum", at(name)});
        commands.push_back({"/usr/bin/cp", at(name), at("copy")});
    }
    const std::vector<double> ms = mediansInTurn(commands, rounds);
    const auto ratio = [&](std::size_t of, double to) { return to > 0 ? ms[of] / to : 0; };
    const auto hashedAndCopied = [&](std::size_t read) { return ms[read + 1] + ms[read + 2]; };
    return {ratio(1, ms[0]), ratio(2, hashedAndCopied(3)), ratio(3, hashedAndCopied(3)), ratio(6, hashedAndCopied(6)),
            ratio(9, hashedAndCopied(9))};
}

std::vector<ProgramRow> programRows(const std::string& previous, const std::string& present, const Scan& scan, int rounds) {
    const test::TemporaryFolder folder;
    std::vector<ProgramRow> rows;
    if (!writeScan(scan, folder.path())) return rows;
    for (const Task& task : tasksIn(folder.path())) {
        std::vector<double> cpu[2], wall[2];
        for (int run = 0; run < 2 * rounds; ++run) {
            const std::string& program = run % 2 == 0 ? previous : present;
            auto cost = costOf(program, task.words);
            if (!cost && task.words.back() == "--comments") // version 0.1 always wrote comments and does not know the flag
                cost = costOf(program, {task.words.begin(), task.words.end() - 1});
            if (!cost) {
                std::fprintf(stderr, "edgescan-bench: %s failed: %s\n", program.c_str(), task.what.c_str());
                break;
            }
            cpu[run % 2].push_back(cost->cpuMs);
            wall[run % 2].push_back(cost->wallMs);
        }
        if (cpu[1].size() < static_cast<std::size_t>(rounds)) continue;
        const double ms = medianOf(cpu[1]);
        rows.push_back({task.what, medianOf(cpu[0]) / ms, medianOf(wall[0]) / medianOf(wall[1]), ms});
    }
    return rows;
}

} // namespace edgescan::bench
