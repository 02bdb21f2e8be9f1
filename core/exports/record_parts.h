// Functions for both writing and verifying exports.
#pragma once

#include "core/exports/provenance.h"
#include "core/files/open_save/sidecar_grid.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::exports {

inline constexpr const char* kRecordFormat = "edgescan-record/1";

/// SHA-256 of the parts of a scan that affect the method: shape, angles, ranges, states, points. The same file opened with other options
/// has another hash.
[[nodiscard]] std::string gridSha256(const Scan& scan);

/// The program and its libraries with versions, for the record.
[[nodiscard]] nlohmann::ordered_json programOfRecords();

/// The record as text, with the SHA-256 of all other parts at its end.
[[nodiscard]] std::string sealed(nlohmann::ordered_json record);

/// The sidecar with the SHA-256 of all other parts at its end, and a check of this hash.
[[nodiscard]] nlohmann::ordered_json sealedSidecar(nlohmann::ordered_json sidecar);
[[nodiscard]] bool sidecarIsWhole(const nlohmann::ordered_json& sidecar);

/// The scan from which the points of an export are taken: filled cells have ranges if the choices ask for this, and with a selection all
/// other cells are masked.
[[nodiscard]] std::shared_ptr<const Scan> chosenScan(const edges::Detection& detection, const ExportOptions& options);

/// The selection in a record: {"cells": n, "runs": [[first, count], ...]}; null without a selection. And the reverse: empty if it is
/// damaged.
[[nodiscard]] nlohmann::ordered_json selectionRecord(const ExportOptions& options);
[[nodiscard]] std::shared_ptr<const std::vector<std::uint32_t>> selectionOf(const nlohmann::ordered_json& record, std::size_t cells);

/// The number of points, and the corners of their bounding box.
struct PointBounds {
    std::size_t count = 0;
    Eigen::Vector3d leastM = Eigen::Vector3d::Zero();
    Eigen::Vector3d mostM = Eigen::Vector3d::Zero();
};

/// The expected points of a cloud. The scan must have the placement that the options ask for.
[[nodiscard]] PointBounds pointsToWrite(ExportContent content, const edges::Detection& detection, const ExportOptions& options);

/// The points in a file, read by the reader of its format; empty if the format has no reader for bare points.
Result<std::optional<PointBounds>> pointsWritten(std::string_view bytes, const std::filesystem::path& path);

} // namespace edgescan::exports
