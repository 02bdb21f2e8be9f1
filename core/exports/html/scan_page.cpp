// Writes the sections of a report in order.
#include "core/exports/html/scan_page.h"

#include "core/base/base64.h"
#include "core/base/bounded_json.h"
#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/shell_quoted.h"
#include "core/base/tolerance_text.h"
#include "core/containers/png/png.h"
#include "core/edges/gray/gray.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/exports/html/html.h"
#include "core/exports/html/notes_section.h"
#include "core/exports/html/rock_section.h"
#include "core/exports/html/scan_pictures.h"
#include "core/exports/provenance.h"
#include "core/exports/report.h"
#include "core/files/point_tables/edge_colours.h"
#include "core/inspect/measure/cell_target.h"
#include "core/scan/georef/place_form.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostWarnings = 200;
constexpr int kCloudWidth = 1000, kCloudHeight = 640;
constexpr const char* kUnknown = "the file does not say";

std::string fact(const std::string& name, const std::string& value) {
    return "<div><dt>" + htmlText(name) + "</dt><dd>" + htmlText(value.empty() ? kUnknown : value) + "</dd></div>\n";
}

/// What a person wrote remains in every language.
std::string writtenFact(const std::string& name, const std::string& value) {
    return "<div><dt>" + htmlText(name) + "</dt><dd translate=\"no\">" + htmlText(value) + "</dd></div>\n";
}

std::string textAt(const Json& record, const char* pointer) {
    const Json::json_pointer at(pointer);
    return record.contains(at) && record.at(at).is_string() ? record.at(at).get<std::string>() : std::string();
}

std::string metres(double mm) { return fixedText(mm / 1000, 2) + " m"; }

std::string frameText(const Scan& scan) {
    if (!scan.placement) return "scanner's own frame; no pose was given";
    const Placement& place = *scan.placement;
    return "mine grid" + (place.grid.empty() ? "" : " (" + place.grid + ")") + (place.outOfSpec ? ", OUT OF SPEC" : "");
}

std::string placeText(const Scan& scan) {
    if (!scan.placement) return "not known: no pose";
    const Eigen::Vector3d at = scan.placement->originEnhM + PlacedPoints(scan).local(0, 0, Eigen::Vector3d::Zero());
    return "E " + fixedText(at.x(), 3) + ", N " + fixedText(at.y(), 3) + ", RL " + fixedText(at.z(), 3) + " m (scanner)";
}

// The file's own times; where it has none, those of the pose.
std::string whenText(const Scan& scan, const Acquisition& measured) {
    const bool fromPose = measured.startUtc.empty() && scan.placement;
    const std::string start = fromPose ? scan.placement->scanStartUtc : measured.startUtc;
    const std::string end = fromPose ? scan.placement->scanEndUtc : measured.endUtc;
    if (start.empty()) return {};
    return plainUtc(start) + (end.empty() ? "" : " to " + plainUtc(end)) +
           (fromPose                       ? " (as the pose says)"
            : measured.clockSource.empty() ? ""
                                           : " (" + measured.clockSource + ")");
}

std::string poseText(const Placement& place) {
    if (place.timeUtc.empty()) return "at a time that it does not say";
    const double age = place.ageSeconds;
    return plainUtc(place.timeUtc) + (std::isnan(age) ? ", the start of the scan is not known"
                                      : age > 0       ? ", " + significantText(age, 3) + " s before the start of the scan"
                                                      : ", " + significantText(-age, 3) + " s after the start of the scan");
}

std::string uncertaintyText(const edges::Detection& detection) {
    constexpr double kNearM = 5, kFarM = 10;
    const RangeNoise noise = inspect::noiseOf(detection);
    const auto twice = [&](double atM) {
        return fixedText(shownTolerance(inspect::kReportedSigmas * noise.at(atM) / 1000.0, 3), 3) + " m at " + fixedText(atM, 0) + " m";
    };
    return "ranges ± " + twice(kNearM) + ", ± " + twice(kFarM) + " (two standard deviations)" +
           (detection.scan->placement ? "; the pose does not say its own" : "");
}

std::string placeOf(const Scan& scan) {
    std::string facts = "<h2>Where</h2>\n<dl class=\"facts\">\n" + fact("Position", placeText(scan)) + fact("Frame", frameText(scan));
    if (scan.placement)
        facts += (scan.placement->robot.empty() ? fact("Robot", "the pose does not say") : writtenFact("Robot", scan.placement->robot)) +
                 fact("Pose", poseText(*scan.placement));
    return facts + "</dl>\n";
}

std::string factsOf(const edges::Detection& detection, const Json& record, const PageWords& words) {
    const Scan& scan = *detection.scan;
    const Acquisition measured = scan.acquisition ? *scan.acquisition : Acquisition{};
    std::string scanner = measured.vendor;
    for (const std::string& more : {measured.model, measured.serial.empty() ? "" : "serial " + measured.serial,
                                    measured.firmware.empty() ? "" : "firmware " + measured.firmware}) {
        if (!more.empty()) scanner += (scanner.empty() ? "" : ", ") + more;
    }
    std::string by = words.operatorName;
    if (!words.role.empty()) by += (by.empty() ? "" : ", ") + words.role;
    const RangeLimits limits = rangeLimits(scan);
    const auto valid = countCells(scan)[static_cast<std::size_t>(CellState::Valid)];
    const auto edges = static_cast<double>(detection.edges->size());
    std::string facts = "<h2>What, when, by whom</h2>\n<dl class=\"facts\">\n";
    if (!words.site.empty()) facts += writtenFact("Site", words.site);
    facts += writtenFact("File", fileName(scan.path)) + fact("Format", scan.format);
    facts += fact("Grid", std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) + " beams");
    const edges::GrayScale& gray = detection.gray->scale;
    facts += fact("Distances", valid > 0 ? metres(limits.minMm) + " to " + metres(limits.maxMm) + " measured; gray levels from " +
                                               metres(gray.nearMm) + " to " + metres(gray.farMm)
                                         : "none was measured");
    facts += fact("Scanned", whenText(scan, measured)) + fact("Scanner", scanner);
    facts += fact("Uncertainty", uncertaintyText(detection));
    facts += fact("Edges", groupedText(detection.edges->size()) + " cells, " +
                               fixedText(100 * edges / std::max(1.0, static_cast<double>(valid)), 1) + " % of those measured");
    facts += fact("Method", edges::choiceLabel(*edges::findParameter("method"), detection.settings));
    facts += (by.empty() ? fact("Report by", "not said") : writtenFact("Report by", by)) + fact("Made", plainUtc(words.madeUtc));
    if (const std::string note = textAt(record, "/scan/note"); !note.empty()) facts += writtenFact("Note", note);
    return facts + "</dl>\n" + placeOf(scan);
}

/// "talin.boresight_rpy_deg" of a pose or calibration file as the form of the window names it: "Boresight".
std::string withoutKeys(std::string text) {
    for (const std::span<const PlaceField> form : {poseFields(), mountingFields()}) {
        for (const PlaceField& field : form) {
            const std::string key = std::string(field.group) + "." + field.key, label = field.label;
            const std::size_t at = *field.group == '\0' ? text.npos : text.find(key);
            const std::size_t end = std::min(label.find(" ["), label.find(':'));
            if (at != text.npos) text.replace(at, key.size(), '"' + label.substr(0, end) + '"');
        }
    }
    return text;
}

std::string warningsOf(const Json& record) {
    std::string html = "<h2>Warnings</h2>\n";
    const Json& warnings = record["warnings"];
    if (warnings.empty()) return html + "<p>None was raised when this file was read.</p>\n";
    for (std::size_t i = 0; i < std::min(warnings.size(), kMostWarnings); ++i)
        html += "<p class=\"warning\">&#9888; " +
                htmlText(printable(withoutKeys(warnings[i].is_string() ? warnings[i].get<std::string>() : ""))) + "</p>\n";
    if (warnings.size() > kMostWarnings) html += "<p>and " + std::to_string(warnings.size() - kMostWarnings) + " more in the record.</p>\n";
    return html;
}

/// In the order of CellState, as in the glossary.
constexpr std::array<const char*, kCellStates> kStateWords{"measured", "no return", "status of the scanner", "outside the range window",
                                                           "masked",   "lost line"};

std::string completenessOf(const Scan& scan, const Json& record) {
    const auto counts = countCells(scan);
    const Json& acquired = record["acquisition"];
    const int expected = acquired.value("lines_expected", scan.lines()), received = acquired.value("lines_received", scan.lines());
    std::string html = "<h2>Completeness</h2>\n<p>" + std::string(received < expected ? "<strong>INCOMPLETE</strong> " : "") +
                       std::to_string(received) + " of " + std::to_string(expected) + " lines, " + groupedText(scan.cells()) +
                       " cells.</p>\n<dl class=\"facts\">\n";
    for (int s = 0; s < kCellStates; ++s) {
        const auto count = counts[static_cast<std::size_t>(s)];
        const double share = 100.0 * static_cast<double>(count) / std::max(1.0, static_cast<double>(scan.cells()));
        html += fact(kStateWords.at(static_cast<std::size_t>(s)), groupedText(count) + " (" + fixedText(share, 2) + " %)");
    }
    return html + "</dl>\n";
}

constexpr std::array kClassNames{"edge", "jump", "convex fold", "concave fold", "data border", "outline before a void", "void rim"};

std::string edgeLegend(const edges::Detection& detection) {
    std::string html = "<div class=\"legend\">";
    const auto counts = edges::countClasses(detection);
    for (std::size_t kind = detection.classes ? 1 : 0; kind < (detection.classes ? kClassNames.size() : std::size_t{1}); ++kind) {
        const std::size_t count = detection.classes ? counts[kind] : detection.edges->size();
        if (count == 0 && detection.classes) continue;
        html += legendEntry(files::kEdgeColours[kind], std::string(kClassNames[kind]) + " (" + groupedText(count) + ")");
    }
    html += "</div>\n";
    if (!detection.borders) return html;
    const edges::BorderCounts borders = edges::countBorders(detection);
    const auto share = [&](std::size_t count) {
        return std::lround(100.0 * static_cast<double>(count) / std::max<double>(1, static_cast<double>(detection.edges->size())));
    };
    const long folds = share(borders.folds), unknown = share(borders.unknown),
               likely = detection.edges->empty() ? 0 : 100 - folds - unknown;
    return html + "<p class=\"note\" id=\"borders\">" + std::to_string(likely) +
           " % of the edge cells are likely the border of a rock (30 % likely and more), " + std::to_string(folds) +
           " % are folds within a rock, " + std::to_string(unknown) + " % are unknown.</p>\n";
}

std::string scaleOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    std::string text = "Across: " + std::to_string(scan.beams()) + " beams";
    if (polar != nullptr && !polar->beamDeg.empty())
        text += ", " + fixedText(polar->beamDeg.front(), 1) + " to " + fixedText(polar->beamDeg.back(), 1) + " degrees";
    text += "; down: " + std::to_string(scan.lines()) + " lines";
    if (polar != nullptr && !polar->lineDeg.empty())
        text += ", " + fixedText(polar->lineDeg.front(), 1) + " to " + fixedText(polar->lineDeg.back(), 1) + " degrees";
    return htmlText(text);
}

/// Rocks have a picture of the points of their own.
std::string cloudOf(const edges::Detection& detection) {
    const CloudPicture cloud = cloudPicture(detection, kCloudWidth, kCloudHeight);
    const double barMetres = cloud.metrePixels * 5 < kCloudWidth / 2.0 ? 5 : 1;
    return "<figure class=\"picture\">" + htmlImage(cloud.png, "The points in perspective, seen from behind the scanner") +
           "<div class=\"legend\"><span class=\"bar\" style=\"background:#444;height:4px;flex:none;width:" +
           fixedText(100 * barMetres * cloud.metrePixels / kCloudWidth, 2) + "%\"></span><span>" + fixedText(barMetres, 0) +
           " m at the middle of the cloud</span></div>\n<figcaption>The points, edges in their colours.</figcaption></figure>\n";
}

/// The first ones of the page.
std::string picturesOf(const edges::Detection& detection) {
    const Scan& scan = *detection.scan;
    const edges::GrayScale& scale = detection.gray->scale;
    std::string html = "<section class=\"pictures\">\n<figure class=\"picture\">" +
                       htmlImage(grayPicture(detection, kMostPagePixels), "Ranges as gray levels, line by line");
    html += "<div class=\"legend\"><span>" + metres(scale.nearMm) +
            "</span><span class=\"bar\" style=\"background:linear-gradient(to right,#000,#fff)\"></span><span>" + metres(scale.farMm) +
            "</span>" + (scale.logarithmic ? "<span>equal ratios</span>" : "") + "</div>\n<figcaption>Gray levels: black is " +
            metres(scale.nearMm) + " and nearer, or nothing came back; white is " + metres(scale.farMm) + " and farther. " + scaleOf(scan) +
            ".</figcaption></figure>\n";
    html += "<figure class=\"picture\">" + htmlImage(edgePicture(detection, kMostPagePixels), "Edges on darkened gray levels") +
            edgeLegend(detection) + "<figcaption>Edges. " + scaleOf(scan) + ".</figcaption></figure>\n</section>\n";
    return html;
}

/// The words of the turning view's script, in its order; then those of the classes.
constexpr std::array kViewWords{"No point there.",
                                "Line %1, beam %2: range %3 mm, %4; %5 m.",
                                "Beam at %1 degrees, line at %2 degrees.",
                                "Rock %1: visible %2 x %3 m, ± %4 m, at %5 m; candidate - geometry only, one viewpoint.",
                                "This browser has no WebGL; the pictures below show the same.",
                                "no edge"};
constexpr std::array kViewButtons{"Turn", "Edges only", "Nearer", "Farther", "Larger points", "From the start", "Rocks"};

std::string viewOf(const ViewPoints& view, bool rocks) {
    std::string buttons, words;
    for (const char* each : std::span(kViewButtons).first(kViewButtons.size() - (rocks ? 0 : 1)))
        buttons += std::string("<button>") + each + "</button>";
    for (const auto& some : {std::span<const char* const>(kViewWords), std::span<const char* const>(kClassNames)})
        for (const char* each : some) words += std::string("<span>") + each + "</span>";
    const auto part = [](std::size_t shown, std::size_t of, const char* what) {
        return groupedText(shown) + (shown == of ? "" : " of " + groupedText(of)) + " " + what;
    };
    return "<section class=\"onscreen\">\n<h2>Turning view</h2>\n<div class=\"tools\" id=\"viewtools\">" + buttons +
           "</div>\n<p id=\"viewwords\" hidden>" + words +
           "</p>\n<div class=\"view\"><canvas id=\"view\" tabindex=\"0\" role=\"application\" aria-label=\"Points of the scan in three "
           "dimensions; arrow "
           "keys turn, plus and minus come nearer, Enter picks\"></canvas></div>\n<p class=\"pick\" id=\"pick\" role=\"status\"></p>\n<p "
           "class=\"note\">Drag to turn, wheel or two fingers to come nearer, click a point for its numbers. Keys: arrows turn, + and - "
           "come "
           "nearer, Shift and arrows shift, Enter picks what is in the middle, Home goes back. Shown, evenly chosen: " +
           part(view.points, view.pointsOf, "points") + " and " + part(view.edges, view.edgesOf, "edge cells") + ".</p>\n</section>\n";
}

std::string settingsOf(const edges::Detection& detection) {
    std::string html = "<h2>Settings</h2>\n<dl class=\"facts\">\n";
    const auto changed = edges::changedFromDefault(detection.settings);
    const edges::Measured measured = edges::measuredOf(detection);
    for (const edges::Parameter& parameter : edges::parameters()) {
        if (!parameter.usedBy(detection.settings)) continue;
        const bool other = std::ranges::find(changed, std::string(parameter.key)) != changed.end();
        const std::string value = edges::choiceLabel(parameter, detection.settings), unit = std::string(" ") + parameter.unit;
        const bool automatic = parameter.automatic != nullptr && std::isnan(parameter.get(detection.settings));
        const double used = automatic ? parameter.automatic(detection.settings, measured) : edges::kAutomatic;
        html += "<div><dt>" + htmlText(parameter.label) + "</dt><dd>" +
                htmlText(value + (numberOf(value) ? unit : std::string()) +
                         (std::isnan(used) ? std::string() : ": " + significantText(used, 3) + unit)) +
                (other ? " <em>changed from the default</em>" : "") + "</dd></div>\n";
    }
    return html + "</dl>\n";
}

std::string againOf(const edges::Detection& detection, const Json& record, const PageWords& words) {
    const auto hash = [](const std::string& name, const std::string& value) {
        return "<tr><td>" + htmlText(name) + "</td><td class=\"hash\">" + htmlText(value.empty() ? "none" : value) + "</td></tr>\n";
    };
    std::string html = "<h2>File and program</h2>\n<table>\n<tbody>\n";
    html += hash("SHA-256 of the file", detection.scan->sha256) + hash("SHA-256 of the grid", textAt(record, "/scan/grid_sha256"));
    html += hash("SHA-256 of the edge mask", maskSha256(*detection.mask));
    html += hash("Program", "EdgeScan " + textAt(record, "/program/version") + ", commit " + textAt(record, "/program/commit"));
    const auto folded = [](const char* title, const char* attributes, const std::string& text) {
        return std::string("<details class=\"onscreen\"><summary>") + title + "</summary>\n<pre" + attributes + ">" + htmlText(text) +
               "</pre></details>\n";
    };
    return html + "</tbody></table>\n" +
           folded("The command that makes this report as a page for browsers", " id=\"command\"", words.command) +
           folded("The whole record", "", jsonText(record).substr(0, 60'000));
}

std::string dataOf(const edges::Detection& detection, const ViewPoints& view, const rocks::Study* rocks) {
    Json colours = Json::array();
    for (const Rgb& colour : files::kEdgeColours) colours.push_back({colour.red, colour.green, colour.blue});
    Json data{{"count", view.count},
              {"beams", detection.scan->beams()},
              {"placed", detection.scan->placement != nullptr},
              {"origin", {view.originM[0], view.originM[1], view.originM[2]}},
              {"sensor", {view.sensorM[0], view.sensorM[1], view.sensorM[2]}},
              {"colours", colours},
              {"positions", base64(view.positions)},
              {"ranges", base64(view.ranges)},
              {"cells", base64(view.cells)},
              {"classes", base64(view.classes)},
              {"levels", base64(view.levels)}};
    if (rocks != nullptr) {
        data["rocks"] = base64(view.rocks);
        data["faces"] = rockFaceData(*rocks);
    }
    if (const auto* polar = std::get_if<PolarGeometry>(&detection.scan->geometry)) {
        data["beam_deg"] = polar->beamDeg;
        data["line_deg"] = polar->lineDeg;
    }
    return "<script id=\"data\" type=\"application/json\">" + scriptJson(data) + "</script>\n";
}

/// The logo, at most 3 cm high.
std::string headOf(const PageWords& words) {
    return words.logoPng.empty() ? std::string() : "<p class=\"logo\">" + htmlImage(words.logoPng, "Logo") + "</p>\n";
}

/// What the author wrote, line by line.
std::string remarkOf(const PageWords& words) {
    if (words.remark.empty()) return {};
    std::string html = "<h2>Remark</h2>\n<p translate=\"no\">";
    for (std::size_t from = 0; from <= words.remark.size();) {
        const std::size_t end = std::min(words.remark.find('\n', from), words.remark.size());
        html += (from == 0 ? "" : "<br>\n") + htmlText(words.remark.substr(from, end - from));
        from = end + 1;
    }
    return html + "</p>\n";
}

} // namespace

Result<std::string> logoFrom(std::string_view bytes, const std::string& path) {
    constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
    if (!bytes.starts_with(kPng)) return Error{"the logo is not a PNG picture", path, "save it as PNG"};
    if (bytes.size() > kMostLogoBytes)
        return Error{"the logo has " + std::to_string(bytes.size()) + " bytes; at most " + std::to_string(kMostLogoBytes) + " are taken",
                     path, "make the picture smaller"};
    constexpr std::uint64_t kMostPixels = 4'000'000; // 3 cm of paper need far fewer
    return containers::barePng(bytes, kMostPixels, path);
}

ReadingOptions withNames(ReadingOptions options) {
    for (const ReadingOption& option : readingOptionTable()) {
        const std::string text = option.get(options);
        if (option.kind == ReadingOption::Kind::Path && !text.empty()) option.set(options, fileName(text));
    }
    return options;
}

std::string scanPage(const edges::Detection& detection, const PageWords& words, const PageNotes& notes) {
    const rocks::Study* const rocks = notes.rocks;
    const Scan& scan = *detection.scan;
    ExportOptions options;
    options.operatorName = words.operatorName;
    options.role = words.role;
    const auto parsed = parseOrderedJson(exportRecord(ExportContent::EdgeImage, detection, options), "record");
    const Json record = parsed ? *parsed : Json{{"warnings", Json::array()}, {"acquisition", Json::object()}};
    const std::optional<rocks::Faces> faces = rocks == nullptr ? std::nullopt : std::optional(rocks::rockFaces(*rocks));
    const ViewPoints view = viewPoints(detection, kMostPagePoints, kMostPageEdges, faces ? &*faces : nullptr);
    const std::string title = "Scan " + (scan.name.empty() ? fileName(scan.path) : scan.name);
    std::string body =
        "<main>\n" + headOf(words) + "<h1>" + htmlText(title) +
        "</h1>\n<p class=\"note\">Edges and rocks are candidates: geometry only, one viewpoint. What is hidden behind a surface was "
        "not measured.</p>\n";
    body += warningsOf(record) + picturesOf(detection) + remarkOf(words) + factsOf(detection, record, words) +
            completenessOf(scan, record) + viewOf(view, rocks != nullptr) + (rocks == nullptr ? cloudOf(detection) : std::string()) +
            (notes.notebook == nullptr ? std::string() : notebookSection(detection, *notes.notebook, kMostPagePixels, notes.translated)) +
            (rocks == nullptr ? std::string() : rockSection(detection, *rocks, *faces, notes.notebook)) +
            (notes.change == nullptr ? std::string() : changeSection(detection, *notes.change, notes.earlier, kMostPagePixels)) +
            settingsOf(detection) + againOf(detection, record, words) + "</main>\n" + dataOf(detection, view, rocks);
    return htmlPage(title, body, reportScript());
}

} // namespace edgescan::exports
