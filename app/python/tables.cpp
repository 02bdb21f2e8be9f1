// The core's tables for Python: parameters, reading options, numbers of the simulation. Keywords and their help come from here.
#include "app/python/module.h"

#include "app/lab/sim/simulate.h"
#include "core/base/number_text.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/files/formats/formats.h"
#include "core/files/point_tables/writing_choices.h"
#include "core/scan/grid/reading_options.h"

namespace edgescan::python {
namespace {

py::dict rowOf(const edges::Parameter& p) {
    py::list choices;
    for (const edges::Choice& choice : p.choices) choices.append(choice.name);
    py::dict row;
    row["key"] = p.key;
    row["label"] = p.label;
    row["unit"] = p.unit;
    row["help"] = p.help;
    row["minimum"] = p.minimum;
    row["maximum"] = p.maximum;
    row["default"] = edges::formatValue(p, p.get(edges::Settings{}));
    row["automatic"] = p.automatic != nullptr;
    row["choices"] = choices;
    row["several"] = p.several;
    return row;
}

py::dict rowOf(const ReadingOption& option) {
    using Kind = ReadingOption::Kind;
    py::dict row;
    row["key"] = option.key;
    row["help"] = option.help;
    row["kind"] = option.kind == Kind::Number         ? "number"
                  : option.kind == Kind::ThreeNumbers ? "three numbers"
                  : option.kind == Kind::Whole        ? "whole"
                  : option.kind == Kind::Word         ? "word"
                  : option.kind == Kind::Switch       ? "switch"
                  : option.kind == Kind::Name         ? "name"
                                                      : "path";
    row["choices"] = option.words;
    if (option.limit != nullptr) {
        row["minimum"] = option.limit->limits.least;
        row["maximum"] = option.limit->limits.most;
        row["unit"] = option.limit->unit;
    }
    return row;
}

} // namespace

void bindTables(py::module_& module) {
    module.def("parameters", [] {
        py::list rows;
        for (const edges::Parameter& p : edgescan::edges::parameters()) rows.append(rowOf(p));
        return rows;
    });
    module.def("other_names", [] {
        std::map<std::string, std::string> keys; // by the name of the flag
        for (const edges::Parameter& p : edgescan::edges::parameters()) {
            if (p.name != nullptr) keys[p.name] = p.key;
        }
        return keys;
    });
    module.def("presets", [] {
        std::vector<std::string> names;
        for (const edges::Preset& preset : edges::builtInPresets()) names.push_back(preset.name);
        return names;
    });
    module.def("reading_options", [] {
        py::list rows;
        for (const ReadingOption& option : readingOptionTable()) {
            if ((option.uses & ReadingOption::kFlag) != 0) rows.append(rowOf(option));
        }
        return rows;
    });
    module.def("writing_choices", [] {
        py::list rows;
        for (const files::WritingChoice& choice : files::kWritingChoices)
            rows.append(py::dict(py::arg("key") = choice.key, py::arg("help") = choice.help));
        return rows;
    });
    module.def("simulation_numbers", [] {
        py::list rows;
        const sim::SimulationSettings usual;
        for (const sim::SimulationNumber& number : sim::simulationNumbers())
            rows.append(py::dict(py::arg("key") = number.key, py::arg("minimum") = number.minimum, py::arg("maximum") = number.maximum,
                                 py::arg("default") = number.get(usual)));
        return rows;
    });
}

} // namespace edgescan::python
