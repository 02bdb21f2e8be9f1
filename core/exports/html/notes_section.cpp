// Writes targets, measurements and changes as markup.
#include "core/exports/html/notes_section.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/containers/png/png.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/explain/why.h"
#include "core/exports/html/html.h"
#include "core/exports/html/scan_pictures.h"
#include "core/inspect/change_detection/change_report.h"
#include "core/inspect/measure/cell_target.h"
#include "core/inspect/measure/click_remarks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace edgescan::exports {
namespace {

constexpr const char* kNoPose = "▲ no pose";

std::string cellText(const Scan& scan, std::uint32_t cell) {
    if (cell >= scan.cells()) return "no cell of this scan";
    const auto beams = static_cast<std::uint32_t>(scan.beams());
    return "line " + std::to_string(cell / beams) + ", beam " + std::to_string(cell % beams);
}

using Rows = std::vector<std::pair<std::string, std::string>>; // label and value, in the words of the cards

std::string tripleText(const Eigen::Vector3d& v) { return fixedText(v.x(), 3) + ", " + fixedText(v.y(), 3) + ", " + fixedText(v.z(), 3); }

std::string dipText(const inspect::CellTarget& target) {
    if (!target.surface) return "no plane fits";
    if (!target.dip) return kNoPose;
    const bool falls = target.dip->dipDeg > inspect::kReportedSigmas * target.surface->sigmaDeg;
    return fixedText(target.dip->dipDeg, 0) + "° / " + (falls ? fixedText(target.dip->directionDeg, 0) + "°" : std::string("–"));
}

/// In the words of the card.
std::string edgeText(const inspect::CellTarget& target) {
    return edges::edgeLabel(target.probe.edge, target.probe.kind) +
           (target.strength ? ", strength " + edges::strengthNumber(*target.strength) : std::string());
}

/// Where the cell is by the pose that the scan has now.
Rows placeRows(const inspect::CellTarget& target) {
    if (target.probe.state != CellState::Valid) return {{"Distance", "nothing was measured in this cell"}};
    const std::string tolerance = target.toleranceM > 0.0 ? fixedText(shownTolerance(target.toleranceM, 3), 3) + " m" : "not known";
    return {{"Distance", fixedText(target.distanceM, 3) + " m ± " + tolerance},
            {"X, Y, Z", tripleText(target.probe.pointM)},
            {"E, N, RL", target.probe.mineM ? tripleText(*target.probe.mineM) : kNoPose},
            {"Dip / direction", dipText(target)},
            {"Edge", edgeText(target)}};
}

std::string rowsHtml(const Rows& rows) {
    std::string html;
    for (const auto& [row, value] : rows) html += (html.empty() ? "" : "<br>") + htmlText(row) + ": " + htmlText(value);
    return html;
}

constexpr std::array kTargetColumns{"Target", "Name and note", "Cell", "Where, and its edge now", "Also on its card when it was pinned",
                                    "Pinned"};
constexpr std::array kMeasureColumns{"Measured", "Result, ± two standard deviations", "From", "Cells"};
constexpr std::array kTargetWidths{7, 13, 11, 26, 33, 10}, kMeasureWidths{16, 17, 51, 16, 0, 0}; // % of the table

std::string headRow(const char* id, std::span<const char* const> columns, std::span<const int> widths) {
    std::string html = std::string("<div class=\"wide cards\"><table id=\"") + id + "\">\n<thead><tr>";
    for (std::size_t n = 0; n < columns.size(); ++n) html += "<th width=\"" + std::to_string(widths[n]) + "%\">" + columns[n] + "</th>";
    return html + "</tr></thead><tbody>\n";
}

/// Each cell with the name of its column, which a narrow screen shows. `own`: the cell with the operator's words, which are not translated.
std::string rowOf(std::span<const char* const> columns, const std::vector<std::string>& cells, int own = -1) {
    std::string html = "<tr>";
    for (std::size_t n = 0; n < cells.size(); ++n)
        html += std::string("<td") + (static_cast<int>(n) == own ? " translate=\"no\"" : "") + " data-name=\"" + columns[n] + "\">" +
                cells[n] + "</td>";
    return html + "</tr>\n";
}

std::string targetRow(const edges::Detection& detection, const RangeNoise& noise, const inspect::PinnedTarget& target) {
    const Scan& scan = *detection.scan;
    const Rows now = target.cell < scan.cells() ? placeRows(inspect::targetAt(detection, noise, target.cell)) : Rows{};
    Rows then = target.asPinned;
    // What is the same now, and what only a pose was missing for, if the scan has one now. The size of a rock is in the table of the rocks:
    // here it could be that of before an edit.
    std::erase_if(then, [&](const auto& row) {
        return row.first == inspect::kRockRow || std::ranges::find(now, row) != now.end() ||
               (scan.placement && std::string_view(row.second).starts_with("▲"));
    });
    const std::string name = htmlText(target.name) + (target.note.empty() ? "" : "<br>" + htmlText(target.note));
    return rowOf(kTargetColumns,
                 {std::to_string(target.number), name, cellText(scan, target.cell), rowsHtml(now), rowsHtml(then),
                  htmlText(plainUtc(target.pinnedUtc))},
                 1);
}

std::string measureRow(const edges::Detection& detection, const RangeNoise& noise, const inspect::StoredMeasure& measure,
                       Translated translated) {
    std::string cells;
    for (const std::uint32_t cell : measure.cells) cells += (cells.empty() ? "" : "<br>") + cellText(*detection.scan, cell);
    const auto measured = inspect::measureStored(*detection.scan, noise, measure);
    std::string from;
    if (measured) {
        from = inspect::measureBasis(*measured, translated);
        for (const std::string& remark : inspect::clickRemarks(*detection.scan, *detection.mask, measure, translated))
            from += "; " + remark;
    }
    return rowOf(kMeasureColumns,
                 {inspect::measureName(measure) + " " + htmlText(translated(inspect::traitsOf(measure.kind).label)),
                  measured ? htmlText(inspect::measureText(*measured)) : "its cells hold no points now", htmlText(from), cells});
}

/// Where they are, on the gray levels: targets by number and name, measurements as lines with their values.
std::string notesPicture(const edges::Detection& detection, const RangeNoise& noise, const inspect::Notebook& notebook, int mostPixels) {
    const Scan& scan = *detection.scan;
    const int height = std::min(scan.lines(), mostPixels), width = std::min(scan.beams(), mostPixels);
    const auto at = [&](std::uint32_t cell) {
        const auto beams = static_cast<std::uint32_t>(scan.beams());
        return Eigen::Vector2d((cell % beams + 0.5) * width / scan.beams(), (cell / beams + 0.5) * height / scan.lines());
    };
    const auto isInside = [&](std::uint32_t cell) { return cell < scan.cells(); }; // else of an earlier shape of the scan
    std::vector<PictureNumber> texts;
    std::vector<PictureLine> lines;
    for (const inspect::PinnedTarget& target : notebook.targets) {
        if (!isInside(target.cell)) continue;
        const Eigen::Vector2d place = at(target.cell);
        texts.push_back({std::to_string(target.number) + (target.name.empty() ? "" : " " + target.name), place.x(), place.y(), true, true});
    }
    for (const inspect::StoredMeasure& measure : notebook.measures) {
        if (!std::ranges::all_of(measure.cells, isInside)) continue;
        const auto measured = inspect::measureStored(scan, noise, measure);
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        const auto links = inspect::linksOf(measure.kind);
        for (const auto& [from, to] : links) {
            const Eigen::Vector2d a = at(measure.cells[from]), b = at(measure.cells[to]);
            lines.push_back({a.x(), a.y(), b.x(), b.y()});
            middle += (a + b) / 2 / static_cast<double>(links.size());
        }
        if (!measured) continue;
        const bool warned = measured->isWarned() || inspect::isDoubtful(scan, measure);
        const std::string text = (warned ? "▲ " : "") + inspect::measureName(measure) + " " + inspect::measureText(*measured);
        texts.push_back({text, middle.x(), middle.y()});
    }
    std::size_t leftOut = 0;
    const std::string numbers = pictureNumbers(width, height, texts, leftOut, lines);
    const std::string caption = "The targets by their numbers, and what was measured. Black is near, or nothing came back." +
                                (leftOut == 0 ? ""
                                              : " " + std::to_string(leftOut) + (leftOut == 1 ? " value has" : " values have") +
                                                    " no room in the picture; the table has all.");
    return numberedFigure(grayPicture(detection, mostPixels), "Targets and measures on gray levels", numbers, caption);
}

int spread(const Rgb& c) { return std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue}); }

/// Each pixel gets the most colourful of its cells, so that a smaller picture loses no edges.
Grid<Rgb> smaller(const Grid<Rgb>& picture, int mostPixels) {
    if (picture.lines <= mostPixels && picture.beams <= mostPixels) return picture;
    Grid<Rgb> small(std::min(picture.lines, mostPixels), std::min(picture.beams, mostPixels));
    std::vector<int> best(small.size(), -1);
    for (int line = 0; line < picture.lines; ++line) {
        for (int beam = 0; beam < picture.beams; ++beam) {
            const std::size_t to = small.index(static_cast<int>(static_cast<std::int64_t>(line) * small.lines / picture.lines),
                                               static_cast<int>(static_cast<std::int64_t>(beam) * small.beams / picture.beams));
            const Rgb& from = picture.at(line, beam);
            if (spread(from) <= best[to]) continue;
            best[to] = spread(from);
            small[to] = from;
        }
    }
    return small;
}

std::string linesOf(std::string_view text) {
    std::string html;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        html += htmlText(text.substr(at, end - at)) + "\n";
        at = end + 1;
    }
    return html;
}

} // namespace

std::string notebookSection(const edges::Detection& detection, const inspect::Notebook& notebook, int mostPixels, Translated translated) {
    if (notebook.empty()) return {};
    const RangeNoise noise = inspect::noiseOf(detection);
    std::string html = "<h2>Targets and measures</h2>\n" + notesPicture(detection, noise, notebook, mostPixels);
    if (!notebook.targets.empty()) {
        html += headRow("targets", kTargetColumns, kTargetWidths);
        for (const inspect::PinnedTarget& target : notebook.targets) html += targetRow(detection, noise, target);
        html += "</tbody></table></div>\n";
    }
    if (!notebook.measures.empty()) {
        html += headRow("measures", kMeasureColumns, kMeasureWidths);
        for (const inspect::StoredMeasure& measure : notebook.measures) html += measureRow(detection, noise, measure, translated);
        html += "</tbody></table></div>\n";
    }
    return html;
}

std::string changeSection(const edges::Detection& now, const inspect::SceneChange& change, const std::string& earlier, int mostPixels) {
    std::string html = "<h2>Before and after</h2>\n";
    if (change.earlier.how.outOfSpec) html += "<p class=\"warning\">&#9650; OUT OF SPEC: the warnings below say why.</p>\n";
    html +=
        "<p>Before: " + htmlText(earlier) +
        ". Surfaces and edges that this scan shows otherwise; what is hidden in one of the two is not a change.</p>\n<pre id=\"change\">" +
        linesOf(inspect::changeText(*now.scan, change)) + "</pre>\n";
    const auto png = containers::pngRgbBytes(smaller(inspect::changePicture(*now.scan, change), mostPixels), "report");
    html += "<figure class=\"picture\">" + htmlImage(png ? *png : std::string(), "What changed, on the grid of this scan") +
            "<div class=\"legend\">" + legendEntry(inspect::kGainedColour, "+ edge gained, or surface nearer") +
            legendEntry(inspect::kLostColour, "&minus; edge lost, or surface farther") +
            legendEntry(inspect::kUnchangedColour, "= edge kept") + "</div></figure>\n";
    return html;
}

} // namespace edgescan::exports
