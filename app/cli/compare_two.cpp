// Two scans of one place.
#include "app/cli/compare_two.h"

#include "app/shared/json_output.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/lab/reports/repeat_report.h"

#include <nlohmann/json.hpp>

namespace edgescan::cli {
namespace {

constexpr double kReachM = 0.5; // how far rough poses may be off

Result<std::shared_ptr<const Scan>> opened(const std::string& file, const ReadFlags& read) {
    Result<Scan> scan = openAndWarn(file, read);
    if (!scan) return scan.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *scan); !enough) return enough.error();
    return std::make_shared<const Scan>(std::move(*scan));
}

Result<std::vector<inspect::PlacedScan>> placed(const CompareTwo& asked) {
    std::vector<inspect::PlacedScan> scans;
    std::optional<Eigen::Vector3d> origin;
    for (std::size_t n = 0; n < asked.files.size(); ++n) {
        const auto scan = opened(asked.files[n], asked.read);
        if (!scan) return scan.error();
        if (!asked.poses.empty()) {
            const auto pose = inspect::open3dtkPose(asked.poses[n]);
            if (!pose) return pose.error();
            scans.push_back(inspect::placedBy(*scan, *pose));
            continue;
        }
        if (!(*scan)->placement)
            return Error{"the scan has no place in the mine, so nobody knows how it lies to the other one", asked.files[n],
                         "give --poses A.pose B.pose, or --pose and --calibration"};
        if (!origin) origin = (*scan)->placement->originEnhM;
        scans.push_back(inspect::placedInMine(*scan, *origin));
    }
    return scans;
}

} // namespace

Result<Done> compareTwo(const CompareTwo& asked, const lab::ComparisonProgress& progress) {
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
    run.methods = lab::methodRepeatability((*scans)[0], (*scans)[1], asked.radiusM, asked.settings, progress);
    if (asked.json != "-") printResult(lab::repeatText(run));
    if (asked.json.empty()) return Done{};
    nlohmann::ordered_json report{{"inputs", asked.files}};
    report.update(lab::repeatReport(run));
    return writeDocument(asked.json, document("compare-two", report));
}

} // namespace edgescan::cli
