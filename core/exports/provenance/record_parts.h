// What writing and verifying of exports share.
#pragma once

#include "core/exports/provenance/provenance.h"
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

[[nodiscard]] std::optional<ExportContent> exportContentNamed(std::string_view name);

/// SHA-256 of what a scan is to the method: shape, angles, ranges, states, points. The same file opened otherwise gives another.
[[nodiscard]] std::string gridSha256(const Scan& scan);

/// The program and its libraries, with versions: what a record says of who made it.
[[nodiscard]] nlohmann::ordered_json programOfRecords();

/// The record as text, with the SHA-256 of the rest of it at its end.
[[nodiscard]] std::string sealed(nlohmann::ordered_json record);

/// The sidecar with the SHA-256 of the rest of it at its end, and whether it still has the right one.
[[nodiscard]] nlohmann::ordered_json sealedSidecar(nlohmann::ordered_json sidecar);
[[nodiscard]] bool sidecarIsWhole(const nlohmann::ordered_json& sidecar);

/// The scan that the points of an export are taken from: filled cells have ranges where the choices ask for them, and with a selection all
/// other cells are masked.
[[nodiscard]] std::shared_ptr<const Scan> chosenScan(const edges::Detection& detection, const ExportOptions& options);

/// What a record says of a selection: {"cells": n, "runs": [[first, count], ...]}; null for none. And back: empty where it is damaged.
[[nodiscard]] nlohmann::ordered_json selectionRecord(const ExportOptions& options);
[[nodiscard]] std::shared_ptr<const std::vector<std::uint32_t>> selectionOf(const nlohmann::ordered_json& record, std::size_t cells);

/// How many points, and between which corners.
struct PointBounds {
    std::size_t count = 0;
    Eigen::Vector3d leastM = Eigen::Vector3d::Zero();
    Eigen::Vector3d mostM = Eigen::Vector3d::Zero();
};

/// What a cloud should hold. The scan must have the place that the options ask for.
[[nodiscard]] PointBounds pointsToWrite(ExportContent content, const edges::Detection& detection, const ExportOptions& options);

/// What a file of points holds, by the reader of its format; empty when no reader gives the bare points of that format.
Result<std::optional<PointBounds>> pointsWritten(std::string_view bytes, const std::filesystem::path& path);

} // namespace edgescan::exports
