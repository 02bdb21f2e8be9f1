// edgescan-lab calibrate: estimates the mounting errors of the scanner from a sweep of more than 180 degrees.
#include "app/lab/calibration/backlash.h"
#include "app/lab/calibration/calibration_file.h"
#include "app/lab/calibration/seam_edges.h"
#include "app/lab/calibration/views_picture.h"
#include "app/lab/commands/commands.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"

#include <array>
#include <filesystem>
#include <memory>

namespace edgescan::cli {
namespace {

struct Calibrate {
    std::vector<std::string> files;
    std::string out, base, picture, seam, json;
    bool backlash = false;
    ReadFlags read;
};

std::string errorLine(const char* name, double value, double sd, const char* unit, int digits) {
    return std::string(name) + rightAligned(fixedText(value, digits), 10) + " +- " + fixedText(2 * sd, digits) + " " + unit + "\n";
}

std::string tableOf(const inspect::SelfCalibration& found) {
    const AssemblyErrors& e = found.errors;
    const AssemblyErrors& sd = found.sd;
    return "error of the mounting, +- 2 standard deviations\n" + errorLine("  lever arm t1  ", e.t1Mm(), sd.t1Mm(), "mm", 2) +
           errorLine("  lever arm t2  ", e.t2Mm(), sd.t2Mm(), "mm", 2) +
           errorLine("  tilt of fan   ", e.tiltDeg(), sd.tiltDeg(), "degrees", 4) +
           errorLine("  beam index    ", e.indexDeg(), sd.indexDeg(), "degrees", 4) +
           (found.turnIsEstimated ? errorLine("  turn at 180   ", e.turnDeg(), sd.turnDeg(), "degrees", 4)
                                  : "  turn at 180     a sweep mounting does not show it; the step stays as it is\n") +
           "mismatch of the two views: " + fixedText(found.medianBeforeMm, 1) + " mm before, " + fixedText(found.medianAfterMm, 1) +
           " mm with these errors (median of " + std::to_string(found.cells) + " cells; noise alone explains " +
           fixedText(found.noiseMm, 1) + " mm)\n";
}

/// Writes the picture of the seam, and the number of matching edges into `report`.
Result<Done> drawSeam(const std::shared_ptr<const Scan>& scan, const inspect::SelfCalibration& found, const std::string& path,
                      nlohmann::ordered_json& report) {
    if (auto enough = edges::checkMemoryFor(edges::Work::Detect, *scan); !enough) return enough;
    const auto detection = edges::detectEdges(scan, edges::Settings{});
    const inspect::SeamEdges before = inspect::seamEdges(*scan, *detection->mask, {});
    const inspect::SeamEdges after = inspect::seamEdges(*scan, *detection->mask, found.errors);
    report["seam_edges"] = after.lateEdges;
    report["seam_edges_met_before"] = rounded(before.matchedShare(), 1e4);
    report["seam_edges_met_after"] = rounded(after.matchedShare(), 1e4);
    return containers::savePngRgb(inspect::oneOverTheOther(inspect::seamPicture(before), inspect::seamPicture(after)), path);
}

std::string seamLine(const nlohmann::ordered_json& report) {
    if (!report.contains("seam_edges")) return {};
    const auto percent = [&](const char* key) { return fixedText(100 * report[key].get<double>(), 0); };
    return "of " + std::to_string(report["seam_edges"].get<std::size_t>()) + " edge cells of the late view " +
           percent("seam_edges_met_before") + " % lay within a cell of one of the early view, and " + percent("seam_edges_met_after") +
           " % do with these errors\n";
}

Result<Done> reportBacklash(const Calibrate& asked, const std::vector<std::shared_ptr<const Scan>>& scans,
                            const std::vector<inspect::CalibrationSource>& sources) {
    const Result<inspect::Backlash> found = inspect::backlashOf(*scans[0], *scans[1]);
    if (!found) return Error{found.error().what, asked.files[1], found.error().hint};
    if (asked.json.empty()) {
        printResult("backlash: line angles of the second pass are" + rightAligned(fixedText(found->deg, 4), 8) + " +- " +
                    fixedText(2 * found->sdDeg, 4) + " degrees ahead of those of the first (2 standard deviations); " + "mismatch " +
                    fixedText(found->apartBeforeMm, 1) + " mm before, " + fixedText(found->apartAfterMm, 1) + " mm without it (median of " +
                    std::to_string(found->cells) + " cells)\nNothing is applied automatically.\n");
        return Done{};
    }
    nlohmann::ordered_json report{{"there", {{"name", sources[0].name}, {"sha256", sources[0].sha256}}},
                                  {"back", {{"name", sources[1].name}, {"sha256", sources[1].sha256}}},
                                  {"backlash_deg", found->deg},
                                  {"one_sd_deg", found->sdDeg},
                                  {"cells", found->cells},
                                  {"apart_before_mm", found->apartBeforeMm},
                                  {"apart_after_mm", found->apartAfterMm}};
    return writeDocument(asked.json, document("backlash", report));
}

Result<Done> checkTogether(const Calibrate& asked) {
    if (asked.backlash && asked.files.size() != 2)
        return Error{"backlash needs two passes, " + std::to_string(asked.files.size()) + " given", "--backlash",
                     "give the pass there, then the pass back"};
    if (asked.backlash && !(asked.out.empty() && asked.base.empty() && asked.picture.empty() && asked.seam.empty()))
        return Error{"the backlash is reported only; a calibration file does not hold it", "--backlash",
                     "leave -o, --base, --picture and --seam out; --json writes it"};
    if (auto one = checkOnePose(asked.files, asked.read); !one) return one;
    if (!asked.backlash && asked.out.empty()) return Error{"no name for the calibration file", "-o", "give -o CALIBRATION.json"};
    return checkDistinct(std::array{asked.out, asked.picture, asked.seam, asked.json});
}

struct Opened {
    std::vector<std::shared_ptr<const Scan>> scans;
    std::vector<inspect::CalibrationSource> sources;
};

Result<Opened> openedScans(const Calibrate& asked) {
    Opened opened;
    for (const std::string& file : asked.files) {
        Result<Scan> scan = openAndWarn(file, asked.read);
        if (!scan) return scan.error();
        const Result<std::string> hash = sha256OfFile(file);
        if (!hash) return hash.error();
        opened.sources.push_back({std::filesystem::path(file).filename().string(), *hash});
        scan->name = file;
        opened.scans.push_back(std::make_shared<const Scan>(std::move(*scan)));
    }
    return opened;
}

Result<Done> calibrate(const Calibrate& asked) {
    for (const std::string& file : asked.files) claimInput(file);
    if (auto can = checkOutputs(std::array{asked.out, asked.picture, asked.seam, asked.json}); !can) return can;
    const Result<Opened> opened = openedScans(asked);
    if (!opened) return opened.error();
    const auto& [scans, sources] = *opened;
    if (asked.backlash) return reportBacklash(asked, scans, sources);
    std::string base;
    if (!asked.base.empty()) {
        const auto bytes = readInput(asked.base);
        if (!bytes) return bytes.error();
        base = textOf(*bytes);
    }
    const Result<inspect::SelfCalibration> found = inspect::calibrateFromSweeps(scans);
    if (!found) return found.error();
    const Result<std::string> text = inspect::calibrationText(base, asked.base, *found, sources);
    if (!text) return text.error();
    if (Result<Done> written = writeWholeFile(asked.out, *text); !written) return written;
    if (!asked.picture.empty()) {
        if (Result<Done> saved = containers::savePngRgb(
                inspect::oneOverTheOther(inspect::viewsPicture(*scans.front(), {}), inspect::viewsPicture(*scans.front(), found->errors)),
                asked.picture);
            !saved)
            return saved;
    }
    nlohmann::ordered_json report = inspect::estimateJson(*found, sources);
    if (!asked.seam.empty()) {
        if (Result<Done> drawn = drawSeam(scans.front(), *found, asked.seam, report); !drawn) return drawn;
    }
    if (!asked.json.empty()) return writeDocument(asked.json, document("calibrate", report));
    if (!isStandardOutput(asked.out))
        printResult(tableOf(*found) + seamLine(report) + "Nothing is applied automatically: give the file with --calibration.\n");
    return Done{};
}

} // namespace

void addCalibrate(CLI::App& app, int& code) {
    auto asked = std::make_shared<Calibrate>();
    CLI::App& command = *app.add_subcommand(
        "calibrate", "Estimates mounting errors of the scanner from surfaces that a turn of more than 180 degrees measures twice");
    command
        .add_option("SCAN", asked->files, "Scans of one mounting: spin mounting, 200 to 360 degrees of turn; sweep mounting, 300 to 360")
        ->required();
    command.add_option("-o,--output", asked->out, "New calibration file; - is standard output")
        ->type_name("FILE")
        ->check(namedAs("JSON", ".json"));
    command.add_flag("--backlash", asked->backlash,
                     "Of two passes over the same lines, there and back: report how far the stepper lags when it turns the other way");
    command.add_option("--base", asked->base, "The present calibration file of the robot: only its stepper is replaced")->type_name("FILE");
    command.add_option("--picture", asked->picture, "New PNG: the distance of the two views, before and after")
        ->type_name("FILE")
        ->check(namedAs("a picture", ".png"));
    command.add_option("--seam", asked->seam, "New PNG: the edges of both views in one picture, before and after")
        ->type_name("FILE")
        ->check(namedAs("a picture", ".png"));
    addJsonFlag(command, asked->json, "All figures, instead of the table", {"calibrate", "backlash"});
    addReadFlags(command, asked->read);
    command.callback([asked, &code] {
        const Result<Done> together = checkTogether(*asked);
        const Result<Done> result = together ? calibrate(*asked) : together;
        code = result ? kDone : together ? kRefused : kWrongUsage;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
