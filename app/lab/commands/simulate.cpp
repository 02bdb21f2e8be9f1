// edgescan-lab simulate: writes a simulated sweep as a raw grid.
#include "app/lab/sim/simulate.h"
#include "app/lab/commands/commands.h"
#include "app/lab/sim/truth/truth_files.h"
#include "app/lab/sim/wall_kinds.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/cloud_points.h"
#include "core/files/open_save/save_scan.h"

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace edgescan::cli {
namespace {

struct Simulate {
    std::string out, truth, surface;
    std::string hole; ///< empty: no hole; round if other flags of holes are given
    std::string profile = "high";
    std::string axis = "sweep";
    bool noFootprint = false, noMixedPixels = false, noEchoLoss = false;
    bool progress = false;
    bool holesTyped = false;
    sim::SimulationSettings settings;
};

sim::SimulationSettings settingsOf(const Simulate& simulate) {
    sim::SimulationSettings settings = simulate.settings;
    settings.profile = simulate.profile == "high" ? sim::DeviceProfile::HighResolution : sim::DeviceProfile::Standard;
    settings.axis = simulate.axis == "spin" ? Axis::Spin : Axis::Sweep;
    settings.truth = !simulate.truth.empty();
    settings.hole = simulate.hole == "round"    ? sim::WallHole::Round
                    : simulate.hole == "square" ? sim::WallHole::Square
                                                : sim::WallHole::None;
    if (simulate.hole.empty() && simulate.holesTyped) settings.hole = sim::WallHole::Round;
    settings.surfaceFile = simulate.surface;
    settings.footprint = !simulate.noFootprint;
    settings.mixedPixels = !simulate.noMixedPixels;
    settings.echoLoss = !simulate.noEchoLoss;
    return settings;
}

int run(const Simulate& simulate) {
    const exports::ExportKind& whole = exports::exportKind(exports::ExportContent::WholeScan);
    if (const auto known = exports::checkExtension(whole, simulate.out, simulate.out, ", "); !known)
        return failWith(known.error(), kWrongUsage);
    sim::SimulationProgress progress;
    if (simulate.progress || isatty(STDERR_FILENO) != 0) {
        progress = [](double fraction) {
            showProgress("casting beams " + rightAligned(fixedText(fraction * 100, 0), 3) + " %", fraction >= 1.0);
            return true;
        };
    }
    sim::SimulationSettings settings = settingsOf(simulate);
    if (!simulate.surface.empty()) {
        Result<std::vector<Eigen::Vector3f>> surface = files::cloudPoints(simulate.surface);
        if (!surface) return failWith(surface.error());
        settings.surface = std::move(*surface);
    }
    const Result<sim::Simulation> simulation = edgescan::sim::simulate(settings, progress);
    if (!simulation) return failWith(simulation.error(), kWrongUsage);
    Result<Done> saved = files::saveScan(simulation->scan, simulate.out);
    if (saved && settings.truth) saved = sim::writeTruth(*simulation, settings, simulate.truth);
    const Scan& scan = simulation->scan;
    printError(saved ? std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) + " beams; written to " +
                           placesText({simulate.out}) + (settings.truth ? ", the truth to " + printable(simulate.truth) : "") + "."
                     : saved.error().sentence());
    return saved ? kDone : kRefused;
}

/// Reports a typed flag that has no effect in the chosen scene.
std::optional<Error> idleFlag(const CLI::App& command, const Simulate& simulate) {
    const auto typed = [&](const std::string& key) { return command.count("--" + key) > 0; };
    if (auto idle = sim::idleIn(simulate.settings.scene, typed)) return idle;
    if (simulate.hole == "none" && (typed("hole-count") || typed("hole-size"))) return sim::noHoles();
    return std::nullopt;
}

std::string sceneHelp() {
    std::string text = "What is scanned:";
    for (const sim::SimulationScene& scene : sim::simulationScenes()) text += std::string(" ") + scene.name + " (" + scene.help + ")";
    return text;
}

std::string wallKindHelp() {
    std::string text = "Wall of the bell:";
    for (const sim::WallKind& kind : sim::wallKinds()) text += std::string(" ") + kind.name + " (" + kind.help + ")";
    return text;
}

/// Adds the flag of a row of simulationNumbers().
CLI::Option& add(CLI::App& command, const char* group, std::string_view key, sim::SimulationSettings& settings) {
    const sim::SimulationNumber& row = *std::ranges::find(sim::simulationNumbers(), key, &sim::SimulationNumber::key);
    const std::string flag = std::string("--") + row.key;
    const auto parse = [&row, &settings, flag](const std::string& text) {
        row.set(settings, numberTyped(flag, text, row.limits(), row.decimals == 0, row.unit));
    };
    CLI::Option& option =
        *command.add_option_function<std::string>(flag, parse, row.help)->type_name(rangeName(row.limits()))->group(group);
    std::string usual;
    appendShortest(usual, row.get(settings));
    return *option.default_str(usual);
}

void addSceneFlags(CLI::App& command, Simulate& simulate) {
    const char* group = "Scene";
    sim::SimulationSettings& s = simulate.settings;
    command
        .add_flag("--after-blast", s.afterBlast, "The hang-up after a blast: some rocks gone, others fallen or slid, the rest as before")
        ->group(group);
    add(command, group, "rock-count", s);
    add(command, group, "rock-roughness", s);
    add(command, group, "rock-rounding", s);
    add(command, group, "rock-size", s);
    add(command, group, "rock-lumps", s);
    add(command, group, "rock-lump-size", s);
    command.add_option("--wall-kind", s.wallKind, wallKindHelp())->type_name("NAME")->capture_default_str()->group(group);
    add(command, group, "wall-roughness", s).default_str(""); // the scene decides
    add(command, group, "absorbing-patches", s);
    command.add_option("--surface", simulate.surface, "Cloud of a real surface, seen from above, for the scene rescan")->group(group);
    add(command, group, "surface-scale", s);
    add(command, group, "distance", s);
    command
        .add_option("--hole-shape", simulate.hole, "Open holes in the wall; round where --hole-count or --hole-size is given, else none")
        ->check(CLI::IsMember({"none", "round", "square"}))
        ->group(group);
    add(command, group, "hole-count", s);
    add(command, group, "hole-size", s);
}

void addMeasurementFlags(CLI::App& command, Simulate& simulate) {
    const char* group = "Measurement";
    sim::SimulationSettings& s = simulate.settings;
    add(command, group, "noise", s);
    add(command, group, "dropouts", s);
    add(command, group, "dust", s);
    add(command, group, "line-jitter", s);
    add(command, group, "interlace", s);
    add(command, group, "motor-skew", s);
    add(command, group, "slips", s);
    add(command, group, "status-codes", s);
    add(command, group, "range-step", s);
    add(command, group, "max-range", s);
    command.add_flag("--no-footprint", simulate.noFootprint, "The beam is a line without width")->group(group);
    command.add_flag("--no-mixed-pixels", simulate.noMixedPixels, "Echoes of two surfaces never merge")->group(group);
    command.add_flag("--no-echo-loss", simulate.noEchoLoss, "Grazing and weak echoes are not lost")->group(group);
}

/// Mounting errors that a calibration estimates (docs/reference/calibration.md).
void addAssemblyFlags(CLI::App& command, sim::SimulationSettings& s) {
    const char* group = "Mounting errors, unknown to the scan";
    add(command, group, "mount-t1", s);
    add(command, group, "mount-t2", s);
    add(command, group, "mount-tilt", s);
    add(command, group, "mount-index", s);
    add(command, group, "turn-error", s);
    add(command, group, "zero-jump", s);
}

} // namespace

void addSimulate(CLI::App& app, int& code) {
    auto simulate = std::make_shared<Simulate>();
    sim::SimulationSettings& s = simulate->settings;
    CLI::App& command =
        *app.add_subcommand("simulate", "Simulates a sweep of an LMS511 in a draw-bell; the same seed gives the same bytes");
    command
        .add_option("-o,--output", simulate->out, "New file: " + files::writtenExtensions(true) + " (.json: raw grid, .mcap: recording)")
        ->type_name("FILE")
        ->required();
    command.add_option("--truth", simulate->truth, "Folder for the ground truth: edge classes, objects, faces, clean ranges, rocks, scene")
        ->type_name("DIR");
    command.add_option("--scene", s.scene, sceneHelp())->type_name("NAME")->capture_default_str();
    const char* general = "Options"; // CLI11's group for flags without a group
    addNumber(command, "--seed", s.seed, {0, 999999999999999}, "Seed of everything random");
    add(command, general, "sweep-number", s);
    add(command, general, "lines", s);
    add(command, general, "turn", s);
    add(command, general, "beams", s);
    command.add_option("--axis", simulate->axis, "Mounting of the stepper")->check(CLI::IsMember({"spin", "sweep"}))->capture_default_str();
    command.add_option("--profile", simulate->profile, "Beam divergence: high (resolution, 4.6 mrad) or standard (11 mrad)")
        ->check(CLI::IsMember({"high", "standard"}))
        ->capture_default_str();
    addSceneFlags(command, *simulate);
    addMeasurementFlags(command, *simulate);
    addAssemblyFlags(command, s);
    add(command, general, "threads", s);
    command.add_flag("--progress", simulate->progress, "Show the progress on stderr, also where that is not a terminal");
    command.callback([simulate, &command, &code] {
        if (const std::optional<Error> wrong = idleFlag(command, *simulate)) {
            printError(*wrong);
            code = kWrongUsage;
            return;
        }
        simulate->holesTyped = command.count("--hole-count") + command.count("--hole-size") > 0;
        code = run(*simulate);
    });
}

} // namespace edgescan::cli
