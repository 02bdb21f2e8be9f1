// Escapes text, and writes the frame of a page.
#include "core/exports/html/html.h"

#include "core/base/base64.h"
#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/base/utc_time.h"

#include <nlohmann/json.hpp>

namespace edgescan::exports {
namespace {

#include "assets.inc"

constexpr std::size_t kLongestText = 100'000;

} // namespace

std::string htmlText(std::string_view text) {
    std::string html;
    for (const char c : printable(text, kLongestText)) {
        switch (c) {
        case '&':
            html += "&amp;";
            break;
        case '<':
            html += "&lt;";
            break;
        case '>':
            html += "&gt;";
            break;
        case '"':
            html += "&quot;";
            break;
        case '\'':
            html += "&#39;";
            break;
        default:
            html += c;
        }
    }
    return html;
}

std::string groupedText(std::size_t count) {
    std::string text = std::to_string(count);
    for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, ",");
    return text;
}

std::string legendEntry(const Rgb& c, const std::string& words) {
    return "<span><i style=\"background:rgb(" + std::to_string(c.red) + "," + std::to_string(c.green) + "," + std::to_string(c.blue) +
           ")\"></i>" + words + "</span>";
}

std::string scriptJson(const nlohmann::ordered_json& json) {
    std::string text;
    for (const char c : jsonText(json)) text += c == '<' ? std::string("\\u003c") : c == '>' ? std::string("\\u003e") : std::string(1, c);
    return text;
}

std::string plainUtc(const std::string& time) {
    const auto seconds = parseUtc(time);
    if (!seconds) return time;
    const std::string iso = utcText(*seconds);
    return iso.substr(0, 10) + " " + iso.substr(11, 8) + " UTC";
}

std::string htmlImage(const std::string& png, const std::string& alternative) {
    if (png.empty()) return "<p>There are no cells to show.</p>\n";
    return "<img alt=\"" + htmlText(alternative) + "\" src=\"data:image/png;base64," + base64(png) + "\">\n";
}

std::string htmlPage(const std::string& title, const std::string& body, const std::string& script) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'; "
           "script-src "
           "'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           htmlText(title) + "</title>\n<style>\n" + asset_page_css + "</style>\n</head>\n<body>\n" + body + "<script>\n" + script +
           "</script>\n</body>\n</html>\n";
}

const char* surveyScript() { return asset_survey_js; }
const char* reportScript() { return asset_report_js; }

} // namespace edgescan::exports
