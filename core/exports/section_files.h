// A section as a drawing, as a table and as a picture in true scale.
#pragma once

#include "core/exports/export_kinds.h"
#include "core/inspect/section/section.h"

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>

namespace edgescan::exports {

/// By the extension of the input's path: .dxf, .csv or .png. Error: the options have no plane.
Result<std::string> sectionBytes(const ExportInput& input);

/// Rocks that the section of the options cuts, and the box of its vertices in a frame. Nothing without a plane.
struct SectionContent {
    std::size_t rocks = 0;
    Eigen::AlignedBox3d box{};
};
[[nodiscard]] SectionContent sectionContent(const edges::Detection& detection, const ExportOptions& options, CoordinateFrame frame);

/// The plane in a record, and back. Error: damaged.
[[nodiscard]] nlohmann::ordered_json planeRecord(const inspect::SectionPlane& plane);
Result<std::shared_ptr<const inspect::SectionPlane>> planeOf(const nlohmann::ordered_json& record, const std::string& where);

} // namespace edgescan::exports
