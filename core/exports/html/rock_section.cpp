// Writes rocks as markup.
#include "core/exports/html/rock_section.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/exports/html/html.h"
#include "core/exports/html/picture_numbers.h"
#include "core/exports/html/scan_pictures.h"
#include "core/exports/html/size_drawing.h"
#include "core/files/open_save/save_scan.h"
#include "core/rocks/attributes/rock_columns.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <vector>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFacePixels = 900;                             // along a side
constexpr int kRockCloudWidth = 800, kRockCloudHeight = 512; // px

std::string twoDecimals(double m) { return fixedText(m, 2); }
bool isDoubtful(const rocks::Rock& rock) { return rock.confidence < rocks::kSureConfidence; }

// The longest first, as many as the table has rows.
std::vector<const rocks::Rock*> listedRocks(const rocks::Study& study) {
    std::vector<const rocks::Rock*> longest;
    for (const rocks::Rock& rock : study.rocks) longest.push_back(&rock);
    std::ranges::stable_sort(longest, [](const rocks::Rock* a, const rocks::Rock* b) { return a->longestCaliperM > b->longestCaliperM; });
    longest.resize(std::min(longest.size(), kMostRockRows));
    return longest;
}

std::string tableOf(const rocks::Study& study) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const std::vector<const rocks::Rock*> longest = listedRocks(study);
    const rocks::RockRows rows(study, files::usualFrame(scan));
    std::string html = "<div class=\"wide\"><table id=\"rocks\">\n<thead><tr>", body;
    for (const rocks::RockColumn& column : rocks::rockColumns(rows.frame())) {
        if (column.title != nullptr) html += "<th class=\"number\">" + htmlText(column.title) + "</th>";
    }
    for (const rocks::Rock* rock : longest) {
        const rocks::RockRow row = rows.of(*rock);
        body += "<tr>";
        for (const rocks::RockColumn& column : rocks::rockColumns(rows.frame())) {
            if (column.title != nullptr)
                body += "<td class=\"number\" data-name=\"" + htmlText(column.title) + "\">" + htmlText(column.text(row)) + "</td>";
        }
        body += "</tr>\n";
    }
    html += "</tr></thead><tbody>\n" + body + "</tbody></table></div>\n<p class=\"note\">";
    if (study.rocks.size() > longest.size())
        html += "The " + std::to_string(longest.size()) + " longest of " + std::to_string(study.rocks.size()) +
                " rocks; <code>rocks --csv</code> lists all. ";
    html += scan.placement ? "E, N, RL: mean of the visible points, in the mine grid" +
                                 (scan.placement->grid.empty() ? "" : " (" + htmlText(scan.placement->grid) + ")") + ". "
                           : "x, y, z: mean of the visible points, in the scanner's frame. ";
    return html +
           "a and b: visible spans across the line of sight; hidden parts are not counted. Distance: from the scanner. Area: visible, "
           "across the beams. In front: share of the outline where the "
           "rock is the nearer side. Contacts and free height: at least. Arch: largest angle at the rock between two that it touches; "
           "↓ it hangs below the line between them. p: chance that the outline is right; ▲ below 0.85, hatched.</p>\n";
}

std::string countsOf(const rocks::Study& study, const rocks::SizeCurve& curve) {
    const auto doubtful = std::ranges::count_if(study.rocks, isDoubtful);
    std::string html = "<p><strong>" + std::to_string(study.rocks.size()) + " rocks, each a " + htmlText(rocks::kRockCaveat) +
                       ".</strong> " + std::to_string(doubtful) + " have a doubtful outline (hatched); " +
                       std::to_string(rocks::regionCounts(study.map, rocks::RegionKind::Fines).regions) +
                       " pieces are too small to be shown as rocks";
    if (!study.settings.region.empty())
        html += ", " + std::to_string(rocks::regionCounts(study.map, rocks::RegionKind::Outside).regions) +
                " are outside the region of interest";
    if (!study.edits.empty()) html += "; " + std::to_string(study.edits.size()) + " changes were made by hand";
    html += ". Level " + shortestText(study.settings.level) + " of -4 (fine) to 4 (coarse).</p>\n";
    if (curve.rocks() == 0) return html;
    html += "<p>Visible b: P20 " + twoDecimals(curve.p20M) + " m, P50 " + twoDecimals(curve.p50M) + " m, P80 " + twoDecimals(curve.p80M) +
            " m, largest " + twoDecimals(curve.topM) + " m";
    if (curve.oversizeM > 0)
        html += "; " + fixedText(100 * curve.oversizeShare, 0) + " % over the site's " + twoDecimals(curve.oversizeM) + " m";
    return html + " (" + htmlText(rocks::kSizeCurveCaveat) + ").</p>\n";
}

// Those of the table first, so that they are always there.
std::vector<const rocks::Rock*> rocksInOrder(const rocks::Study& study) {
    std::vector<const rocks::Rock*> order = listedRocks(study);
    const std::set<const rocks::Rock*> listed(order.begin(), order.end());
    for (const rocks::Rock& rock : study.rocks) {
        if (!listed.contains(&rock)) order.push_back(&rock);
    }
    return order;
}

std::string numberedFigure(const std::string& png, const char* alternative, const std::string& numbers, const std::string& caption) {
    return "<figure class=\"picture\"><div class=\"numbered\">" + htmlImage(png, alternative) + numbers + "</div><figcaption>" + caption +
           "</figcaption></figure>\n";
}

std::string leftOutText(std::size_t leftOut) {
    return (leftOut == 0 ? "" : " " + std::to_string(leftOut) + " numbers of smaller rocks have no room and are left out.") +
           std::string("<span class=\"narrow\"> On a narrow screen only the rocks of the table have their numbers.</span>");
}

std::string picturesOf(const edges::Detection& detection, const rocks::Study& study, const rocks::Faces& faces) {
    const std::vector<const rocks::Rock*> order = rocksInOrder(study);
    const std::size_t listed = std::min(order.size(), kMostRockRows);
    const int lines = detection.scan->lines(), beams = detection.scan->beams();
    const int height = std::min(lines, kFacePixels), width = std::min(beams, kFacePixels);
    std::vector<std::size_t> cells;
    std::vector<PictureNumber> onFaces, onCloud;
    for (std::size_t n = 0; n < order.size(); ++n) {
        const auto cell = order[n]->cell;
        cells.push_back(cell);
        onFaces.push_back({order[n]->label, (cell % static_cast<unsigned>(beams) + 0.5) * width / beams,
                           (cell / static_cast<unsigned>(beams) + 0.5) * height / lines, n < listed});
    }
    const CloudPicture cloud = cloudPicture(detection, kRockCloudWidth, kRockCloudHeight, &faces, cells);
    for (std::size_t n = 0; n < order.size(); ++n) {
        if (cloud.places[n]) onCloud.push_back({order[n]->label, cloud.places[n]->x(), cloud.places[n]->y(), n < listed});
    }
    std::size_t leftOut = 0;
    const std::string numbers = pictureNumbers(width, height, onFaces, leftOut);
    std::string html =
        numberedFigure(rockPicture(detection, faces, kFacePixels), "Rocks as coloured faces on gray levels", numbers,
                       "Rocks as faces, doubtful ones hatched. Colours only separate neighbours. The numbers are those of the table, the "
                       "drawing and the files." +
                           leftOutText(leftOut));
    const std::string cloudNumbers = pictureNumbers(kRockCloudWidth, kRockCloudHeight, onCloud, leftOut);
    return html + numberedFigure(cloud.png, "The rocks in perspective, seen from behind the scanner", cloudNumbers,
                                 "The same on the points." + leftOutText(leftOut));
}

} // namespace

std::string rockSection(const edges::Detection& detection, const rocks::Study& study, const rocks::Faces& faces) {
    const rocks::SizeCurve curve = rocks::sizeCurve(study.rocks, study.settings.oversizeM);
    std::string html = "<h2>Rocks</h2>\n" + countsOf(study, curve);
    html += picturesOf(detection, study, faces);
    if (curve.rocks() > 0) html += "<h2>Sizes of the visible rocks</h2>\n" + sizeDrawing(curve);
    return html + "<h2>The largest rocks</h2>\n" + tableOf(study);
}

Json rockFaceData(const rocks::Study& study) {
    Json colours = Json::array(), rocks = Json::array();
    for (const Rgb& colour : rocks::kRockFaceColours) colours.push_back({colour.red, colour.green, colour.blue});
    const std::vector<std::uint8_t> places = rocks::rockColours(study.map);
    for (const rocks::Rock& rock : study.rocks)
        rocks.push_back({places[rock.label], isDoubtful(rock) ? 1 : 0,
                         "visible " + twoDecimals(rock.longestCaliperM) + " x " + twoDecimals(rock.shortestCaliperM) + " m, ± " +
                             twoDecimals(shownTolerance(rock.toleranceM, 2)) + ", at " + twoDecimals(rock.distanceM) + " m; " +
                             rocks::kRockCaveat});
    return {{"colours", colours}, {"rocks", rocks}};
}

} // namespace edgescan::exports
