// The output of the programs for any input: text of files and names reaches the terminal only with escapes, every number has limits, and
// after closed pipes and failures no process hangs and no temporary file remains.
#include "tests/support/folders.h"
#include "tests/support/run_program.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <future>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using test::fileText;
using test::runCli;
using test::runLab;
using test::runProgram;
using test::TemporaryFolder;

const fs::path kSourceRoot = test::sourceFolder();

// Lines of the project's sources with `pattern` outside of comments, as "core/base/x.cpp:12: text".
std::vector<std::string> linesWith(const std::vector<std::string>& folders, const std::regex& pattern, const std::set<std::string>& but) {
    std::vector<std::string> found;
    for (const std::string& folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(kSourceRoot / folder)) {
            const std::string name = fs::relative(entry.path(), kSourceRoot).string();
            if ((entry.path().extension() != ".cpp" && entry.path().extension() != ".h") || but.contains(name)) continue;
            std::istringstream lines(fileText(entry.path()));
            int number = 0;
            for (std::string line; std::getline(lines, line);) {
                ++number;
                line = line.substr(0, line.find("//"));
                if (std::regex_search(line, pattern)) found.push_back(name + ":" + std::to_string(number) + ": " + line);
            }
        }
    }
    return found;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST(Exits, OnlyOneFileWritesToTheTerminal) {
    const std::regex terminal(
        R"(std::(cout|cerr|clog)\b|\b(f|v|vf)?printf\(|\bfput[cs]\(|\bputs\(|\bperror\(|q(Debug|Info|Warning|Critical)\()");
    EXPECT_EQ(joined(linesWith({"core", "ui", "app"}, terminal, {"app/shared/exits.cpp"})), "");
    EXPECT_FALSE(linesWith({"app"}, terminal, {}).empty()); // shows that the pattern works
}

TEST(Exits, OnlyOneFileMakesTextForTheWindow) {
    const std::regex conversion(R"(QString::fromStdString|QString::fromStdU|QString::fromLatin1|QString::fromLocal8Bit|setHtml\()");
    EXPECT_EQ(
        joined(linesWith({"ui"}, conversion, {"ui/base/shown_text.cpp", "ui/panels/dialogs/sheets.cpp", "ui/controllers/report_pdf.cpp"})),
        "");
}

// In each language of the window a number is written in the same way everywhere.
TEST(Exits, OnlyOneFileSetsThousandsApart) {
    EXPECT_EQ(joined(linesWith({"ui"}, std::regex(R"(QLocale::English|toString\(static_cast<q)"), {"ui/base/count_text.h"})), "");
}

TEST(Exits, OnlyOneFileWritesJson) {
    EXPECT_EQ(joined(linesWith({"core", "ui", "app"}, std::regex(R"(\bdump\()"), {"core/base/json_text.cpp"})), "");
}

// Functions that depend on the locale: it may set a decimal comma, thousands separators, and other rules for the case of I.
TEST(Exits, NothingAsksForTheCountrysWayToWriteNumbers) {
    const std::regex calls(
        R"(\b(v?s?n?printf|sscanf|fscanf|strto[dfl]d?|ato[fil]|std::sto[dfil]\w*|wcsto\w+|strftime|std::format|toupper|tolower|)"
        R"(isalpha|isalnum|isdigit|isspace|isupper|islower|ispunct|isprint)\s*\()"
        R"(|stringstream|std::locale|setlocale|std::put_time|std::get_time|QLocale\(\)|QLocale::system|toLocal8Bit|%L[0-9])"
        R"(|<<\s*std::(setprecision|fixed)|std::regex)");
    EXPECT_EQ(joined(linesWith({"core", "ui", "app"}, calls, {"ui/base/plain_window.cpp", "ui/base/language/languages.cpp"})),
              ""); // the second one searches for text
    // Numbers with a fraction have their own text functions (core/base/number_text.h); the library's functions depend on the locale. The
    // library's template is in a program only if a number with a fraction is passed to std::to_string. (app/ is not checked: CLI11 has such
    // a call.)
    const TemporaryFolder folder;
    const std::string list = (folder / "symbols").string();
    const std::string command = "cd " + fs::path(test::programFolder()).parent_path().string() +
                                " && find core ui -name '*.o' -exec nm -A -C {} + >" + list + " 2>/dev/null";
    if (std::system(command.c_str()) != 0) GTEST_SKIP() << "nm is not there";
    std::istringstream symbols(fileText(list));
    std::string wrong;
    std::size_t count = 0;
    for (std::string line; std::getline(symbols, line); ++count) {
        if (line.find("__to_xstring") != std::string::npos || line.find("std::to_string(double)") != std::string::npos)
            wrong += line + "\n";
    }
    EXPECT_GT(count, 1000U);
    EXPECT_EQ(wrong, "");
}

struct NumberFlag {
    std::string command, flag, type;
};

const std::vector<std::string> kCommands{"info", "detect", "convert", "verify", "record", "replay", "why"};
const std::vector<std::string> kLabCommands{"benchmark", "repeatability", "evaluate", "simulate", "emulate", "calibrate"};

// The program that has this command.
std::string programOf(const std::string& command) {
    return std::ranges::count(kLabCommands, command) > 0 ? "edgescan-lab" : "edgescan-cli";
}

// Every flag of `help` that takes a value, with the help's name of the value.
std::vector<NumberFlag> flagsIn(const std::string& command, const std::string& help) {
    static const std::regex row(R"(^\s+(?:-\w,)?(--[a-z0-9-]+)[ =]([A-Z]+(?: [0-9.e+:-]+)?))");
    std::vector<NumberFlag> flags;
    std::istringstream lines(help);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, match, row)) flags.push_back({command, match[1], match[2]});
    }
    return flags;
}

// The arguments that a command needs besides the tested flag.
std::string rest(const std::string& command) {
    if (command == "convert") return "no-such-file.json out.json";
    if (command == "simulate") return "-o /nowhere/out.json --lines 4 --beams 4";
    if (command == "evaluate") return "no-such-file.json --truth no-such-folder";
    if (command == "repeatability") return "no-such-file.json no-such-file-either.json";
    if (command == "record") return "127.0.0.1:1 -o /nowhere/out.mcap --seconds 0.1";
    if (command == "why") return "no-such-file.json --cell 0,0";
    return "no-such-file.json";
}

TEST(Exits, EveryNumberHasLimitsAndIsRefusedByName) {
    int numbers = 0;
    std::set<std::string> tried;
    std::vector<std::string> commands = kCommands;
    commands.insert(commands.end(), kLabCommands.begin(), kLabCommands.end());
    for (const std::string& command : commands) {
        const std::string help = runProgram(programOf(command), command + " --help").out;
        for (const NumberFlag& flag : flagsIn(command, help)) {
            // CLI11's own names of number types: such a flag was added without limits.
            for (const char* bare : {"FLOAT", "INT", "UINT"}) EXPECT_FALSE(flag.type.starts_with(bare)) << command << " " << flag.flag;
            if (!flag.type.starts_with("NUMBER")) continue;
            ++numbers;
            // The limits of a list of thresholds are those of the chosen method.
            EXPECT_TRUE(flag.flag == "--thresholds" || flag.type.find("..") != std::string::npos) << command << " " << flag.flag;
            std::string others = rest(command);
            if (const auto same = others.find(flag.flag + " "); same != std::string::npos)
                others.erase(same, others.find(' ', same + flag.flag.size() + 1) - same);
            std::vector<std::string> values{"nan"};
            if (tried.insert(flag.flag).second) values.emplace_back("1e308"); // commands share flags
            if (numbers == 1 || flag.flag == "--sensor")                      // one parser reads them all
                values.insert(values.end(), {"inf", "-inf", "-1e308", "1e999", "", "1,5", "12x", "99999999999999999999999"});
            for (std::string value : values) {
                const bool list = flag.flag == "--sensor" || flag.flag == "--thresholds";
                if (list && (value.empty() || value.find(',') != std::string::npos)) continue;
                if (flag.flag == "--sensor") value += ",0,0";
                const auto run = runProgram(programOf(command), command + " " + others + " " + flag.flag + "='" + value + "'");
                EXPECT_EQ(run.code, 2) << command << " " << flag.flag << " " << value << ": " << run.err;
                EXPECT_NE(run.err.find(flag.flag), std::string::npos) << command << " " << flag.flag << " " << value << ": " << run.err;
                EXPECT_TRUE(std::regex_search(run.err, std::regex(R"([0-9]( to |\.\.)[0-9])")))
                    << command << " " << flag.flag << " " << value << ": " << run.err;
            }
        }
    }
    EXPECT_GT(numbers, 40);
}

TEST(Exits, NoParameterOfTheMethodTakesANumberThatIsNone) {
    const std::string help = runCli("detect --help").out;
    int parameters = 0;
    for (const NumberFlag& flag : flagsIn("detect", help)) {
        const auto at = help.find(flag.flag + " ");
        if (flag.type != "VALUE" || help.find(" default ", at) == std::string::npos) continue;
        const std::string about = help.substr(at, help.find("\n  --", at) - at);
        if (!std::regex_search(about, std::regex(R"([0-9]\s+to\s+[0-9])"))) continue;
        ++parameters;
        for (const char* value : {"nan", "inf", "-inf", "1e308", "-1", "-1e308", "1e999"}) {
            const auto run = runCli("detect no-such-file.json --method canny " + flag.flag + "=" + value);
            EXPECT_EQ(run.code, 2) << flag.flag << " " << value << run.err;
            EXPECT_NE(run.err.find(flag.flag), std::string::npos) << run.err;
        }
    }
    EXPECT_GT(parameters, 8);
}

// All commands of a program, as its own table prints them; with an empty name for a program without commands.
std::vector<std::string> commandsOf(const std::string& program) {
    if (program == "edgescan") return {""};
    static const std::regex row(R"(^  ([a-z]+)\s\s+\S)");
    std::istringstream help(runProgram(program, "--help").out);
    std::vector<std::string> commands;
    std::smatch match;
    for (std::string line; std::getline(help, line);) {
        if (std::regex_search(line, match, row)) commands.push_back(match[1]);
    }
    return commands;
}

// Every flag of `help` without a value.
std::vector<std::string> switchesIn(const std::string& help) {
    static const std::regex row(R"(^\s+(?:-\w,)?(--[a-z0-9-]+)(\s\s|$))");
    std::istringstream lines(help);
    std::vector<std::string> flags;
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, match, row)) flags.push_back(match[1]);
    }
    return flags;
}

TEST(Exits, EverySwitchTakesTrueOrFalse) {
    std::set<std::string> switches;
    for (const std::string program : {"edgescan-cli", "edgescan-lab", "edgescan"}) {
        if (!fs::exists(fs::path(edgescan::test::programFolder()) / program)) continue;
        const std::vector<std::string> commands = commandsOf(program);
        EXPECT_GE(commands.size(), program == "edgescan" ? 1U : 9U);
        for (const std::string& command : commands) {
            for (const std::string& flag : switchesIn(runProgram(program, command + " --help").out)) {
                std::vector<std::string> values{"0"};
                const bool first = switches.insert(flag).second;
                if (switches.size() == 3 && first) // one parser reads them all
                    values.insert(values.end(), {"-1", "1", "1e308", "on", "off", "True", "''", "yes", "2"});
                for (const std::string& value : values) {
                    const auto run = runProgram(program, command + " " + flag + "=" + value);
                    EXPECT_EQ(run.code, 2) << program << " " << command << " " << flag << "=" << value << run.out;
                    EXPECT_NE(run.err.find(flag), std::string::npos) << run.err;
                    const bool answers = flag == "--help" || flag == "--version";
                    EXPECT_NE(run.err.find(flag + (answers ? ": takes no value" : ": \"")), std::string::npos) << run.err;
                    EXPECT_EQ(run.err.find("is not true or false") == std::string::npos, answers) << run.err;
                }
                if (!first || flag == "--help" || flag == "--version" || program == "edgescan") continue;
                // The unknown flag is refused, so nothing runs.
                const auto run = runProgram(program, command + " " + flag + "=true " + flag + "=false --no-such-flag");
                EXPECT_EQ(run.err.find("is not true or false"), std::string::npos) << run.err;
            }
        }
    }
    EXPECT_GT(switches.size(), 35U);
}

TEST(Exits, FalseSwitchesOff) {
    const TemporaryFolder folder;
    const std::string scan = (folder / "scan.json").string();
    ASSERT_EQ(runLab("simulate -o " + scan + " --lines 20 --beams 30").code, 0);
    const auto pcd = [&](const std::string& flags) {
        const auto run = runCli("convert " + scan + " " + (folder / "out.pcd").string() + " " + flags);
        EXPECT_EQ(run.code, 0) << run.err;
        return fileText(folder / "out.pcd").find("DATA ascii") != std::string::npos;
    };
    for (const char* off : {"", "--ascii=false", "--ascii --ascii=false", "--ascii=true --ascii=false"}) EXPECT_FALSE(pcd(off)) << off;
    for (const char* on : {"--ascii", "--ascii=true", "--ascii=false --ascii"}) EXPECT_TRUE(pcd(on)) << on;
    const auto straightened = [&](const std::string& flags) {
        const auto run = runCli("detect " + scan + " -o " + (folder / "o").string() + " " + flags);
        EXPECT_EQ(run.code, 0) << run.err;
        return fileText(folder / "o/scan_edges.png.provenance.json").find("straighten") != std::string::npos;
    };
    EXPECT_TRUE(straightened("--straighten"));
    for (const char* off : {"", "--straighten=false", "--straighten --straighten=false"}) EXPECT_FALSE(straightened(off)) << off;
}

// Escape sequences of both kinds, line breaks, a reversed text direction, invalid UTF-8.
const std::vector<std::string> kNames{
    "a\x1b[31mred\x1b]0;title\x07", "line\nbreak\r", "\u202egnp.sj", "\u009b31m", "no\xff\xfeutf8", "tab\tand\x7f"};

bool terminalIsSafeFrom(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if ((c < 0x20 && c != '\n') || c == 0x7F || c >= 0xF8) return false;
        if (c == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0) return false;
        if (text.compare(i, 3, "\u202e") == 0) return false;
    }
    return true;
}

int lineCount(const std::string& text) { return static_cast<int>(std::ranges::count(text, '\n')); }

std::string inQuotes(const fs::path& path) { return "'" + path.string() + "'"; }

void expectSafe(const test::ProgramRun& run, const std::string& command) {
    EXPECT_TRUE(terminalIsSafeFrom(run.out)) << command << "\n" << run.out;
    EXPECT_TRUE(terminalIsSafeFrom(run.err)) << command << "\n" << run.err;
    EXPECT_EQ(run.err.find("not foreseen"), std::string::npos) << command << "\n" << run.err;
    EXPECT_LE(run.code, 4) << command << "\n" << run.err;
    EXPECT_TRUE(run.code == 0 || lineCount(run.err) + lineCount(run.out) >= 1) << command;
}

TEST(Exits, NamesReachNoTerminalAsTheyAre) {
    const TemporaryFolder folder;
    ASSERT_EQ(runLab("simulate -o " + (folder / "scan.json").string() + " --lines 12 --beams 16").code, 0);
    for (const std::string& name : kNames) {
        const std::string missing = inQuotes(folder / (name + ".json"));
        const fs::path scan = folder / (name + ".pcd");
        ASSERT_EQ(runCli("convert " + (folder / "scan.json").string() + " " + inQuotes(scan)).code, 0) << name;
        std::vector<std::string> commands;
        for (const char* command : {"info ", "detect ", "verify ", "replay ", "why --cell 0,0 "}) commands.push_back(command + missing);
        commands.push_back("info " + inQuotes(scan));
        commands.push_back("detect " + inQuotes(scan));
        commands.push_back("detect --json - " + inQuotes(scan));
        commands.push_back("why --cell 1,1 " + inQuotes(scan));
        commands.push_back("verify " + inQuotes(scan));
        commands.push_back("verify --json - " + inQuotes(scan));
        commands.push_back("detect --preset " + missing + " " + inQuotes(scan));
        commands.push_back("detect --pose " + missing + " " + inQuotes(scan));
        commands.push_back("detect --" + inQuotes(name) + " " + inQuotes(scan));
        commands.push_back("detect --method " + inQuotes(name) + " " + inQuotes(scan));
        commands.push_back("detect --json " + inQuotes(folder / name / "x.json") + " " + inQuotes(scan));
        commands.push_back("record " + inQuotes(name) + " -o " + inQuotes(folder / name / "x.mcap"));
        commands.push_back(inQuotes(name));
        for (const std::string& command : commands) expectSafe(runCli(command), command);
        for (const std::string& command :
             {"benchmark " + missing, "benchmark --only thesis " + inQuotes(scan), "evaluate " + missing + " --truth " + missing,
              "emulate " + missing, "simulate --scene " + inQuotes(name) + " -o " + (folder / "x.json").string()})
            expectSafe(runLab(command), command);
        // Exports store the name and the source, whatever its bytes.
        const std::string export_ = inQuotes(folder / (name + "_edges.csv"));
        ASSERT_EQ(runCli("detect " + inQuotes(scan) + " --edges " + export_).code, 0) << name;
        EXPECT_EQ(runCli("verify " + export_).code, 0) << runCli("verify " + export_).out;
    }
}

TEST(Exits, HundredThousandCharactersAreToldShort) {
    const std::string text(100000, 'x');
    for (const std::string& command : {"info " + text, "detect --method " + text + " none.json", "detect --" + text,
                                       "record " + text + " -o /nowhere/x.mcap --seconds 0.1"}) {
        const auto run = runCli(command);
        EXPECT_NE(run.code, 0);
        EXPECT_LT(run.err.size(), 6000U) << command.substr(0, 30);
    }
}

TEST(Exits, WhatHostileFilesHoldReachesNoTerminal) {
    EDGESCAN_NEEDS_SHARED("data/hostile");
    const fs::path hostile = test::sharedFolder() / "data/hostile";
    for (const char* name : {"m_esc_meta.mcap", "p_36.pcd", "g_format_1.json", "p_18.pcd"}) {
        for (const char* command : {"info ", "detect ", "detect --json - ", "replay ", "verify ", "why --cell 0,0 "}) {
            const auto run = runCli(command + (hostile / name).string());
            EXPECT_TRUE(terminalIsSafeFrom(run.out)) << command << name << "\n" << run.out;
            EXPECT_TRUE(terminalIsSafeFrom(run.err)) << command << name << "\n" << run.err;
            EXPECT_LT(run.err.size(), 6000U) << command << name;
            EXPECT_EQ(run.err.find("not foreseen"), std::string::npos) << command << name << "\n" << run.err;
        }
    }
}

TEST(Exits, PipesHangNothing) {
    const TemporaryFolder folder;
    const std::string scan = (folder / "scan.json").string();
    ASSERT_EQ(runLab("simulate -o " + scan + " --lines 12 --beams 16").code, 0);
    // PIPE is a new named pipe without a process at its other end, SCAN is a scan. All commands run at once: a command that reads waits for
    // a writer until its time limit.
    const std::vector<std::string> commands{"info PIPE",
                                            "detect PIPE",
                                            "verify PIPE",
                                            "replay PIPE",
                                            "emulate PIPE --seconds 0.1",
                                            "detect --preset PIPE SCAN",
                                            "detect --pose PIPE --calibration PIPE SCAN",
                                            "evaluate SCAN --truth PIPE",
                                            "detect --json PIPE SCAN",
                                            "detect --edges PIPE.pcd SCAN",
                                            "convert SCAN PIPE.pcd",
                                            "convert SCAN PIPE.mcap",
                                            "record 127.0.0.1:1 --seconds 0.1 -o PIPE",
                                            "simulate --lines 4 --beams 4 -o PIPE.pcd",
                                            "simulate --scene rescan --surface PIPE --lines 4 --beams 4 -o SCAN",
                                            "verify --scans " + folder.path().string() + " SCAN",
                                            "calibrate PIPE -o SCAN.out"};
    const auto words = [&](std::size_t n) { return (folder / ("words" + std::to_string(n))).string(); };
    std::vector<std::future<int>> statuses;
    for (std::size_t n = 0; n < commands.size(); ++n) {
        const std::string pipe = (folder / ("pipe" + std::to_string(n))).string();
        ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
        for (const char* extension : {".pcd", ".json", ".mcap"}) fs::create_symlink(pipe, pipe + extension);
        std::string command = std::regex_replace(commands[n], std::regex("PIPE"), pipe);
        command = std::regex_replace(command, std::regex("SCAN"), scan);
        const std::string line = "timeout 120 " + test::programFolder() + "/" + programOf(command.substr(0, command.find(' '))) + " " +
                                 command + " >" + words(n) + " 2>&1";
        statuses.push_back(std::async(std::launch::async, [line] { return std::system(line.c_str()); }));
    }
    for (std::size_t n = 0; n < commands.size(); ++n) {
        const int status = statuses[n].get();
        EXPECT_TRUE(WEXITSTATUS(status) == 1 || WEXITSTATUS(status) == 2) << commands[n] << "\n" << fileText(words(n)); // 124: it hung
    }
}

TEST(Exits, AFailedRecordingIsNotInTheWayOfTheNext) {
    const TemporaryFolder folder;
    const std::string path = (folder / "sweep.mcap").string();
    for (int again = 0; again < 2; ++again) {
        const auto run = runCli("record 127.0.0.1:1 --seconds 0.2 -o " + path);
        EXPECT_EQ(run.code, 1);
        EXPECT_EQ(run.err.find("exists"), std::string::npos) << run.err;
        EXPECT_FALSE(fs::exists(path));
    }
    // No program may remove a file that existed before.
    std::ofstream(path) << "mine";
    EXPECT_EQ(runCli("record 127.0.0.1:1 --seconds 0.2 -o " + path).code, 1);
    EXPECT_EQ(fileText(path), "mine");
}

TEST(Exits, NewFilesKeepTheUmaskAndNoLinkOfAnotherIsFollowed) {
    const TemporaryFolder folder;
    const fs::path scan = folder / "scan.json";
    ASSERT_EQ(runLab("simulate -o " + scan.string() + " --lines 12 --beams 16").code, 0);
    const unsigned before = ::umask(0077);
    for (const char* name : {"a.pcd", "a.las", "a.mcap", "a.csv", "a.json"}) {
        EXPECT_EQ(runCli("convert " + scan.string() + " " + (folder / name).string()).code, 0) << name;
        struct stat status {};
        ASSERT_EQ(::stat((folder / name).c_str(), &status), 0) << name;
        EXPECT_EQ(status.st_mode & 0777U, 0600U) << name;
    }
    ::umask(before);
    if (::geteuid() != 0) return;
    fs::create_symlink("victim.pcd", folder / "laid.pcd");
    ASSERT_EQ(::lchown((folder / "laid.pcd").c_str(), 65534, 65534), 0);
    const auto run = runCli("convert " + scan.string() + " " + (folder / "laid.pcd").string());
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("another user"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder / "victim.pcd"));
}

} // namespace
} // namespace edgescan
