// OBJ (Wavefront): vertices, with colours where edges are known. Edges as lines would hide the points in many viewers.

#include "core/base/translated_text.h"
#include "core/files/formats/format.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/files/point_tables/axis_words.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/point_columns.h"
#include "core/files/point_tables/text_layout.h"
#include "core/files/point_tables/text_refusals.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::size_t kLinesLookedAt = 200;

bool isObjWord(std::string_view word) {
    static constexpr std::array<std::string_view, 12> kWords{"v", "vn", "vt", "vp", "f", "l", "o", "g", "s", "mtllib", "usemtl", "p"};
    return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

/// Curves, surfaces and display attributes, which few files have.
bool isRareObjWord(std::string_view word) {
    static constexpr std::array<std::string_view, 30> kWords{
        "cstype", "deg",      "bmat",     "step",  "curv",       "curv2",     "surf",  "parm",  "trim",   "hole",
        "scrv",   "sp",       "end",      "con",   "mg",         "bevel",     "bzp",   "bsp",   "lod",    "maplib",
        "usemap", "c_interp", "d_interp", "ctech", "shadow_obj", "trace_obj", "stech", "group", "object", "call"};
    return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

std::string_view firstWord(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    return line.substr(0, line.find_first_of(" \t"));
}

std::optional<double> numberIn(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
    return problem == std::errc{} ? value : std::nan("");
}

/// Text whose first words are those of OBJ.
bool looksLikeObj(const Source& source) {
    if (firstByteThatIsNoText(source.text())) return false;
    std::string_view text = source.text();
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    HeaderLines lines(text.substr(0, 65536));
    while (lines.number() < kLinesLookedAt && lines.next()) {
        const auto words = wordsOf(lines.line());
        if (words.empty() || words[0].starts_with('#')) continue;
        return words.size() > 1 && isObjWord(words[0]);
    }
    return false;
}

Result<PointTable> readObjPoints(const Source& source) {
    // A vertex takes eight bytes of text at least ("v 1 2 3") and 24 in memory, twice while it grows.
    if (auto enough = checkMemory(std::uint64_t{source.bytes.size()} * 6, source.path.string()); !enough) return enough.error();
    PointTable table;
    table.format = "OBJ";
    PrintedDigits digits;
    HeaderLines lines(source.text());
    std::size_t unknown = 0, firstUnknown = 0;
    std::optional<double> unitMm;
    bool continued = false; // by a \ at the end of the line before
    while (lines.next()) {
        const std::string_view line = lines.line();
        const std::string_view word = firstWord(line);
        const bool goesOn = std::exchange(continued, line.ends_with('\\'));
        if (word != "v") {
            const bool known = goesOn || word.empty() || word.starts_with('#') || isObjWord(word) || isRareObjWord(word);
            if (!known && unknown++ == 0) firstUnknown = lines.number();
            const auto unit = word.starts_with('#') && table.points.empty() ? unitInComment(line) : std::nullopt;
            if (unit) unitMm = unit;
            continue;
        }
        const auto words = wordsOf(line);
        Eigen::Vector3d point;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto value = i + 1 < words.size() ? numberIn(words[i + 1]) : std::nullopt;
            if (!value && i + 1 < words.size()) return noNumber(source, lines.number(), words[i + 1]);
            if (!value)
                return source.refusedAtLine(lines.number(), "this vertex does not hold three numbers",
                                            "copy the file again, it may be cut off here");
            point[static_cast<Eigen::Index>(i)] = *value;
            if (table.points.size() < 20000) countDigits(words[i + 1], digits);
        }
        table.points.push_back(point);
        if (table.points.size() % 16384 == 0 &&
            !source.goOn("reading points", 0.5 * static_cast<double>(lines.nextByte()) / static_cast<double>(source.bytes.size())))
            return source.cancelled();
    }
    if (table.points.empty()) return source.refused("this OBJ file has no vertices", "choose another file");
    if (unknown > 0)
        table.remarks.push_back(withValues(counted(unknown, "line holds no words of OBJ and was not read, the first is line %1.",
                                                   "lines hold no words of OBJ and were not read, the first is line %1."),
                                           {firstUnknown}));
    if (endsWithoutLineEnd(source.text())) table.remarks.emplace_back(kMayBeCutOff);
    table.width = table.points.size();
    table.precision = precisionOf(digits);
    takeUnitOfComment(table, unitMm, source);
    return table;
}

/// Viewers draw no vertices that nothing refers to: every one is a point element too, a hundred per line.
void appendElements(std::string& text, std::size_t points) {
    constexpr std::size_t kPerLine = 100;
    for (std::size_t n = 1; n <= points; ++n) {
        text += (n - 1) % kPerLine == 0 ? "p " : " ";
        text += std::to_string(n);
        if (n % kPerLine == 0 || n == points) text += '\n';
    }
}

Result<std::string> objBytes(CloudColumns cloud, const std::string& where, bool) {
    if (auto enough = checkMemory(std::uint64_t{rowsOf(cloud)} * 60, where); !enough) return enough.error();
    std::string text = "# " + frameText(cloud) + "\n";
    for (const std::string& line : commentLines(cloud.record, kRecordMark)) text += "# " + line + "\n";
    const std::array<const CloudColumn*, 3> colours{columnNamed(cloud, "red"), columnNamed(cloud, "green"), columnNamed(cloud, "blue")};
    const CloudColumn* state = columnNamed(cloud, "state");
    const int decimals = cloud.frame == CoordinateFrame::Mine ? 4 : 6;
    std::size_t points = 0;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        if (state != nullptr && numberIn(*state, row) != 0) continue; // no point there
        text += 'v';
        const Eigen::Vector3d point = pointIn(cloud, row);
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            appendFixed(text, point[axis], decimals);
        }
        for (const CloudColumn* colour : colours) { // behind the vertex: the common extension
            if (colour == nullptr) continue;
            text += ' ';
            appendFixed(text, numberIn(*colour, row) / 255.0, 3);
        }
        text += '\n';
        ++points;
    }
    appendElements(text, points);
    return text;
}

} // namespace

Format objFormat() {
    return {.title = "Wavefront OBJ",
            .reads = {".obj"},
            .writes = {".obj"},
            .recognises = looksLikeObj,
            .read = readingOf<readObjPoints>,
            .write = objBytes,
            .keeps = Keeps::Points,
            .inFloats = {"MeshLab", "PCL", "Blender", "three.js", "loaders.gl"}};
}

} // namespace edgescan::files
