// edgescan-cli rocks: turns the edges of a scan into one label per rock, with a description of each rock.
#include "app/cli/commands.h"
#include "app/cli/export_flags.h"
#include "app/shared/numbers.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/exports/provenance.h"
#include "core/exports/rock_files.h"
#include "core/inspect/section/section.h"
#include "core/rocks/attributes/size_curve.h"
#include "core/rocks/attributes/study.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace edgescan::cli {
namespace {

constexpr exports::ExportKind::Needs kRocks = exports::ExportKind::Needs::Rocks;

struct RocksFlags {
    std::string file, writeEdits;
    ExportPaths out;
    std::vector<std::string> why, split;
    std::vector<std::string> through; ///< cells of a section
    int throughRock = 0;              ///< 0: none
    RockFlags rocks;
    ReadFlags read;
    WriteFlags write;
    MethodFlags method;
};

bool isOnRock(const rocks::Study& study, std::uint32_t cell) {
    return study.map.regions[study.map.regionOfSegment[study.segmentation->segment[cell]]].kind == rocks::RegionKind::Rock;
}

// Splits at these cells, one after the other, like clicks in the viewer.
Result<Done> split(const RocksFlags& flags, const rocks::Inputs& inputs, rocks::Study& study) {
    for (const std::string& text : flags.split) {
        const auto cell = cellIn(*inputs.scan, text, "--split");
        if (!cell) return cell.error();
        const bool wasRock = isOnRock(study, *cell);
        const auto edit = rocks::splitAt(*study.segmentation, *study.tree, study.settings.level, *cell);
        const Error notOnRock{"the cell " + text + " is not on a rock", "--split", "choose a cell of a rock; --labels shows them"};
        if (!edit && !wasRock) return notOnRock;
        if (!edit)
            return Error{"there is nothing to split at " + text, "--split",
                         "choose a cell of a rock that is made of several pieces, or a lower --level"};
        std::vector<rocks::Edit> edits = study.edits;
        edits.push_back(*edit);
        study = rocks::studyRocks(inputs, study.settings, edits, &study);
        if (!wasRock && !isOnRock(study, *cell)) return notOnRock;
    }
    return Done{};
}

std::string summary(const rocks::Study& study, const std::string& file) {
    const rocks::SizeCurve curve = rocks::sizeCurve(study.rocks, study.settings.oversizeM);
    const rocks::RegionCounts fines = rocks::regionCounts(study.map, rocks::RegionKind::Fines);
    std::string text = printable(file) + ": " + std::to_string(study.rocks.size()) + " rocks (" + rocks::kRockCaveat + ")";
    if (curve.rocks() > 0)
        text += ", visible width b: P20 " + fixedText(curve.p20M, 2) + " P50 " + fixedText(curve.p50M, 2) + " P80 " +
                fixedText(curve.p80M, 2) + " largest " + fixedText(curve.topM, 2) + " m";
    text += ", " + std::to_string(fines.regions) + " pieces of fines";
    return text + (rocks::upOf(*study.segmentation->inputs.scan).assumed ? "; up is the scanner's z axis, assumed" : "");
}

Result<Done> answerWhy(const RocksFlags& flags, const rocks::Study& study) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const auto one = cellIn(scan, flags.why[0], "--why");
    const auto other = cellIn(scan, flags.why[1], "--why");
    if (!one || !other) return one ? other.error() : one.error();
    printResult(document("rocks-why", exports::whyReport(study, rocks::whyTwoRocks(study, *one, *other))), true);
    return Done{};
}

/// The plane of the section; null without one.
Result<std::shared_ptr<const inspect::SectionPlane>> planeFor(const RocksFlags& flags, const rocks::Study& study) {
    const Scan& scan = *study.segmentation->inputs.scan;
    std::shared_ptr<const inspect::SectionPlane> none;
    Result<inspect::SectionPlane> plane = inspect::SectionPlane{};
    if (flags.throughRock > 0) {
        if (rocks::rockOf(study.rocks, static_cast<std::uint32_t>(flags.throughRock)) == nullptr)
            return Error{"no rock has the number " + std::to_string(flags.throughRock), "--section-rock",
                         "give a number of the table of rocks (--csv)"};
        const Grid<std::uint32_t> labels = rocks::rockLabels(*study.segmentation, study.map);
        std::vector<std::uint32_t> cells;
        for (std::uint32_t k = 0; k < labels.size(); ++k) {
            if (labels[k] == static_cast<std::uint32_t>(flags.throughRock)) cells.push_back(k);
        }
        plane = inspect::planeThroughRock(scan, cells);
    } else if (!flags.through.empty()) {
        const auto from = cellIn(scan, flags.through[0], "--section-through"), to = cellIn(scan, flags.through[1], "--section-through");
        if (!from || !to) return from ? to.error() : from.error();
        plane = inspect::planeThrough(scan, *from, *to);
    } else {
        return none;
    }
    if (!plane) return plane.error();
    return std::make_shared<const inspect::SectionPlane>(*plane);
}

Result<Done> writeFiles(const RocksFlags& flags, const edges::Detection& detection, const std::shared_ptr<const rocks::Study>& study) {
    warnOfIdleWriting(flags.write, *detection.scan);
    exports::ExportOptions options = exportOptions(flags.write, *detection.scan);
    options.rocks = study;
    const auto plane = planeFor(flags, *study);
    if (!plane) return plane.error();
    options.section = *plane;
    const std::vector<WantedExport> files = wantedExports(flags.out, kRocks, detection.scan->name, options.frame);
    std::vector<std::string> paths{flags.writeEdits};
    for (const WantedExport& file : files) paths.push_back(file.path);
    if (auto distinct = checkDistinct(paths); !distinct) return distinct;
    WrittenOutputs outputs;
    for (const WantedExport& file : files) {
        if (file.kind->content == exports::ExportContent::RockReport && file.path == "-") {
            printResult(document("rocks", exports::rocksReport(*study, options.frame)), true);
            continue;
        }
        outputs.add(file.path, exports::exportWithProvenance(file.kind->content, detection, file.path, options)); // after a failure too
    }
    if (!flags.writeEdits.empty()) {
        const Scan& scan = *detection.scan;
        const rocks::Preset preset{study->settings, study->edits, scan.sha256};
        outputs.add(flags.writeEdits, writeWholeFile(flags.writeEdits, rocks::rockPresetText(preset, scan.lines(), scan.beams())));
    }
    if (auto all = outputs.outcome(); !all) return all;
    const bool inFolder = !flags.out.folder.empty();
    std::string places = inFolder ? printable(flags.out.folder) : placesText({paths.begin() + 1, paths.end()});
    if (!flags.writeEdits.empty()) places += (places.empty() ? "" : ", ") + placesText({flags.writeEdits});
    if (flags.why.empty() && places.empty())
        printResult(summary(*study, flags.file));
    else if (flags.why.empty() && writesFiles(paths))
        printError(summary(*study, flags.file) + "; written to " + places +
                   (inFolder ? ": " + namesText({paths.begin() + 1, paths.end()}, flags.out.folder) : "") + ".");
    if (study->rocks.empty() && !files.empty())
        printError(printable(flags.file) +
                   ": no rock was found, so the files hold none; a smaller --min-cells or another --level finds more.");
    if (const std::string coordinates = outputs.coordinates(flags.out.folder); !coordinates.empty()) printError(coordinates);
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

std::vector<std::string> typedOutputs(const RocksFlags& flags) {
    std::vector<std::string> paths(flags.out.typed.begin(), flags.out.typed.end());
    paths.push_back(flags.writeEdits);
    return paths;
}

// Wrong usage is reported before any file is read.
Result<Done> checkUsage(RocksFlags& flags) {
    if (auto known = checkExtensions(flags.out); !known) return known;
    if (auto used = checkWriting(flags.write, wantedExports(flags.out, kRocks, "scan", CoordinateFrame::Mine), flags.method); !used)
        return used;
    if (auto distinct = checkDistinct(typedOutputs(flags)); !distinct) return distinct;
    const bool noPlane = flags.through.empty() && flags.throughRock == 0;
    if (const std::string& section = flags.out.of(exports::exportKind(exports::ExportContent::Section)); noPlane != section.empty())
        return Error{noPlane ? "a section needs a plane" : "the section has no file", "--section",
                     noPlane ? "give --section-through LINE,BEAM LINE,BEAM or --section-rock N" : "give --section FILE"};
    claimInput(flags.file);
    if (const auto rocks = checkRocks(flags.rocks); !rocks) return rocks.error();
    return checkMethod(flags.method);
}

/// Rocks are found from the steps and folds of the surface, whatever of these is an edge. A cloud of rocks has the edges too.
void warnOfIdleFlags(const RocksFlags& flags) {
    const auto warn = [](const std::string& flag, const char* why = "rocks are found from the surface, not from its edges") {
        printError(flag + " has no effect: " + why + "; leave it out.");
    };
    const auto wanted = wantedExports(flags.out, kRocks, "scan", CoordinateFrame::Mine);
    if (std::ranges::any_of(wanted, [](const WantedExport& one) { return one.kind->content == exports::ExportContent::RockCloud; })) return;
    const auto all = settingsOf(flags.method);
    if (all && all->fillCells > 0 && !all->fillEdges) warn("--fill", "filled cells count only with --fill-edges on");
    const auto ofGray = [](const edges::Settings& settings) { return !edges::reads(settings.method, edges::kReadsSurface); };
    if (const auto preset = presetOf(flags.method); !flags.method.preset.empty() && preset && ofGray(preset->settings) &&
                                                    edges::sameUpTo(edges::Stage::Responses, preset->settings, edges::Settings{}))
        warn("--preset " + flags.method.preset);
    for (const edges::Parameter& p : edges::parameters()) {
        const edges::Stage stage = p.feeds;
        const std::string& typed = flags.method.typed.at(p.key);
        if (typed == kNotTyped) continue;
        edges::Settings ofMethod;
        const bool isMethod = std::string_view(p.key) == "method";
        if (const auto value = edges::parseValue(p, typed); isMethod && value) p.set(ofMethod, *value);
        const bool used = stage == edges::Stage::Surface || stage == edges::Stage::Responses ||
                          (isMethod && ofMethod.method == edges::Method::EdgeScanPlus);
        if (!used) warn(edges::flagOf(p) + (isMethod ? " " + typed : ""));
    }
}

int run(RocksFlags& flags) {
    if (const Result<Done> usage = checkUsage(flags); !usage) return failWith(usage.error(), kWrongUsage);
    warnOfIdleFlags(flags);
    if (const auto made = makeFolder(flags.out.folder, "give -o a folder that can be written to"); !made) return failWith(made.error());
    if (const auto can = checkOutputs(typedOutputs(flags)); !can) return failWith(can.error());
    const Result<Done> result = findRocks(flags);
    if (result) return kDone;
    printError(result.error());
    if (flags.out.of(exports::exportKind(exports::ExportContent::RockReport)) == "-")
        printResult(refusal("rocks", flags.file, result.error()), true);
    return kRefused;
}

} // namespace

void addRocks(CLI::App& app, int& code) {
    auto flags = std::make_shared<RocksFlags>();
    CLI::App& command = *app.add_subcommand("rocks", std::string("Finds the rocks between the edges: ") + rocks::kRockCaveat);
    command.add_option("FILE", flags->file, "Scan")->required();
    const char* results = "Results";
    addExportFlags(command, kRocks, flags->out, results);
    addFolderFlag(command, flags->out, results);
    command.add_option("--why", flags->why, "Why two cells belong to two rocks or to one, as JSON on standard output")
        ->expected(2)
        ->type_name("LINE,BEAM")
        ->check(cellText())
        ->group(results);
    CLI::Option* through =
        command.add_option("--section-through", flags->through, "The plane of the section is vertical and goes through these two cells")
            ->expected(2)
            ->type_name("LINE,BEAM")
            ->check(cellText())
            ->group(results);
    command.add_option("--section-rock", flags->throughRock, "The plane of the section goes along the rock with this number")
        ->type_name("NUMBER")
        ->check(CLI::Range(1, 1000000))
        ->excludes(through)
        ->group(results);
    const char* group = "Rocks";
    addRockFlags(command, flags->rocks, true);
    command.add_option("--split", flags->split, "Splits the rock at this cell, as a click in the viewer does")
        ->expected(1)
        ->type_name("LINE,BEAM")
        ->check(cellText())
        ->group(group);
    command.add_option("--write-edits", flags->writeEdits, "New file for settings and edits, those of --split included")
        ->type_name("FILE")
        ->check(replacesOnly({"rock-edits"}))
        ->group(group);
    addMethodFlags(command, flags->method);
    addReadFlags(command, flags->read);
    addWriteFlags(command, flags->write);
    command.callback([flags, &code] { code = run(*flags); });
}

} // namespace edgescan::cli
