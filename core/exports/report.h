// The content of a scan and the results of the method, as JSON (docs/reference/command-line.md, "JSON of info", "JSON of detect").
#pragma once

#include "core/edges/explain/why.h"
#include "core/edges/pipeline/detection.h"

#include <nlohmann/json_fwd.hpp>

namespace edgescan::exports {

[[nodiscard]] nlohmann::ordered_json whyReport(const edges::Detection& detection, const edges::Why& why);

/// {"valid": n, "no_return": n, ...}; the values add up to lines x beams.
[[nodiscard]] nlohmann::ordered_json cellsReport(const Scan& scan);

/// Axis and angles of the beams and lines, or the position of the sensor.
[[nodiscard]] nlohmann::ordered_json geometryReport(const Scan& scan);

/// The object that `edgescan-cli info` prints for one file.
[[nodiscard]] nlohmann::ordered_json infoReport(const Scan& scan);

/// The object of `edgescan-cli detect --json`. `loadMs`: time that opening took, ms.
[[nodiscard]] nlohmann::ordered_json detectReport(const edges::Detection& detection, double loadMs);

/// Whether the scan was taken as one of rough surfaces, and the shares that say so; null if the method measures no folds, or was not asked.
[[nodiscard]] nlohmann::ordered_json roughnessReport(const edges::Detection& detection);

/// {"jump": n, "convex": n, "concave": n, "border": n, "silhouette": n, "rim": n}, or null if the method does not distinguish classes.
[[nodiscard]] nlohmann::ordered_json classesReport(const edges::Detection& detection);

/// {"strong": n, "weak": n, "folds": n, "unknown": n}: edges by their probability to be the border of a rock; null if the method does not
/// measure the surface.
[[nodiscard]] nlohmann::ordered_json rockBordersReport(const edges::Detection& detection);

/// {"gaps": n, "cells": n, "by_plane": n, "by_line": n, "sd_mm_p50": x}: the filled gaps; `filling` of the scan.
[[nodiscard]] nlohmann::ordered_json filledReport(const GapFilling& filling);

/// The report as text, indented or on one line. Bytes of a path that are not UTF-8 become replacement characters.
[[nodiscard]] std::string reportText(const nlohmann::ordered_json& report, bool indented);

/// SHA-256 of the lines x beams mask bytes, 0 or 255.
[[nodiscard]] std::string maskSha256(const Grid<std::uint8_t>& mask);

} // namespace edgescan::exports
