// edgescan-cli compare: the changes between two scans of one place, before and after a blast.
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/inputs.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/inspect/change_detection/change_report.h"
#include "core/inspect/registration/placed_scan.h"

#include <array>
#include <nlohmann/json.hpp>

#include <memory>

namespace edgescan::cli {
namespace {

struct CompareFlags {
    std::string before, now, json, picture;
    std::vector<std::string> poses;
    bool bySurfaces = false;
    ReadFlags read;
    MethodFlags method;
};

Result<std::shared_ptr<const edges::Detection>> detected(const CompareFlags& flags, const std::string& file) {
    Result<Scan> scan = openAndWarn(file, flags.read);
    if (!scan) return scan.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *scan); !enough) return enough.error();
    const Result<edges::Settings> settings = settingsFor(flags.method, *scan);
    if (!settings) return settings.error();
    return edges::detectEdges(std::make_shared<const Scan>(std::move(*scan)), *settings);
}

Result<inspect::RegistrationRequest> wishOf(const CompareFlags& flags) {
    inspect::RegistrationRequest wish;
    wish.bySurfaces = flags.bySurfaces;
    if (flags.poses.empty()) return wish;
    const auto before = inspect::open3dtkPose(flags.poses[0]);
    if (!before) return before.error();
    const auto now = inspect::open3dtkPose(flags.poses[1]);
    if (!now) return now.error();
    wish.poses = std::array{*now, *before};
    return wish;
}

Result<Done> checkUsage(const CompareFlags& flags) {
    if (auto method = checkMethodAndWarn(flags.method); !method) return method;
    if (auto distinct = checkDistinct(std::array{flags.json, flags.picture}); !distinct) return distinct;
    return checkOnePose({flags.before, flags.now}, flags.read);
}

Result<Done> compare(const CompareFlags& flags) {
    claimInput(flags.before);
    claimInput(flags.now);
    if (auto can = checkOutputs(std::array{flags.json, flags.picture}); !can) return can;
    const auto wish = wishOf(flags);
    if (!wish) return wish.error();
    const auto before = detected(flags, flags.before);
    if (!before) return before.error();
    const auto now = detected(flags, flags.now);
    if (!now) return now.error();
    const Scan& later = *(*now)->scan;
    if (flags.bySurfaces && flags.poses.empty() && !later.placement && !(*before)->scan->placement)
        printError("--by-surfaces has no effect: no scan has a pose; leave it out.");
    const auto found = inspect::sceneChange({(*now)->scan, (*now)->mask}, {(*before)->scan, (*before)->mask}, *wish);
    if (!found) return found.error();
    if (!flags.picture.empty()) {
        if (const auto saved = containers::savePngRgb(inspect::changePicture(later, *found), flags.picture); !saved) return saved.error();
    }
    if (flags.json != "-" && flags.picture != "-") printResult(inspect::changeText(later, *found));
    if (flags.json.empty()) return Done{};
    nlohmann::ordered_json report{{"before", flags.before}, {"now", flags.now}};
    report.update(inspect::changeReport(later, *found));
    return writeDocument(flags.json, document("compare", report));
}

} // namespace

void addCompare(CLI::App& app, int& code) {
    auto flags = std::make_shared<CompareFlags>();
    CLI::App& command = *app.add_subcommand(
        "compare", "Finds what changed between two scans of one place: edges gained and lost, surfaces nearer and farther");
    command.add_option("BEFORE", flags->before, "The scan before")->required();
    command.add_option("NOW", flags->now, "The scan now")->required();
    addPosesFlag(command, flags->poses);
    command.add_flag("--by-surfaces", flags->bySurfaces, "Line the scans up by their surfaces, also where there are poses");
    addJsonFlag(command, flags->json, "All figures and regions");
    command
        .add_option("--picture", flags->picture,
                    "New PNG on the grid of the scan now: gained, lost and unchanged edges, nearer and farther surfaces")
        ->type_name("FILE")
        ->check(namedAs("a picture", ".png"));
    addMethodFlags(command, flags->method);
    addReadFlags(command, flags->read);
    command.callback([flags, &code] {
        const Result<Done> usage = checkUsage(*flags);
        const Result<Done> result = usage ? compare(*flags) : usage;
        code = result ? kDone : usage ? kRefused : kWrongUsage;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
