// Writes rows as data for the script of the survey.
#include "core/exports/html/survey_page.h"

#include "core/base/base64.h"
#include "core/base/bounded_json.h"
#include "core/base/foreign_text.h"
#include "core/containers/png/png.h"
#include "core/edges/gray/gray.h"
#include "core/exports/html/html.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

// A path as a link from the page: every byte with another meaning in links is written as %XX.
std::string linkOf(const std::string& path) {
    constexpr const char* kHex = "0123456789ABCDEF";
    std::string link;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' || c == '.' || c == '-' ||
                           c == '_' || c == '~';
        if (plain)
            link += c;
        else
            link += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
    }
    return link;
}

bool hasReport(const Json& row) {
    return row.contains("outputs") &&
           std::ranges::any_of(row["outputs"], [](const Json& output) { return output.value("file", "") == "report.html"; });
}

Json numberAt(const Json& row, const char* pointer) {
    const Json::json_pointer at(pointer);
    return row.contains(at) && row.at(at).is_number() ? row.at(at) : Json();
}

// The values of a row for the script, in the order of its columns (assets/survey.js).
Json shownOf(const Json& row, const std::string& picture) {
    const std::string folder = row.value("results", "");
    const bool any = row.contains("outputs") && !row["outputs"].empty();
    const Json lines = numberAt(row, "/lines"), beams = numberAt(row, "/beams"), valid = numberAt(row, "/cells/valid");
    Json share;
    if (lines.is_number() && beams.is_number() && valid.is_number())
        share = valid.get<double>() / std::max(1.0, lines.get<double>() * beams.get<double>());
    return {printable(row.value("input", "")),
            row.value("outcome", ""),
            any ? linkOf(folder) + (hasReport(row) ? "/report.html" : "/") : std::string(),
            row.contains("scanned_utc") && row["scanned_utc"].is_string() ? plainUtc(row["scanned_utc"].get<std::string>()) : std::string(),
            lines,
            beams,
            share,
            numberAt(row, "/edges"),
            numberAt(row, "/noise_mm_at_5_m"),
            row.contains("warnings") ? row["warnings"] : Json::array(),
            row.contains("error") && row["error"].is_string() ? row["error"] : Json(""),
            picture.empty() ? std::string() : base64(picture),
            numberAt(row, "/rocks/rock_count"),
            numberAt(row, "/rocks/size_curve/visible_wide_p50_m"),
            numberAt(row, "/rocks/size_curve/visible_wide_p80_m"),
            numberAt(row, "/rocks/size_curve/visible_wide_top_m")};
}

} // namespace

std::string surveyPage(const std::string& title, const std::vector<std::string>& rows,
                       const std::function<std::string(const std::string& row)>& picture) {
    Json shown = Json::array();
    const std::size_t each = std::max<std::size_t>(1, (rows.size() + kMostSurveyPictures - 1) / kMostSurveyPictures);
    std::string data = "[";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto row = parseOrderedJson(rows[i], "");
        if (!row) continue;
        data += (data.size() > 1 ? ",\n" : "") + scriptJson(shownOf(*row, i % each == 0 ? picture(rows[i]) : std::string()));
    }
    const std::string some =
        each == 1 ? "" : "<p class=\"note\">Pictures of every " + std::to_string(each) + "th scan, so that the page stays small.</p>\n";
    const std::string body =
        "<main>\n<h1>" + htmlText(title) + "</h1>\n<p id=\"summary\"></p>\n" + some +
        "<div id=\"tools\"></div>\n<div id=\"sheet\"></div>\n<div class=\"wide\"><table id=\"table\"></table></div>\n"
        "<p class=\"note\">Edges and rocks are candidates: geometry only, one viewpoint each; sizes are of what is visible.</p>\n"
        "<noscript>This page needs scripts; the same rows are in results.csv.</noscript>\n</main>\n"
        "<script id=\"data\" type=\"application/json\">" +
        data + "]</script>\n";
    return htmlPage(title, body, surveyScript());
}

std::string surveyPicture(const edges::Detection& detection) {
    constexpr int kSide = 96;
    constexpr int kBrightestGround = 150;
    const Grid<std::uint8_t>& gray = detection.gray->levels;
    if (gray.lines <= 0 || gray.beams <= 0) return {};
    const double ratio = std::max({1.0, static_cast<double>(gray.beams) / kSide, static_cast<double>(gray.lines) / kSide});
    Grid<std::uint8_t> small(std::max(1, static_cast<int>(gray.lines / ratio)), std::max(1, static_cast<int>(gray.beams / ratio)));
    for (int y = 0; y < small.lines; ++y) {
        const int firstLine = static_cast<int>(static_cast<std::int64_t>(y) * gray.lines / small.lines);
        const int lastLine = std::max(firstLine + 1, static_cast<int>(static_cast<std::int64_t>(y + 1) * gray.lines / small.lines));
        for (int x = 0; x < small.beams; ++x) {
            const int firstBeam = static_cast<int>(static_cast<std::int64_t>(x) * gray.beams / small.beams);
            const int lastBeam = std::max(firstBeam + 1, static_cast<int>(static_cast<std::int64_t>(x + 1) * gray.beams / small.beams));
            int sum = 0, edges = 0;
            const int cells = (lastLine - firstLine) * (lastBeam - firstBeam);
            for (int i = firstLine; i < lastLine; ++i) {
                for (int j = firstBeam; j < lastBeam; ++j) {
                    sum += gray.at(i, j);
                    edges += detection.mask->at(i, j) != 0 ? 1 : 0;
                }
            }
            const int ground = sum / cells * kBrightestGround / 255;
            const double share = std::sqrt(static_cast<double>(edges) / cells); // so that a line one cell wide remains visible
            small.at(y, x) = static_cast<std::uint8_t>(ground + (255 - ground) * share);
        }
    }
    const auto bytes = containers::png8Bytes(small, "survey");
    return bytes ? *bytes : std::string();
}

} // namespace edgescan::exports
