// The texts of a report.
#include "ui/controllers/report_words.h"

#include "ui/base/core_words.h"
#include "ui/base/shown_text.h"

#include <QObject>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace edgescan::ui {
namespace {

// Texts between two tags. %1 to %9 are numbers or names, or texts of this table again.
constexpr std::array kTexts{
    QT_TRANSLATE_NOOP("QObject", "Scan %1"),
    QT_TRANSLATE_NOOP("QObject",
                      "Edges and rocks are candidates: geometry only, one viewpoint. What is hidden behind a surface was not measured."),
    QT_TRANSLATE_NOOP("QObject", "Warnings"),
    QT_TRANSLATE_NOOP("QObject", "None was raised when this file was read."),
    QT_TRANSLATE_NOOP("QObject", "and %1 more in the record."),
    QT_TRANSLATE_NOOP("QObject", "Remark"),
    QT_TRANSLATE_NOOP("QObject", "What, when, by whom"),
    QT_TRANSLATE_NOOP("QObject", "Site"),
    QT_TRANSLATE_NOOP("QObject", "File"),
    QT_TRANSLATE_NOOP("QObject", "Format"),
    QT_TRANSLATE_NOOP("QObject", "Grid"),
    QT_TRANSLATE_NOOP("QObject", "%1 lines x %2 beams"),
    QT_TRANSLATE_NOOP("QObject", "Distances"),
    QT_TRANSLATE_NOOP("QObject", "%1 to %2 measured; gray levels from %3 to %4"),
    QT_TRANSLATE_NOOP("QObject", "none was measured"),
    QT_TRANSLATE_NOOP("QObject", "Scanned"),
    QT_TRANSLATE_NOOP("QObject", "the file does not say"),
    QT_TRANSLATE_NOOP("QObject", "%1 (as the pose says)"),
    QT_TRANSLATE_NOOP("QObject", "Scanner"),
    QT_TRANSLATE_NOOP("QObject", "serial %1"),
    QT_TRANSLATE_NOOP("QObject", "firmware %1"),
    QT_TRANSLATE_NOOP("QObject", "Uncertainty"),
    QT_TRANSLATE_NOOP("QObject", "ranges ± %1 m at %2 m, ± %3 m at %4 m (two standard deviations)"),
    QT_TRANSLATE_NOOP("QObject", "%1; the pose does not say its own"),
    QT_TRANSLATE_NOOP("QObject", "Edges"),
    QT_TRANSLATE_NOOP("QObject", "%1 cells, %2 % of those measured"),
    QT_TRANSLATE_NOOP("QObject", "Method"),
    QT_TRANSLATE_NOOP("QObject", "Report by"),
    QT_TRANSLATE_NOOP("QObject", "not said"),
    QT_TRANSLATE_NOOP("QObject", "Made"),
    QT_TRANSLATE_NOOP("QObject", "Note"),
    QT_TRANSLATE_NOOP("QObject", "Where"),
    QT_TRANSLATE_NOOP("QObject", "Position"),
    QT_TRANSLATE_NOOP("QObject", "not known: no pose"),
    QT_TRANSLATE_NOOP("QObject", "E %1, N %2, RL %3 m (scanner)"),
    QT_TRANSLATE_NOOP("QObject", "Frame"),
    QT_TRANSLATE_NOOP("QObject", "scanner's own frame; no pose was given"),
    QT_TRANSLATE_NOOP("QObject", "mine grid%1"),
    QT_TRANSLATE_NOOP("QObject", "Robot"),
    QT_TRANSLATE_NOOP("QObject", "the pose does not say"),
    QT_TRANSLATE_NOOP("QObject", "Pose"),
    QT_TRANSLATE_NOOP("QObject", "at a time that it does not say"),
    QT_TRANSLATE_NOOP("QObject", "%1, the start of the scan is not known"),
    QT_TRANSLATE_NOOP("QObject", "%1 s before the start of the scan"),
    QT_TRANSLATE_NOOP("QObject", "%1 s after the start of the scan"),
    QT_TRANSLATE_NOOP("QObject", "Turning view"),
    QT_TRANSLATE_NOOP(
        "QObject", "Drag to turn, wheel or two fingers to come nearer, click a point for its numbers. Keys: arrows turn, + and - come "
                   "nearer, Shift and arrows shift, Enter picks what is in the middle, Home goes back. Shown, evenly chosen: %1 and %2."),
    QT_TRANSLATE_NOOP("QObject", "Turn"),
    QT_TRANSLATE_NOOP("QObject", "Edges only"),
    QT_TRANSLATE_NOOP("QObject", "Nearer"),
    QT_TRANSLATE_NOOP("QObject", "Farther"),
    QT_TRANSLATE_NOOP("QObject", "Larger points"),
    QT_TRANSLATE_NOOP("QObject", "From the start"),
    QT_TRANSLATE_NOOP("QObject", "No point there."),
    QT_TRANSLATE_NOOP("QObject", "Line %1, beam %2: range %3 mm, %4; %5 m."),
    QT_TRANSLATE_NOOP("QObject", "Beam at %1 degrees, line at %2 degrees."),
    QT_TRANSLATE_NOOP("QObject", "Rock %1: visible %2 x %3 m, ± %4 m, at %5 m; candidate - geometry only, one viewpoint."),
    QT_TRANSLATE_NOOP("QObject", "This browser has no WebGL; the pictures below show the same."),
    QT_TRANSLATE_NOOP("QObject", "no edge"),
    QT_TRANSLATE_NOOP("QObject", "edge"),
    QT_TRANSLATE_NOOP("QObject", "jump"),
    QT_TRANSLATE_NOOP("QObject", "convex fold"),
    QT_TRANSLATE_NOOP("QObject", "concave fold"),
    QT_TRANSLATE_NOOP("QObject", "data border"),
    QT_TRANSLATE_NOOP("QObject", "outline before a void"),
    QT_TRANSLATE_NOOP("QObject", "void rim"),
    QT_TRANSLATE_NOOP("QObject", "Logo"),
    QT_TRANSLATE_NOOP("QObject", "Size curve of the visible rocks: share of the rocks over their visible width b"),
    QT_TRANSLATE_NOOP("QObject", "Ranges as gray levels, line by line"),
    QT_TRANSLATE_NOOP("QObject", "Edges on darkened gray levels"),
    QT_TRANSLATE_NOOP("QObject", "The points in perspective, seen from behind the scanner"),
    QT_TRANSLATE_NOOP("QObject", "The rocks in perspective, seen from behind the scanner"),
    QT_TRANSLATE_NOOP("QObject", "Rocks as coloured faces on gray levels"),
    QT_TRANSLATE_NOOP("QObject", "Targets and measures on gray levels"),
    QT_TRANSLATE_NOOP("QObject", "What changed, on the grid of this scan"),
    QT_TRANSLATE_NOOP("QObject", "Points of the scan in three dimensions; arrow keys turn, plus and minus come nearer, Enter picks"),
    QT_TRANSLATE_NOOP("QObject", "%1 of %2 points"),
    QT_TRANSLATE_NOOP("QObject", "%1 points"),
    QT_TRANSLATE_NOOP("QObject", "%1 of %2 edge cells"),
    QT_TRANSLATE_NOOP("QObject", "%1 edge cells"),
    QT_TRANSLATE_NOOP("QObject", "Pictures"),
    QT_TRANSLATE_NOOP("QObject", "equal ratios"),
    QT_TRANSLATE_NOOP("QObject",
                      "Gray levels: black is %1 and nearer, or nothing came back; white is %2 and farther. Across: %3; down: %4."),
    QT_TRANSLATE_NOOP("QObject", "Edges. Across: %1; down: %2."),
    QT_TRANSLATE_NOOP("QObject", "%1 beams, %2 to %3 degrees"),
    QT_TRANSLATE_NOOP("QObject", "%1 lines, %2 to %3 degrees"),
    QT_TRANSLATE_NOOP("QObject", "%1 beams"),
    QT_TRANSLATE_NOOP("QObject", "edge (%1)"),
    QT_TRANSLATE_NOOP("QObject", "jump (%1)"),
    QT_TRANSLATE_NOOP("QObject", "convex fold (%1)"),
    QT_TRANSLATE_NOOP("QObject", "concave fold (%1)"),
    QT_TRANSLATE_NOOP("QObject", "data border (%1)"),
    QT_TRANSLATE_NOOP("QObject", "outline before a void (%1)"),
    QT_TRANSLATE_NOOP("QObject", "void rim (%1)"),
    QT_TRANSLATE_NOOP(
        "QObject",
        "%1 of the edge cells are likely the border of a rock (30 % likely and more), %2 are folds within a rock, %3 are unknown."),
    QT_TRANSLATE_NOOP("QObject", "%1 m at the middle of the cloud"),
    QT_TRANSLATE_NOOP("QObject", "The points, edges in their colours."),
    QT_TRANSLATE_NOOP("QObject", "Rocks"),
    QT_TRANSLATE_NOOP("QObject", "%1 rocks, each a candidate - geometry only, one viewpoint."),
    QT_TRANSLATE_NOOP("QObject", "Sizes of the visible rocks"),
    QT_TRANSLATE_NOOP("QObject", "visible width b [m]"),
    QT_TRANSLATE_NOOP("QObject", "rocks that are not wider"),
    QT_TRANSLATE_NOOP("QObject", "largest %1"),
    QT_TRANSLATE_NOOP("QObject", "%1 % over %2"),
    QT_TRANSLATE_NOOP("QObject", "The rocks with the largest visible width b"),
    QT_TRANSLATE_NOOP("QObject", "On a narrow screen only the rocks of the table have their numbers."),
    QT_TRANSLATE_NOOP("QObject", "Completeness"),
    QT_TRANSLATE_NOOP("QObject", "INCOMPLETE"),
    QT_TRANSLATE_NOOP("QObject", "%1 of %2 lines, %3 cells."),
    QT_TRANSLATE_NOOP("QObject", "measured"),
    QT_TRANSLATE_NOOP("QObject", "no return"),
    QT_TRANSLATE_NOOP("QObject", "status of the scanner"),
    QT_TRANSLATE_NOOP("QObject", "outside the range window"),
    QT_TRANSLATE_NOOP("QObject", "masked"),
    QT_TRANSLATE_NOOP("QObject", "lost line"),
    QT_TRANSLATE_NOOP("QObject", "Settings"),
    QT_TRANSLATE_NOOP("QObject", "File and program"),
    QT_TRANSLATE_NOOP("QObject", "auto: %1"),
    QT_TRANSLATE_NOOP("QObject", "%1 degrees"),
    QT_TRANSLATE_NOOP("QObject", "%1 cells"),
    QT_TRANSLATE_NOOP("QObject", "%1 steps"),
    QT_TRANSLATE_NOOP("QObject", "%1 % of range"),
    QT_TRANSLATE_NOOP("QObject", "%1 % of high"),
    QT_TRANSLATE_NOOP("QObject", "changed from the default"),
    QT_TRANSLATE_NOOP("QObject", "The command that makes this report as a page for browsers"),
    QT_TRANSLATE_NOOP("QObject", "SHA-256 of the file"),
    QT_TRANSLATE_NOOP("QObject", "SHA-256 of the grid"),
    QT_TRANSLATE_NOOP("QObject", "SHA-256 of the edge mask"),
    QT_TRANSLATE_NOOP("QObject", "none"),
    QT_TRANSLATE_NOOP("QObject", "Program"),
    QT_TRANSLATE_NOOP("QObject", "EdgeScan %1, commit %2"),
    QT_TRANSLATE_NOOP("QObject", "The whole record"),
    QT_TRANSLATE_NOOP("QObject", "Targets and measures"),
    QT_TRANSLATE_NOOP("QObject", "Target"),
    QT_TRANSLATE_NOOP("QObject", "Name and note"),
    QT_TRANSLATE_NOOP("QObject", "Cell"),
    QT_TRANSLATE_NOOP("QObject", "Where, and its edge now"),
    QT_TRANSLATE_NOOP("QObject", "Also on its card when it was pinned"),
    QT_TRANSLATE_NOOP("QObject", "Pinned"),
    QT_TRANSLATE_NOOP("QObject", "Measured"),
    QT_TRANSLATE_NOOP("QObject", "Result, ± two standard deviations"),
    QT_TRANSLATE_NOOP("QObject", "From"),
    QT_TRANSLATE_NOOP("QObject", "line %1, beam %2"),
    QT_TRANSLATE_NOOP("QObject", "no cell of this scan"),
    QT_TRANSLATE_NOOP("QObject", "its cells hold no points now"),
    QT_TRANSLATE_NOOP("QObject", "M%1 %2"),
    QT_TRANSLATE_NOOP("QObject", "E, N, RL: %1"),
    QT_TRANSLATE_NOOP("QObject", "Distance: %1"),
    QT_TRANSLATE_NOOP("QObject", "Dip / direction: %1"),
    QT_TRANSLATE_NOOP("QObject", "Edge: %1"),
    QT_TRANSLATE_NOOP("QObject", "Resolves: %1"),
    QT_TRANSLATE_NOOP("QObject", "Surface: %1"),
    QT_TRANSLATE_NOOP("QObject", "From the boom: %1"),
    QT_TRANSLATE_NOOP("QObject", "Confidence: %1"),
    QT_TRANSLATE_NOOP("QObject", "%1° ± %2° off the beam"),
    QT_TRANSLATE_NOOP("QObject", "%1 · surface %2° off square"),
    QT_TRANSLATE_NOOP("QObject", "%1 % of %2 settings"),
    QT_TRANSLATE_NOOP("QObject", "raw grid"),
    QT_TRANSLATE_NOOP("QObject", "%1, strength %2"),
    QT_TRANSLATE_NOOP("QObject", "no plane fits"),
    QT_TRANSLATE_NOOP("QObject", "▲ no pose"),
    QT_TRANSLATE_NOOP("QObject", "nothing was measured in this cell"),
    QT_TRANSLATE_NOOP("QObject", "Before and after"),
    QT_TRANSLATE_NOOP("QObject", "▲ OUT OF SPEC: the warnings below say why."),
    QT_TRANSLATE_NOOP("QObject",
                      "Before: %1. Surfaces and edges that this scan shows otherwise; what is hidden in one of the two is not a change."),
    QT_TRANSLATE_NOOP("QObject", "+ edge gained, or surface nearer"),
    QT_TRANSLATE_NOOP("QObject", "− edge lost, or surface farther"),
    QT_TRANSLATE_NOOP("QObject", "= edge kept"),
};

// Parts of longer texts.
constexpr std::array kSentences{
    QT_TRANSLATE_NOOP("QObject", "%1 has an uncertain outline (hatched); %2 pieces are too small to be shown as rocks"),
    QT_TRANSLATE_NOOP("QObject", "%1 have an uncertain outline (hatched); %2 pieces are too small to be shown as rocks"),
    QT_TRANSLATE_NOOP("QObject", ", %1 are outside the region of interest"),
    QT_TRANSLATE_NOOP("QObject", "; %1 change was made by hand"),
    QT_TRANSLATE_NOOP("QObject", "; %1 changes were made by hand"),
    QT_TRANSLATE_NOOP("QObject", "Level %1 of -4 (fine) to 4 (coarse)."),
    QT_TRANSLATE_NOOP("QObject",
                      "Visible width b: P20 %1 m, P50 %2 m, P80 %3 m (20, 50 and 80 % of the rocks are not wider), largest %4 m"),
    QT_TRANSLATE_NOOP("QObject", "; %1 % over the site's %2 m"),
    QT_TRANSLATE_NOOP("QObject", "by number of visible rocks; hidden parts make it finer than the pile is, by 40 % and more"),
    QT_TRANSLATE_NOOP("QObject", "Rocks as faces, uncertain ones hatched. Colours only separate neighbours. The numbers are those of the "
                                 "table, the drawing and the files."),
    QT_TRANSLATE_NOOP("QObject", "The rocks on the points."),
    QT_TRANSLATE_NOOP("QObject", "%1 numbers of smaller rocks have no room and are left out."),
    QT_TRANSLATE_NOOP("QObject", "The %1 largest (visible width b) of %2 rocks; the export of rocks as a table lists all."),
    QT_TRANSLATE_NOOP("QObject",
                      "The %1 largest (visible width b) of %2 rocks; %3 more are over the site's %4; the export of rocks as a table "
                      "lists all."),
    QT_TRANSLATE_NOOP("QObject", "E, N, RL: mean of the visible points, in the mine grid"),
    QT_TRANSLATE_NOOP("QObject", "x, y, z: mean of the visible points, in the scanner's frame."),
    QT_TRANSLATE_NOOP("QObject", "a and b: visible spans across the line of sight; hidden parts are not counted. Distance: median of its "
                                 "ranges. Area: visible, across the beams. In front: share of the outline where the rock is the nearer "
                                 "side. Contacts and free height: at least. Arch: largest angle at the rock between two that it touches; ↓ "
                                 "it hangs below the line between them. p: chance that the outline is right; ▲ below 0.85, hatched."),
    QT_TRANSLATE_NOOP("QObject", "Without a pose, up is the scanner's z axis, which is assumed: free height and ↓ are measured along it."),
    QT_TRANSLATE_NOOP("QObject", "Number with ▲: merged by hand of parts that do not touch."),
    QT_TRANSLATE_NOOP("QObject", "The targets by their numbers, and what was measured. Black is near, or nothing came back."),
    QT_TRANSLATE_NOOP("QObject", "%1 value has no room in the picture; the table has all."),
    QT_TRANSLATE_NOOP("QObject", "%1 values have no room in the picture; the table has all."),
    QT_TRANSLATE_NOOP("QObject", "no pose: lined up by their surfaces"),
    QT_TRANSLATE_NOOP("QObject", "lined up by their poses"),
    QT_TRANSLATE_NOOP("QObject", "one scan with two settings"),
    QT_TRANSLATE_NOOP("QObject", "; other cells: points of one moved to the grid of the other"),
    QT_TRANSLATE_NOOP("QObject", "edges: %1 + gained, %2 - lost, %3 kept, %4 not seen by the other"),
    QT_TRANSLATE_NOOP("QObject", "cells: %1 nearer, %2 farther, %3 same, %4 no range now, %5 no range before"),
    QT_TRANSLATE_NOOP("QObject", "median difference"),
    QT_TRANSLATE_NOOP("QObject", "a change is more than %1 standard deviations: %2 mm at 5 m, %3 mm at 10 m"),
    QT_TRANSLATE_NOOP("QObject", "%1 regions of %2 cells and more, visible surface from one viewpoint"),
};

constexpr std::array<std::pair<const char*, const char*>, 9> kEntities{{{"&plusmn;", "±"},
                                                                        {"&minus;", "−"},
                                                                        {"&#9650;", "▲"},
                                                                        {"&#9888;", "⚠"},
                                                                        {"&#39;", "'"},
                                                                        {"&quot;", "\""},
                                                                        {"&lt;", "<"},
                                                                        {"&gt;", ">"},
                                                                        {"&amp;", "&"}}};

QString decoded(QString text) {
    for (const auto& [entity, sign] : kEntities) text.replace(QLatin1String(entity), QString::fromUtf8(sign));
    return text;
}

QString textInLanguage(const QString& text) {
    static const CoreTexts whole(QStringList(kTexts.begin(), kTexts.end()), true),
        sentences(QStringList(kSentences.begin(), kSentences.end()), false);
    if (const QString label = QObject::tr(exactBytes(text).c_str()); label != text) return label; // of a setting or a column
    if (const QString known = whole.translated(text, textInLanguage); known != text) return known;
    if (const QString known = sentences.translated(text); known != text) return known;
    if (text.contains(", ")) { // a list
        QStringList each = text.split(", ");
        for (QString& one : each) one = whole.translated(QObject::tr(exactBytes(one).c_str()), textInLanguage);
        return each.join(", ");
    }
    return coreSentence(text);
}

/// Spaces around a text stay.
std::string translated(std::string_view text) {
    const auto first = text.find_first_not_of(" \n"), last = text.find_last_not_of(" \n");
    if (first == text.npos) return std::string(text);
    const QString before = decoded(exactText(std::string(text.substr(first, last - first + 1))));
    QString after = textInLanguage(before);
    after.replace(QRegularExpression("(?<=\\d),(?=\\d{3}(?!\\d))"), QChar(0x202F)); // as countText()
    if (after == before) return std::string(text);
    return std::string(text.substr(0, first)) + exactBytes(after.toHtmlEscaped()) + std::string(text.substr(last + 1));
}

/// A tag with those of its attributes that are shown or read aloud.
std::string tagTranslated(std::string tag) {
    for (const char* attribute : {" data-name=\"", " alt=\"", " aria-label=\""}) {
        const std::size_t at = tag.find(attribute), begin = at + std::string_view(attribute).size();
        if (at == tag.npos) continue;
        const std::size_t end = tag.find('"', begin);
        tag.replace(begin, end - begin, translated(std::string_view(tag).substr(begin, end - begin)));
    }
    return tag;
}

std::string linesTranslated(std::string_view text) {
    std::string lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines += translated(text.substr(at, end - at)) + (end < text.size() ? "\n" : "");
        at = end + 1;
    }
    return lines;
}

} // namespace

std::string reportInLanguage(const std::string& page, const std::string& language) {
    if (language == "en") return page;
    std::string result;
    std::string tag; // before the text
    for (std::size_t at = 0; at < page.size();) {
        const std::size_t open = std::min(page.find('<', at), page.size());
        const std::string_view text = std::string_view(page).substr(at, open - at);
        const bool isCode = tag.find("translate=\"no\"") != tag.npos || tag.starts_with("<script") || tag.starts_with("<style") ||
                            tag.starts_with("<pre") || tag.starts_with("<code");
        result += tag == "<pre id=\"change\">" ? linesTranslated(text) : isCode ? std::string(text) : translated(text);
        if (open == page.size()) break;
        const bool isOpaque = page.compare(open, 7, "<script") == 0 || page.compare(open, 6, "<style") == 0;
        std::size_t end = std::min(page.find('>', open), page.size() - 1) + 1;
        const std::string next = page.substr(open, end - open);
        if (next != "<br>") tag = next; // which is within a text
        if (isOpaque) {                 // what is in them may hold tags
            const std::size_t close = page.find(tag.starts_with("<script") ? "</script>" : "</style>", end);
            end = std::min(close, page.size());
        }
        result += tag == "<html lang=\"en\">" ? "<html lang=\"" + language + "\">" : tagTranslated(page.substr(open, end - open));
        at = end;
    }
    return result;
}

} // namespace edgescan::ui
