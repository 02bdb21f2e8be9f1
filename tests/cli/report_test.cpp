// The report of a scan: one self-contained file in which text of files is never interpreted as HTML. It works in a real browser.
#include "core/edges/pipeline/pipeline.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/inspect/measure/cell_target.h"
#include "core/inspect/measure/notebook.h"
#include "tests/support/robot_files.h"
#include "tests/support/rock_scene.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::fileText;
using test::runCli;

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(CliReport, IsOneFileThatLoadsNothingAndPromisesNothing) {
    const test::TemporaryFolder folder;
    const fs::path scan = folder / "s.pcd", page = folder / "s.html";
    ASSERT_TRUE(files::saveScan(test::boxesScan(60, 90, 4, 0.02), scan));
    const auto run = runCli("report " + scan.string() + " -o " + page.string() + " --sensitivity 1.5 --operator 'Ann B.' --role surveyor");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string text = fileText(page);
    EXPECT_EQ(countOf(text, "http"), 1U) << "only the policy's http-equiv";
    EXPECT_EQ(countOf(text, "src=\"data:image/png;base64,"), 3U);
    EXPECT_EQ(countOf(text, "src="), 3U + countOf(text, ".src="));
    EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
    const auto detect = json::parse(runCli("detect " + scan.string() + " --sensitivity 1.5 --json -").out);
    for (const std::string& phrase :
         {detect["sha256"].get<std::string>(), detect["edge_mask_sha256"].get<std::string>(),
          std::to_string(detect["edges"].get<int>()) + " cells", std::string("candidates: geometry only, one viewpoint"),
          std::string("changed from the default"), std::string("Ann B., surveyor"), std::string("no pose was given")})
        EXPECT_NE(text.find(phrase), std::string::npos) << phrase;
    // In the folder of the scan the command in the page makes the same page again, except for the time in it.
    std::smatch command;
    ASSERT_TRUE(std::regex_search(text, command, std::regex("<pre id=\"command\">edgescan-cli ([^<]*)</pre>")));
    const std::string typed = std::regex_replace(command[1].str(), std::regex("&#39;"), "'");
    fs::rename(page, folder / "first.html");
    const std::string program = fs::absolute(test::programFolder()).string() + "/edgescan-cli ";
    ASSERT_EQ(std::system(("cd " + folder.path().string() + " && " + program + typed + " >" + (folder / "said").string()).c_str()), 0)
        << typed;
    const std::regex made("<dt>Made</dt><dd>[^<]*</dd>");
    EXPECT_EQ(std::regex_replace(fileText(page), made, ""), std::regex_replace(text, made, ""));
    fs::copy_file(scan, folder / "scan.html");
    EXPECT_EQ(runCli("report " + (folder / "scan.html").string() + " -o " + (folder / "scan.html").string()).code,
              1); // never over the input
    EXPECT_EQ(runCli("report " + (folder / "none.pcd").string() + " -o " + (folder / "n.html").string()).code, 1);
    EXPECT_FALSE(fs::exists(folder / "n.html"));
}

TEST(CliReport, TellsWhatWasPinnedMeasuredAndWhatChanged) {
    const test::TemporaryFolder folder;
    const fs::path now = folder / "now.pcd", before = folder / "before.pcd", page = folder / "s.html", targets = folder / "t.json";
    Scan scan = test::boxesScan(60, 90, 4, 0.0);
    ASSERT_TRUE(files::saveScan(scan, now));
    for (int line = 20; line < 30; ++line) {
        for (int beam = 30; beam < 45; ++beam) scan.rangeMm.at(line, beam) += 900.0F;
    }
    ASSERT_TRUE(files::saveScan(scan, before));
    const auto opened = files::openScan(now);
    ASSERT_TRUE(opened);
    inspect::Notebook notebook;
    notebook.targets.push_back({.number = 3,
                                .name = "<b>key & stone",
                                .cell = 25 * 90 + 40,
                                .pinnedUtc = "2026-11-21T08:00:00Z",
                                .asPinned = {{"distance", "5.1 m"}}});
    notebook.measures.push_back({.kind = inspect::MeasureKind::Distance, .cells = {10 * 90 + 20, 40 * 90 + 70}, .number = 2});
    std::ofstream(targets) << inspect::notebookText(notebook, inspect::notebookScan(*opened));
    const std::string flags =
        "report " + now.string() + " -o " + page.string() + " --targets " + targets.string() + " --before " + before.string();
    const auto run = runCli(flags);
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string text = fileText(page);
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(*opened), edges::Settings{});
    const auto measured =
        inspect::measureCells(*opened, inspect::noiseOf(*detection), inspect::MeasureKind::Distance, notebook.measures[0].cells);
    ASSERT_TRUE(measured);
    const auto change = runCli("compare " + before.string() + " " + now.string());
    ASSERT_EQ(change.code, 0) << change.err;
    const std::string largest = std::regex_replace(change.out.substr(0, change.out.find('\n')), std::regex("&"), "&amp;");
    for (const std::string& phrase :
         {std::string("&lt;b&gt;key &amp; stone"), std::string("line 25, beam 40"), std::string("distance: 5.1 m"),
          std::string("data-name=\"Where, and its edge now\">Distance: "), // a card on a phone
          std::string("<h2>Where</h2>"), std::string("<dt>Position</dt><dd>not known: no pose"),
          std::string(" measured; gray levels from "), std::string("<dt>Jump</dt><dd>auto: "), std::string("Edge: no edge"),
          inspect::measureText(*measured), std::string("Before and after"), std::string("OUT OF SPEC"), largest})
        EXPECT_NE(text.find(phrase), std::string::npos) << phrase;
    EXPECT_EQ(text.find("<b>key"), std::string::npos);
    EXPECT_EQ(countOf(text, "src=\"data:image/png;base64,"), 5U);
    for (const char* ours : {"no_return", "out_of_window", "silhouette", "convex crease"})
        EXPECT_EQ(text.substr(0, text.find("The whole record")).find(ours), std::string::npos) << "a word of files: " << ours;
    EXPECT_EQ(text.find(now.parent_path().string() + "/"), std::string::npos);
    // Targets of another scan, and an impossible path.
    EXPECT_EQ(runCli("report " + before.string() + " -o " + (folder / "x.html").string() + " --targets " + targets.string()).code, 1);
    EXPECT_EQ(runCli("report " + now.string() + " -o " + (folder / "x.html").string() + " --before " + (folder / "none.pcd").string()).code,
              1);
    EXPECT_FALSE(fs::exists(folder / "x.html"));
}

TEST(CliReport, TextOfFilesAndNamesStaysText) {
    const test::TemporaryFolder folder;
    Scan hostile = test::boxesScan(20, 30, 4);
    hostile.note = "</script><script>alert(1)</script><img src=x onerror=alert(2)>";
    const fs::path scan = folder / "a<script>alert(3)<\xe2\x80\xaex'\"&.json";
    ASSERT_TRUE(files::saveScan(hostile, scan));
    const fs::path page = folder / "s.html";
    std::string quoted = "'";
    for (const char c : scan.string()) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    const auto run = runCli("report " + quoted + "' -o " + page.string() + " --operator '<b onclick=\"x\">'");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string text = fileText(page);
    EXPECT_EQ(countOf(text, "<script"), 2U); // the data and the code
    EXPECT_EQ(countOf(text, "<img"), 3U);
    EXPECT_EQ(countOf(text, "<b "), 0U);
    EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos);
    EXPECT_EQ(text.find(folder.path().string()), std::string::npos); // files by their names, no home and no user
    EXPECT_NE(text.find("&lt;img src=x onerror=alert(2)&gt;"), std::string::npos);
}

// What the script of a page writes into its attribute data-found.
std::string foundIn(const fs::path& folder, const std::string& text) {
    std::ofstream(folder / "tried.html", std::ios::binary) << text;
    const std::string command =
        "cd " + folder.string() +
        " && timeout 300 chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader "
        "--user-data-dir=profile --allow-file-access-from-files --window-size=1400,900 --enable-logging=stderr --virtual-time-budget=3000 "
        "--dump-dom "
        "tried.html >dom 2>log";
    EXPECT_EQ(std::system(command.c_str()), 0) << fileText(folder / "log");
    EXPECT_EQ(fileText(folder / "log").find("CONSOLE"), std::string::npos) << fileText(folder / "log");
    std::smatch found;
    const std::string dom = fileText(folder / "dom");
    const std::size_t at = dom.find("data-found=\"");
    if (at == std::string::npos) return {};
    const std::string value = dom.substr(at + 12, dom.find('"', at + 12) - at - 12);
    return std::regex_replace(value, std::regex("&quot;"), "\"");
}

// A page with an added script that acts like an operator and writes the result into the document.
std::string inBrowser(const fs::path& folder, const fs::path& page, const std::string& script) {
    std::string text = fileText(page);
    text.insert(text.rfind("</body>"), "<script>" + script + "</script>");
    return foundIn(folder, text);
}

// The page as on a screen of this width, or as printed on paper of this width; the script sees its document as `page`, and fills `found`.
std::string inFrame(const fs::path& folder, const fs::path& page, int width, bool printed, const std::string& script) {
    return foundIn(folder, "<!DOCTYPE html><body><iframe id=\"frame\" src=\"" + page.filename().string() +
                               "\" style=\"border:0;width:" + std::to_string(width) + R"JS(px;height:800px"></iframe><script>
        var frame = document.getElementById('frame');
        frame.onload = function () {
          var page = frame.contentDocument, view = frame.contentWindow, found = {}, printed = )JS" +
                               (printed ? "true" : "false") + R"JS(;
          if (printed) Array.prototype.forEach.call(page.styleSheets[0].cssRules, function (rule) {
            if (rule.media) rule.media.mediaText = rule.media.mediaText.indexOf('print') >= 0 ? 'all' : 'not all';
          });
          )JS" + script + R"JS(
          document.body.setAttribute('data-found', JSON.stringify(found));
        };</script></body>)JS");
}

TEST(CliReport, ItsViewTurnsAndPicksInARealBrowser) {
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed (apt-get install chromium)";
    const test::TemporaryFolder folder;
    const Scan scan = test::boxesScan(80, 120, 4);
    ASSERT_TRUE(files::saveScan(scan, folder / "s.json"));
    ASSERT_EQ(runCli("report " + (folder / "s.json").string() + " -o " + (folder / "s.html").string()).code, 0);
    const std::string found = inBrowser(folder.path(), folder / "s.html", R"JS(
        var view = document.getElementById('view'), found = {};
        function seen() {
          var copy = document.createElement('canvas'); copy.width = view.width; copy.height = view.height;
          var pen = copy.getContext('2d'); pen.drawImage(view, 0, 0);
          var d = pen.getImageData(0, 0, copy.width, copy.height).data, counts = { drawn: 0, edges: 0, sum: 0 };
          for (var i = 0; i < d.length; i += 4) {
            if (d[i] > 40 || d[i + 1] > 40) { counts.drawn++; counts.sum = (counts.sum * 31 + i) % 1000000007; }
            if (d[i + 1] > 200 && d[i] < 60) counts.edges++;
          }
          return counts;
        }
        function key(name) { view.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true, cancelable: true })); }
        found.first = seen();
        key('ArrowLeft'); key('ArrowUp'); found.turned = seen();
        key('Home'); found.home = seen();
        key('Enter'); found.picked = document.getElementById('pick').textContent;
        document.querySelectorAll('#viewtools button')[1].click(); found.edgesOnly = seen();
        key('Enter'); found.edge = document.getElementById('pick').textContent;
        found.wide = document.documentElement.scrollWidth > window.innerWidth;
        document.body.setAttribute('data-found', JSON.stringify(found));)JS");
    ASSERT_FALSE(found.empty());
    const json result = json::parse(found);
    EXPECT_GT(result["first"]["drawn"].get<int>(), 3000) << result;
    EXPECT_GT(result["first"]["edges"].get<int>(), 100);
    EXPECT_NE(result["turned"]["sum"], result["first"]["sum"]);
    EXPECT_EQ(result["home"]["sum"], result["first"]["sum"]);
    EXPECT_LT(result["edgesOnly"]["drawn"].get<int>(), result["first"]["drawn"].get<int>());
    EXPECT_FALSE(result["wide"].get<bool>());
    std::smatch match;
    const std::string picked = result["picked"];
    ASSERT_TRUE(std::regex_search(picked, match, std::regex("Line ([0-9]+), beam ([0-9]+): range ([0-9]+) mm"))) << picked;
    EXPECT_EQ(std::stod(match[3]), std::round(scan.rangeMm.at(std::stoi(match[1]), std::stoi(match[2])))) << picked;
}

// The 25 largest, and all over the oversize, up to 100.
std::size_t rowsFor(const json& rocks, double oversizeM) {
    const auto over = std::ranges::count_if(rocks, [&](const json& rock) { return rock["visible_wide_m"].get<double>() > oversizeM; });
    return std::min(rocks.size(), std::clamp<std::size_t>(static_cast<std::size_t>(over), 25, 100));
}

TEST(CliReport, ShowsRocksInPicturesTableAndCurve) {
    const test::TemporaryFolder folder;
    const fs::path scan = folder / "bell.json", page = folder / "s.html";
    ASSERT_TRUE(files::saveScan(*test::rockScene("hangup", 77, 240, 274).scan, scan));
    const auto run = runCli("report " + scan.string() + " -o " + page.string() + " --rocks --level 0.5 --oversize 0.6");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string text = fileText(page);
    const json rocks = json::parse(runCli("rocks " + scan.string() + " --level 0.5 --oversize 0.6 --json -").out);
    ASSERT_GT(rocks["rock_count"], 10);
    EXPECT_NE(text.find(std::to_string(rocks["rock_count"].get<int>()) + " rocks, each a candidate - geometry only, one viewpoint"),
              std::string::npos);
    EXPECT_EQ(countOf(text, "src=\"data:image/png;base64,"), 4U);
    const std::size_t table = text.find("<table id=\"rocks\">");
    ASSERT_NE(table, std::string::npos);
    EXPECT_EQ(countOf(text.substr(table, text.find("</table>", table) - table), "<tr>"), 1 + rowsFor(rocks["rocks"], 0.6));
    double longest = 0;
    for (const json& rock : rocks["rocks"]) longest = std::max(longest, rock["visible_long_m"].get<double>());
    const std::string name = "data-name=\"visible length a [m]\">";
    EXPECT_NEAR(std::stod(text.substr(text.find(name) + name.size())), longest, 0.006);
    EXPECT_EQ(countOf(text, "<svg id=\"sizes\""), 1U);
    EXPECT_NE(text.find("over 0.60 m"), std::string::npos);
    EXPECT_NE(text.find("40 % and more"), std::string::npos);
    EXPECT_NE(text.find("--rocks --level 0.5 --oversize 0.6"), std::string::npos);
    // All over the oversize are in the table, or the page says how many are not.
    for (const auto& [oversize, said] :
         {std::pair{"0.3", "the export of rocks as a table lists all"}, {"0.05", " more are over the site&#39;s 0.05 m"}}) {
        ASSERT_EQ(runCli("report " + scan.string() + " -o " + page.string() + " --rocks --level -4 --oversize " + oversize).code, 0);
        const std::string other = fileText(page);
        const json all = json::parse(runCli("rocks " + scan.string() + " --level -4 --oversize " + oversize + " --json -").out)["rocks"];
        EXPECT_EQ(countOf(other, "data-name=\"Rock\""), rowsFor(all, std::stod(oversize)));
        EXPECT_EQ(other.find(said) != std::string::npos, all.size() > rowsFor(all, std::stod(oversize))) << all.size();
    }
    ASSERT_EQ(runCli("report " + scan.string() + " -o " + page.string() + " --rocks --level 0.5 --oversize 0.6").code, 0);
    EXPECT_EQ(runCli("report " + scan.string() + " -o " + page.string() + " --level 1").code, 2);
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed (apt-get install chromium)";
    const std::string found = inBrowser(folder.path(), page, R"JS(
        var view = document.getElementById('view'), found = {};
        function seen() {
          var copy = document.createElement('canvas'); copy.width = view.width; copy.height = view.height;
          var pen = copy.getContext('2d'); pen.drawImage(view, 0, 0);
          var d = pen.getImageData(0, 0, copy.width, copy.height).data, counts = { coloured: 0, green: 0 };
          for (var i = 0; i < d.length; i += 4) {
            if (Math.abs(d[i] - d[i + 1]) + Math.abs(d[i + 1] - d[i + 2]) > 40) counts.coloured++;
            if (d[i + 1] > 200 && d[i] < 60) counts.green++;
          }
          return counts;
        }
        found.rocks = seen();
        var buttons = document.querySelectorAll('#viewtools button');
        buttons[buttons.length - 1].click(); found.edges = seen();
        buttons[buttons.length - 1].click();
        view.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true, cancelable: true }));
        found.picked = document.getElementById('pick').textContent;
        document.body.setAttribute('data-found', JSON.stringify(found));)JS");
    ASSERT_FALSE(found.empty());
    const json result = json::parse(found);
    EXPECT_GT(result["rocks"]["coloured"].get<int>(), 3000) << result;
    EXPECT_EQ(result["rocks"]["green"].get<int>(), 0) << result;
    EXPECT_GT(result["edges"]["green"].get<int>(), 100) << result;
    EXPECT_NE(result["picked"].get<std::string>().find("Line "), std::string::npos) << result;
}

// A scan with a pose and the files of its robot, and its report with rocks.
class PlacedReport : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(files::saveScan(*test::rockScene("hangup", 77, 240, 274).scan, folder / "bell.json"));
        Calibration robot = test::exampleCalibration();
        robot.axis = {1, 0, 0};
        robot.robot = "Mule 7";
        std::ofstream(folder / "robot.json") << test::calibrationText(robot);
        std::ofstream(folder / "pose.json") << R"({"format": "edgescan-pose/1", "robot": "Mule 7", "boom": {"azimuth_deg": 33.5},
            "scan_start": "2026-11-20T10:00:00Z", "scan_end": "2026-11-20T10:00:40.500Z",
            "inclinometer": {"time": "2026-11-20T09:59:58Z", "tilt_x_deg": 14.25, "tilt_y_deg": -3.4},
            "talin": {"time": "2026-11-20T09:59:58Z", "easting_m": 498765.432, "northing_m": 5150123.456, "elevation_m": 287.654,
                      "heading_deg": 217.4, "pitch_deg": 5.75, "roll_deg": -2.1, "zone": "17N", "datum": "WGS84"}})";
        const auto run = runCli("report " + flags + " --rocks --oversize 0.6 -o " + (folder / "s.html").string());
        ASSERT_EQ(run.code, 0) << run.err;
        text = fileText(folder / "s.html");
        rocks = json::parse(runCli("rocks " + flags + " --oversize 0.6 --json -").out)["rocks"];
        ASSERT_GT(rocks.size(), 25U);
    }
    test::TemporaryFolder folder;
    std::string flags = (folder / "bell.json").string() + " --pose " + (folder / "pose.json").string() + " --calibration " +
                        (folder / "robot.json").string();
    std::string text;
    json rocks;
};

TEST_F(PlacedReport, SaysWhereEachRockIsAndWhenTheScanWasMade) {
    const auto value = [](const std::string& row, const std::string& name) {
        const std::string tag = "data-name=\"" + name + "\">";
        return std::stod(row.substr(row.find(tag) + tag.size()));
    };
    std::size_t rows = 0;
    for (std::size_t at = text.find("<tr><td class=\"number\" data-name=\"Rock\">"); at != std::string::npos;
         at = text.find("<tr><td class=\"number\" data-name=\"Rock\">", at + 1)) {
        const std::string row = text.substr(at, text.find("</tr>", at) - at);
        const json& rock = rocks[static_cast<std::size_t>(value(row, "Rock")) - 1];
        EXPECT_NEAR(value(row, "E [m]"), rock["easting_m"].get<double>(), 0.006);
        EXPECT_NEAR(value(row, "N [m]"), rock["northing_m"].get<double>(), 0.006);
        EXPECT_NEAR(value(row, "RL [m]"), rock["elevation_m"].get<double>(), 0.006);
        ++rows;
    }
    EXPECT_EQ(rows, rowsFor(rocks, 0.6));
    for (const char* phrase :
         {"<dt>Scanned</dt><dd>2026-11-20 10:00:00 UTC to 2026-11-20 10:00:40 UTC (as the pose says)</dd>",
          "<dt>Robot</dt><dd translate=\"no\">Mule 7</dd>",
          "<dt>Pose</dt><dd>2026-11-20 09:59:58 UTC, 2 s before the start of the scan</dd>", "<dt>Uncertainty</dt><dd>ranges ± "})
        EXPECT_NE(text.find(phrase), std::string::npos) << phrase;
    EXPECT_TRUE(std::regex_search(text, std::regex("<dt>Made</dt><dd>[0-9]{4}-[0-9]{2}-[0-9]{2} [0-9:]{8} UTC</dd>")));
}

TEST_F(PlacedReport, ShowsEveryColumnAndNumberAtEveryWidthInARealBrowser) {
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed (apt-get install chromium)";
    constexpr int kPaper = 680; // 180 mm between the margins of A4
    for (const int width : {390, kPaper, 800, 1280}) {
        SCOPED_TRACE(width);
        const json found = json::parse(inFrame(folder.path(), folder / "s.html", width, width == kPaper, R"JS(
            function box(e) { return e.getBoundingClientRect(); }
            function isShown(e) { return box(e).width > 0 && view.getComputedStyle(e).visibility === 'visible'; }
            var edge = page.documentElement.clientWidth, all = Array.prototype.slice;
            found.wide = page.documentElement.scrollWidth > edge;
            var cells = all.call(page.querySelectorAll('#rocks td'));
            found.cells = cells.length;
            found.outside = cells.filter(function (c) { return !isShown(c) || box(c).right > edge || c.scrollWidth > box(c).width + 1; }).length;
            var heads = all.call(page.querySelectorAll('#rocks th')).filter(isShown).length;
            found.named = heads > 0 ? heads : cells.slice(0, 14).filter(function (c) {
              return view.getComputedStyle(c, '::before').content.length > 2;
            }).length;
            found.tables = all.call(page.querySelectorAll('.wide')).filter(function (w) { return w.scrollWidth > w.clientWidth; }).length;
            var picture = page.querySelector('.numbered'), numbers = {}, image = box(picture.querySelector('img'));
            all.call(picture.querySelectorAll('text')).filter(isShown).forEach(function (t) {
              var b = box(t);
              numbers[t.textContent] = b.left > image.left - 9 && b.right < image.right + 9 && b.top > image.top - 9 && b.bottom < image.bottom + 9 &&
                b.height > 6;
            });
            found.missing = cells.filter(function (c, n) { return n % 14 === 0 && !numbers[c.textContent]; }).length;
            var labels = all.call(page.querySelectorAll('#sizes text')).map(box);
            found.labels = labels.length;
            found.covered = 0;
            labels.forEach(function (a, n) { labels.slice(n + 1).forEach(function (b) {
              if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) found.covered++;
            }); });)JS"));
        EXPECT_FALSE(found["wide"].get<bool>());
        EXPECT_EQ(found["cells"], rowsFor(rocks, 0.6) * 14);
        EXPECT_EQ(found["outside"], 0);
        EXPECT_EQ(found["named"], 14);
        EXPECT_EQ(found["tables"], 0);
        EXPECT_EQ(found["missing"], 0);
        EXPECT_GT(found["labels"], 10);
        EXPECT_EQ(found["covered"], 0);
    }
    EXPECT_NE(text.find("visible width b [m]</text>"), std::string::npos);
}

TEST(CliReport, PrintsOnA4InARealBrowser) {
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed (apt-get install chromium)";
    const test::TemporaryFolder folder;
    ASSERT_TRUE(files::saveScan(test::boxesScan(80, 120, 4), folder / "s.json"));
    ASSERT_EQ(runCli("report " + (folder / "s.json").string() + " -o " + (folder / "s.html").string()).code, 0);
    const std::string command = "cd " + folder.path().string() +
                                " && timeout 300 chromium --headless --no-sandbox --user-data-dir=profile --no-pdf-header-footer "
                                "--print-to-pdf=s.pdf s.html >log 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << fileText(folder / "log");
    const std::string pdf = fileText(folder / "s.pdf");
    EXPECT_TRUE(pdf.starts_with("%PDF"));
    std::smatch box;
    ASSERT_TRUE(std::regex_search(pdf, box, std::regex(R"(/MediaBox \[0 0 ([0-9.]+) ([0-9.]+)\])")));
    EXPECT_NEAR(std::stod(box[1]), 595.3, 1);
    EXPECT_NEAR(std::stod(box[2]), 841.9, 1);
}

TEST(CliReport, OfTheLargestScanItStaysBelowItsBound) {
    const test::TemporaryFolder folder;
    Scan scan = test::boxesScan(1300, 1300, 4, 0.3); // more cells than pixels, and noise that PNG cannot compress
    std::uint32_t state = 1;
    for (float& range : scan.rangeMm.cells) range = static_cast<float>(1000 + (state = state * 1664525U + 1013904223U) / 200000U);
    ASSERT_TRUE(files::saveScan(scan, folder / "s.mcap"));
    ASSERT_EQ(runCli("report " + (folder / "s.mcap").string() + " -o " + (folder / "s.html").string()).code, 0);
    const auto bytes = fs::file_size(folder / "s.html");
    EXPECT_LT(bytes, 14'000'000U); // docs/reference/report.md
    EXPECT_GT(bytes, 2'000'000U);
}

} // namespace
} // namespace edgescan
