// The place of a scan that its own file states.
#include "core/files/open_save/written_place.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/scan/georef/chain.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Dense>

#include <limits>
#include <optional>

namespace edgescan::files {

namespace {

constexpr double kMostOffRotation = 1e-3; // of an element of a matrix that is printed with few digits

constexpr double kUnexplained = 3.0; // times the rounding

bool moves(const Eigen::Matrix3d& turn, const Eigen::Vector3d& place) { return !place.isZero(0.0) || !turn.isIdentity(0.0); }

/// Empty when the matrix is not a rotation.
std::optional<Eigen::Matrix3d> nearestRotation(const Eigen::Matrix3d& printed) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(printed, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
    if (!((printed - turn).cwiseAbs().maxCoeff() < kMostOffRotation) || turn.determinant() < 0) return std::nullopt;
    return turn;
}

} // namespace

void placeAsWritten(Scan& scan, const WrittenPlace& written, const Source& source) {
    if (scan.placement || !moves(written.turn, written.place)) return;
    const std::string format = written.format;
    const auto turn = written.fewDigits ? nearestRotation(written.turn) : written.turn;
    if (!turn) {
        scan.warnings.emplace_back("The matrix in the file is not a rotation and shift, so the scan stays in the scanner's frame.");
        return;
    }
    if (!moves(*turn, written.place)) return;
    const Eigen::Vector3d placeM = written.place * (source.options->unitMm.value_or(1000.0) / 1000.0);
    if (!physical::kPlaceM.hold(placeM.x()) || !physical::kPlaceM.hold(placeM.y()) || !physical::kElevationM.hold(placeM.z())) {
        scan.warnings.push_back(withValues(
            "The %1 file puts the scanner at %2, %3, %4 m, which is not a place on earth, so the scan stays in the scanner's frame.",
            {format, significantText(placeM.x(), 6), significantText(placeM.y(), 6), significantText(placeM.z(), 6)}));
        return;
    }
    auto placement = std::make_shared<Placement>();
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    placement->mount.axis = polar != nullptr && polar->axis == Axis::Sweep ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
    placement->originEnhM = chooseOrigin(placeM);
    placement->poses = {{*turn, placeM - placement->originEnhM}};
    placement->grid = withValues("as the %1 file has it", {format});
    placement->source = withValues("the header of %1", {source.path.filename().string()});
    placement->ageSeconds = std::numeric_limits<double>::quiet_NaN();
    placement->warnings = {
        withValues("The place is the one written in the %1 file: whether that is the mine grid, who registered it knows.", {format})};
    scan.placement = std::move(placement);
}

void placeAsFound(Scan& scan, const FreeAxis& found, double metres) {
    const Eigen::Vector3d placeM = found.place * metres;
    const std::string misfit = significantText(found.misfit * metres * 1000.0, 2) + " mm";
    const std::string lever = significantText(found.lever.norm() * metres * 1000.0, 3) + " mm";
    std::string text =
        withValues("The points are in another frame than the scanner's. Their scan lines turn about one axis, at %1, %2, %3 m, and the "
                   "mirror is %4 off the axis",
                   {significantText(placeM.x(), 10), significantText(placeM.y(), 10), significantText(placeM.z(), 10), lever});
    if (found.scale != 1.0) text += withValues("; the grid has the scale %1", {significantText(found.scale, 7)});
    scan.warnings.push_back(withValues("%1. The points fit lines and beams within %2.", {text, misfit}));
    if (found.misfit > kUnexplained * found.precision.absolute)
        scan.warnings.push_back(
            withValues("That is more than the rounding of the numbers explains, %1 mm: ranges may be off, and edges may differ from those "
                       "of the scan. The record of the file, or the scan as it was measured, has them exactly.",
                       {significantText(found.precision.absolute * metres * 1000.0, 2)}));
    auto placement = std::make_shared<Placement>();
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    placement->mount.axis = polar != nullptr && polar->axis == Axis::Sweep ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
    placement->mount.sensorInMover = {found.tilt, found.lever * metres};
    placement->originEnhM = chooseOrigin(placeM);
    placement->poses = {{found.turn.transpose(), placeM - placement->originEnhM}};
    placement->gridScale = found.scale;
    placement->grid = withValues("as the %1 file has it", {scan.format});
    placement->source = "the scan lines of the points";
    placement->ageSeconds = std::numeric_limits<double>::quiet_NaN();
    placement->warnings = {
        "The place was found from the scan lines of the points: whether their frame is the mine grid, the file does not say."};
    scan.placement = std::move(placement);
}

} // namespace edgescan::files
