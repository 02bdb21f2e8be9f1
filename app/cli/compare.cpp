// edgescan-cli compare: every method of the thesis, every PCL peer and EdgeScan+ on one scan in one run.
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "core/base/whole_file.h"
#include "core/eval/truth_fit.h"
#include "core/pictures/png.h"
#include "core/report/comparison_pictures.h"
#include "core/report/comparison_report.h"
#include "core/report/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>

#include <unistd.h>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

struct CompareFlags {
    std::string file, truth, json, pictures;
    ComparisonSettings settings;
    bool slow = false, noPeers = false;
    ReadFlags read;
};

// "BoundaryEstimation k=30" -> "boundaryestimation-k-30".
std::string fileName(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+';
        if (plain)
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!result.empty() && result.back() != '-')
            result += '-';
    }
    while (!result.empty() && result.back() == '-') result.pop_back();
    return result;
}

Result<Done> savePictures(const CompareFlags& flags, const Scan& scan, const std::vector<ComparedMethod>& methods,
                          const std::optional<TruthSet>& truth) {
    const fs::path folder = flags.pictures;
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return Error{"the folder cannot be made (" + failed.message() + ")", flags.pictures, "give one that can be written to"};
    for (const ComparedMethod& method : methods) {
        if (method.edges == 0 && !method.note.empty()) continue;
        if (const Result<Done> saved = savePng8(method.mask, folder / (fileName(method.key) + ".png")); !saved) return saved.error();
    }
    if (truth) {
        const Grid<Rgb> sheet = truthSheet(scan, methods, truth->edges, flags.settings.tolerance);
        if (const Result<Done> saved = sheet.size() > 0 ? savePngRgb(sheet, folder / "truth.png") : Done{}; !saved) return saved.error();
    }
    return savePngRgb(edgesSheet(scan, methods), folder / "comparison.png");
}

// Flags that would change nothing, or make every score 0.
std::optional<Error> wrongUsage(const CompareFlags& flags) {
    if (std::isnan(flags.settings.tolerance)) return Error{"the tolerance is no number", "--tolerance", "give 0 to 20 cells"};
    if (flags.settings.bestThreshold && flags.truth.empty())
        return Error{"without truth no threshold is the best", "--best", "give --truth DIR too"};
    return std::nullopt;
}

// The first key of --only that no method has.
std::optional<Error> unknownKey(const std::vector<std::string>& only) {
    const std::vector<std::string> known = comparedKeys();
    for (const std::string& key : only) {
        if (std::ranges::find(known, key) != known.end()) continue;
        std::string names;
        for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
        return Error{"no method is called \"" + key + "\"", "--only", "use " + names};
    }
    return std::nullopt;
}

Result<Done> compare(const CompareFlags& flags) {
    Result<Scan> opened = openAsAsked(flags.file, readingOptions(flags.read));
    if (!opened) return opened.error();
    const auto scan = std::make_shared<const Scan>(std::move(*opened));
    std::optional<TruthSet> truth;
    if (!flags.truth.empty()) {
        Result<TruthSet> read = readTruth(flags.truth);
        if (!read) return read.error();
        if (read->edges.edgeClass.lines != scan->lines() || read->edges.edgeClass.beams != scan->beams())
            return Error{"the truth is not of this scan's shape", flags.truth, "give the folder that was written with the scan"};
        if (auto fits = checkTruthFits(*scan, *read, flags.truth); !fits) return fits.error();
        truth = std::move(*read);
    }
    ComparisonSettings settings = flags.settings;
    settings.peers = !flags.noPeers && flags.settings.only.empty();
    if (flags.slow) settings.peerLimits.seconds = std::numeric_limits<double>::infinity();
    const bool tell = flags.read.progress || isatty(STDERR_FILENO) != 0;
    const auto progress = [&](const char* name, double fraction) {
        if (tell) std::fprintf(stderr, "\r%3.0f %% %-40s", 100 * fraction, name);
        return true;
    };
    const std::vector<ComparedMethod> methods = compareMethods(scan, truth ? &*truth : nullptr, settings, progress);
    if (tell) std::fprintf(stderr, "\r%-48s\r", "");
    if (!flags.pictures.empty()) {
        const Result<Done> saved = savePictures(flags, *scan, methods, truth);
        if (!saved) return saved.error();
    }
    if (flags.json != "-") std::cout << comparisonText(*scan, methods);
    if (flags.json.empty()) return Done{};
    const std::string json = reportText(comparisonReport(*scan, methods, settings), true) + "\n";
    if (flags.json != "-") return writeWholeFile(flags.json, json);
    std::cout << json;
    return Done{};
}

} // namespace

void addCompare(CLI::App& app, int& code) {
    auto flags = std::make_shared<CompareFlags>();
    CLI::App& command = *app.add_subcommand("compare", "Every method of the thesis, the PCL peers and EdgeScan+ on one scan, in one run");
    command.add_option("FILE", flags->file, "Scan")->required();
    command.add_option("--truth", flags->truth, "Folder with ground truth of simulate --truth: also scores");
    command.add_option("--json", flags->json, "All figures; - is stdout, instead of the tables");
    command.add_option("--pictures", flags->pictures,
                       "Folder for a labelled sheet (comparison.png), with truth one of cells found, missed and false (truth.png), and one "
                       "mask per method");
    command.add_option("--tolerance", flags->settings.tolerance, "How far a detection may lie from a true edge [cells]")
        ->check(CLI::Range(0.0, 20.0))
        ->capture_default_str();
    command.add_flag("--best", flags->settings.bestThreshold, "With truth: also each method's score at its best threshold for this scan");
    command
        .add_option("--repeats", flags->settings.repeats, "Runs of each of our methods, interleaved; medians of thread CPU time are told")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--radius", flags->settings.peerLimits.radiusM, "Radius of PCL's BoundaryEstimation [m]")
        ->check(CLI::Range(0.001, 10.0))
        ->capture_default_str();
    command
        .add_option("--peer-seconds", flags->settings.peerLimits.seconds, "A PCL peer that works point by point stops after this time [s]")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command.add_flag("--slow", flags->slow, "Let every PCL peer end, however long it takes");
    command.add_option("--only", flags->settings.only, "Only these of our methods, and no peers: thesis,edgescan+")->delimiter(',');
    command.add_flag("--no-peers", flags->noPeers, "Leave the PCL peers out");
    addReadFlags(command, flags->read);
    command.callback([flags, &code] {
        const std::optional<Error> unknown = unknownKey(flags->settings.only);
        if (const std::optional<Error> wrong = unknown ? unknown : wrongUsage(*flags)) {
            complain(*wrong);
            code = kWrongUsage;
            return;
        }
        const Result<Done> result = compare(*flags);
        code = result ? kDone : kRefused;
        if (!result) complain(result.error());
    });
}

} // namespace edgescan::cli
