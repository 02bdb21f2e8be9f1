// edgescan-cli compare: every method of the thesis, every PCL peer and EdgeScan+ on one scan in one run.
#include "app/cli/commands.h"
#include "app/cli/compare_two.h"
#include "app/shared/json_output.h"
#include "app/shared/options.h"
#include "core/base/number_text.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/lab/reports/comparison_pictures.h"
#include "core/lab/reports/comparison_report.h"
#include "core/lab/score/truth_fit.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

#include <unistd.h>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

struct CompareFlags {
    std::vector<std::string> files, poses;
    std::string truth, json, pictures;
    double matchRadiusM = 0.1;
    bool refine = false;
    lab::ComparisonSettings settings;
    bool slow = false, noPeers = false;
    ReadFlags read;
};

// "BoundaryEstimation k=30" -> "boundaryestimation-k-30".
std::string fileName(const std::string& name) {
    std::string result;
    for (const char c : asciiLower(name)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+';
        if (plain)
            result += c;
        else if (!result.empty() && result.back() != '-')
            result += '-';
    }
    while (!result.empty() && result.back() == '-') result.pop_back();
    return result;
}

Result<Done> savePictures(const CompareFlags& flags, const Scan& scan, const std::vector<lab::ComparedMethod>& methods,
                          const std::optional<lab::TruthSet>& truth) {
    const fs::path folder = flags.pictures;
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return Error{"the folder cannot be made (" + failed.message() + ")", flags.pictures, "give one that can be written to"};
    for (const lab::ComparedMethod& method : methods) {
        if (method.edges == 0 && !method.note.empty()) continue;
        if (const Result<Done> saved = containers::savePng8(method.mask, folder / (fileName(method.key) + ".png")); !saved)
            return saved.error();
    }
    if (truth) {
        const Grid<Rgb> sheet = lab::truthSheet(scan, methods, truth->edges, flags.settings.tolerance);
        if (const Result<Done> saved = sheet.size() > 0 ? containers::savePngRgb(sheet, folder / "truth.png") : Done{}; !saved)
            return saved.error();
    }
    return containers::savePngRgb(lab::edgesSheet(scan, methods), folder / "comparison.png");
}

// Flags that would change nothing, or make every score 0.
std::optional<Error> wrongUsage(const CompareFlags& flags) {
    const bool two = flags.files.size() == 2;
    if (two && (!flags.truth.empty() || !flags.pictures.empty()))
        return Error{"two scans are compared with each other", flags.truth.empty() ? "--pictures" : "--truth", "give one scan for that"};
    if (!two && (!flags.poses.empty() || flags.refine))
        return Error{"one scan needs no pose", flags.poses.empty() ? "--refine" : "--poses", "give two scans of one place"};
    if (flags.settings.bestThreshold && flags.truth.empty())
        return Error{"without truth no threshold is the best", "--best", "give --truth DIR too"};
    return std::nullopt;
}

// The first key of --only that no method has.
std::optional<Error> unknownKey(const std::vector<std::string>& only) {
    const std::vector<std::string> known = lab::comparedKeys();
    for (const std::string& key : only) {
        if (std::ranges::find(known, key) != known.end()) continue;
        std::string names;
        for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
        return Error{"no method is called \"" + key + "\"", "--only", "use " + names};
    }
    return std::nullopt;
}

Result<Done> compare(const CompareFlags& flags) {
    lab::ComparisonSettings settings = flags.settings;
    settings.withPcl = !flags.noPeers && flags.settings.only.empty();
    if (flags.slow) settings.pclLimits.seconds = std::numeric_limits<double>::infinity();
    const bool tell = flags.read.progress || isatty(STDERR_FILENO) != 0;
    const auto progress = [&](const char* name, double fraction) {
        if (tell) showProgress(rightAligned(fixedText(100 * fraction, 0), 3) + " % " + name, fraction >= 1.0);
        return true;
    };
    if (flags.files.size() == 2) {
        settings.repeats = 1;
        return compareTwo({flags.files, flags.poses, flags.json, flags.refine, flags.matchRadiusM, settings, flags.read}, progress);
    }
    Result<Scan> opened = openAndWarn(flags.files.front(), flags.read);
    if (!opened) return opened.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *opened); !enough) return enough.error();
    const auto scan = std::make_shared<const Scan>(std::move(*opened));
    std::optional<lab::TruthSet> truth;
    if (!flags.truth.empty()) {
        Result<lab::TruthSet> read = lab::readTruth(flags.truth);
        if (!read) return read.error();
        if (read->edges.edgeClass.lines != scan->lines() || read->edges.edgeClass.beams != scan->beams())
            return Error{"the truth is not of this scan's shape", flags.truth, "give the folder that was written with the scan"};
        if (auto fits = lab::checkTruthFits(*scan, *read, flags.truth); !fits) return fits.error();
        truth = std::move(*read);
    }
    const std::vector<lab::ComparedMethod> methods = lab::compareMethods(scan, truth ? &*truth : nullptr, settings, progress);
    if (tell) showProgress("all compared", true);
    if (!flags.pictures.empty()) {
        const Result<Done> saved = savePictures(flags, *scan, methods, truth);
        if (!saved) return saved.error();
    }
    if (flags.json != "-") printResult(lab::comparisonText(*scan, methods));
    if (flags.json.empty()) return Done{};
    return writeDocument(flags.json, document("compare", lab::comparisonReport(*scan, methods, settings)));
}

} // namespace

void addCompare(CLI::App& app, int& code) {
    auto flags = std::make_shared<CompareFlags>();
    CLI::App& command = *app.add_subcommand("compare", "Every method of the thesis, the PCL peers and EdgeScan+ on one scan, in one run");
    command.add_option("FILE", flags->files, "Scan; or two scans of one place: how many edges of each the other has too")
        ->required()
        ->expected(1, 2);
    command
        .add_option("--poses", flags->poses,
                    "Of two scans: their .pose files of 3DTK, in the same order; else both need a place in the mine")
        ->expected(2);
    command.add_flag("--refine", flags->refine,
                     "Of two scans: bring their surfaces onto each other first, and tell how far they lie apart");
    addNumber(command, "--match-radius", flags->matchRadiusM, {0.001, 10}, "Of two scans: how near the other one's edge must lie [m]");
    command.add_option("--truth", flags->truth, "Folder with ground truth of simulate --truth: also scores");
    command.add_option("--json", flags->json, "All figures; - is stdout, instead of the tables");
    command.add_option("--pictures", flags->pictures,
                       "Folder for a labelled sheet (comparison.png), with truth one of cells found, missed and false (truth.png), and one "
                       "mask per method");
    addNumber(command, "--tolerance", flags->settings.tolerance, {0, 20}, "How far a detection may lie from a true edge [cells]");
    command.add_flag("--best", flags->settings.bestThreshold, "With truth: also each method's score at its best threshold for this scan");
    addNumber(command, "--repeats", flags->settings.repeats, {1, 1000},
              "Runs of each of our methods, interleaved; medians of thread CPU time are told");
    addNumber(command, "--radius", flags->settings.pclLimits.radiusM, {0.001, 10}, "Radius of PCL's BoundaryEstimation [m]");
    addNumber(command, "--peer-seconds", flags->settings.pclLimits.seconds, {0, 1e6},
              "A PCL peer that works point by point stops after this time [s]");
    command.add_flag("--slow", flags->slow, "Let every PCL peer end, however long it takes");
    command.add_option("--only", flags->settings.only, "Only these of our methods, and no peers: thesis,edgescan+")->delimiter(',');
    command.add_flag("--no-peers", flags->noPeers, "Leave the PCL peers out");
    addReadFlags(command, flags->read);
    command.callback([flags, &code] {
        const std::optional<Error> unknown = unknownKey(flags->settings.only);
        if (const std::optional<Error> wrong = unknown ? unknown : wrongUsage(*flags)) {
            printError(*wrong);
            code = kWrongUsage;
            return;
        }
        const Result<Done> result = compare(*flags);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
