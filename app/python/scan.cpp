// Scans in Python: opening them, and their cells as arrays.
#include "app/python/module.h"
#include "core/edges/edgescan_plus/range_field.h"

#include "core/base/file_address.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/exports/report.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/cartesian.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace edgescan::python {
namespace {

ReadingOptions optionsOf(const Typed& typed) {
    ReadingOptions options;
    for (const ReadingOption& option : readingOptionTable()) {
        const auto text = typed.find(option.key);
        if (text == typed.end()) continue;
        valueOf(checked(option, text->second));
        option.set(options, text->second);
    }
    options.progress = [](const char*, double) { return noSignal(); };
    return options;
}

ScanObject openFile(const std::string& path, const Typed& typed) {
    const ReadingOptions options = optionsOf(typed);
    const BindInputs inputs; // no file that the scan was read from is replaced while there is the scan
    Result<Scan> scan = unlocked([&] { return files::openAsAsked(path, options); });
    raiseSignal();
    const auto held =
        std::make_shared<const std::pair<Scan, std::shared_ptr<const InputClaims>>>(valueOf(std::move(scan)), inputs.claims());
    return {ScanPtr(held, &held->first)};
}

/// A scan of a file's content, given its extension.
ScanObject scanOfContent(const std::string& content, const std::string& extension, const std::string& name, const Typed& typed) {
    const ReadingOptions options = optionsOf(typed);
    Result<Scan> scan = unlocked([&] { return files::readScanBytes(std::as_bytes(std::span(content)), extension, options); });
    raiseSignal();
    if (!scan) {
        Error problem = scan.error();
        if (problem.where.starts_with("memory")) problem.where = "xyz"; // the argument
        throw Refused{problem};
    }
    Scan read = std::move(*scan);
    read.name = name;
    return {std::make_shared<const Scan>(std::move(read))};
}

py::array_t<double> pointsOf(const ScanPtr& scan, const std::string& name) {
    const CoordinateFrame frame = frameOf(*scan, name);
    py::array_t<double> array({scan->lines(), scan->beams(), 3});
    double* at = array.mutable_data();
    unlocked([&] {
        const CartesianTables tables(*scan);
        std::optional<PlacedPoints> placed;
        if (frame != CoordinateFrame::Scanner) placed.emplace(*scan);
        for (int line = 0; line < scan->lines(); ++line) {
            for (int beam = 0; beam < scan->beams(); ++beam) {
                const Eigen::Vector3d own = tables.point(line, beam);
                const Eigen::Vector3d point = placed ? placed->inFrame(frame, line, beam, own) : own;
                at = std::copy_n(point.data(), 3, at);
            }
        }
        return Done{};
    });
    return array;
}

py::object anglesOf(const ScanPtr& scan, std::vector<double> PolarGeometry::*member) {
    const auto* polar = std::get_if<PolarGeometry>(&scan->geometry);
    if (polar == nullptr) return py::none();
    return vectorArray(polar->*member, scan);
}

py::object axisOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return py::none();
    return py::str(polar->axis == Axis::Spin ? "spin" : "sweep");
}

py::object directionOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    return polar == nullptr ? py::object(py::none()) : py::object(py::float_(polar->lineDirection));
}

py::object timesOf(const ScanPtr& scan) {
    if (!scan->acquisition || scan->acquisition->lineTimesS.empty()) return py::none();
    return vectorArray(scan->acquisition->lineTimesS, scan->acquisition);
}

py::object originOf(const Scan& scan) {
    if (scan.placement == nullptr) return py::none();
    return py::array_t<double>(3, scan.placement->originEnhM.data());
}

py::list warningsOf(const Scan& scan) {
    py::list sentences;
    for (const std::string& warning : scan.warnings) sentences.append(nameOf(withKeywords(warning)));
    return sentences;
}

std::string textOf(const Scan& scan) {
    return "<edgescan.Scan " + printable(scan.name) + ": " + std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) +
           " beams>";
}

} // namespace

CoordinateFrame frameOf(const Scan& scan, const std::string& name) {
    const CoordinateFrame frame = name == "local"  ? CoordinateFrame::MineLocal
                                  : name == "mine" ? CoordinateFrame::Mine
                                                   : CoordinateFrame::Scanner;
    if (frame == CoordinateFrame::Scanner && name != "scanner")
        throw Refused{{"\"" + name + "\" names no frame", "frame", "use scanner, local or mine"}};
    if (frame != CoordinateFrame::Scanner && scan.placement == nullptr)
        throw Refused{{"the scan has no place in the mine", scan.path, "open it with pose and calibration"}};
    return frame;
}

void bindScan(py::module_& module) {
    Class<ScanObject> type(module, "Scan", "A sweep as measured: lines x beams cells, each with a range and a state.");
    // clang-format off
    const auto property = [&](const char* name, const auto& get, const char* help) {
        type.def_property_readonly(name, [get](const ScanObject& self) { return get(self.scan); }, help);
    };
    property("lines", [](const ScanPtr& s) { return s->lines(); }, "Number of lines: rows of the arrays.");
    property("beams", [](const ScanPtr& s) { return s->beams(); }, "Number of beams: columns of the arrays.");
    property("range_mm", [](const ScanPtr& s) { return gridArray(s->rangeMm, s); },
             "float32, lines x beams, mm. A range only where state is 0. No copy, read only.");
    property("state", [](const ScanPtr& s) { return gridArray(s->state, s); },
             "uint8, lines x beams: 0 valid, 1 no return, 2 device status, 3 outside the window, 4 masked, 5 lost. No copy, read only.");
    property("intensity", [](const ScanPtr& s) -> py::object { return s->intensity.size() > 0 ? gridArray(s->intensity, s) : py::object(py::none()); },
             "float32, lines x beams: as it was read, NaN where a cell has none. None where the scan has none. No copy, read only.");
    property("beam_deg", [](const ScanPtr& s) { return anglesOf(s, &PolarGeometry::beamDeg); },
             "float64, beams: angle of each beam in the fan, degrees. None where the scan holds points without angles.");
    property("line_deg", [](const ScanPtr& s) { return anglesOf(s, &PolarGeometry::lineDeg); },
             "float64, lines: angle of the stepper at each line, degrees. None as for beam_deg.");
    property("line_skew_deg", [](const ScanPtr& s) { return anglesOf(s, &PolarGeometry::lineSkewDeg); },
             "float64, beams: degrees that the stepper turned until each beam of a line; empty: none. None as for beam_deg.");
    property("line_direction", [](const ScanPtr& s) { return directionOf(*s); },
             "1.0: line angles turn right-handed about the axis; -1.0: the other way. None as for beam_deg.");
    property("axis", [](const ScanPtr& s) { return axisOf(*s); }, "What the stepper turns about, 'spin' or 'sweep'. None as for beam_deg.");
    property("origin", [](const ScanPtr& s) { return originOf(*s); },
             "float64, 3: Easting, Northing, Elevation of the local zero, m. None without a place in the mine.");
    property("name", [](const ScanPtr& s) { return nameOf(s->name); }, "Short name.");
    property("path", [](const ScanPtr& s) { return nameOf(s->path); }, "File it was opened from; empty when made in memory.");
    property("format", [](const ScanPtr& s) { return s->format; }, "What the file was recognised as.");
    property("sha256", [](const ScanPtr& s) { return s->sha256; }, "Of the file's bytes, lower-case hex.");
    property("warnings", [](const ScanPtr& s) { return warningsOf(*s); }, "Sentences about what was assumed, repaired or lost on reading.");
    // clang-format on
    property(
        "line_times_s", [](const ScanPtr& s) -> py::object { return timesOf(s); },
        "float64, lines: seconds since 1970 UTC at which each line was measured. None where the scan does not say it.");
    type.def("__repr__", [](const ScanObject& self) { return textOf(*self.scan); });
    module.def("open", &openFile);
    module.def("scan_of_content", &scanOfContent);
    module.def("path_of_address", [](const std::string& text) { return py::bytes(valueOf(pathOfAddress(text))); });
    module.def("scan_xyz", [](const ScanObject& scan, const std::string& frame) { return pointsOf(scan.scan, frame); });
    module.def("scan_info", [](const ScanObject& scan) { return objectOf(exports::infoReport(*scan.scan)); });
}

} // namespace edgescan::python
