// Rocks in Python: labels and a row per rock. Segments are computed once per result, so another level costs little.
#include "app/python/result.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/open_save/save_scan.h"
#include "core/rocks/attributes/rock_columns.h"

#include <nlohmann/json.hpp>

#include <span>
#include <variant>

namespace edgescan::python {
namespace {

struct RocksObject {
    std::shared_ptr<const rocks::Study> study;
    std::shared_ptr<const Grid<std::uint32_t>> labels, regions;
    std::vector<std::string> warnings;
};

rocks::RockSettings settingsOf(const std::map<std::string, double>& numbers, const std::string& region) {
    rocks::RockSettings settings;
    for (const rocks::RockParameter& parameter : rocks::rockParameters()) {
        const auto given = numbers.find(parameter.key);
        if (given == numbers.end()) continue;
        const double value = given->second;
        const std::string where = std::string("--") + parameter.key;
        if (!parameter.limits().hold(value))
            throw Refused{
                {shortestText(value) + " is outside " + shortestText(parameter.minimum) + " to " + shortestText(parameter.maximum), where,
                 "give a value within these limits"}};
        parameter.set(settings, value);
        if (parameter.get(settings) != value) throw Refused{{shortestText(value) + " is not a whole number", where, "give a whole number"}};
    }
    if (!region.empty()) settings.region = valueOf(rocks::parseRegion(region));
    return settings;
}

RocksObject rocksOf(rocks::Study made, const std::vector<std::string>& warnings) {
    auto study = std::make_shared<const rocks::Study>(std::move(made));
    auto labels = std::make_shared<const Grid<std::uint32_t>>(rocks::rockLabels(*study->segmentation, study->map));
    auto regions = std::make_shared<const Grid<std::uint32_t>>(rocks::regionLabels(*study->segmentation, study->map));
    return {std::move(study), std::move(labels), std::move(regions), warnings};
}

RocksObject rocks(const ResultObject& result, const std::map<std::string, double>& numbers, const std::string& region) {
    const rocks::RockSettings settings = settingsOf(numbers, region);
    const Grid<std::uint8_t>& mask = *result.detection->mask;
    std::vector<std::string> warnings;
    if (!settings.region.empty() && !valueOf(rocks::isRegionInside(settings.region, mask.lines, mask.beams)))
        warnings.emplace_back("A part of the region is outside of the scan; the rest counts.");
    return unlocked([&] { return rocksOf(rocks::studyRocks(rocks::rockInputs(*whole(result)), settings), warnings); });
}

RocksObject atLevel(const RocksObject& self, double level) {
    rocks::RockSettings settings = self.study->settings;
    settings.level = settingsOf({{"level", level}}, "").level;
    return unlocked(
        [&] { return rocksOf(rocks::studyRocks(self.study->segmentation->inputs, settings, {}, self.study.get()), self.warnings); });
}

/// Error: the rocks are those of a scan with other ranges.
void checkSameScan(const RocksObject& self, const ResultObject& result) {
    const Scan &one = *self.study->segmentation->inputs.scan, &other = *result.detection->scan;
    if (&one == &other || (one.lines() == other.lines() && one.beams() == other.beams() && one.state.cells == other.state.cells &&
                           one.rangeMm.cells == other.rangeMm.cells))
        return;
    throw Refused{{"the rocks are of another scan", "rocks", "give those that edgescan.rocks() finds in this result"}};
}

struct AsPython {
    py::object operator()(std::monostate) const { return py::none(); }
    py::object operator()(std::span<const std::uint32_t> list) const {
        py::list rocks;
        for (const std::uint32_t rock : list) rocks.append(rock);
        return rocks;
    }
    template <class Value>
    py::object operator()(const Value& value) const {
        return py::cast(value);
    }
};

py::list tableOf(const RocksObject& self, const std::string& name) {
    const Scan& scan = *self.study->segmentation->inputs.scan;
    const CoordinateFrame frame = name == "auto" ? files::usualFrame(scan) : frameOf(scan, name);
    const rocks::RockRows rows(*self.study, frame);
    py::list table;
    for (const rocks::Rock& rock : self.study->rocks) {
        const rocks::RockRow row = rows.of(rock);
        py::dict values;
        for (const rocks::RockColumn& column : rocks::rockColumns(frame)) values[column.key] = std::visit(AsPython{}, column.value(row));
        table.append(values);
    }
    return table;
}

py::list regionTableOf(const rocks::RegionMap& map) {
    py::list rows;
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        const rocks::Region& region = map.regions[n];
        rows.append(py::dict(py::arg("region") = n, py::arg("kind") = rocks::regionKindName(region.kind),
                             py::arg("cells") = region.sums.cells, py::arg("visible_area_m2") = region.sums.areaM2,
                             py::arg("four_sd_m") = region.longM, py::arg("evidence") = region.evidence,
                             py::arg("confidence") = region.confidence));
    }
    return rows;
}

std::string tableHelp() {
    std::string help =
        "A dict per rock, the columns of `edgescan-cli rocks --csv`: coordinates in the mine grid where the scan has a place, "
        "otherwise in the scanner's frame.\n";
    for (const rocks::RockColumn& column : rocks::rockColumns(CoordinateFrame::Mine))
        help += "\n    " + std::string(column.key) + ": " + column.help;
    return help;
}

} // namespace

void bindRocks(py::module_& module) {
    const std::string tables = tableHelp();
    Class<RocksObject> type(module, "Rocks", "Candidates for rocks at one level: geometry only, from one viewpoint.");
    const auto property = [&](const char* name, const auto& get, const char* help) {
        type.def_property_readonly(
            name, [get](const RocksObject& self) { return get(self); }, help);
    };
    property(
        "count", [](const RocksObject& r) { return r.study->map.rocks; }, "Number of rocks.");
    property(
        "labels", [](const RocksObject& r) { return gridArray(*r.labels, r.labels); },
        "uint32, lines x beams: 0 none, then the rocks 1 to count, the largest visible area first. No copy, read only.");
    property(
        "regions", [](const RocksObject& r) { return gridArray(*r.regions, r.regions); },
        "uint32, lines x beams: 0 none, else `region` of a row of `region_table`, whatever its kind. No copy, read only.");
    property(
        "table", [](const RocksObject& r) { return tableOf(r, "auto"); }, tables.c_str());
    property(
        "region_table", [](const RocksObject& r) { return regionTableOf(r.study->map); },
        "A dict per region, rocks first: region, kind (rock, not_rock, fines, outside), cells (measured, without spikes), visible_area_m2 "
        "(across the beams), four_sd_m (4 standard deviations of its points along their longest axis), evidence, confidence.");
    property(
        "settings", [](const RocksObject& r) { return objectOf(rocks::rockSettingsToJson(r.study->settings)); }, "What it was made with.");
    property(
        "warnings", [](const RocksObject& r) { return r.warnings; }, "Sentences about the region.");
    type.def("__repr__", [](const RocksObject& r) {
        return "<edgescan.Rocks: " + std::to_string(r.study->map.rocks) + " rocks at level " + shortestText(r.study->settings.level) + ">";
    });
    module.def("rocks_at", &atLevel);
    module.def("rocks_of_scan", &checkSameScan);
    module.def("rocks_table", &tableOf);
    module.def("rocks", &rocks);
    module.def("rock_parameters", [] {
        py::list rows;
        const rocks::RockSettings usual;
        for (const rocks::RockParameter& p : rocks::rockParameters())
            rows.append(py::dict(py::arg("key") = p.key, py::arg("help") = p.help, py::arg("unit") = p.unit, py::arg("minimum") = p.minimum,
                                 py::arg("maximum") = p.maximum, py::arg("default") = shortestText(p.get(usual))));
        return rows;
    });
}

} // namespace edgescan::python
