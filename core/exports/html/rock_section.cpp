// Writes rocks as markup.
#include "core/exports/html/rock_section.h"

#include "core/base/number_text.h"
#include "core/exports/html/html.h"
#include "core/exports/html/scan_pictures.h"
#include "core/rocks/attributes/size_curve.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFacePixels = 900;                             // along a side
constexpr int kRockCloudWidth = 800, kRockCloudHeight = 512; // px
constexpr int kCurveWidth = 640, kCurveHeight = 230;         // in units of the drawing
constexpr int kCurveLeft = 46, kCurveRight = 20, kCurveTop = 10, kCurveBottom = 34;

std::string twoDecimals(double m) { return fixedText(m, 2); }
std::string atLeast(double value, int decimals) { return value > 0 ? "≥ " + fixedText(value, decimals) : "–"; }
bool isDoubtful(const rocks::Rock& rock) { return rock.confidence < rocks::kSureConfidence; }

struct RockCell {
    const char* title;
    std::string (*text)(const rocks::Rock&);
};
const std::array<RockCell, 10> kRockCells{{
    {"Rock", [](const rocks::Rock& r) { return std::to_string(r.label); }},
    {"a visible [m]", [](const rocks::Rock& r) { return twoDecimals(r.longestCaliperM); }},
    {"b visible [m]", [](const rocks::Rock& r) { return twoDecimals(r.shortestCaliperM); }},
    {"± [m]", [](const rocks::Rock& r) { return twoDecimals(r.toleranceM); }},
    {"distance [m]", [](const rocks::Rock& r) { return twoDecimals(r.distanceM); }},
    {"in front [%]", [](const rocks::Rock& r) { return fixedText(100 * r.unoccluded, 0); }},
    {"contacts", [](const rocks::Rock& r) { return atLeast(static_cast<double>(r.contacts.size()), 0); }},
    {"free below [m]", [](const rocks::Rock& r) { return atLeast(r.freeHeightM, 2); }},
    {"arch [°] ± 25", [](const rocks::Rock& r) { return r.archDeg ? fixedText(*r.archDeg, 0) + (r.isBelowContacts ? " ↓" : "") : "–"; }},
    {"p", [](const rocks::Rock& r) { return (isDoubtful(r) ? "▲ " : "") + fixedText(r.confidence, 2); }},
}};

std::string tableOf(const rocks::Study& study) {
    std::vector<const rocks::Rock*> longest;
    for (const rocks::Rock& rock : study.rocks) longest.push_back(&rock);
    std::ranges::stable_sort(longest, [](const rocks::Rock* a, const rocks::Rock* b) { return a->longestCaliperM > b->longestCaliperM; });
    longest.resize(std::min(longest.size(), kMostRockRows));
    std::string html = "<div class=\"wide\"><table id=\"rocks\">\n<thead><tr>";
    for (const RockCell& cell : kRockCells) html += "<th class=\"number\">" + htmlText(cell.title) + "</th>";
    html += "</tr></thead><tbody>\n";
    for (const rocks::Rock* rock : longest) {
        html += "<tr>";
        for (const RockCell& cell : kRockCells) html += "<td class=\"number\">" + htmlText(cell.text(*rock)) + "</td>";
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n<p class=\"note\">";
    if (study.rocks.size() > longest.size())
        html += "The " + std::to_string(longest.size()) + " longest of " + std::to_string(study.rocks.size()) + " rocks. ";
    return html +
           "a and b: visible spans across the line of sight; hidden parts are not counted. In front: share of the outline where the "
           "rock is the nearer side. Contacts and free height: at least. Arch: largest angle at the rock between two that it touches; "
           "↓ it hangs below the line between them. p: chance that the outline is right; ▲ below 0.85, hatched.</p>\n";
}

// Widths to the right, shares upwards.
class CurveDrawing {
public:
    explicit CurveDrawing(const rocks::SizeCurve& curve)
        : curve_(curve), rightM_(std::max(0.5, std::ceil(2 * 1.02 * std::max(curve.topM, curve.oversizeM)) / 2)) {}

    [[nodiscard]] std::string svg() const {
        std::string html = "<svg id=\"sizes\" class=\"picture\" viewBox=\"0 0 " + std::to_string(kCurveWidth) + " " +
                           std::to_string(kCurveHeight) + "\" role=\"img\" aria-label=\"Size curve of the visible rocks\">\n";
        for (const int percent : {0, 50, 100}) {
            html += line(x(0), y(percent / 100.0), x(rightM_), y(percent / 100.0), "stroke=\"#b8bec3\"");
            html += text(x(0) - 6, y(percent / 100.0) + 4, "end", std::to_string(percent) + " %");
        }
        const double step = rightM_ > 3 ? 1 : 0.5;
        for (int n = 0; n * step <= rightM_; ++n) {
            const bool isLast = (n + 1) * step > rightM_;
            html += text(x(n * step), kCurveHeight - 16, "middle", fixedText(n * step, 1) + (isLast ? " m" : ""));
        }
        return html + oversize() + path() + marks() + "</svg>\n";
    }

private:
    [[nodiscard]] double x(double wideM) const { return kCurveLeft + wideM / rightM_ * (kCurveWidth - kCurveLeft - kCurveRight); }
    [[nodiscard]] static double y(double share) { return kCurveHeight - kCurveBottom - share * (kCurveHeight - kCurveTop - kCurveBottom); }
    static std::string number(double value) { return fixedText(value, 1); }
    static std::string line(double x1, double y1, double x2, double y2, const std::string& look) {
        return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) + "\" " + look +
               "/>\n";
    }
    static std::string text(double x, double y, const char* anchor, const std::string& words) {
        return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" font-size=\"12\" text-anchor=\"" + anchor + "\">" + htmlText(words) +
               "</text>\n";
    }
    [[nodiscard]] std::string path() const {
        std::string d = "M" + number(x(0)) + " " + number(y(0));
        const auto count = static_cast<double>(curve_.rocks());
        for (std::size_t n = 0; n < curve_.rocks(); ++n)
            d += " H" + number(x(curve_.widthsM[n])) + " V" + number(y(static_cast<double>(n + 1) / count));
        return "<path d=\"" + d + " H" + number(x(rightM_)) + "\" fill=\"none\" stroke=\"#1c1f22\" stroke-width=\"1.6\"/>\n";
    }
    [[nodiscard]] std::string marks() const {
        struct Mark {
            const char* name;
            double wideM, share;
        };
        std::string html;
        for (const auto& [name, wideM, share] : {Mark{"P20", curve_.p20M, 0.2}, Mark{"P50", curve_.p50M, 0.5},
                                                 Mark{"P80", curve_.p80M, 0.8}, Mark{"largest", curve_.topM, 1.0}}) {
            html += line(x(wideM), y(share), x(wideM), y(0), "stroke=\"#9a4a12\" stroke-dasharray=\"2 3\"");
            html += "<circle cx=\"" + number(x(wideM)) + "\" cy=\"" + number(y(share)) + "\" r=\"3.5\" fill=\"#9a4a12\"/>\n";
            const bool atEnd = x(wideM) > kCurveWidth - 120;
            html += text(x(wideM) + (atEnd ? -7 : 7), y(share) + 15, atEnd ? "end" : "start", std::string(name) + " " + twoDecimals(wideM));
        }
        return html;
    }
    [[nodiscard]] std::string oversize() const {
        if (curve_.oversizeM <= 0) return {};
        return line(x(curve_.oversizeM), y(1), x(curve_.oversizeM), y(0), "stroke=\"#1c1f22\" stroke-dasharray=\"7 4\"") +
               text(kCurveWidth - kCurveRight, kCurveHeight - 2, "end",
                    fixedText(100 * curve_.oversizeShare, 0) + " % over " + twoDecimals(curve_.oversizeM) + " m");
    }

    const rocks::SizeCurve& curve_;
    double rightM_;
};

std::string countsOf(const rocks::Study& study, const rocks::SizeCurve& curve) {
    const auto doubtful = std::ranges::count_if(study.rocks, isDoubtful);
    std::string html = "<p><strong>" + std::to_string(study.rocks.size()) + " rocks, each a " + htmlText(rocks::kRockCaveat) +
                       ".</strong> " + std::to_string(doubtful) + " have a doubtful outline (hatched); " +
                       std::to_string(rocks::regionCounts(study.map, rocks::RegionKind::Fines).regions) +
                       " pieces are too small to be shown as rocks";
    if (!study.settings.region.empty())
        html += ", " + std::to_string(rocks::regionCounts(study.map, rocks::RegionKind::Outside).regions) +
                " lie outside the region of interest";
    if (!study.edits.empty()) html += "; " + std::to_string(study.edits.size()) + " changes were made by hand";
    html += ". Level " + shortestText(study.settings.level) + " of -4 (fine) to 4 (coarse).</p>\n";
    if (curve.rocks() == 0) return html;
    html += "<p>Visible b: P20 " + twoDecimals(curve.p20M) + " m, P50 " + twoDecimals(curve.p50M) + " m, P80 " + twoDecimals(curve.p80M) +
            " m, largest " + twoDecimals(curve.topM) + " m";
    if (curve.oversizeM > 0)
        html += "; " + fixedText(100 * curve.oversizeShare, 0) + " % over the site's " + twoDecimals(curve.oversizeM) + " m";
    return html + " (" + htmlText(rocks::kSizeCurveCaveat) + ").</p>\n";
}

} // namespace

std::string rockSection(const edges::Detection& detection, const rocks::Study& study, const rocks::Faces& faces) {
    const rocks::SizeCurve curve = rocks::sizeCurve(study.rocks, study.settings.oversizeM);
    std::string html = "<h2>Rocks</h2>\n" + countsOf(study, curve);
    html +=
        "<div class=\"pictures\">\n<figure class=\"picture\">" +
        htmlImage(rockPicture(detection, faces, kFacePixels), "Rocks as coloured faces on gray levels") +
        "<figcaption>Rocks as faces, doubtful ones hatched. Colours tell neighbours apart and mean nothing else.</figcaption></figure>\n";
    html += "<figure class=\"picture\">" +
            htmlImage(cloudPicture(detection, kRockCloudWidth, kRockCloudHeight, &faces).png,
                      "The rocks in perspective, seen from behind the scanner") +
            "<figcaption>The same on the points.</figcaption></figure>\n</div>\n";
    if (curve.rocks() > 0) html += "<h2>Sizes of the visible rocks</h2>\n" + CurveDrawing(curve).svg();
    return html + "<h2>The largest rocks</h2>\n" + tableOf(study);
}

Json rockFaceData(const rocks::Study& study) {
    Json colours = Json::array(), rocks = Json::array();
    for (const Rgb& colour : rocks::kRockFaceColours) colours.push_back({colour.red, colour.green, colour.blue});
    const std::vector<std::uint8_t> places = rocks::rockColours(study.map);
    for (const rocks::Rock& rock : study.rocks)
        rocks.push_back({places[rock.label], isDoubtful(rock) ? 1 : 0,
                         "visible " + twoDecimals(rock.longestCaliperM) + " x " + twoDecimals(rock.shortestCaliperM) + " m, ± " +
                             twoDecimals(rock.toleranceM) + ", at " + twoDecimals(rock.distanceM) + " m; " + rocks::kRockCaveat});
    return {{"colours", colours}, {"rocks", rocks}};
}

} // namespace edgescan::exports
