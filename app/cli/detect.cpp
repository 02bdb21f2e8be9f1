// edgescan-cli detect: runs the method on files and writes the requested results.
#include "app/cli/commands.h"
#include "app/cli/export_flags.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/provenance.h"
#include "core/exports/report.h"
#include "core/scan/gap_filling/gap_filling.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <set>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

struct Detect {
    std::vector<std::string> files;
    std::string json;
    ExportPaths out;
    ReadFlags read;
    WriteFlags write;
    MethodFlags method;
};

// The output paths of one scan; an empty path of the JSON is not written.
struct Outputs {
    std::string json;
    std::vector<WantedExport> exports;

    [[nodiscard]] std::vector<std::string> paths() const {
        std::vector<std::string> all{json};
        for (const WantedExport& wanted : exports) all.push_back(wanted.path);
        return all;
    }
};

Outputs outputsOf(const Detect& detect, const Scan& scan) {
    const CoordinateFrame frame = exportOptions(detect.write, scan).frame;
    Outputs out{detect.json, wantedExports(detect.out, exports::ExportKind::Needs::Edges, scan.name, frame)};
    if (out.json.empty() && !detect.out.folder.empty()) out.json = (fs::path(detect.out.folder) / scan.name).string() + "_edges.json";
    return out;
}

// Returns what is said of the coordinates in the files.
Result<std::string> writeOutputs(const Detect& detect, const Outputs& out, const edges::Detection& detection, double loadMs) {
    const exports::ExportOptions options = exportOptions(detect.write, *detection.scan);
    WrittenOutputs outputs;
    for (const auto& [kind, path] : out.exports) // after a failure too
        outputs.add(path, exports::exportWithProvenance(kind->content, detection, path, options));
    if (!out.json.empty() && outputs.allWritten()) {
        const bool lines = detect.files.size() > 1 && out.json == "-";
        outputs.add(out.json, writeDocument(out.json, document("detect", exports::detectReport(detection, loadMs)), !lines));
    } else if (!out.json.empty()) {
        outputs.leftOut(out.json);
    }
    if (auto all = outputs.outcome(); !all) return all.error();
    return outputs.coordinates(detect.out.folder);
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
    warnOfIdleWriting(detect.write, *detection->scan);
    const Outputs out = outputsOf(detect, *detection->scan);
    if (auto distinct = checkDistinct(out.paths()); !distinct) return distinct;
    const auto coordinates = writeOutputs(detect, out, *detection, loadMs);
    if (!coordinates) return coordinates.error();
    const std::string places = detect.out.folder.empty() ? placesText(out.paths()) : printable(detect.out.folder);
    const std::string found = printable(file) + ": " + summary(*detection);
    if (places.empty())
        printResult(found);
    else if (writesFiles(out.paths()))
        printError(found + "; written to " + places + (detect.out.folder.empty() ? "" : ": " + namesText(out.paths(), detect.out.folder)) +
                   ".");
    if (!coordinates->empty()) printError(*coordinates);
    return Done{};
}

// True if one output path would get the results of several scans.
bool onePathForSeveral(const Detect& detect) {
    const bool onePath = !(detect.json.empty() || detect.json == "-") ||
                         std::ranges::any_of(detect.out.typed, [](const std::string& path) { return !path.empty(); });
    return detect.files.size() > 1 && onePath;
}

std::vector<std::string> typedOutputs(const Detect& detect) {
    std::vector<std::string> typed{detect.json};
    typed.insert(typed.end(), detect.out.typed.begin(), detect.out.typed.end());
    return typed;
}

// Wrong usage is reported before any file is read.
Result<Done> checkUsage(const Detect& detect) {
    if (onePathForSeveral(detect)) return Error{"one output file cannot hold the results of several scans", "", "use -o DIR"};
    if (auto one = checkOnePose(detect.files, detect.read); !one) return one;
    if (auto known = checkExtensions(detect.out); !known) return known;
    const auto wanted = wantedExports(detect.out, exports::ExportKind::Needs::Edges, "scan", CoordinateFrame::Mine);
    if (auto used = checkWriting(detect.write, wanted, detect.method); !used) return used;
    if (auto distinct = checkDistinct(typedOutputs(detect)); !distinct) return distinct;
    std::set<std::string> stems;
    for (const std::string& file : detect.files) {
        claimInput(file); // before the first scan writes results
        const std::string stem = files::scanName(file);
        if (stems.insert(stem).second || (detect.out.folder.empty() && file != "-")) continue;
        if (std::ranges::count(detect.files, file) > 1) return Error{"this scan is given twice", file, "give it once"};
        return Error{"two scans have the name " + stem + ", and so would their results", file, "give one folder each"};
    }
    return Done{};
}

int run(const Detect& detect) {
    const Result<Done> usage = checkUsage(detect);
    const Result<Done> method = checkMethodAndWarn(detect.method);
    if (!usage || !method) return failWith(usage ? method.error() : usage.error(), kWrongUsage);
    if (const auto made = makeFolder(detect.out.folder, "give -o a folder that can be written to"); !made) return failWith(made.error());
    if (const auto can = checkOutputs(typedOutputs(detect)); !can) return failWith(can.error());
    std::size_t done = 0, refused = 0;
    for (const std::string& file : detect.files) {
        const auto one = [&] {
            const Result<Done> result = detectOne(detect, file);
            if (result) return kDone;
            printError(result.error());
            if (detect.json == "-") printResult(refusal("detect", file, result.error()), detect.files.size() == 1);
            return kRefused;
        };
        ++(guarded(one, kRefused) == kDone ? done : refused);
    }
    return codeOf(done, refused);
}

} // namespace

void addDetect(CLI::App& app, int& code) {
    auto detect = std::make_shared<Detect>();
    CLI::App& command = *app.add_subcommand("detect", "Finds the edges of scans; without an output flag it prints their number");
    command.add_option("FILE", detect->files, "Scans; a scan that is refused does not stop the others")->required();
    const char* group = "Results";
    addJsonFlag(command, detect->json, "Counts, settings, hash of the mask, times; of several scans a line each").group(group);
    addExportFlags(command, exports::ExportKind::Needs::Edges, detect->out, group);
    addFolderFlag(command, detect->out, group);
    addMethodFlags(command, detect->method);
    addReadFlags(command, detect->read);
    addWriteFlags(command, detect->write);
    command.callback([detect, &code] { code = run(*detect); });
}

} // namespace edgescan::cli
