// What else is found from results: why a cell is an edge, what changed between two scans, and the report as a page.
#include "app/python/result.h"

#include "core/base/bounded_json.h"
#include "core/base/inputs.h"
#include "core/base/shell_quoted.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/edges/explain/why.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/edges/settings/command_text.h"
#include "core/edges/settings/parameters.h"
#include "core/exports/html/scan_page.h"
#include "core/exports/report.h"
#include "core/inspect/change_detection/change_report.h"
#include "core/scan/grid/reading_options.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace edgescan::python {
namespace {

py::object why(const ResultObject& result, const py::int_& lineGiven, const py::int_& beamGiven) {
    const Scan& scan = *result.detection->scan;
    const std::int64_t line = wholeOf(lineGiven), beam = wholeOf(beamGiven);
    if (line < 0 || beam < 0 || line >= scan.lines() || beam >= scan.beams())
        throw Refused{
            {"there is no cell at line " + std::to_string(line) + ", beam " + std::to_string(beam), "line, beam",
             "lines run from 0 to " + std::to_string(scan.lines() - 1) + ", beams from 0 to " + std::to_string(scan.beams() - 1)}};
    return objectOf(unlocked([&] {
        valueOf(edges::checkMemoryFor(edges::Work::Explain, scan));
        const auto detection = whole(result);
        return exports::whyReport(*detection,
                                  edges::whyCell(*detection, scan.rangeMm.index(static_cast<int>(line), static_cast<int>(beam))));
    }));
}

inspect::SceneChange changeOf(const edges::Detection& before, const edges::Detection& now, const inspect::RegistrationRequest& wish = {}) {
    valueOf(edges::checkMemoryFor(edges::Work::Compare, *before.scan));
    return valueOf(inspect::sceneChange({now.scan, now.mask}, {before.scan, before.mask}, wish));
}

/// "--method canny" and "--method edgescan+", or all settings that differ; empty: they are the same.
std::pair<std::string, std::string> differentSettings(const edges::Settings& before, const edges::Settings& now) {
    std::pair<std::string, std::string> texts;
    for (const edges::Parameter& p : edges::parameters()) {
        if (!p.usedBy(before) && !p.usedBy(now)) continue;
        const std::string was = edges::formatValue(p, p.get(before)), is = edges::formatValue(p, p.get(now));
        if (was == is) continue;
        for (auto& [text, value] : {std::pair<std::string&, const std::string&>{texts.first, was}, {texts.second, is}})
            text += (text.empty() ? "" : ", ") + edges::flagOf(p) + " " + value;
        if (std::string_view(p.key) == "method") break; // the others are of one method
    }
    return texts;
}

py::object compare(const ResultObject& before, const ResultObject& now, const std::vector<std::string>& poses, bool bySurfaces,
                   const std::string& picture) {
    return objectOf(unlocked([&] {
        const BindInputs inputs;
        inspect::RegistrationRequest wish;
        wish.bySurfaces = bySurfaces;
        if (!poses.empty()) wish.poses = std::array{valueOf(inspect::open3dtkPose(poses[1])), valueOf(inspect::open3dtkPose(poses[0]))};
        const Scan& later = *now.detection->scan;
        for (const Scan* scan : {&later, before.detection->scan.get()}) {
            if (!scan->path.empty()) claimInput(scan->path);
        }
        const inspect::SceneChange change = changeOf(*before.detection, *now.detection, wish);
        if (!picture.empty()) valueOf(containers::savePngRgb(inspect::changePicture(later, change), picture));
        nlohmann::ordered_json report{{"before", before.detection->scan->path}, {"now", later.path}};
        report.update(inspect::changeReport(later, change));
        if (const auto [was, is] = differentSettings(before.detection->settings, now.detection->settings); !was.empty())
            report["warnings"].push_back("The edges were found with other settings, before with " + was + " and now with " + is +
                                         ": edges gained and lost may be those of the settings.");
        return report;
    }));
}

/// The command that makes the report; of a scan that is in no file, how to get one.
std::string commandOf(const edges::Detection& detection, const std::string& path, const std::string& more) {
    const Scan& scan = *detection.scan;
    if (scan.path.empty()) return "edgescan.save(scan, FILE), because this scan was made in memory; then edgescan-cli report FILE" + more;
    std::string command = "edgescan-cli report " + shellQuoted(fileName(scan.path)) + " -o " + shellQuoted(fileName(path));
    const auto options = parseReadingOptions(scan.openedWith, scan.path);
    if (const std::string flags = options ? readingFlags(exports::withNames(*options)) : std::string(); !flags.empty())
        command += " " + flags;
    command += " " + edges::settingsFlags(detection.settings) + more;
    return scan.placement ? command + "  # with --pose and --calibration: " + scan.placement->source : command;
}

/// `rockSettings`: JSON, or empty for a page without rocks.
std::size_t report(const ResultObject& result, const std::string& path, const std::string& rockSettings, const std::string& targets,
                   const ScanObject* before, const std::string& operatorName, const std::string& role) {
    return unlocked([&] {
        const BindInputs inputs;
        const ScanPtr scan = result.detection->scan;
        for (const ScanPtr& input : {scan, before != nullptr ? before->scan : ScanPtr()}) {
            if (input && !input->path.empty()) claimInput(input->path);
        }
        const bool withRocks = !rockSettings.empty();
        valueOf(edges::checkMemoryFor(withRocks ? edges::Work::Rocks : edges::Work::Detect, *scan));
        const auto detection = withRocks ? edges::detectEdges(scan, result.detection->settings, edges::KeepFor::Rocks) : whole(result);
        std::string more;
        exports::PageNotes notes{nullptr, nullptr, nullptr, {}};
        std::optional<rocks::Study> study;
        if (withRocks) {
            const auto settings = valueOf(rocks::rockSettingsFromJson(valueOf(parseJson(rockSettings, "rocks")), "rocks"));
            notes.rocks = &study.emplace(rocks::studyRocks(rocks::rockInputs(*detection), settings));
            more += " --rocks";
            if (const std::string flags = rocks::rockSettingsFlags(settings); !flags.empty()) more += " " + flags;
        }
        std::optional<inspect::Notebook> notebook;
        if (!targets.empty()) {
            const auto bytes = valueOf(readInput(targets));
            notes.notebook =
                &notebook.emplace(valueOf(inspect::notebookFromText(edgescan::textOf(bytes), inspect::notebookScan(*scan), targets)));
            more += " --targets " + shellQuoted(fileName(targets));
        }
        std::optional<inspect::SceneChange> change;
        if (before != nullptr) {
            notes.change = &change.emplace(changeOf(*edges::detectEdges(before->scan, detection->settings), *detection));
            notes.earlier = before->scan->path.empty() ? before->scan->name : fileName(before->scan->path);
            more += " --before " + shellQuoted(notes.earlier);
        }
        if (!operatorName.empty()) more += " --operator " + shellQuoted(operatorName);
        if (!role.empty()) more += " --role " + shellQuoted(role);
        const exports::PageWords words{commandOf(*detection, path, more), operatorName, role, utcText(utcNow())};
        const std::string page = exports::scanPage(*detection, words, notes);
        valueOf(writeWholeFile(path, page));
        return page.size();
    });
}

} // namespace

void bindFindings(py::module_& module) {
    module.def("why", &why);
    module.def("compare", &compare);
    module.def("report", &report, py::arg("result"), py::arg("path"), py::arg("rocks"), py::arg("targets"), py::arg("before").none(true),
               py::arg("operator"), py::arg("role"));
}

} // namespace edgescan::python
