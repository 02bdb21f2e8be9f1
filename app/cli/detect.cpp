// edgescan-cli detect: runs the method on files and writes the requested results.
#include "app/cli/commands.h"
#include "app/shared/json_output.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/provenance/provenance.h"
#include "core/exports/provenance/report.h"
#include "core/files/formats/formats.h"
#include "core/files/point_tables/point_table.h"
#include "core/scan/georef/placed_points.h"

#include <array>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

struct Detect {
    std::vector<std::string> files;
    std::string json, mask, gray, range, edges, cloud, folder;
    bool ndjson = false;
    ReadFlags read;
    WriteFlags write;
    MethodFlags method;
};

// The output paths of one scan; an empty path is not written.
struct Outputs {
    std::string json, mask, gray, range, edges, cloud;

    [[nodiscard]] std::array<std::string, 6> paths() const { return {json, mask, gray, range, edges, cloud}; }
};

Outputs typedOutputs(const Detect& detect) { return {detect.json, detect.mask, detect.gray, detect.range, detect.edges, detect.cloud}; }

Outputs outputsOf(const Detect& detect, const Scan& scan) {
    Outputs out = typedOutputs(detect);
    if (detect.folder.empty()) return out;
    const std::string stem = (fs::path(detect.folder) / scan.name).string();
    const auto fill = [&](std::string& path, const std::string& tail) {
        if (path.empty()) path = stem + tail;
    };
    fill(out.json, "_edges.json");
    fill(out.mask, "_edges.png");
    fill(out.gray, "_gray.png");
    fill(out.range, "_range.png");
    const CoordinateFrame frame = exportOptions(detect.write, usualFrame(scan)).frame;
    fill(out.edges, std::string("_edges") + frameTail(frame) + ".pcd");
    fill(out.cloud, std::string("_cloud") + frameTail(frame) + ".pcd");
    return out;
}

Result<Done> writeOutputs(const Detect& detect, const Outputs& out, const edges::Detection& detection, double loadMs) {
    const exports::ExportOptions options = exportOptions(detect.write, usualFrame(*detection.scan));
    const std::vector<std::pair<exports::ExportContent, std::string>> exports{{exports::ExportContent::EdgeImage, out.mask},
                                                                              {exports::ExportContent::GrayImage, out.gray},
                                                                              {exports::ExportContent::RangeImage, out.range},
                                                                              {exports::ExportContent::EdgeCloud, out.edges},
                                                                              {exports::ExportContent::FullCloud, out.cloud}};
    std::optional<Error> failure; // the other exports are still written
    for (const auto& [content, path] : exports) {
        if (path.empty()) continue;
        const auto written = exports::exportWithProvenance(content, detection, path, options);
        if (!written && !failure) failure = written.error();
    }
    if (failure) return *failure;
    if (out.json.empty()) return Done{};
    const bool lines = detect.ndjson || (detect.files.size() > 1 && out.json == "-");
    return writeDocument(out.json, document("detect", exports::detectReport(detection, loadMs)), !lines);
}

/// The folder or the files that were written; empty if no file was written.
std::string placesWrittenTo(const Detect& detect, const Outputs& out) {
    if (!detect.folder.empty()) return printable(detect.folder);
    std::string places;
    for (const std::string& path : out.paths()) {
        if (!path.empty()) places += (places.empty() ? "" : ", ") + (isStreamOrDevice(path) ? "standard output" : printable(path));
    }
    return places;
}

std::string filledText(const edges::Detection& detection) {
    if (!detection.filled) return {};
    return ", " + std::to_string(detection.filled->cells.size()) + " cells filled in " + std::to_string(detection.filled->gaps) + " gaps";
}

std::string summary(const edges::Detection& detection) {
    const Scan& scan = *detection.scan;
    return std::to_string(detection.edges->size()) + " edge cells of " + std::to_string(scan.cells()) + " (" +
           std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) + " beams)" + filledText(detection) + ", " +
           fixedText(detection.totalMs, 1) + " ms";
}

Result<Done> detectOne(const Detect& detect, const std::string& file) {
    const auto start = std::chrono::steady_clock::now();
    Result<Scan> opened = openAndWarn(file, detect.read);
    if (!opened) return opened.error();
    const double loadMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (auto enough = edges::checkMemoryFor(edges::Work::Detect, *opened); !enough) return enough.error();
    const Result<edges::Settings> settings = settingsFor(detect.method, *opened);
    if (!settings) return settings.error();
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings);
    const Outputs out = outputsOf(detect, *detection->scan);
    if (auto distinct = checkDistinct(out.paths()); !distinct) return distinct;
    if (auto written = writeOutputs(detect, out, *detection, loadMs); !written) return written;
    const std::string places = placesWrittenTo(detect, out);
    const std::string found = printable(file) + ": " + summary(*detection);
    if (places.empty())
        printResult(found);
    else
        reportWritten(found + "; written to " + places + ".", detect.read);
    return Done{};
}

// True if one output path would get the results of several scans.
bool onePathForSeveral(const Detect& detect) {
    const bool onePath = !(detect.json.empty() || detect.json == "-") || !detect.mask.empty() || !detect.gray.empty() ||
                         !detect.range.empty() || !detect.edges.empty() || !detect.cloud.empty();
    return detect.files.size() > 1 && onePath;
}

// Wrong usage is reported before any file is read.
Result<Done> checkUsage(const Detect& detect) {
    if (onePathForSeveral(detect)) return Error{"one output file cannot hold the results of several scans", "", "use -o DIR"};
    for (const std::string& path : {detect.edges, detect.cloud}) {
        if (const files::Format* format = files::writtenFormat(path); !path.empty() && (format == nullptr || format->write == nullptr))
            return Error{"the extension names no format for points", path, "use " + files::writtenExtensions(false)};
    }
    if (auto distinct = checkDistinct(typedOutputs(detect).paths()); !distinct) return distinct;
    std::set<std::string> stems;
    for (const std::string& file : detect.files) {
        claimInput(file); // before the first scan writes results
        const std::string stem = files::scanName(file);
        if (detect.folder.empty() || stems.insert(stem).second) continue;
        return Error{"two scans have the name " + stem + ", and so would their results", file, "give one folder each"};
    }
    return Done{};
}

int run(const Detect& detect) {
    const Result<Done> usage = checkUsage(detect);
    const Result<Done> method = checkMethod(detect.method);
    if (!usage || !method) {
        printError(usage ? method.error() : usage.error());
        return kWrongUsage;
    }
    if (!detect.folder.empty()) {
        std::error_code failed;
        fs::create_directories(detect.folder, failed);
        if (failed) {
            printError({"the folder cannot be made (" + failed.message() + ")", detect.folder, "give -o a folder that can be written to"});
            return kRefused;
        }
    }
    int code = kDone;
    for (const std::string& file : detect.files) {
        const auto one = [&] {
            const Result<Done> result = detectOne(detect, file);
            if (result) return kDone;
            printError(result.error());
            if (detect.json == "-") printResult(refusal("detect", file, result.error()), detect.files.size() == 1 && !detect.ndjson);
            return kRefused;
        };
        if (guarded(one, kRefused) != kDone) code = kRefused;
    }
    return code;
}

} // namespace

void addDetect(CLI::App& app, int& code) {
    auto detect = std::make_shared<Detect>();
    CLI::App& command = *app.add_subcommand("detect", "Finds the edges and writes what is asked for");
    command.add_option("FILE", detect->files, "Scans; after a bad one the others are still done")->required();
    const char* group = "Results";
    command.add_option("--json", detect->json, "Counts, settings, mask hash, times; - is stdout")->group(group);
    command.add_flag("--ndjson", detect->ndjson, "JSON on one line per scan; without --json on stdout")->group(group);
    command.add_option("--mask", detect->mask, "Edge map, 8-bit PNG, 255 = edge, row = line, column = beam")->group(group);
    command.add_option("--gray", detect->gray, "Gray image, 8-bit PNG")->group(group);
    command.add_option("--range", detect->range, "Ranges in mm, 16-bit PNG")->group(group);
    command.add_option("--edges", detect->edges, "Edge points in metres: " + files::writtenExtensions(false))->group(group);
    command.add_option("--cloud", detect->cloud, "All points in metres with a field for edges: the same formats")->group(group);
    command.add_option("-o,--output", detect->folder, "Folder for all of these, under the scan's name")->group(group);
    addMethodFlags(command, detect->method);
    addReadFlags(command, detect->read);
    addWriteFlags(command, detect->write);
    command.callback([detect, &code] {
        if (detect->ndjson && detect->json.empty() && detect->folder.empty()) detect->json = "-";
        code = run(*detect);
    });
}

} // namespace edgescan::cli
