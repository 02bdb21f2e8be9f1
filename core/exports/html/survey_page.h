// The survey of an archive: a contact sheet and a table that sorts and filters, in one file.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace edgescan::exports {

/// Pictures of more scans than this are left out, evenly, and the page says so: it stays below 30 MB for any number of pictures.
inline constexpr std::size_t kMostSurveyPictures = 5000;

/// `rows`: of the table, as lines of JSON. `picture`: the PNG of a row's scan, empty where there is none. Rows link to reports, or to the
/// folder of their results, relative to the page.
[[nodiscard]] std::string surveyPage(const std::string& title, const std::vector<std::string>& rows,
                                     const std::function<std::string(const std::string& row)>& picture);

} // namespace edgescan::exports
