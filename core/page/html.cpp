// Escaping, and the frame of a page.
#include "core/page/html.h"

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"

#include <nlohmann/json.hpp>

namespace edgescan {
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

std::string scriptJson(const nlohmann::ordered_json& json) {
    std::string text;
    for (const char c : jsonText(json)) text += c == '<' ? std::string("\\u003c") : c == '>' ? std::string("\\u003e") : std::string(1, c);
    return text;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        std::uint32_t three = static_cast<unsigned char>(bytes[i]) << 16U;
        if (left > 1) three |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + 1])) << 8U;
        if (left > 2) three |= static_cast<unsigned char>(bytes[i + 2]);
        text += kDigits[three >> 18U & 63U];
        text += kDigits[three >> 12U & 63U];
        text += left > 1 ? kDigits[three >> 6U & 63U] : '=';
        text += left > 2 ? kDigits[three & 63U] : '=';
    }
    return text;
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

} // namespace edgescan
