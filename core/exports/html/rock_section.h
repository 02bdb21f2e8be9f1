// The rocks of a report: how many, how large, faces in pictures, and a table of the largest.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/rocks/attributes/faces.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace edgescan::exports {

/// Rows of the table; of more rocks the longest are shown, and the page says so.
inline constexpr std::size_t kMostRockRows = 25;

/// Markup. `faces`: rockFaces() of the study.
[[nodiscard]] std::string rockSection(const edges::Detection& detection, const rocks::Study& study, const rocks::Faces& faces);

/// For the script of the turning view: the colours, and of each rock its colour, whether it is striped, and a sentence.
[[nodiscard]] nlohmann::ordered_json rockFaceData(const rocks::Study& study);

} // namespace edgescan::exports
