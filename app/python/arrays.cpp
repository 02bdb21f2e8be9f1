// A scan from arrays of numpy: ranges, states, intensities, angles, times and place, checked as a file's are.
#include "app/python/module.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/utc_time.h"
#include "core/files/formats/range_geometry.h"
#include "core/files/open_save/check_measured.h"
#include "core/files/point_tables/point_columns.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/acquisition.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

namespace edgescan::python {
namespace {

template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

constexpr double kMostExactMm = 1 << 24;

/// The arguments of Scan(); edgescan/_arrays.py checked their types, shapes and states.
struct Arrays {
    Array<double> range;
    std::optional<Array<std::uint8_t>> state;
    std::optional<Array<float>> intensity;
    std::vector<double> beamDeg, lineDeg, lineSkewDeg, lineTimesS;
    std::string axis, name, pose, calibration;
    double lineDirection = 1.0;
    double unitMm = 1.0;
    bool counts = false; ///< the ranges are whole counts of `unitMm`
};

std::string cellText(const char* array, std::size_t k, int beams) {
    const auto width = static_cast<std::size_t>(beams);
    return std::string(array) + "[" + std::to_string(k / width) + ", " + std::to_string(k % width) + "]";
}

Refused wrongCell(const char* array, std::size_t k, int beams, double value, const char* why, const char* hint) {
    return Refused{{shortestText(value) + " " + why, cellText(array, k, beams), hint}};
}

/// Cells without a state of their own: NaN and 0 are missing returns.
void setRange(Scan& scan, std::size_t k, double value, double mm) {
    if (std::isnan(value) || value == 0) {
        scan.state[k] = CellState::NoReturn;
        return;
    }
    if (!(mm > 0) || !physical::kRangeMm.hold(mm))
        throw wrongCell("range_mm", k, scan.beams(), value, "is not a range",
                        "give more than 0 to 1e9 mm, and NaN or 0 where there is no return");
    scan.rangeMm[k] = static_cast<float>(mm);
}

void setCell(Scan& scan, std::size_t k, double value, double mm, std::uint8_t state) {
    scan.state[k] = static_cast<CellState>(state);
    const bool empty = std::isnan(value) || value == 0;
    if (scan.state[k] == CellState::Valid) {
        if (empty)
            throw wrongCell("range_mm", k, scan.beams(), value, "is not a range, and the state of this cell is valid",
                            "give another state");
        return setRange(scan, k, value, mm);
    }
    if (empty) return;
    if (scan.state[k] != CellState::DeviceStatus || !(mm > 0) || !physical::kRangeMm.hold(mm))
        throw wrongCell("range_mm", k, scan.beams(), value, "is a range, and the state of this cell is not valid",
                        "give NaN or 0 where the state is not 0; only a device status has a code");
    scan.rangeMm[k] = static_cast<float>(mm);
}

void setCells(Scan& scan, const Arrays& arrays) {
    const double* values = arrays.range.data();
    const std::uint8_t* states = arrays.state ? arrays.state->data() : nullptr;
    std::size_t rounded = 0;
    std::set<std::uint32_t> codes;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const bool isCode = states != nullptr && states[k] == static_cast<std::uint8_t>(CellState::DeviceStatus);
        const double mm = values[k] * (isCode ? scan.unitMm : arrays.unitMm); // a code has no unit
        if (states != nullptr)
            setCell(scan, k, values[k], mm, states[k]);
        else
            setRange(scan, k, values[k], mm);
        rounded += mm > kMostExactMm && static_cast<double>(scan.rangeMm[k]) != mm ? 1 : 0;
        if (scan.state[k] == CellState::DeviceStatus) codes.insert(static_cast<std::uint32_t>(std::lround(values[k])));
    }
    codes.erase(0);
    scan.statusCodes.assign(codes.begin(), codes.end());
    if (rounded > 0)
        scan.warnings.push_back(std::to_string(rounded) + " ranges above 16,777 m were rounded to the next number of 4 bytes.");
    if (!arrays.intensity) return;
    scan.intensity = Grid<float>(scan.lines(), scan.beams());
    std::copy_n(arrays.intensity->data(), scan.cells(), scan.intensity.cells.begin());
}

void setTimes(Scan& scan, const std::vector<double>& times) {
    if (times.empty()) return;
    for (std::size_t i = 0; i < times.size(); ++i) {
        constexpr NumberLimits kTimes{0, 4102444800.0}; // 1970 to 2100
        if (!kTimes.hold(times[i]) || (i > 0 && times[i] < times[i - 1]))
            throw Refused{{shortestText(times[i]) + " is not a time", "line_times_s[" + std::to_string(i) + "]",
                           "give ascending seconds since 1970 in UTC, one per line"}};
    }
    auto acquisition = std::make_shared<Acquisition>();
    acquisition->startUtc = utcText(times.front());
    acquisition->endUtc = utcText(times.back());
    acquisition->clockSource = "line_times_s";
    acquisition->lineTimesS = times;
    scan.acquisition = std::move(acquisition);
}

/// Numbers that are accepted and seldom meant: no range, angles without an order, another unit, radians as degrees.
void warnOfSeldomMeant(Scan& scan, const Arrays& arrays) {
    if (std::ranges::find(scan.state.cells, CellState::Valid) == scan.state.cells.end())
        scan.warnings.emplace_back("No cell of this scan has a range.");
    const auto areOrdered = [](const std::vector<double>& degrees) { // also across a whole turn
        bool rise = true, fall = true;
        for (std::size_t n = 1; n < degrees.size(); ++n) {
            const double step = std::remainder(degrees[n] - degrees[n - 1], 360.0);
            rise = rise && step >= 0;
            fall = fall && step <= 0;
        }
        return rise || fall;
    };
    for (const auto& [name, angles] : {std::pair{"beam_deg", &arrays.beamDeg}, {"line_deg", &arrays.lineDeg}}) {
        if (!areOrdered(*angles))
            scan.warnings.push_back(std::string(name) + " neither rises nor falls throughout, and edges are found between neighbours: " +
                                    "sort these angles and the ranges with them.");
    }
    std::ranges::move(files::seldomMeasured(scan, "unit, such as \"mm\" or \"m\""), std::back_inserter(scan.warnings));
    constexpr double kTurn = 6.2832, kWideFan = 1.5;
    constexpr std::size_t kFewestBeams = 16;
    const auto withinTurn = [](const std::vector<double>& angles) {
        return std::ranges::all_of(angles, [](double angle) { return std::abs(angle) <= kTurn; });
    };
    const double fan = arrays.beamDeg.empty() ? 0 : std::abs(arrays.beamDeg.back() - arrays.beamDeg.front());
    if (arrays.beamDeg.size() >= kFewestBeams && fan < 1)
        scan.warnings.push_back("The beams span " + significantText(fan, 2) +
                                " degrees: check that the angles are degrees and not radians.");
    if (arrays.beamDeg.size() >= kFewestBeams && fan >= kWideFan && withinTurn(arrays.beamDeg) && withinTurn(arrays.lineDeg))
        scan.warnings.emplace_back(
            "All angles are below 6.29 degrees, so they may be radians: give numpy.degrees() of them where they are.");
}

ScanObject scanOfArrays(const Arrays& arrays) {
    const auto lines = static_cast<std::uint64_t>(arrays.range.shape(0)), beams = static_cast<std::uint64_t>(arrays.range.shape(1));
    const char* where = "the arrays of Scan()";
    if (lines * beams > files::kMostPoints || !physical::kAlongOneSide.hold(static_cast<double>(std::max(lines, beams))))
        throw Refused{
            {std::to_string(lines) + " lines x " + std::to_string(beams) + " beams are more than any scan has", where, "split them"}};
    valueOf(checkMemory(lines * beams * 24, where));
    Scan scan;
    scan.name = arrays.name;
    scan.format = "array";
    scan.unitMm = arrays.counts ? arrays.unitMm : 1.0;
    scan.rangeMm = Grid<float>(static_cast<int>(lines), static_cast<int>(beams));
    scan.state = Grid<CellState>(static_cast<int>(lines), static_cast<int>(beams), CellState::Valid);
    scan.geometry = PolarGeometry{.beamDeg = arrays.beamDeg,
                                  .lineDeg = arrays.lineDeg,
                                  .axis = arrays.axis == "spin" ? Axis::Spin : Axis::Sweep,
                                  .lineDirection = arrays.lineDirection,
                                  .lineSkewDeg = arrays.lineSkewDeg};
    setCells(scan, arrays);
    setTimes(scan, arrays.lineTimesS);
    valueOf(files::checkMeasured(scan, where));
    warnOfSeldomMeant(scan, arrays);
    if (!arrays.pose.empty()) scan.placement = valueOf(openPlacement(arrays.pose, arrays.calibration, scan, arrays.lineTimesS));
    if (scan.placement) valueOf(files::checkMeasured(scan, where));
    return {std::make_shared<const Scan>(std::move(scan))};
}

ScanObject made(const py::dict& given) {
    const auto text = [&](const char* key) { return py::cast<std::string>(given[key]); };
    const auto numbers = [&](const char* key) { return py::cast<std::vector<double>>(given[key]); };
    Arrays arrays;
    arrays.range = py::cast<Array<double>>(given["range_mm"]);
    if (!given["state"].is_none()) arrays.state = py::cast<Array<std::uint8_t>>(given["state"]);
    if (!given["intensity"].is_none()) arrays.intensity = py::cast<Array<float>>(given["intensity"]);
    arrays.beamDeg = numbers("beam_deg");
    arrays.lineDeg = numbers("line_deg");
    arrays.lineSkewDeg = numbers("line_skew_deg");
    arrays.lineTimesS = numbers("line_times_s");
    arrays.axis = text("axis");
    arrays.name = text("name");
    arrays.pose = text("pose");
    arrays.calibration = text("calibration");
    arrays.lineDirection = py::cast<double>(given["line_direction"]);
    arrays.unitMm = py::cast<double>(given["unit_mm"]);
    arrays.counts = py::cast<bool>(given["counts"]);
    return unlocked([&] { return scanOfArrays(arrays); });
}

/// Scan(...) calls edgescan._arrays.made, which checks the arguments; nothing else makes an object without content.
PyObject* newScan(PyTypeObject* of, PyObject* arguments, PyObject* keywords) {
    if (reinterpret_cast<PyObject*>(of) != py::type::of<ScanObject>().ptr()) {
        PyErr_Format(PyExc_TypeError, "%s: a class cannot be derived from edgescan.Scan", of->tp_name);
        return nullptr;
    }
    try {
        const py::object make = py::module_::import("edgescan._arrays").attr("made");
        return PyObject_Call(make.ptr(), arguments, keywords);
    } catch (py::error_already_set& error) {
        error.restore();
        return nullptr;
    }
}

} // namespace

void bindArrays(py::module_& module) {
    auto* type = reinterpret_cast<PyTypeObject*>(py::type::of<ScanObject>().ptr());
    type->tp_new = newScan;
    type->tp_init = [](PyObject*, PyObject*, PyObject*) { return 0; };
    PyType_Modified(type);
    module.def("scan_of_arrays", &made);
}

} // namespace edgescan::python
