// One scan of an archive: checks whether it is done; if not, reads it, detects, writes to a staging folder, moves the files into place and
// reports.
#include "app/cli/batch_scan.h"

#include "app/shared/outputs.h"
#include "core/base/bounded_json.h"
#include "core/base/inputs.h"
#include "core/base/json_text.h"
#include "core/base/sha256.h"
#include "core/base/shell_quoted.h"
#include "core/base/utc_time.h"
#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/edges/settings/parameters.h"
#include "core/exports/html/scan_page.h"
#include "core/exports/html/survey_page.h"
#include "core/exports/report.h"
#include "core/exports/rock_files.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/points_on_grid.h"
#include "core/files/open_save/sidecar_grid.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// A word of --results.
struct ResultWord {
    std::string word;
    const exports::ExportKind* kind; ///< null: not an export; stem and extension are given below
    std::string stem = {};
    std::string extension = {}; ///< empty: the extension is typed after the word
};

/// Results of edges, then of rocks; in each group those of one format come first.
const std::vector<ResultWord>& resultWords() {
    static const std::vector<ResultWord> kWords = [] {
        std::vector<ResultWord> words;
        const auto add = [&](exports::ExportKind::Needs needs, bool oneFormat) {
            for (const exports::ExportKind& kind : exports::exportKinds()) {
                const bool one = kind.holds != exports::ExportKind::Holds::Points && kind.files.size() == 1;
                const bool inFolder = std::ranges::any_of(kind.files, &exports::ExportFile::inFolder); // a section needs a plane
                if (kind.needs == needs && one == oneFormat && inFolder)
                    words.push_back({kind.key, &kind, {}, one ? kind.files.front().extension : ""});
            }
        };
        add(exports::ExportKind::Needs::Edges, true);
        words.push_back({"json", nullptr, "detect", ".json"});
        words.push_back({"report", nullptr, "report", ".html"});
        add(exports::ExportKind::Needs::Edges, false);
        add(exports::ExportKind::Needs::Rocks, true);
        add(exports::ExportKind::Needs::Rocks, false);
        return words;
    }();
    return kWords;
}

double milliseconds(Clock::time_point since) {
    return std::round(std::chrono::duration<double, std::milli>(Clock::now() - since).count() * 1000) / 1000;
}

double cpuMilliseconds() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

// Size and modification time in nanoseconds since 1970: they show that a file is still being written.
struct FileState {
    std::int64_t bytes = -1, modified = -1;
    bool operator==(const FileState&) const = default;
};
FileState stateOf(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {status.st_size, std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

fs::path folderOf(const BatchWork& work, std::size_t job) { return work.results / "scans" / work.names[job]; }

Json beginRow(const BatchWork& work, std::size_t job) {
    return {{"input", work.inputs[job]},
            {"outcome", "done"},
            {"results", "scans/" + work.names[job]},
            {"settings_sha256", work.settingsSha256},
            {"program", std::string(version()) + " " + commit()}};
}

// Lists every file that was read for this scan: the scan, its counts or description, pose, calibration and provenance record. Returns
// whether the scan's own file is readable.
bool addInputFiles(Json& row, const std::string& input, const InputClaims& claims) {
    std::vector<std::string> paths{input};
    for (const fs::path& path : claimedPaths(claims)) {
        if (std::ranges::find(paths, path.string()) == paths.end()) paths.push_back(path.string());
    }
    std::sort(paths.begin() + 1, paths.end());
    Json files = Json::array(), modified = Json::array();
    for (const std::string& path : paths) {
        const FileState state = stateOf(path);
        const auto hash = sha256OfFile(path);
        files.push_back({{"file", path}, {"bytes", state.bytes}, {"sha256", hash ? Json(*hash) : Json()}});
        modified.push_back(state.modified);
    }
    row["bytes"] = files[0]["bytes"];
    row["sha256"] = files[0]["sha256"];
    row["files"] = files;
    row["record_beside"] = files::sidecarOf(input).has_value();
    row["times"]["modified"] = modified;
    return files[0]["bytes"] >= 0 && files[0]["sha256"].is_string();
}

Json changedSettings(const edges::Settings& settings) {
    const auto all = edges::settingsToJson(settings);
    Json changed{{"method", all["method"]}};
    for (const std::string& key : edges::changedFromDefault(settings)) changed[key] = all[key];
    return changed;
}

void addDetection(Json& row, const edges::Detection& detection) {
    const Json report = exports::detectReport(detection, 0);
    const Scan& scan = *detection.scan;
    row["format"] = scan.format;
    row["scan_sha256"] = scan.sha256;
    row["method"] = report["settings"]["method"];
    row["settings"] = changedSettings(detection.settings);
    for (const char* key : {"lines", "beams", "cells", "range_mm", "edges", "classes", "noise_mm_at_5_m", "edge_mask_sha256", "frame"})
        row[key] = report[key];
    if (scan.acquisition) {
        row["scanned_utc"] = scan.acquisition->startUtc;
        row["serial"] = scan.acquisition->serial;
    }
    row["warnings"] = report["warnings"];
    for (const std::string& warning : placeWarnings(scan)) row["warnings"].push_back(warning);
    if (const auto sentence = files::leftOutSentence(scan)) row["warnings"].push_back(*sentence);
}

// The same keys as the JSON of `rocks`, without the list of rocks.
void addRockStudy(Json& row, const rocks::Study& study) {
    Json report = exports::rocksReport(study, CoordinateFrame::Scanner);
    row["rocks"] = Json::object();
    for (const char* key : {"rock_count", "size_curve", "fines", "not_rock", "outside_region", "labels_sha256", "note"})
        row["rocks"][key] = std::move(report[key]);
}

// The command that makes the same report.
std::string reportCommand(const BatchWork& work, const Scan& scan) {
    std::string command = "edgescan-cli report " + shellQuoted(fileName(scan.path)) + " -o report.html";
    for (const std::string& flags : {typedFlags(work.method), readingFlags(exports::withNames(work.read.options)),
                                     work.withRocks ? std::string("--rocks") : std::string(), typedFlags(work.rocks)})
        command += flags.empty() ? "" : " " + flags;
    return command;
}

// Adds what is said of the coordinates of the file to the row, for moveIntoPlace().
Result<Done> writeOne(const BatchWork& work, const WantedFile& wanted, const edges::Detection& detection,
                      const std::shared_ptr<const rocks::Study>& rocks, double loadMs, const fs::path& folder, Json& row) {
    exports::ExportOptions options = exportOptions(work.write, *detection.scan);
    options.sidecar = work.sidecars;
    options.rocks = rocks;
    if (wanted.extension == ".html") {
        const exports::PageWords words{reportCommand(work, *detection.scan), work.write.operatorName, work.write.role, utcText(utcNow())};
        return writeWholeFile(folder / (wanted.stem + wanted.extension),
                              exports::scanPage(detection, words, {.rocks = rocks.get(), .earlier = {}}));
    }
    if (wanted.kind == nullptr)
        return writeDocument(folder / (wanted.stem + wanted.extension), document("detect", exports::detectReport(detection, loadMs)));
    const std::string name = exports::exportFileName(*wanted.kind, wanted.extension, options.frame);
    const auto written = exports::exportWithProvenance(wanted.kind->content, detection, folder / name, options);
    if (!written) return written.error();
    if (written->coordinates)
        row["coordinates"][name] = {{"frame", frameName(written->coordinates->frame)},
                                    {"coordinates", exports::coordinatesText(*written->coordinates)}};
    return Done{};
}

// JSON files, records and reports contain times, so their bytes differ in every run.
bool holdsTimes(const fs::path& path) { return path.extension() == ".json" || path.extension() == ".html"; }

// Removes the results of an earlier row that this run did not make again.
void removeOld(const fs::path& folder, const Json& before, const std::vector<fs::path>& made) {
    if (!before.contains("outputs")) return;
    for (const Json& old : before["outputs"]) {
        const fs::path name = fs::path(old.value("file", "")).filename();
        std::error_code ignored;
        if (!name.empty() && std::ranges::find(made, name) == made.end() && checkIsNoInput(folder / name))
            fs::remove(folder / name, ignored);
    }
}

// Moves results from the staging folder to their place. Removes results of an earlier run that this run does not make.
Result<Done> moveIntoPlace(const fs::path& from, const fs::path& to, const Json& before, Json& row) {
    std::error_code problem;
    row["outputs"] = Json::array();
    std::vector<fs::path> made;
    for (const auto& entry : fs::directory_iterator(from, problem)) made.push_back(entry.path().filename());
    std::ranges::sort(made);
    if (problem) return Error{"the folder cannot be read (" + problem.message() + ")", from.string(), "check the disk and its rights"};
    if (!made.empty()) {
        if (auto folder = makeFolder(to, "check the disk and its rights"); !folder) return folder;
    }
    std::vector<FileMove> moves;
    for (const fs::path& name : made) {
        const auto hash = holdsTimes(name) ? Result<std::string>(std::string()) : sha256OfFile(from / name);
        if (!hash) return hash.error();
        Json output{{"file", name.string()}};
        if (!holdsTimes(name)) output.update(Json{{"bytes", fs::file_size(from / name, problem)}, {"sha256", *hash}});
        if (row.contains("coordinates") && row["coordinates"].contains(name.string())) output.update(row["coordinates"][name.string()]);
        row["outputs"].push_back(output);
        moves.push_back({from / name, to / name});
    }
    row.erase("coordinates");
    if (auto moved = moveWholeFiles(moves); !moved) {
        Json& outputs = row["outputs"]; // only those that moved
        for (std::size_t n = moves.size(); n-- > 0;) {
            if (fs::exists(moves[n].from, problem)) outputs.erase(n);
        }
        return moved;
    }
    removeOld(to, before, made);
    return Done{};
}

Json rowBefore(const BatchWork& work, std::size_t job) {
    const auto found = work.before.find(work.inputs[job]);
    if (found == work.before.end()) return {};
    const auto row = parseOrderedJson(found->second, "");
    return row ? *row : Json();
}

void refuse(Json& row, const char* outcome, const Error& error) {
    row["outcome"] = outcome;
    row["error"] = error.sentence();
}

// Opens, detects, writes into `staging`; stores the outcome in the row.
std::string fillRow(const BatchWork& work, const std::string& input, const fs::path& staging, Json& row) {
    const BindInputs inputs;
    claimInput(input);
    const auto start = Clock::now();
    ReadingOptions reading = work.read.options;
    Result<Scan> opened = files::openAsAsked(input, reading);
    const double loadMs = milliseconds(start);
    row["times"] = {{"load_ms", loadMs}};
    const bool readable = addInputFiles(row, input, *inputs.claims());
    if (!opened) {
        refuse(row, readable ? "refused" : "failed", opened.error());
        return {};
    }
    const auto enough = edges::checkMemoryFor(work.withRocks ? edges::Work::Rocks : edges::Work::Detect, *opened);
    const Result<edges::Settings> settings = settingsFor(work.method, *opened);
    if (!enough || !settings) {
        refuse(row, "refused", enough ? settings.error() : enough.error());
        return {};
    }
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings,
                                              work.withRocks ? edges::KeepFor::Rocks : edges::KeepFor::Edges);
    row["times"]["detect_ms"] = std::round(detection->totalMs * 1000) / 1000;
    addDetection(row, *detection);
    std::shared_ptr<const rocks::Study> rocks;
    if (work.withRocks) {
        const auto asked = presetOf(work.rocks, *detection->scan);
        if (!asked) {
            refuse(row, "refused", asked.error());
            return {};
        }
        const auto begun = Clock::now();
        rocks = std::make_shared<const rocks::Study>(rocks::studyRocks(rocks::rockInputs(*detection), *asked->settings));
        row["times"]["rocks_ms"] = milliseconds(begun);
        addRockStudy(row, *rocks);
    }
    for (const WantedFile& wanted : work.wanted) {
        const auto written = writeOne(work, wanted, *detection, rocks, loadMs, staging, row);
        if (!written) {
            Error error = written.error();
            if (error.where.starts_with(staging.string())) error.where = input + ", " + fs::path(error.where).filename().string();
            refuse(row, "failed", error);
            return {};
        }
    }
    return exports::surveyPicture(*detection);
}

} // namespace

Result<std::vector<WantedFile>> wantedFiles(const std::string& commaSeparated) {
    std::vector<WantedFile> wanted;
    if (commaSeparated.empty()) return wanted;
    for (std::size_t at = 0; at <= commaSeparated.size();) {
        const std::size_t end = std::min(commaSeparated.find(',', at), commaSeparated.size());
        const std::string typed = commaSeparated.substr(at, end - at);
        at = end + 1;
        if (typed.empty())
            return Error{"a comma is too many or a name is missing", commaSeparated, "write the names with one comma between them"};
        if (typed == "none") return Error{"none means no file at all", commaSeparated, "give none alone, or leave it out"};
        if (std::ranges::any_of(wanted, [&](const WantedFile& other) { return other.typed == typed; })) continue;
        const std::size_t dot = std::min(typed.find('.'), typed.size());
        const auto word = std::ranges::find(resultWords(), typed.substr(0, dot), &ResultWord::word);
        const bool hasExtension = word != resultWords().end() && word->extension.empty();
        if (word == resultWords().end() || hasExtension != (dot < typed.size()))
            return Error{"this is not a result", typed, "use " + wantedWords()};
        const std::string extension = hasExtension ? typed.substr(dot) : word->extension;
        if (hasExtension) {
            if (auto can = exports::checkExtension(*word->kind, "x" + extension, typed, " "); !can) return can.error();
        }
        wanted.push_back({typed, word->kind, word->stem, extension});
    }
    return wanted;
}

std::string wantedWords() {
    std::string words;
    for (const ResultWord& word : resultWords()) words += (words.empty() ? "" : ", ") + word.word + (word.extension.empty() ? ".EXT" : "");
    return words;
}

namespace {

// True if the earlier row is still valid: same input, settings and program, and its results exist.
bool isUnchanged(const BatchWork& work, std::size_t job, const Json& row) {
    if (!row.is_object() || row.value("settings_sha256", "") != work.settingsSha256) return false;
    if (row.value("results", "") != "scans/" + work.names[job] || !row.contains("files") || !row.contains("record_beside")) return false;
    const std::string outcome = row.value("outcome", "");
    const Json& times = row["times"];
    const bool triedAgain = work.retry || work.memoryBytes > times.value("memory_bytes", std::uint64_t{0});
    if (outcome != "done" && (outcome != "refused" || triedAgain)) return false;
    if (files::sidecarOf(work.inputs[job]).has_value() != row["record_beside"]) return false;
    const Json modified = times.value("modified", Json::array());
    for (std::size_t i = 0; i < row["files"].size(); ++i) {
        const Json& file = row["files"][i];
        const std::string path = file.value("file", "");
        const FileState state = stateOf(path);
        if (!file.contains("bytes") || file["bytes"] != state.bytes) return false;
        if (work.trustTimes && i < modified.size() && modified[i] == state.modified) continue;
        const auto hash = sha256OfFile(path);
        if (!hash || !file.contains("sha256") || file["sha256"] != Json(*hash)) return false;
    }
    if (!row.contains("outputs")) return true;
    return std::ranges::all_of(row["outputs"], [&](const Json& output) {
        std::error_code gone;
        const auto bytes = fs::file_size(folderOf(work, job) / fs::path(output.value("file", "")).filename(), gone);
        return !gone && (!output.contains("bytes") || output["bytes"] == bytes);
    });
}

} // namespace

std::string scanForArchive(const BatchWork& work, std::size_t job, int worker) {
    const Json old = rowBefore(work, job);
    if (isUnchanged(work, job, old)) return {};
    const auto start = Clock::now();
    const double cpuBefore = cpuMilliseconds();
    const fs::path staging = work.workFolder / std::to_string(worker);
    std::error_code problem;
    fs::remove_all(staging, problem);
    fs::create_directories(staging, problem);
    const std::string& input = work.inputs[job];
    const FileState before = stateOf(input);
    Json row = beginRow(work, job);
    std::string picture = fillRow(work, input, staging, row);
    if (row["outcome"] == "done" && !(stateOf(input) == before))
        refuse(row, "failed", {"the file changed while it was read", input, "run the command again when it is complete"});
    if (row["outcome"] != "done") {
        fs::remove_all(staging, problem);
        fs::create_directories(staging, problem);
        picture.clear();
    }
    if (const auto moved = moveIntoPlace(staging, folderOf(work, job), old, row); !moved) refuse(row, "failed", moved.error());
    if (row["outcome"] != "done") row["times"]["memory_bytes"] = work.memoryBytes;
    row["times"]["total_ms"] = milliseconds(start);
    row["times"]["cpu_ms"] = std::round((cpuMilliseconds() - cpuBefore) * 1000) / 1000;
    row["times"]["finished_utc"] = utcText(utcNow());
    Json times = std::move(row["times"]); // last in every row
    row.erase("times");
    row["times"] = std::move(times);
    return jsonText(row) + "\n" + picture;
}

Json failedRow(const BatchWork& work, std::size_t job, const std::string& death) {
    Json row = beginRow(work, job);
    const Error error{"the process that worked on this scan was lost: " + death, work.inputs[job],
                      "look at it by itself with detect; it is tried again when the same command is run again"};
    refuse(row, "failed", error);
    row["times"] = {{"finished_utc", utcText(utcNow())}};
    removeOld(folderOf(work, job), rowBefore(work, job), {});
    return row;
}

} // namespace edgescan::cli
