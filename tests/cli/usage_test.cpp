// What a person types wrong: names that nearly exist, names of version 0.1, flags in the wrong place. What the help says: groups, examples,
// exit codes.
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace edgescan {
namespace {

using test::ProgramRun;
using test::runProgram;

struct Mistake {
    std::string program, typed, answer;
};

void expectAnswers(const std::vector<Mistake>& mistakes) {
    for (const Mistake& one : mistakes) {
        const ProgramRun run = runProgram(one.program, one.typed);
        EXPECT_EQ(run.code, 2) << one.typed << "\n" << run.err;
        EXPECT_NE(run.err.find(one.answer), std::string::npos) << one.typed << "\n" << run.err;
        EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
        EXPECT_EQ(run.err.find("ubcommand"), std::string::npos) << run.err;
    }
}

TEST(Usage, AnUnknownNameIsAnsweredWithTheNearest) {
    expectAnswers({{"edgescan-cli", "detct x.pcd", "detct: there is no such command; did you mean detect?"},
                   {"edgescan-cli", "detect x.pcd --jmp 30", "--jmp: there is no such flag; did you mean --jump?"},
                   {"edgescan-cli", "detect x.pcd --jmp=30", "did you mean --jump?"},
                   {"edgescan-cli", "detect x.pcd --include", "did you mean --include-attached?"},
                   {"edgescan-cli", "detect --jmp 30", "did you mean --jump?"},
                   {"edgescan-cli", "detect x.pcd --wholly-different", "detect --help lists all flags"},
                   {"edgescan-cli", "", "--help lists the commands"},
                   {"edgescan-cli", "replay a.mcap b.mcap", "one too many"},
                   {"edgescan-lab", "bench x.pcd", "did you mean benchmark?"}});
}

TEST(Usage, ANameOfVersion01IsAnsweredWithTheNewOne) {
    expectAnswers({{"edgescan-cli", "change a.pcd b.pcd", "use compare"},
                   {"edgescan-cli", "serve a.pcd", "use edgescan-lab emulate"},
                   {"edgescan-cli", "evaluate a.png --truth t", "use edgescan-lab evaluate"},
                   {"edgescan-cli", "why a.pcd --line 3 --beam 4", "use --cell LINE,BEAM"},
                   {"edgescan-cli", "detect a.pcd --ndjson", "use --json -"},
                   {"edgescan-cli", "record host -o r.mcap --first-line 3", "use --line-start"},
                   {"edgescan-cli", "record host -o r.mcap --standing", "use --stop-and-go"},
                   {"edgescan-cli", "compare a.pcd b.pcd --poses a.pose b.pose", "use --poses-3dtk"},
                   {"edgescan-lab", "repeatability a.pcd b.pcd --poses a.pose b.pose", "use --poses-3dtk"},
                   {"edgescan-lab", "evaluate a.png --truth t --ranges a.pcd", "use --scan-of-mask"},
                   {"edgescan-cli", "batch folder -o r --strict", "it is 4 where a scan was refused"},
                   {"edgescan-lab", "emulate a.pcd --split", "use --split-sends"},
                   {"edgescan-lab", "emulate a.pcd --merge", "use --merge-sends"},
                   {"edgescan-lab", "simulate -o a.pcd --repeat 1", "use --sweep-number"},
                   {"edgescan-lab", "simulate -o a.pcd --rocks 5", "use --rock-count"},
                   {"edgescan-lab", "simulate -o a.pcd --hole round", "use --hole-shape"},
                   {"edgescan-lab", "simulate -o a.pcd --holes 2", "use --hole-count"}});
}

TEST(Usage, TooFewValuesOfOneFlagAreCounted) {
    const auto run = test::runCli("info x.pcd --sensor 1,2");
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.err, "edgescan-cli: --sensor: takes 3 values and got 2; write \"1,2\" as 3 numbers with commas between them: Place of "
                       "the scanner for a cloud without a grid, as "
                       "X,Y,Z [m].\n");
}

TEST(Usage, AFolderFlagRefusesTheNameOfAFile) {
    expectAnswers({{"edgescan-cli", "detect none.json -o edges.pcd", "name of one file"},
                   {"edgescan-cli", "rocks none.json -o rocks.dxf", "name of one file"}});
}

// What the new file lacks concerns only a file that was written.
TEST(Usage, ARefusedConversionSaysOnlyWhy) {
    const test::TemporaryFolder folder;
    const std::string scan = (folder / "a.json").string();
    ASSERT_EQ(test::runLab("simulate -o " + scan + " --lines 20 --beams 30").code, 0);
    const ProgramRun done = test::runCli("convert " + scan + " " + (folder / "a.xyz").string());
    EXPECT_NE(done.err.find("provenance"), std::string::npos) << done.err;
    const ProgramRun refused = test::runCli("convert " + scan + " /nonexistent-folder/a.xyz");
    EXPECT_EQ(refused.code, 1);
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
}

TEST(Usage, TheVersionNamesCommitAndLicence) {
    for (const std::string program : {"edgescan-cli", "edgescan-lab"}) {
        const std::string text = runProgram(program, "--version").out;
        EXPECT_TRUE(std::regex_search(text, std::regex("^" + program + " [0-9.]+ \\(commit [0-9a-z]+\\)\nLicence: BSD-3"))) << text;
    }
}

// Packages are built from an archive that has no history.
TEST(Usage, AnArchiveOfTheSourcesKnowsItsCommit) {
    const std::string git = "git -C '" + test::sourceFolder() + "' ";
    const auto said = [](const std::string& command) {
        std::string text(64, '\0');
        FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
        text.resize(std::fread(text.data(), 1, text.size(), pipe));
        ::pclose(pipe);
        return text;
    };
    const std::string commit = said(git + "rev-parse HEAD");
    if (commit.size() < 40) GTEST_SKIP() << "the sources have no history here";
    EXPECT_EQ(said(git + "archive HEAD core/base/commit.txt | tar -xO"), commit);
}

std::vector<std::string> commandsIn(const std::string& help) {
    static const std::regex row(R"(\n  ([a-z]+)  +[A-Z])");
    std::vector<std::string> names;
    for (std::sregex_iterator at(help.begin(), help.end(), row), end; at != end; ++at) names.push_back((*at)[1]);
    return names;
}

std::vector<std::string> examplesIn(const std::string& help) {
    std::vector<std::string> examples;
    std::istringstream lines(help.substr(std::min(help.size(), help.find("Examples:"))));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  edgescan")) examples.push_back(line.substr(2));
    return examples;
}

TEST(Usage, EveryCommandHasAGroupAnExampleAndItsExitCodes) {
    for (const std::string program : {"edgescan-cli", "edgescan-lab"}) {
        const bool isLab = program == "edgescan-lab";
        const std::string all = runProgram(program, "--help").out;
        EXPECT_EQ(all.find("ubcommand"), std::string::npos);
        EXPECT_NE(all.find(isLab ? "\nTwo scans:\n  repeatability" : "\nTwo scans:\n  compare"), std::string::npos) << all;
        EXPECT_GE(commandsIn(all).size(), 9U);
        for (const std::string& command : commandsIn(all)) {
            const std::string help = runProgram(program, command + " --help").out;
            EXPECT_FALSE(examplesIn(help).empty()) << command;
            for (const char* code : {"\n  0  ", "\n  1  ", "\n  2  "}) EXPECT_NE(help.find(code), std::string::npos) << command << help;
            EXPECT_EQ(help.find("\n  3  ") != std::string::npos, command == "verify" || command == "audit" || command == "families")
                << command;
        }
    }
}

TEST(Usage, CommandsThatWentToTheLabStartItAndSaySo) {
    for (const char* command : {"simulate", "emulate", "calibrate"}) {
        const auto run = test::runCli(std::string(command) + " --help");
        EXPECT_EQ(run.code, 0);
        EXPECT_EQ(run.out, test::runLab(std::string(command) + " --help").out);
        EXPECT_NE(run.err.find(std::string("type edgescan-lab ") + command), std::string::npos) << run.err;
    }
}

// "edgescan emulate --help" showed the help of the viewer.
TEST(Usage, TheViewerNamesTheProgramOfACommand) {
    if (!std::filesystem::exists(test::programFolder() + "/edgescan")) GTEST_SKIP() << "the viewer was not built";
    for (const std::string& command : commandsIn(runProgram("edgescan-cli", "--help").out))
        expectAnswers({{"edgescan", command + " --help", "type edgescan-cli " + command + " --help"}});
}

// The examples of all commands in one folder, in the order of the help; that of simulate first, because the others read its scan.
TEST(Usage, TheExamplesOfTheHelpWork) {
    const test::TemporaryFolder folder;
    const auto path = [&](const char* name) { return (folder / name).string(); };
    const auto run = [&](const std::string& line) {
        const std::string there = "--version >/dev/null && cd " + folder.path().string() + " && " + test::programFolder() + "/" + line;
        const ProgramRun done = runProgram("edgescan-cli", there);
        EXPECT_EQ(done.code, 0) << line << "\n" << done.err;
    };
    for (const std::string& line : examplesIn(test::runLab("simulate --help").out)) run(line);
    ASSERT_EQ(test::runLab("simulate -o " + path("SWEEP.mcap") + " --lines 60 --beams 80").code, 0);
    ASSERT_EQ(test::runLab("simulate -o " + path("AGAIN.json") + " --seed 7 --lines 150 --beams 191").code, 0);
    for (const char* pose : {"A.pose", "B.pose"}) std::ofstream(folder / pose) << "0 0 0\n0 0 0\n";
    std::size_t examples = 0;
    for (const std::string program : {"edgescan-cli", "edgescan-lab"}) {
        for (const std::string& command : commandsIn(runProgram(program, "--help").out)) {
            // These need a scanner, a log of the viewer or scanned stones, or run until they are stopped.
            if (command == "record" || command == "audit" || command == "emulate" || command == "simulate" || command == "stones") continue;
            for (const std::string& line : examplesIn(runProgram(program, command + " --help").out)) {
                run(line);
                ++examples;
            }
        }
    }
    EXPECT_GE(examples, 18U);
}

TEST(Usage, AddressesOfFilesAreTheirPaths) {
    for (const char* typed : {"info", "detect", "rocks", "why --cell 1,1", "report -o /dev/null", "compare /no/a.pcd", "place --show"}) {
        const ProgramRun run = runProgram("edgescan-cli", std::string(typed) + " file:///no%20such/gr%C3%B6%C3%9Fe.pcd");
        EXPECT_NE(run.code, 0) << typed;
        EXPECT_EQ(run.err.find("file:"), std::string::npos) << run.err;
    }
    EXPECT_NE(runProgram("edgescan-cli", "info file:///no%20such/a.pcd").err.find("/no such/a.pcd"), std::string::npos);
    expectAnswers({{"edgescan-cli", "info file://mill.example/a.pcd", "a file on another computer, mill.example"},
                   {"edgescan-cli", "info file:///a%2.pcd", "a % without the two digits"}});
}

} // namespace
} // namespace edgescan
