// edgescan-lab stones: a scan of a heap of real stones, with its truth.
#include "app/lab/commands/commands.h"
#include "app/lab/stones/stone_scene.h"
#include "app/shared/options.h"
#include "core/base/number_text.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/save_scan.h"

#include <unistd.h>

#include <array>
#include <memory>

namespace edgescan::cli {
namespace {

struct StonesAsked {
    std::string stones, out, truth;
    lab::StoneScene scene;
    int threads = 0;
};

/// "2 % occluding, 3 % contact, ...": shares of all cells.
std::string truthText(const sim::EdgeTruth& truth) {
    constexpr std::array<const char*, 5> kNames{"", "occluding", "contact", "crease", "next to the open"};
    std::array<std::size_t, 5> count{};
    std::size_t ignored = 0;
    for (std::size_t k = 0; k < truth.edgeClass.size(); ++k) {
        ++count[truth.edgeClass[k]];
        ignored += truth.ignore[k] != 0 ? 1 : 0;
    }
    const auto share = [&](std::size_t cells) {
        return fixedText(100.0 * static_cast<double>(cells) / static_cast<double>(truth.edgeClass.size()), 1) + " % ";
    };
    std::string text = "of the cells ";
    for (std::size_t n = 1; n < count.size(); ++n) text += share(count[n]) + kNames[n] + ", ";
    return text + share(ignored) + "not scored";
}

Result<Done> scanStones(const StonesAsked& asked) {
    const exports::ExportKind& whole = exports::exportKind(exports::ExportContent::WholeScan);
    if (auto known = exports::checkExtension(whole, asked.out, asked.out, ", "); !known) return known;
    const auto stones = lab::readStones(asked.stones, asked.scene.set, asked.threads);
    if (!stones) return stones.error();
    lab::StoneProgress progress;
    if (isatty(STDERR_FILENO) != 0) {
        progress = [](double fraction) {
            showProgress("stones " + rightAligned(fixedText(fraction * 100, 0), 3) + " %", fraction >= 1.0);
            return true;
        };
    }
    const auto made = lab::stoneScan(asked.scene, *stones, asked.threads, progress);
    if (!made) return made.error();
    const Scan& scan = made->simulation.scan;
    if (auto saved = files::saveScan(scan, asked.out); !saved) return saved;
    if (!asked.truth.empty()) {
        if (auto written = sim::writeTruthSet(made->truth, asked.truth); !written) return written;
        if (auto written = sim::writeRockList(made->simulation, asked.truth); !written) return written;
    }
    printResult(scan.name + ": " + std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) + " beams, " +
                truthText(made->truth.edges));
    return Done{};
}

} // namespace

void addStones(CLI::App& app, int& code) {
    auto asked = std::make_shared<StonesAsked>();
    lab::StoneScene& scene = asked->scene;
    CLI::App& command = *app.add_subcommand(
        "stones", "Lets scanned stones fall into a heap and scans it with the errors of an LMS511; the true edges are known");
    command.add_option("--stones", asked->stones, "Folder of the stones: rocks.json and an NPZ file for each")
        ->type_name("DIR")
        ->required();
    command
        .add_option("--kind", scene.kind,
                    "bench: a heap on a floor, from above; hangup: stones held in a bell, from below; pile: muck at a draw point")
        ->check(CLI::IsMember(lab::siteKinds()))
        ->capture_default_str();
    command.add_option("--set", scene.set, "free: stones that weights may learn from; lab: those that only judge; all: both")
        ->check(CLI::IsMember(lab::stoneSets()))
        ->capture_default_str();
    addNumber(command, "--seed", scene.seed, {0, 999999999999999}, "Seed of everything random");
    addNumber(command, "--view", scene.view, {0, 1000}, "0, or the same heap from a moved scanner");
    addNumber(command, "--noise", scene.noise, {0, 100}, "Times the range noise of the device");
    command.add_flag("--carved", scene.carved, "Facets, scoops and scars that the scanned stones did not have");
    command.add_flag("--full", scene.full, "800 lines x 1000 beams instead of 400 x 500");
    command.add_flag("--spin", scene.spin, "The scanner turns about its viewing direction");
    command.add_option("--settled", scene.settled, "Folder where the settled heap is read from, or else stored")->type_name("DIR");
    command.add_option("-o,--output", asked->out, "New file: " + files::writtenExtensions(true))->type_name("FILE")->required();
    command.add_option("--truth", asked->truth, "Folder for the ground truth: edge classes, objects, clean ranges, stones")
        ->type_name("DIR");
    addNumber(command, "--threads", asked->threads, {0, 1024}, "0 = one per core; the result is the same");
    command.callback([asked, &code] {
        const Result<Done> result = scanStones(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
