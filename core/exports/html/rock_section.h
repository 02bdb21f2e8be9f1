// The rocks of a report: their number and sizes, pictures with coloured faces, and a table of the largest.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/faces.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace edgescan::exports {

/// Rows of the table: the largest rocks (visible width b), and all over the oversize up to the second number. The page says what is left
/// out.
inline constexpr std::size_t kUsualRockRows = 25, kMostRockRows = 100;

/// Markup. `faces`: rockFaces() of the study. `notebook`: its targets with a name name the rocks of the table; may be null.
[[nodiscard]] std::string rockSection(const edges::Detection& detection, const rocks::Study& study, const rocks::Faces& faces,
                                      const inspect::Notebook* notebook);

/// Data for the script of the rotating view: the colours, and for each rock its colour, whether it is hatched, and its sizes.
[[nodiscard]] nlohmann::ordered_json rockFaceData(const rocks::Study& study);

} // namespace edgescan::exports
