// edgescan-cli rocks: turns the edges of a scan into one label per rock, with a description of each rock.
#include "app/cli/commands.h"
#include "app/cli/rock_flags.h"
#include "app/shared/json_output.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/provenance/provenance.h"
#include "core/exports/provenance/rock_files.h"
#include "core/exports/provenance/rock_report.h"
#include "core/files/formats/formats.h"
#include "core/rocks/attributes/size_curve.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/georef/placed_points.h"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

// One flag per row: the path of a result, and its name inside an output folder.
struct RockOutput {
    const char* flag;
    exports::ExportContent content;
    const char* tail;
    const char* formats; ///< of outlines and hulls: extensions, separated by commas; null: any format
    const char* help;
};
constexpr RockOutput kRockOutputs[]{
    {"--labels", exports::ExportContent::RockLabels, "_rocks.png", nullptr,
     "16-bit PNG: 0 none, then 1..n, the largest visible area first"},
    {"--json", exports::ExportContent::RockReport, "_rocks.json", nullptr, "All rocks with what may be said of them; - is stdout"},
    {"--csv", exports::ExportContent::RockTable, "_rocks.csv", nullptr, "One row per rock, units in the names"},
    {"--cloud", exports::ExportContent::RockCloud, "_rocks.pcd", nullptr, "All points in metres with a field for rocks"},
    {"--outlines", exports::ExportContent::RockOutlines, "_rocks.dxf", ".dxf,.geojson",
     "Closed polylines in space (.dxf), or polygons in the picture (.geojson)"},
    {"--hulls", exports::ExportContent::RockHulls, "_hulls.ply", ".ply,.obj",
     "Convex hulls of the visible points, never a volume: .ply or .obj"},
};
constexpr std::size_t kOutputs = std::size(kRockOutputs);
constexpr std::size_t placeOf(exports::ExportContent content) {
    for (std::size_t n = 0; n < kOutputs; ++n) {
        if (kRockOutputs[n].content == content) return n;
    }
    return kOutputs;
}
constexpr std::size_t kReport = placeOf(exports::ExportContent::RockReport);
constexpr std::size_t kOutlines = placeOf(exports::ExportContent::RockOutlines);

struct RocksFlags {
    std::string file, folder, writeEdits;
    std::array<std::string, kOutputs> paths;
    std::vector<std::string> why, split;
    RockFlags rocks;
    ReadFlags read;
    WriteFlags write;
    MethodFlags method;
};

struct WantedFile {
    const RockOutput* output;
    std::string path;
};

std::vector<WantedFile> wantedFiles(const RocksFlags& flags, const Scan& scan) {
    std::vector<WantedFile> files;
    const CoordinateFrame frame = exportOptions(flags.write, usualFrame(scan)).frame;
    for (std::size_t n = 0; n < kOutputs; ++n) {
        const RockOutput& output = kRockOutputs[n];
        std::string path = flags.paths[n];
        if (path.empty() && !flags.folder.empty()) {
            const fs::path tail = output.tail;
            path = (fs::path(flags.folder) / scan.name).string() + tail.stem().string() +
                   (exports::namesFrame(output.content, tail) ? frameTail(frame) : "") + tail.extension().string();
        }
        if (!path.empty()) files.push_back({&output, path});
    }
    if (!flags.folder.empty() && flags.paths[kOutlines].empty()) // they are also drawn in the picture
        files.push_back({&kRockOutputs[kOutlines], (fs::path(flags.folder) / scan.name).string() + "_rocks.geojson"});
    return files;
}

// "LINE,BEAM" as a cell of the scan.
Result<std::uint32_t> cellOf(const std::string& text, const Scan& scan, const char* flag) {
    const auto corner = rocks::parseRegion(text + " " + text);
    if (!corner || corner->size() != 2 || !scan.rangeMm.contains(corner->front().line, corner->front().beam))
        return Error{"\"" + text + "\" is no cell of the scan", flag,
                     "give LINE,BEAM with lines from 0 to " + std::to_string(scan.lines() - 1) + " and beams from 0 to " +
                         std::to_string(scan.beams() - 1)};
    return static_cast<std::uint32_t>(scan.rangeMm.index(corner->front().line, corner->front().beam));
}

// Splits at these cells, one after the other, like clicks in the viewer.
Result<Done> split(const RocksFlags& flags, const rocks::Inputs& inputs, rocks::Study& study) {
    for (const std::string& text : flags.split) {
        const auto cell = cellOf(text, *inputs.scan, "--split");
        if (!cell) return cell.error();
        const auto edit = rocks::splitAt(*study.segmentation, *study.tree, study.settings.level, *cell);
        if (!edit)
            return Error{"there is nothing to split at " + text, "--split",
                         "choose a cell of a rock that is made of several pieces, or a lower --level"};
        std::vector<rocks::Edit> edits = study.edits;
        edits.push_back(*edit);
        study = rocks::studyRocks(inputs, study.settings, edits, &study);
    }
    return Done{};
}

std::string summary(const rocks::Study& study, const std::string& file) {
    const rocks::SizeCurve curve = rocks::sizeCurve(study.rocks, study.settings.oversizeM);
    const rocks::RegionCounts fines = rocks::regionCounts(study.map, rocks::RegionKind::Fines);
    std::string text = printable(file) + ": " + std::to_string(study.rocks.size()) + " rocks (" + rocks::kRockCaveat + ")";
    if (curve.rocks() > 0)
        text += ", visible width P20 " + fixedText(curve.p20M, 2) + " P50 " + fixedText(curve.p50M, 2) + " P80 " +
                fixedText(curve.p80M, 2) + " largest " + fixedText(curve.topM, 2) + " m";
    return text + ", " + std::to_string(fines.regions) + " pieces of fines";
}

Result<Done> answerWhy(const RocksFlags& flags, const rocks::Study& study) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const auto one = cellOf(flags.why[0], scan, "--why");
    const auto other = cellOf(flags.why[1], scan, "--why");
    if (!one || !other) return one ? other.error() : one.error();
    printResult(document("rocks-why", exports::whyReport(study, rocks::whyTwoRocks(study, *one, *other))), true);
    return Done{};
}

Result<Done> writeFiles(const RocksFlags& flags, const edges::Detection& detection, const std::shared_ptr<const rocks::Study>& study) {
    exports::ExportOptions options = exportOptions(flags.write, usualFrame(*detection.scan));
    options.rocks = study;
    std::optional<Error> failure; // the other files are still written
    const std::vector<WantedFile> files = wantedFiles(flags, *detection.scan);
    std::vector<std::string> paths{flags.writeEdits};
    for (const WantedFile& file : files) paths.push_back(file.path);
    if (auto distinct = checkDistinct(paths); !distinct) return distinct;
    for (const WantedFile& file : files) {
        if (file.output->content == exports::ExportContent::RockReport && file.path == "-") {
            printResult(document("rocks", exports::rocksReport(*study, options.frame)), true);
            continue;
        }
        const auto written = exports::exportWithProvenance(file.output->content, detection, file.path, options);
        if (!written && !failure) failure = written.error();
    }
    if (!flags.writeEdits.empty()) {
        const Scan& scan = *detection.scan;
        const rocks::Preset preset{study->settings, study->edits, scan.sha256};
        const auto written = writeWholeFile(flags.writeEdits, rocks::rockPresetText(preset, scan.lines(), scan.beams()));
        if (!written && !failure) failure = written.error();
    }
    if (failure) return *failure;
    if (!flags.why.empty()) return Done{};
    std::string places = printable(flags.folder);
    for (const WantedFile& file : files) {
        if (flags.folder.empty())
            places += (places.empty() ? "" : ", ") + (isStreamOrDevice(file.path) ? "standard output" : printable(file.path));
    }
    if (!flags.writeEdits.empty()) places += (places.empty() ? "" : ", ") + printable(flags.writeEdits);
    if (places.empty())
        printResult(summary(*study, flags.file));
    else
        reportWritten(summary(*study, flags.file) + "; written to " + places + ".", flags.read);
    return Done{};
}

Result<Done> findRocks(const RocksFlags& flags) {
    Result<Scan> opened = openAndWarn(flags.file, flags.read);
    if (!opened) return opened.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Rocks, *opened); !enough) return enough.error();
    const Result<edges::Settings> settings = settingsFor(flags.method, *opened);
    if (!settings) return settings.error();
    const auto preset = presetOf(flags.rocks, *opened);
    if (!preset) return preset.error();
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings, edges::KeepFor::Rocks);
    const rocks::Inputs inputs = rocks::rockInputs(*detection);
    auto study = std::make_shared<rocks::Study>(rocks::studyRocks(inputs, *preset->settings, preset->edits));
    if (const auto done = split(flags, inputs, *study); !done) return done.error();
    if (!flags.why.empty()) {
        if (const auto done = answerWhy(flags, *study); !done) return done.error();
    }
    return writeFiles(flags, *detection, study);
}

// Wrong usage is reported before any file is read.
Result<Done> checkUsage(RocksFlags& flags) {
    std::vector<std::string> paths(flags.paths.begin(), flags.paths.end());
    paths.push_back(flags.writeEdits);
    for (std::size_t n = 0; n < paths.size(); ++n) {
        const std::string& path = paths[n];
        if (path.empty()) continue;
        if (n < kOutputs && kRockOutputs[n].formats != nullptr) {
            const std::string formats = std::string(",") + kRockOutputs[n].formats + ",";
            if (formats.find("," + asciiLower(fs::path(path).extension().string()) + ",") == std::string::npos)
                return Error{"the extension names no format for this", path, std::string("use ") + kRockOutputs[n].formats};
        }
        if (n < kOutputs && kRockOutputs[n].content == exports::ExportContent::RockCloud) {
            const files::Format* format = files::writtenFormat(path);
            if (format == nullptr || format->write == nullptr)
                return Error{"the extension names no format for points", path, "use " + files::writtenExtensions(false)};
        }
    }
    if (auto distinct = checkDistinct(paths); !distinct) return distinct;
    claimInput(flags.file);
    if (const auto rocks = checkRocks(flags.rocks); !rocks) return rocks.error();
    return checkMethod(flags.method);
}

int run(RocksFlags& flags) {
    if (const Result<Done> usage = checkUsage(flags); !usage) {
        printError(usage.error());
        return kWrongUsage;
    }
    if (!flags.folder.empty()) {
        std::error_code failed;
        fs::create_directories(flags.folder, failed);
        if (failed) {
            printError({"the folder cannot be made (" + failed.message() + ")", flags.folder, "give -o a folder that can be written to"});
            return kRefused;
        }
    }
    const Result<Done> result = findRocks(flags);
    if (result) return kDone;
    printError(result.error());
    if (flags.paths[kReport] == "-") printResult(refusal("rocks", flags.file, result.error()), true);
    return kRefused;
}

} // namespace

void addRocks(CLI::App& app, int& code) {
    auto flags = std::make_shared<RocksFlags>();
    CLI::App& command = *app.add_subcommand("rocks", std::string("Finds the rocks between the edges: ") + rocks::kRockCaveat);
    command.add_option("FILE", flags->file, "Scan")->required();
    const char* results = "Results";
    for (std::size_t n = 0; n < kOutputs; ++n)
        command.add_option(kRockOutputs[n].flag, flags->paths[n], kRockOutputs[n].help)->group(results);
    command.add_option("-o,--output", flags->folder, "Folder for all of these, under the scan's name")->group(results);
    command.add_option("--why", flags->why, "Why two cells, each as LINE,BEAM, lie in two rocks or in one; JSON on stdout")
        ->expected(2)
        ->group(results);
    const char* group = "Rocks";
    addRockFlags(command, flags->rocks, true);
    command.add_option("--split", flags->split, "Splits the rock at this cell, as LINE,BEAM, as a click would")->expected(1)->group(group);
    command.add_option("--write-edits", flags->writeEdits, "Where settings and edits go, those of --split included")->group(group);
    addMethodFlags(command, flags->method);
    addReadFlags(command, flags->read);
    addWriteFlags(command, flags->write);
    command.callback([flags, &code] { code = run(*flags); });
}

} // namespace edgescan::cli
