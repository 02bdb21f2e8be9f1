// The survey of an archive: a contact sheet, and a table that can be sorted and filtered, in one file.
#pragma once

#include "core/edges/pipeline/detection.h"

#include <functional>
#include <string>
#include <vector>

namespace edgescan::exports {

/// Most pictures of a survey. Of more scans, some are left out evenly and the page says so, so that the page is always below 30 MB.
inline constexpr std::size_t kMostSurveyPictures = 5000;

/// `rows`: of the table, as lines of JSON. `picture`: the PNG of a row's scan, empty if there is none. Rows have links to reports, or to
/// the folder of their results, relative to the page.
[[nodiscard]] std::string surveyPage(const std::string& title, const std::vector<std::string>& rows,
                                     const std::function<std::string(const std::string& row)>& picture);

/// The darkened gray levels with white edges: PNG of at most 96 x 96 pixels, in the proportions of the scan. Empty without cells.
[[nodiscard]] std::string surveyPicture(const edges::Detection& detection);

} // namespace edgescan::exports
