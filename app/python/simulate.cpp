// The simulator in Python.
#include "app/python/module.h"

#include "app/lab/sim/truth/truth_files.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <charconv>

namespace edgescan::python {
namespace {

struct SimulationObject {
    std::shared_ptr<const sim::Simulation> simulation;
    ScanPtr scan; ///< the simulated scan
    sim::SimulationSettings settings;
};

/// Error: the simulation was made without truth.
Result<sim::TruthSet> truthOf(const SimulationObject& object) {
    if (!object.simulation->truth) return Error{"it was made without ground truth", "the simulation", "simulate with truth=True"};
    return sim::truthSetOf(*object.simulation);
}

/// The index of a word among the allowed words of a setting.
std::size_t wordOf(const std::string& key, const std::string& text, const std::vector<std::string>& words) {
    const auto found = std::ranges::find(words, text);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
    throw Refused{{"\"" + text + "\" is not one of its values", "--" + key, "use one of " + all}};
}

void setNumber(sim::SimulationSettings& settings, const sim::SimulationNumber& number, double value) {
    const std::string where = std::string("--") + number.key;
    if (!number.limits().hold(value))
        throw Refused{{shortestText(value) + " is out of reason", where,
                       "give " + shortestText(number.minimum) + " to " + shortestText(number.maximum)}};
    number.set(settings, value);
    if (number.get(settings) != value) throw Refused{{shortestText(value) + " is not a whole number", where, "give a whole number"}};
}

void setWord(sim::SimulationSettings& s, const std::string& key, const std::string& text) {
    const auto on = [&] { return wordOf(key, text, {"off", "on"}) == 1; };
    if (key == "scene")
        s.scene = text;
    else if (key == "axis")
        s.axis = wordOf(key, text, {"spin", "sweep"}) == 0 ? Axis::Spin : Axis::Sweep;
    else if (key == "profile")
        s.profile = wordOf(key, text, {"high", "standard"}) == 0 ? sim::DeviceProfile::HighResolution : sim::DeviceProfile::Standard;
    else if (key == "hole-shape")
        s.hole =
            std::array{sim::WallHole::None, sim::WallHole::Round, sim::WallHole::Square}[wordOf(key, text, {"none", "round", "square"})];
    else if (key == "wall-kind")
        s.wallKind = text;
    else if (key == "footprint")
        s.footprint = on();
    else if (key == "mixed-pixels")
        s.mixedPixels = on();
    else if (key == "echo-loss")
        s.echoLoss = on();
    else if (key == "after-blast")
        s.afterBlast = on();
    else if (key == "truth")
        s.truth = on();
    else
        throw Refused{{"the simulation has no such setting", key, "see help(edgescan.simulate)"}};
}

SimulationObject make(std::uint64_t seed, const std::map<std::string, double>& numbers, const Typed& words, const ScanObject* surface) {
    SimulationObject object;
    sim::SimulationSettings& settings = object.settings;
    settings.seed = seed;
    for (const sim::SimulationNumber& number : sim::simulationNumbers()) {
        if (const auto given = numbers.find(number.key); given != numbers.end()) setNumber(settings, number, given->second);
    }
    for (const auto& [key, text] : words) setWord(settings, key, text);
    const auto given = [&](const std::string& key) {
        return numbers.contains(key) || (words.contains(key) && words.at(key) != "off") || (key == "surface" && surface != nullptr);
    };
    if (const auto idle = sim::idleIn(settings.scene, given)) throw Refused{*idle};
    const bool ofHoles = numbers.contains("hole-count") || numbers.contains("hole-size");
    if (ofHoles && words.contains("hole-shape") && settings.hole == sim::WallHole::None) throw Refused{sim::noHoles()};
    // As on the command line: holes are round by default.
    if (!words.contains("hole-shape") && ofHoles) settings.hole = sim::WallHole::Round;
    Result<sim::Simulation> made = unlocked([&] {
        if (surface != nullptr) {
            const CartesianTables tables(*surface->scan);
            for (std::size_t k = 0; k < surface->scan->cells(); ++k) {
                if (surface->scan->state[k] == CellState::Valid) settings.surface.emplace_back(tables.point(k).cast<float>());
            }
            for (const AttachedPoint& point : surface->scan->attached) settings.surface.emplace_back(point.pointM.cast<float>());
            settings.surfaceFile = surface->scan->path;
        }
        return sim::simulate(settings, [](double) { return noSignal(); });
    });
    raiseSignal();
    object.simulation = std::make_shared<const sim::Simulation>(valueOf(std::move(made)));
    object.scan = ScanPtr(object.simulation, &object.simulation->scan);
    return object;
}

/// The truth's grids as arrays; the keys are the names of the files that the command line writes.
py::dict truthArrays(const SimulationObject& object) {
    const auto set = unlocked([&] { return std::make_shared<const sim::TruthSet>(valueOf(truthOf(object))); });
    const sim::SimulationTruth& truth = *object.simulation->truth;
    py::dict arrays;
    arrays["edge_class"] = gridArray(set->edges.edgeClass, set);
    arrays["ignore"] = gridArray(set->edges.ignore, set);
    arrays["object"] = gridArray(truth.object, object.simulation);
    arrays["face"] = gridArray(truth.face, object.simulation);
    arrays["clean_mm"] = gridArray(truth.cleanMm, object.simulation);
    return arrays;
}

} // namespace

void bindSimulate(py::module_& module) {
    Class<SimulationObject>(module, "Simulation", "A simulated scan, and its ground truth where it was asked for.")
        .def_property_readonly(
            "scan", [](const SimulationObject& self) { return ScanObject{self.scan}; }, "The scan.")
        .def_property_readonly("truth", &truthArrays,
                               "A dict of arrays of lines x beams, read only: edge_class (uint8: 0 none, 1 occluding, 2 contact, "
                               "3 crease, 4 void), ignore (uint8: 255 = not scored), object (uint16: 0 none, 1 wall, 2... rocks), face "
                               "(uint16), clean_mm (float32, mm: ranges without noise). Error if it was not asked for.")
        .def("__repr__", [](const SimulationObject& self) {
            return "<edgescan.Simulation of seed " + std::to_string(self.settings.seed) + ": " + std::to_string(self.scan->lines()) +
                   " lines x " + std::to_string(self.scan->beams()) + " beams>";
        });
    module.def("save_truth", [](const SimulationObject& self, const std::string& folder) {
        unlocked([&] {
            if (!self.simulation->truth) valueOf(truthOf(self));
            return valueOf(sim::writeTruth(*self.simulation, self.settings, folder));
        });
    });
    module.def("simulate", &make, py::arg("seed"), py::arg("numbers"), py::arg("words"), py::arg("surface").none(true));
}

} // namespace edgescan::python
