// Edges in Python: detection, its arrays, writing results, and scores against ground truth.
#include "app/python/result.h"
#include "core/edges/gray/gray.h"
#include "core/edges/settings/parameters.h"

#include "app/shared/typed_settings.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/report.h"
#include "core/files/formats/formats.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>

namespace edgescan::python {
namespace {

cli::MethodFlags flagsOf(const Typed& typed, const std::string& preset) {
    cli::MethodFlags flags = cli::noFlags();
    flags.preset = preset;
    for (const auto& [name, text] : typed) {
        std::string& value = flags.typed.at(edges::findParameter(name)->key);
        if (value != cli::kNotTyped) throw Refused{{"two names of one setting are given", "--" + name, "give one of them"}};
        value = text;
    }
    return flags;
}

ResultObject detect(const ScanObject& of, const Typed& typed, const std::string& preset) {
    const cli::MethodFlags flags = flagsOf(typed, preset);
    valueOf(cli::checkMethod(flags));
    for (const std::string& note : cli::methodNotes(flags)) logWarning(note);
    return unlocked([&]() -> ResultObject {
        const BindInputs inputs;
        claimInput(preset); // if it is a file
        valueOf(edges::checkMemoryFor(edges::Work::Detect, *of.scan));
        return {edges::detectEdges(of.scan, valueOf(cli::settingsFor(flags, *of.scan)))};
    });
}

py::array strengthOf(const ResultObject& result) {
    const auto later = result.later;
    unlocked([&] {
        const auto detection = whole(result);
        std::call_once(later->strength, [&] { later->map = edges::thresholdMapOf(*detection); });
        return Done{};
    });
    return gridArray(later->map.highest, later);
}

py::array grayOf(const ResultObject& result) {
    const auto detection = unlocked([&] { return whole(result); });
    return gridArray(detection->gray->levels, detection);
}

py::object bordersOf(const ResultObject& result) {
    const auto detection = unlocked([&] {
        auto found = whole(result);
        if (found->borders) (void)*found->borders;
        return found;
    });
    return detection->borders ? vectorArray(*detection->borders, detection) : py::object(py::none());
}

py::object reportOf(const ResultObject& result) {
    return objectOf(unlocked([&] { return exports::detectReport(*whole(result), 0.0); }));
}

exports::ExportContent contentOf(const std::string& name) {
    std::string names;
    for (const exports::ExportKind& kind : exports::exportKinds()) {
        if (kind.needs > exports::ExportKind::Needs::Edges) continue;
        if (name == kind.key) return kind.content;
        names += (names.empty() ? "" : ", ") + std::string(kind.key);
    }
    throw Refused{{"\"" + name + "\" is not a content of a file", "content", "use one of " + names}};
}

/// How to write a file; the keywords are the names of the flags.
cli::WriteFlags writeFlagsOf(const Typed& typed) {
    cli::WriteFlags flags;
    const auto text = [&](const char* key, const std::string& usual) {
        const auto found = typed.find(key);
        return found == typed.end() ? usual : found->second;
    };
    flags.frame = text("frame", flags.frame);
    if (flags.frame != "auto" && flags.frame != "scanner" && flags.frame != "local" && flags.frame != "mine")
        throw Refused{{"\"" + flags.frame + "\" names no frame", "frame", "use auto, scanner, local or mine"}};
    flags.ascii = text("ascii", "off") == "on";
    flags.includeAttached = text("include-attached", "off") == "on";
    flags.operatorName = text("operator", "");
    flags.role = text("role", "");
    for (const files::WritingChoice& choice : files::kWritingChoices) flags.choices.*choice.member = text(choice.key, "off") == "on";
    return flags;
}

std::size_t write(const edges::Detection& detection, exports::ExportContent content, const std::string& path, const Typed& typed) {
    const cli::WriteFlags flags = writeFlagsOf(typed);
    const cli::WantedExport file{&exports::exportKind(content), path};
    valueOf(exports::checkExtension(*file.kind, path, path, ", "));
    if (const char* idle = cli::idleWriting(flags, {&file, 1}))
        throw Refused{
            {"this flag changes nothing in this file", std::string("--") + idle, "leave it out, or write a file that it changes"}};
    return unlocked([&] {
        const BindInputs inputs;
        const Scan& scan = *detection.scan;
        if (!scan.path.empty()) claimInput(scan.path);
        const exports::ExportOptions options = cli::exportOptions(flags, scan, path);
        return valueOf(exports::exportWithProvenance(content, detection, path, options)).count;
    });
}

std::size_t saveScanObject(const ScanObject& scan, const std::string& path, const Typed& typed) {
    edges::Detection detection;
    detection.scan = scan.scan;
    return write(detection, exports::ExportContent::WholeScan, path, typed);
}

std::size_t saveResult(const ResultObject& result, const std::string& path, const std::string& content, const Typed& typed) {
    const auto detection = unlocked([&] { return whole(result); });
    return write(*detection, contentOf(content), path, typed);
}

py::dict timesOf(const edges::Detection& detection) {
    py::dict times;
    for (const edges::StageTime& time : detection.timings) times[py::str(time.stage)] = time.milliseconds;
    return times;
}

std::string textOf(const edges::Detection& detection) {
    return "<edgescan.Result " + printable(detection.scan->name) + ": " + std::to_string(detection.edges->size()) + " edge cells of " +
           std::to_string(detection.scan->cells()) + ">";
}

void bindResult(py::module_& module) {
    using D = std::shared_ptr<const edges::Detection>;
    Class<ResultObject> type(module, "Result", "The edges that one run of the method found in one scan.");
    // clang-format off
    const auto property = [&](const char* name, const auto& get, const char* help) {
        type.def_property_readonly(name, [get](const ResultObject& self) { return get(self.detection); }, help);
    };
    property("scan", [](const D& d) { return ScanObject{d->scan}; }, "The scan.");
    property("mask", [](const D& d) { return gridArray(*d->mask, d); }, "uint8, lines x beams: 255 = edge. No copy, read only.");
    property("classes", [](const D& d) -> py::object { return d->classes ? gridArray(*d->classes, d) : py::object(py::none()); },
             "uint8, lines x beams: 0 none, 1 jump, 2 convex, 3 concave, 4 border, 5 outline before a void, 6 void rim. None where the method has no classes. "
             "No copy, read only.");
    property("edges", [](const D& d) { return vectorArray(*d->edges, d); },
             "uint32, ascending: index line * beams + beam of every edge cell. No copy, read only.");
    property("settings", [](const D& d) { return objectOf(edges::settingsToJson(d->settings)); }, "Every parameter's value, by its key.");
    property("threshold", [](const D& d) { return std::string(edges::sweptParameter(d->settings.method).key); },
             "Key of the parameter that `strength` is in units of.");
    property("times_ms", [](const D& d) { return timesOf(*d); }, "Milliseconds of each stage.");
    property("mask_sha256", [](const D& d) { return exports::maskSha256(*d->mask); }, "SHA-256 of the bytes of `mask`, as the command line prints it.");
    // clang-format on
    type.def_property_readonly("strength", &strengthOf,
                               "float64, lines x beams: the highest value of the parameter `threshold` at which the cell is an edge; "
                               "negative: at none, infinite: at all. Worked out when first asked for. No copy, read only.");
    type.def_property_readonly(
        "borders", &bordersOf,
        "uint8, as many as `edges`: how likely each edge is the border of a rock and not a fold within one, in percent; "
        "255: unknown. None where the method does not measure the surface. Worked out when first asked for. "
        "No copy, read only.");
    type.def_property_readonly("gray", &grayOf, "uint8, lines x beams: gray levels, 0 where there is no range. No copy, read only.");
    type.def("__repr__", [](const ResultObject& self) { return textOf(*self.detection); });
}

} // namespace

void bindDetect(py::module_& module) {
    bindResult(module);
    module.def("detect", &detect);
    module.def("result_report", &reportOf);
    module.def("save_scan", &saveScanObject);
    module.def("save_result", &saveResult);
    module.def("write_file", [](const std::string& path, const std::string& content) { // bytes
        unlocked([&] { return valueOf(writeWholeFile(path, std::as_bytes(std::span(content)))); });
    });
}

} // namespace edgescan::python
