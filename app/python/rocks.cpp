// Rocks in Python: labels and a row per region. Segments are computed once per result, so another level costs little.
#include "app/python/result.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/rocks/selection/rock_map.h"

#include <nlohmann/json.hpp>

namespace edgescan::python {
namespace {

/// The part that does not depend on the settings.
struct Pieces {
    rocks::Segmentation leaves;
    rocks::MergeTree tree;
};

struct RocksObject {
    std::shared_ptr<const Pieces> pieces;
    std::shared_ptr<const rocks::RegionMap> map;
    std::shared_ptr<const Grid<std::uint32_t>> labels, regions;
};

rocks::RockSettings settingsOf(const std::map<std::string, double>& numbers, const std::string& region) {
    rocks::RockSettings settings;
    for (const rocks::RockParameter& parameter : rocks::rockParameters()) {
        const auto given = numbers.find(parameter.key);
        if (given == numbers.end()) continue;
        const double value = given->second;
        if (!parameter.limits().hold(value))
            throw Refused{
                {shortestText(value) + " is outside " + shortestText(parameter.minimum) + " to " + shortestText(parameter.maximum),
                 parameter.key, "give a value within these limits"}};
        parameter.set(settings, value);
        if (parameter.get(settings) != value)
            throw Refused{{shortestText(value) + " is not a whole number", parameter.key, "give a whole number"}};
    }
    if (!region.empty()) settings.region = taken(rocks::parseRegion(region));
    return settings;
}

RocksObject at(std::shared_ptr<const Pieces> pieces, const rocks::RockSettings& settings) {
    auto map = std::make_shared<const rocks::RegionMap>(rocks::rocksAt(pieces->leaves, pieces->tree, settings));
    auto labels = std::make_shared<const Grid<std::uint32_t>>(rocks::rockLabels(pieces->leaves, *map));
    auto regions = std::make_shared<const Grid<std::uint32_t>>(rocks::regionLabels(pieces->leaves, *map));
    return {std::move(pieces), std::move(map), std::move(labels), std::move(regions)};
}

RocksObject rocks(const ResultObject& result, const std::map<std::string, double>& numbers, const std::string& region) {
    const rocks::RockSettings settings = settingsOf(numbers, region);
    return unlocked([&] {
        auto pieces = std::make_shared<Pieces>();
        pieces->leaves = rocks::segmentRocks(rocks::rockInputs(*whole(result)));
        pieces->tree = rocks::mergeTree(pieces->leaves.count(), pieces->leaves.borders);
        return at(std::move(pieces), settings);
    });
}

py::list tableOf(const rocks::RegionMap& map) {
    py::list rows;
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        const rocks::Region& region = map.regions[n];
        // NaN for a region without a measured cell
        const Eigen::Vector3d centre = region.sums.sumM / static_cast<double>(region.sums.cells);
        rows.append(py::dict(py::arg("label") = n, py::arg("kind") = rocks::regionKindName(region.kind),
                             py::arg("cells") = region.sums.cells, py::arg("area_m2") = region.sums.areaM2,
                             py::arg("long_m") = region.longM, py::arg("x_m") = centre.x(), py::arg("y_m") = centre.y(),
                             py::arg("z_m") = centre.z(), py::arg("evidence") = region.evidence,
                             py::arg("confidence") = region.confidence));
    }
    return rows;
}

} // namespace

void bindRocks(py::module_& module) {
    Class<RocksObject> type(module, "Rocks", "Candidates for rocks at one level: geometry only, from one viewpoint.");
    const auto property = [&](const char* name, const auto& get, const char* help) {
        type.def_property_readonly(
            name, [get](const RocksObject& self) { return get(self); }, help);
    };
    property(
        "count", [](const RocksObject& r) { return r.map->rocks; }, "Number of rocks.");
    property(
        "labels", [](const RocksObject& r) { return gridArray(*r.labels, r.labels); },
        "uint32, lines x beams: 0 none, then the rocks 1 to count, the largest visible area first. No copy, read only.");
    property(
        "regions", [](const RocksObject& r) { return gridArray(*r.regions, r.regions); },
        "uint32, lines x beams: 0 none, else the label of a row of `table`, whatever its kind. No copy, read only.");
    property(
        "table", [](const RocksObject& r) { return tableOf(*r.map); },
        "A dict per region, rocks first: label, kind (rock, not_rock, fines, outside), cells (measured, without spikes), area_m2 (seen, "
        "across the beams), long_m (4 "
        "standard deviations along its longest axis), x_m, y_m, z_m (mean, metres from the sensor), evidence, confidence.");
    property(
        "settings", [](const RocksObject& r) { return objectOf(rocks::rockSettingsToJson(r.map->settings)); }, "What it was made with.");
    type.def("__repr__", [](const RocksObject& r) {
        return "<edgescan.Rocks: " + std::to_string(r.map->rocks) + " rocks at level " + shortestText(r.map->settings.level) + ">";
    });
    module.def("rocks_at", [](const RocksObject& self, double level) {
        rocks::RockSettings settings = self.map->settings;
        settings.level = settingsOf({{"level", level}}, "").level;
        return unlocked([&] { return at(self.pieces, settings); });
    });
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
