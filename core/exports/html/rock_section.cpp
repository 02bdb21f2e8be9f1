// Writes rocks as markup.
#include "core/exports/html/rock_section.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/exports/html/html.h"
#include "core/exports/html/scan_pictures.h"
#include "core/exports/rock_files.h"
#include "core/files/open_save/save_scan.h"
#include "core/rocks/attributes/rock_columns.h"
#include "core/rocks/attributes/size_curve.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace edgescan::exports {
namespace {

constexpr int kWidth = 700, kHeight = 290;                       // in units of the drawing
constexpr int kLeft = 88, kRight = 150, kTop = 30, kBottom = 58; // on the right: room for a label

std::string number(double value) { return fixedText(value, 1); }
std::string metresOf(double m) { return fixedText(m, 2) + " m"; }

class Drawing {
public:
    explicit Drawing(const rocks::SizeCurve& curve)
        : curve_(curve), rightM_(std::max(0.5, std::ceil(2 * 1.02 * std::max(curve.topM, curve.oversizeM)) / 2)) {}

    [[nodiscard]] std::string svg() const {
        return "<svg id=\"sizes\" class=\"picture\" viewBox=\"0 0 " + std::to_string(kWidth) + " " + std::to_string(kHeight) +
               "\" role=\"img\" aria-label=\"Size curve of the visible rocks: share of the rocks over their visible width b\">\n" + axes() +
               oversize() + path() + marks() + "</svg>\n";
    }

private:
    [[nodiscard]] double x(double wideM) const { return kLeft + wideM / rightM_ * (kWidth - kLeft - kRight); }
    [[nodiscard]] static double y(double share) { return kHeight - kBottom - share * (kHeight - kTop - kBottom); }
    static std::string line(double x1, double y1, double x2, double y2, const std::string& look) {
        return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) + "\" " + look +
               "/>\n";
    }
    static std::string text(double x, double y, const char* anchor, const std::string& words, const std::string& turn = {}) {
        return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" font-size=\"13\" text-anchor=\"" + anchor + "\"" + turn + ">" +
               htmlText(words) + "</text>\n";
    }

    [[nodiscard]] std::string axes() const {
        std::string html;
        for (const int percent : {0, 20, 40, 60, 80, 100}) {
            const double at = y(percent / 100.0);
            html += line(x(0), at, x(rightM_), at, "stroke=\"#d5d9dc\"") + text(x(0) - 6, at + 4, "end", std::to_string(percent) + " %");
        }
        const double step = rightM_ > 6 ? 2 : rightM_ > 3 ? 1 : 0.5;
        for (int n = 0; n * step <= rightM_; ++n)
            html += line(x(n * step), y(0), x(n * step), y(0) + 5, "stroke=\"#5b6268\"") +
                    text(x(n * step), y(0) + 25, "middle", fixedText(n * step, 1));
        const double middle = (y(0) + y(1)) / 2;
        return html + text((x(0) + x(rightM_)) / 2, kHeight - 8, "middle", "visible width b [m]") +
               text(16, middle, "middle", "rocks that are not wider", " transform=\"rotate(-90 16 " + number(middle) + ")\"");
    }

    [[nodiscard]] std::string path() const {
        std::string d = "M" + number(x(0)) + " " + number(y(0));
        const auto count = static_cast<double>(curve_.rocks());
        for (std::size_t n = 0; n < curve_.rocks(); ++n)
            d += " H" + number(x(curve_.widthsM[n])) + " V" + number(y(static_cast<double>(n + 1) / count));
        return "<path d=\"" + d + " H" + number(x(rightM_)) + "\" fill=\"none\" stroke=\"#1c1f22\" stroke-width=\"1.6\"/>\n";
    }

    // The labels are below one another, at the heights of their shares.
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
            html += text(x(wideM) + 7, y(share) + 16, "start", std::string(name) + " " + metresOf(wideM));
        }
        return html;
    }

    // Its label is above the curve, where there is no other.
    [[nodiscard]] std::string oversize() const {
        if (curve_.oversizeM <= 0) return {};
        const double at = x(curve_.oversizeM);
        const char* anchor = at < kWidth / 3.0 ? "start" : at > 2 * kWidth / 3.0 ? "end" : "middle";
        return line(at, y(1) - 8, at, y(0), "stroke=\"#1c1f22\" stroke-dasharray=\"7 4\"") +
               text(at, y(1) - 13, anchor, fixedText(100 * curve_.oversizeShare, 0) + " % over " + metresOf(curve_.oversizeM));
    }

    const rocks::SizeCurve& curve_;
    double rightM_;
};

/// An SVG element with the id "sizes". The curve must have rocks.
std::string sizeDrawing(const rocks::SizeCurve& curve) { return Drawing(curve).svg(); }

using Json = nlohmann::ordered_json;

constexpr int kFacePixels = 900;                             // along a side
constexpr int kRockCloudWidth = 800, kRockCloudHeight = 512; // px

std::size_t overSite(const rocks::Study& study) {
    const double limit = study.settings.oversizeM;
    const auto isOver = [&](const rocks::Rock& rock) { return rock.shortestCaliperM > limit; };
    return limit > 0 ? static_cast<std::size_t>(std::ranges::count_if(study.rocks, isOver)) : 0;
}

// The largest (visible width b) first, as many as the table has rows.
std::vector<const rocks::Rock*> listedRocks(const rocks::Study& study) {
    std::vector<const rocks::Rock*> largest;
    for (const rocks::Rock& rock : study.rocks) largest.push_back(&rock);
    std::ranges::stable_sort(largest, [](const rocks::Rock* a, const rocks::Rock* b) { return a->shortestCaliperM > b->shortestCaliperM; });
    largest.resize(std::min(largest.size(), std::clamp(overSite(study), kUsualRockRows, kMostRockRows)));
    return largest;
}

// Which ones the table has, and where the others are.
std::string listedText(const rocks::Study& study, std::size_t listed) {
    if (study.rocks.size() <= listed) return {};
    const std::size_t over = overSite(study);
    return "The " + std::to_string(listed) + " largest (visible width b) of " + std::to_string(study.rocks.size()) + " rocks; " +
           (over > listed ? std::to_string(over - listed) + " more are over the site's " + metresOf(study.settings.oversizeM) + "; " : "") +
           "the export of rocks as a table lists all. ";
}

std::string tableOf(const rocks::Study& study, const inspect::Notebook* notebook) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const std::vector<const rocks::Rock*> largest = listedRocks(study);
    const rocks::RockRows rows(study, files::usualFrame(scan), notebook != nullptr ? namedCells(notebook->targets) : rocks::NamedCells());
    std::string html = "<div class=\"wide cards\"><table id=\"rocks\">\n<thead><tr>", body;
    const auto titles = std::ranges::count_if(rocks::rockColumns(rows.frame()), [](const auto& each) { return each.title != nullptr; });
    const std::string head = "<th class=\"number\" width=\"" + std::to_string(100 / titles) + "%\">"; // as wide as each other
    for (const rocks::RockColumn& column : rocks::rockColumns(rows.frame())) {
        if (column.title != nullptr) html += head + htmlText(column.title) + "</th>";
    }
    for (const rocks::Rock* rock : largest) {
        const rocks::RockRow row = rows.of(*rock);
        std::string names = row.names; // after its number, the first column
        body += "<tr>";
        for (const rocks::RockColumn& column : rocks::rockColumns(rows.frame())) {
            if (column.title != nullptr)
                body += "<td class=\"number\" data-name=\"" + htmlText(column.title) + "\">" + htmlText(column.text(row)) +
                        (names.empty() ? "" : " " + htmlText(std::exchange(names, {}))) + "</td>";
        }
        body += "</tr>\n";
    }
    html += "</tr></thead><tbody>\n" + body + "</tbody></table></div>\n<p class=\"note\">";
    html += listedText(study, largest.size());
    html += scan.placement ? "E, N, RL: mean of the visible points, in the mine grid" +
                                 (scan.placement->grid.empty() ? "" : " (" + htmlText(scan.placement->grid) + ")") + ". "
                           : "x, y, z: mean of the visible points, in the scanner's frame. ";
    return html +
           "a and b: visible spans across the line of sight; hidden parts are not counted. Distance: median of its ranges. Area: visible, "
           "across the beams. In front: share of the outline where the "
           "rock is the nearer side. Contacts and free height: at least. Arch: largest angle at the rock between two that it touches; "
           "↓ it hangs below the line between them. p: chance that the outline is right; ▲ below 0.85, hatched." +
           (rocks::upOf(scan).assumed
                ? " Without a pose, up is the scanner's z axis, which is assumed: free height and ↓ are measured along it."
                : "") +
           (std::ranges::any_of(study.rocks, [](const rocks::Rock& rock) { return !rock.apart.empty(); })
                ? " Number with ▲: merged by hand of parts that do not touch."
                : "") +
           "</p>\n";
}

std::string countsOf(const rocks::Study& study, const rocks::SizeCurve& curve) {
    const auto uncertain = std::ranges::count_if(study.rocks, rocks::isDoubtful);
    std::string html =
        "<p><strong>" + std::to_string(study.rocks.size()) + " rocks, each a " + htmlText(rocks::kRockCaveat) + ".</strong> " +
        std::to_string(uncertain) + (uncertain == 1 ? " has" : " have") + " an uncertain outline (hatched); " +
        std::to_string(rocks::regionCounts(study.map, rocks::RegionKind::Fines).regions) + " pieces are too small to be shown as rocks";
    if (!study.settings.region.empty())
        html += ", " + std::to_string(rocks::regionCounts(study.map, rocks::RegionKind::Outside).regions) +
                " are outside the region of interest";
    if (const std::size_t changes = rocks::changesByHand(study.edits); changes > 0)
        html += "; " + std::to_string(changes) + (changes == 1 ? " change was made by hand" : " changes were made by hand");
    html += ". Level " + shortestText(study.settings.level) + " of -4 (fine) to 4 (coarse).</p>\n";
    if (curve.rocks() == 0) return html;
    html += "<p>Visible width b: P20 " + metresOf(curve.p20M) + ", P50 " + metresOf(curve.p50M) + ", P80 " + metresOf(curve.p80M) +
            " (20, 50 and 80 % of the rocks are not wider), largest " + metresOf(curve.topM);
    if (curve.oversizeM > 0) html += "; " + fixedText(100 * curve.oversizeShare, 0) + " % over the site's " + metresOf(curve.oversizeM);
    return html + " (" + htmlText(rocks::kSizeCurveCaveat) + ").</p>\n";
}

// Those of the table first, so that they are always there.
std::vector<const rocks::Rock*> rocksInOrder(const rocks::Study& study) {
    std::vector<const rocks::Rock*> order = listedRocks(study), listed = order;
    for (const rocks::Rock& rock : study.rocks) {
        if (std::ranges::find(listed, &rock) == listed.end()) order.push_back(&rock);
    }
    return order;
}

// `isSecond`: paper has that picture without numbers.
std::string leftOutText(std::size_t leftOut, bool isSecond = false) {
    const std::string text = " " + std::to_string(leftOut) + " numbers of smaller rocks have no room and are left out.";
    return (leftOut == 0 ? ""
            : isSecond   ? "<span class=\"onscreen\">" + text + "</span>"
                         : text) +
           std::string("<span class=\"narrow\"> On a narrow screen only the rocks of the table have their numbers.</span>");
}

struct RockPictures {
    std::string faces, cloud;
};

RockPictures picturesOf(const edges::Detection& detection, const rocks::Study& study, const rocks::Faces& faces) {
    const std::vector<const rocks::Rock*> order = rocksInOrder(study);
    const std::size_t listed = listedRocks(study).size();
    const int lines = detection.scan->lines(), beams = detection.scan->beams();
    const int height = std::min(lines, kFacePixels), width = std::min(beams, kFacePixels);
    std::vector<std::size_t> cells;
    std::vector<PictureNumber> onFaces, onCloud;
    for (std::size_t n = 0; n < order.size(); ++n) {
        const auto cell = order[n]->cell;
        cells.push_back(cell);
        onFaces.push_back({std::to_string(order[n]->label), (cell % static_cast<unsigned>(beams) + 0.5) * width / beams,
                           (cell / static_cast<unsigned>(beams) + 0.5) * height / lines, n < listed});
    }
    const CloudPicture cloud = cloudPicture(detection, kRockCloudWidth, kRockCloudHeight, &faces, cells);
    for (std::size_t n = 0; n < order.size(); ++n) {
        if (cloud.places[n]) onCloud.push_back({std::to_string(order[n]->label), cloud.places[n]->x(), cloud.places[n]->y(), n < listed});
    }
    std::size_t leftOut = 0;
    const std::string numbers = pictureNumbers(width, height, onFaces, leftOut);
    RockPictures pictures;
    pictures.faces =
        numberedFigure(rockPicture(detection, faces, kFacePixels), "Rocks as coloured faces on gray levels", numbers,
                       "Rocks as faces, uncertain ones hatched. Colours only separate neighbours. The numbers are those of the table, the "
                       "drawing and the files." +
                           leftOutText(leftOut));
    const std::string cloudNumbers = pictureNumbers(kRockCloudWidth, kRockCloudHeight, onCloud, leftOut);
    pictures.cloud = numberedFigure(cloud.png, "The rocks in perspective, seen from behind the scanner", cloudNumbers,
                                    "The rocks on the points." + leftOutText(leftOut, true), "picture second");
    return pictures;
}

} // namespace

std::string rockSection(const edges::Detection& detection, const rocks::Study& study, const rocks::Faces& faces,
                        const inspect::Notebook* notebook) {
    const rocks::SizeCurve curve = rocks::sizeCurve(study.rocks, study.settings.oversizeM);
    std::string html = "<h2>Rocks</h2>\n" + countsOf(study, curve);
    const RockPictures pictures = picturesOf(detection, study, faces);
    html += pictures.faces + "<section class=\"pictures\">\n";
    if (curve.rocks() > 0)
        html += "<figure class=\"picture sizes\">" + sizeDrawing(curve) + "<figcaption>Sizes of the visible rocks</figcaption></figure>\n";
    html += pictures.cloud + "</section>\n";
    return html + "<h2>The rocks with the largest visible width b</h2>\n" + tableOf(study, notebook);
}

Json rockFaceData(const rocks::Study& study) {
    Json colours = Json::array(), rocks(study.map.rocks, nullptr); // by label
    for (const Rgb& colour : rocks::kRockFaceColours) colours.push_back({colour.red, colour.green, colour.blue});
    const std::vector<std::uint8_t> places = rocks::rockColours(study.map);
    for (const rocks::Rock& rock : study.rocks)
        rocks[rock.label - 1] = {places[rock.label],
                                 rocks::isDoubtful(rock) ? 1 : 0,
                                 fixedText(rock.longestCaliperM, 2),
                                 fixedText(rock.shortestCaliperM, 2),
                                 fixedText(shownTolerance(rock.toleranceM, 2), 2),
                                 fixedText(rock.distanceM, 2)};
    return {{"colours", colours}, {"rocks", rocks}};
}

} // namespace edgescan::exports
