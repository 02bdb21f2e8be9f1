// edgescan-cli: edge detection without a display.
#include "app/cli/commands.h"
#include "app/shared/exits.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/base/inputs.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

using namespace edgescan;

namespace {

const char* const kSomeRefused = "some scans were refused; the others are done";

struct Command {
    void (*add)(CLI::App& app, int& code);
    cli::CommandText text;
};

// In the order of the help. After the example of `edgescan-lab simulate` all others work in this order in one folder.
const std::vector<Command>& commands() {
    using cli::kDiffers, cli::kPartly;
    const auto code = [](int number, const char* meaning) { return cli::Term{std::to_string(number), meaning}; };
    const char *const look = "Look at a scan", *const find = "Find edges and rocks", *const archive = "Archives", *const two = "Two scans",
                      *const trust = "Records", *const live = "Scanner";
    static const std::vector<Command> all{
        {cli::addInfo, {"info", look, {"edgescan-cli info BELL.json"}, {code(kPartly, kSomeRefused)}}},
        {cli::addWhy, {"why", look, {"edgescan-cli why BELL.json --cell 120,200"}, {}}},
        {cli::addThumbnail, {"thumbnail", look, {"edgescan-cli thumbnail BELL.json SMALL.png"}, {}}},
        {cli::addDetect,
         {"detect",
          find,
          {"edgescan-cli detect BELL.json", "edgescan-cli detect BELL.json -o RESULTS --jump 40",
           "edgescan-cli detect BELL.json --edges EDGES.dxf --json EDGES.json"},
          {code(kPartly, kSomeRefused)}}},
        {cli::addRocks,
         {"rocks", find, {"edgescan-cli rocks BELL.json --csv ROCKS.csv", "edgescan-cli rocks BELL.json --level 0.5 -o RESULTS"}, {}}},
        {cli::addReport, {"report", find, {"edgescan-cli report BELL.json -o REPORT.html --rocks --site \"North 4\""}, {}}},
        {cli::addConvert, {"convert", find, {"edgescan-cli convert BELL.json BELL.pcd"}, {}}},
        {cli::addBatch,
         {"batch",
          archive,
          {"edgescan-cli batch BELL.json BELL.pcd -o ARCHIVE --results mask,json"},
          {code(kPartly, "every scan has its row, and some were refused or failed")}}},
        {cli::addCompare,
         {"compare",
          two,
          {"edgescan-lab simulate -o AFTER.json --after-blast --seed 7 --lines 300 --beams 381",
           "edgescan-cli compare BELL.json AFTER.json --picture CHANGE.png"},
          {}}},
        {cli::addVerify,
         {"verify",
          trust,
          {"edgescan-cli verify RESULTS/BELL_edges.png --scans ."},
          {code(kDiffers, "an export differs from what its record describes"), code(kPartly, "some exports cannot be checked")}}},
        {cli::addAudit,
         {"audit",
          trust,
          {"edgescan-cli audit ~/.config/edgescan/audit.jsonl"},
          {code(kDiffers, "a line of the log was altered, dropped or moved")}}},
        {cli::addRecord, {"record", live, {"edgescan-cli record 192.168.0.1 -o SWEEP.mcap --lines 600 --axis sweep --line-step 0.3"}, {}}},
        {cli::addReplay, {"replay", live, {"edgescan-cli replay SWEEP.mcap --quiet"}, {}}},
    };
    return all;
}

/// Setting up all commands with their flags takes longer than many commands run. Therefore only the commands that the arguments can mean
/// are set up.
std::vector<Command> commandsFor(int argc, char** argv) {
    const std::vector<Command>& all = commands();
    const auto named = [&](const char* word) { return std::ranges::find(all, word, [](const Command& one) { return one.text.name; }); };
    if (argc == 2 && std::string_view(argv[1]) == "--version") return {};
    if (argc < 2 || named(argv[1]) == all.end()) return all;
    const bool another = std::any_of(argv + 2, argv + argc, [&](const char* word) { return named(word) != all.end(); });
    return another ? all : std::vector<Command>{*named(argv[1])};
}

/// The commands that went to edgescan-lab answer with those of the program in the same folder, and say so.
void runInLab(int argc, char** argv) {
    constexpr std::array<std::string_view, 3> kLab{"simulate", "emulate", "calibrate"};
    if (argc < 2 || std::ranges::find(kLab, argv[1]) == kLab.end()) return;
    std::error_code failed;
    std::string lab = (std::filesystem::read_symlink("/proc/self/exe", failed).parent_path() / "edgescan-lab").string();
    cli::printError(std::string(argv[1]) + " is a command of edgescan-lab now: type edgescan-lab " + argv[1] + ".");
    argv[0] = lab.data();
    execv(lab.c_str(), argv); // where it is missing, the command is unknown
}

} // namespace

int main(int argc, char** argv) {
    runInLab(argc, argv);
    CLI::App app{"EdgeScan: the edges of rocks in a laser range scan"};
    app.set_version_flag("--version", cli::versionText());
    app.require_subcommand(1);
    int code = cli::kDone;
    cli::surviveFileLimit();
    const BindInputs inputs; // no input file can be overwritten
    std::vector<cli::CommandText> texts;
    const std::vector<Command> typed = commandsFor(argc, argv);
    for (const Command& command : typed) {
        command.add(app, code);
        texts.push_back(command.text);
    }
    const auto addOthers = [&] {
        for (const Command& command : typed.size() == 1 ? commands() : std::vector<Command>()) {
            if (command.text.name != typed.front().text.name) command.add(app, code);
        }
    };
    cli::addPages(app, {"edgescan-cli",
                        "edges of rocks in laser range scans",
                        {"edgescan-lab simulate -o BELL.json --truth TRUTH --seed 7 --lines 300 --beams 381",
                         "edgescan-cli detect BELL.json", "edgescan-cli detect BELL.json -o RESULTS --jump 40",
                         "edgescan-cli convert BELL.json BELL.pcd", "edgescan-cli verify RESULTS/BELL_edges.png --scans ."},
                        {{"EXPORT.provenance.json", "record next to an export: what verify rebuilds it from"},
                         {"SCAN.u16", "the ranges of the raw grid SCAN.json"},
                         {"~/.config/edgescan/audit.jsonl", "the viewer's audit log, which audit checks"}},
                        texts});
    return cli::exitCodeOf([&] { return cli::parsed(app, argc, argv, addOthers).value_or(code); });
}
