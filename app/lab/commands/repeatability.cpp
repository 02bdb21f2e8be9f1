// edgescan-lab repeatability: how many edges of one scan another of the same place has too.
#include "app/lab/commands/commands.h"
#include "app/lab/commands/compared_methods.h"
#include "app/lab/reports/repeat_report.h"
#include "app/shared/outputs.h"
#include "core/edges/pipeline/work_memory.h"

#include <nlohmann/json.hpp>

namespace edgescan::cli {
namespace {

struct Repeatability {
    std::vector<std::string> files; ///< two
    std::vector<std::string> poses; ///< two of 3DTK; empty: both scans need a place in the mine
    double radiusM = 0.1;
    bool refine = false;
    ComparedFlags compared;
};

constexpr double kReachM = 0.5; // how far rough poses may be off

Result<std::shared_ptr<const Scan>> opened(const std::string& file, const ReadFlags& read) {
    Result<Scan> scan = openAndWarn(file, read);
    if (!scan) return scan.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *scan); !enough) return enough.error();
    return std::make_shared<const Scan>(std::move(*scan));
}

Result<std::vector<inspect::PlacedScan>> placed(const Repeatability& asked) {
    std::vector<inspect::PlacedScan> scans;
    std::optional<Eigen::Vector3d> origin;
    for (std::size_t n = 0; n < asked.files.size(); ++n) {
        const auto scan = opened(asked.files[n], asked.compared.read);
        if (!scan) return scan.error();
        if (!asked.poses.empty()) {
            const auto pose = inspect::open3dtkPose(asked.poses[n]);
            if (!pose) return pose.error();
            scans.push_back(inspect::placedBy(*scan, *pose));
            continue;
        }
        if (!(*scan)->placement)
            return Error{"the scan has no place in the mine, so its position relative to the other one is unknown", asked.files[n],
                         "give --poses-3dtk A.pose B.pose, or --pose and --calibration"};
        if (!origin) origin = (*scan)->placement->originEnhM;
        scans.push_back(inspect::placedInMine(*scan, *origin));
    }
    return scans;
}

Result<Done> repeatability(const Repeatability& asked) {
    auto scans = placed(asked);
    if (!scans) return scans.error();
    lab::RepeatRun run;
    run.radiusM = asked.radiusM;
    if (asked.refine) {
        auto alignment = inspect::alignScans((*scans)[0], (*scans)[1], kReachM);
        if (!alignment) return Error{alignment.error().what, asked.files[1], alignment.error().hint};
        (*scans)[1] = inspect::corrected(std::move((*scans)[1]), alignment->correction);
        run.alignment = *alignment;
    }
    lab::ComparisonSettings settings = comparisonSettings(asked.compared);
    settings.repeats = 1;
    run.methods = lab::methodRepeatability((*scans)[0], (*scans)[1], asked.radiusM, settings, shownProgress(asked.compared));
    const std::string& json = asked.compared.json;
    if (json != "-") printResult(lab::repeatText(run));
    if (json.empty()) return Done{};
    nlohmann::ordered_json report{{"inputs", asked.files}};
    report.update(lab::repeatReport(run));
    return writeDocument(json, document("repeatability", report));
}

} // namespace

void addRepeatability(CLI::App& app, int& code) {
    auto asked = std::make_shared<Repeatability>();
    CLI::App& command =
        *app.add_subcommand("repeatability", "Counts how many edges of one scan another scan of the same place has too, per method");
    command.add_option("SCAN", asked->files, "Two scans of one place")->required()->expected(2);
    addPosesFlag(command, asked->poses);
    command.add_flag("--refine", asked->refine, "Fit their surfaces onto each other first, and report their distance");
    addNumber(command, "--match-radius", asked->radiusM, {0.001, 10}, "How near the other one's edge must lie [m]");
    addComparedFlags(command, asked->compared);
    command.callback([asked, &code] {
        if (const std::optional<Error> unknown = unknownKey(asked->compared)) {
            printError(*unknown);
            code = kWrongUsage;
            return;
        }
        const Result<Done> one = checkOnePose(asked->files, asked->compared.read);
        const Result<Done> result = one ? repeatability(*asked) : one;
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
