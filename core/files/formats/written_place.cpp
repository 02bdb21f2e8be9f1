// The place of a scan that its own file states.
#include "core/files/formats/written_place.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/scan/georef/chain.h"
#include "core/scan/grid/placement.h"

#include <limits>

namespace edgescan::files {

void placeAsWritten(Scan& scan, const Eigen::Matrix3d& turn, const Eigen::Vector3d& place, const char* format, const Source& source) {
    if (scan.placement || (place.isZero(0.0) && turn.isIdentity(0.0))) return;
    const Eigen::Vector3d placeM = place * (source.options->unitMm.value_or(1000.0) / 1000.0);
    if (!physical::kPlaceM.hold(placeM.x()) || !physical::kPlaceM.hold(placeM.y()) || !physical::kElevationM.hold(placeM.z())) {
        scan.warnings.push_back(std::string("The ") + format + " file puts the scanner at " + significantText(placeM.x(), 6) + ", " +
                                significantText(placeM.y(), 6) + ", " + significantText(placeM.z(), 6) +
                                " m, which is no place on earth, so the scan stays in the scanner's frame.");
        return;
    }
    auto placement = std::make_shared<Placement>();
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    placement->mount.axis = polar != nullptr && polar->axis == Axis::Sweep ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
    placement->originEnhM = chooseOrigin(placeM);
    placement->poses = {{turn, placeM - placement->originEnhM}};
    placement->grid = std::string("as the ") + format + " file has it";
    placement->source = "the header of " + source.path.filename().string();
    placement->ageSeconds = std::numeric_limits<double>::quiet_NaN();
    placement->warnings = {std::string("The place is the one written in the ") + format +
                           " file: whether that is the mine grid, who registered it knows."};
    scan.placement = std::move(placement);
}

} // namespace edgescan::files
