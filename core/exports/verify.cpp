// Verifies record, scan, method and bytes.
#include "core/exports/verify.h"

#include "core/base/bounded_json.h"
#include "core/base/foreign_text.h"
#include "core/base/held_file.h"
#include "core/base/inputs.h"
#include "core/base/json_text.h"
#include "core/base/own_kind.h"
#include "core/base/result.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/exports/record_parts.h"
#include "core/exports/report.h"
#include "core/files/open_save/open_scan.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/placement_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

namespace edgescan::exports {
namespace {

namespace fs = std::filesystem;

template <class Iterator>
void addFiles(std::vector<fs::path>& files, Iterator entries) {
    std::error_code problem;
    for (const Iterator end; entries != end && !problem; entries.increment(problem)) {
        std::error_code ignored;
        if (entries->is_regular_file(ignored)) files.push_back(entries->path());
    }
}

/// Files of one folder, likely ones first: the file with the old name, then the others by name.
void likelyFirst(std::vector<fs::path>& files, const std::string& oldName) {
    const fs::path stem = fs::path(oldName).stem();
    const auto rank = [&](const fs::path& file) { return file.filename() == oldName ? 0 : file.stem() == stem ? 1 : 2; };
    std::sort(files.begin(), files.end(),
              [&](const fs::path& a, const fs::path& b) { return std::pair(rank(a), a) < std::pair(rank(b), b); });
}

/// The file with this SHA-256 that `isIt` accepts: first the one with its old name in the folder of the export, then any file in this
/// folder, then any file under `scansFolder`. Files of other descriptions may have the same bytes: where `isIt` accepts none, the first.
Result<fs::path> findScan(const std::string& sha256, const std::string& oldName, const fs::path& exported,
                          const std::optional<fs::path>& scansFolder, const std::function<bool(const fs::path&)>& isIt) {
    std::error_code problem;
    std::vector<fs::path> files;
    for (const fs::path& name : namesOf(exported)) {
        const fs::path folder = name.has_parent_path() ? name.parent_path() : fs::path(".");
        addFiles(files, fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, problem));
    }
    likelyFirst(files, oldName);
    if (scansFolder) {
        if (!fs::is_directory(*scansFolder, problem))
            return Error{"there is no such folder", scansFolder->string(), "give --scans the folder of the scan"};
        std::vector<fs::path> more;
        addFiles(more, fs::recursive_directory_iterator(*scansFolder, fs::directory_options::skip_permission_denied, problem));
        likelyFirst(more, oldName);
        files.insert(files.end(), more.begin(), more.end());
    }
    std::optional<fs::path> first;
    for (const fs::path& file : files) {
        const auto hash = sha256OfFile(file);
        if (!hash || *hash != sha256) continue;
        if (isIt(file)) return file;
        if (!first) first = file;
    }
    if (first) return *first;
    const std::string where = scansFolder ? " or under " + scansFolder->string() : "";
    return Error{"the scan " + oldName + " with SHA-256 " + sha256.substr(0, 16) + "... is not next to the export" + where,
                 exported.string(), scansFolder ? "copy the scan there" : "give --scans the folder that holds it"};
}

using Json = nlohmann::ordered_json;

std::string sha256Of(const std::string& text) { return sha256Hex(std::as_bytes(std::span(text))); }

/// Null if the text is damaged; the altered parts are still reported.
Json parsed(std::string_view text) {
    auto json = parseOrderedJson(text, "");
    return json ? std::move(*json) : Json();
}

/// The value of the record at a JSON pointer, or null.
Json at(const Json& record, const std::string& pointer) {
    const Json::json_pointer way(pointer);
    return record.contains(way) ? record.at(way) : Json();
}
std::string wordAt(const Json& record, const std::string& pointer) {
    const Json value = at(record, pointer);
    return value.is_string() ? value.get<std::string>() : std::string();
}

/// Error if a later version of the program may know the format: "edgescan-record/7".
Result<Done> knownFormat(const Json& object, const char* known, const Verification& v) {
    const std::string format = wordAt(object, "/format");
    const std::string name(known, std::string_view(known).find('/') + 1);
    if (format == known || !format.starts_with(name)) return Done{};
    return Error{"the record is of the format " + format.substr(0, 60) + ", and this program knows " + known, v.exported.string(),
                 "verify with the version that made the export"};
}

/// Compares what the sidecar says about the file with the file. A sidecar that was altered says nothing about it.
void compareSidecar(const Json& sidecar, const std::string& bytes, Verification& v) {
    if (sidecar.contains("sidecar_sha256") && !sidecarIsWhole(sidecar)) {
        v.damage.emplace_back("The file next to the export was altered: its block \"export\" with time, counts and bounds, or its grid.");
        return;
    }
    if (wordAt(sidecar, "/export/sha256") != v.foundSha256)
        v.findings.emplace_back("The export is not the file that the record next to it was written for: its SHA-256 is another.");
    if (at(sidecar, "/export/bytes") != Json(bytes.size()))
        v.findings.emplace_back("The record next to the export says another number of bytes.");
    const std::string name = wordAt(sidecar, "/export/file");
    if (name != v.exported.filename().string()) v.remarks.push_back("It was called " + name + " when it was written.");
}

/// The record of the place that is whole; faults of either place are added to the damage and the findings.
Result<Json> recordOf(const std::string& bytes, Verification& v) {
    Json fromSidecar;
    const auto path = files::sidecarOf(v.exported);
    if (const auto sidecar = readWholeFile(path.value_or(files::sidecarPath(v.exported)))) {
        const Json whole = parsed(textOf(*sidecar));
        if (const auto known = knownFormat(whole, files::kSidecarFormat, v); !known) return known.error();
        if (wordAt(whole, "/format") == files::kSidecarFormat) fromSidecar = at(whole, "/record");
        if (const auto known = knownFormat(fromSidecar, kRecordFormat, v); !known) return known.error();
        if (recordIsWhole(fromSidecar))
            compareSidecar(whole, bytes, v);
        else
            v.damage.emplace_back("The record next to the export is damaged or was altered.");
    }
    const std::string embedded = embeddedRecord(bytes);
    const Json inside = parsed(embedded);
    if (const auto known = knownFormat(inside, kRecordFormat, v); !known) return known.error();
    if (!embedded.empty() && !recordIsWhole(inside)) v.damage.emplace_back("The record inside the export is damaged or was altered.");
    if (recordIsWhole(inside) && recordIsWhole(fromSidecar) && inside != fromSidecar)
        v.findings.emplace_back("The record inside the export and the one next to it are not the same.");
    if (recordIsWhole(fromSidecar)) return fromSidecar;
    if (recordIsWhole(inside)) return inside;
    const bool none = embedded.empty() && v.damage.empty();
    if (none && ownKind(bytes) == "edgescan-raw-grid")
        return Error{"this is a scan and not an export", v.exported.string(), "give what was exported from it"};
    return Error{none ? "there is no record in the export and none next to it" : "no record of the export is left unaltered",
                 v.exported.string(),
                 none ? "copy " + files::sidecarPath(v.exported).filename().string() + " next to it" : "export the scan again"};
}

Error notUnderstood(const Verification& v, const std::string& what) {
    return {"the record's " + what + " is not understood", v.exported.string(), "verify with the version that made the export"};
}

/// The scan as it was when the export was made.
Result<std::shared_ptr<const Scan>> scanOf(const Json& record, const std::optional<fs::path>& scansFolder, Verification& v) {
    const std::string hash = wordAt(record, "/scan/sha256");
    if (hash.empty())
        return Error{"the export was made from a scan that was in no file", v.exported.string(), "save the scan first and export it again"};
    const Json openedWith = at(record, "/scan/opened_with");
    const auto options = parseReadingOptions(openedWith.empty() ? std::string() : jsonText(openedWith), v.exported.string());
    if (!options) return options.error();
    Result<Scan> opened{Scan{}};
    bool fits = false;
    const auto isIt = [&](const fs::path& path) {
        opened = files::openAsAsked(path, *options);
        v.scan = path;
        return fits = opened && gridSha256(*opened) == wordAt(record, "/scan/grid_sha256");
    };
    const auto path = findScan(hash, wordAt(record, "/scan/input"), v.exported, scansFolder, isIt);
    if (!path) return path.error();
    if (v.scan != *path) isIt(*path); // the last one that was tried is not it
    if (!opened) return opened.error();
    if (!fits)
        v.findings.emplace_back(
            "The scan's file is the same but opens as another grid here: another version of the program reads it otherwise.");
    opened->placement.reset();
    if (const Json pose = at(record, "/pose"); pose.is_object()) {
        const auto placement = placementFromJson(nlohmann::json(pose), static_cast<std::uint64_t>(opened->lines()), v.exported.string());
        if (!placement) return placement.error();
        opened->placement = *placement;
    }
    return std::make_shared<const Scan>(std::move(*opened));
}

void compareResults(const Json& record, const edges::Detection& detection, Verification& v) {
    const std::string recorded = wordAt(record, "/edge_mask_sha256");
    if (maskSha256(*detection.mask) != recorded) v.findings.emplace_back("The method finds other edges here than the record says.");
    const Json cells = cellsReport(*detection.scan);
    if (at(record, "/cells") != cells) v.findings.emplace_back("The counts of cells by state are others than the record says.");
}

/// The settings in the words of today.
nlohmann::json settingsOf(const Json& record) {
    const Json version = at(record, "/default_settings/version");
    return edges::settingsOfRecord(nlohmann::json(at(record, "/settings")), version.is_number_integer() ? version.get<int>() : 0);
}

/// The scan and its edges; without edges if only the scan was exported.
Result<std::shared_ptr<const edges::Detection>> detectionOf(const Json& record, const ExportKind& kind,
                                                            const std::optional<fs::path>& scansFolder, Verification& v) {
    const bool method = kind.needs != ExportKind::Needs::Scan;
    const auto settings = method ? edges::settingsFromJson(settingsOf(record), edges::cannySettings(), v.exported.string())
                                 : Result<edges::Settings>(edges::Settings{});
    if (!settings) return settings.error();
    const auto scan = scanOf(record, scansFolder, v);
    if (!scan) return scan.error();
    if (!method) {
        auto bare = std::make_shared<edges::Detection>();
        bare->scan = *scan;
        return std::shared_ptr<const edges::Detection>(bare);
    }
    auto detection =
        edges::detectEdges(*scan, *settings, kind.needs == ExportKind::Needs::Rocks ? edges::KeepFor::Rocks : edges::KeepFor::Edges);
    compareResults(record, *detection, v);
    return detection;
}

/// The rocks with the settings and edits of the record.
Result<std::shared_ptr<const rocks::Study>> rocksOf(const Json& record, const edges::Detection& detection, const Verification& v) {
    const std::string where = v.exported.string();
    const auto settings = rocks::rockSettingsFromJson(nlohmann::json(at(record, "/rocks/settings")), where);
    if (!settings) return settings.error();
    const Scan& scan = *detection.scan;
    const auto edits = rocks::rockEditsFromJson(nlohmann::json(at(record, "/rocks/edits")), scan.lines(), scan.beams(), where);
    if (!edits) return edits.error();
    auto study = std::make_shared<rocks::Study>(rocks::studyRocks(rocks::rockInputs(detection), *settings, *edits));
    if (const Json listed = at(record, "/rocks/listed"); !listed.is_null()) {
        if (!listed.is_array() || !std::ranges::all_of(listed, [](const Json& label) { return label.is_number_unsigned(); }))
            return Error{"the record's list of rocks holds something else than numbers", where, "export the rocks again"};
        study->listed = listed.get<std::vector<std::uint32_t>>();
    }
    return std::shared_ptr<const rocks::Study>(std::move(study));
}

/// Adds the classes without cells that an older record does not contain.
void addLaterClasses(Json& then, const Json& now) {
    if (!then.is_object()) return;
    for (const auto& [key, value] : now.items()) {
        if (!then.contains(key) && value == 0) then[key] = value;
    }
}

/// Computes everything in the record again, except operator and program, and compares.
void compareRecord(const Json& record, const Json& again, Verification& v) {
    for (const auto& [key, value] : again.items()) {
        if (key == "program" || key == "operator" || key == "role" || key == "record_sha256" || !record.contains(key)) continue;
        Json then = record[key], now = value;
        if (key == "scan") then.erase("input"), now.erase("input"); // the file may have been renamed
        if (key == "settings") then = Json(settingsOf(record));
        // another set of defaults; the settings themselves were compared
        if (key == "default_settings" && at(then, "/version") != at(now, "/version")) continue;
        if (key == "classes") addLaterClasses(then, now);
        if (then != now && key != "cells") v.findings.push_back("The record says something else of \"" + key + "\" than this scan gives.");
    }
}

/// Possible reasons for a difference.
void compareProgram(const Json& record, Verification& v) {
    const Json now = programOfRecords();
    const std::string then = wordAt(record, "/program/version") + " (" + wordAt(record, "/program/commit") + ")";
    const std::string present = std::string(version()) + " (" + commit() + ")";
    if (then != present) v.findings.push_back("The export was made by version " + then + ", this is " + present + ".");
    for (const auto& [library, number] : now["libraries"].items()) {
        const std::string used = wordAt(record, "/program/libraries/" + library);
        const auto here = number.get<std::string>(); // g++ 14 does not compile a comparison of a string with a JSON value
        if (used != here) v.findings.push_back("It was made with " + library + " " + used + ", this is " + here + ".");
    }
}

void compareBytes(const std::string& found, const std::string& expected, Verification& v) {
    if (found == expected) return;
    const auto [a, b] = std::mismatch(found.begin(), found.end(), expected.begin(), expected.end());
    const auto byte = static_cast<std::uint64_t>(a - found.begin());
    v.firstDifference = byte;
    std::string text = "Byte " + std::to_string(byte) + " is the first that differs";
    if (b == expected.end()) text = "The export goes on after byte " + std::to_string(byte) + ", where it should end";
    if (a == found.end()) text = "The export ends at byte " + std::to_string(byte) + " of " + std::to_string(expected.size());
    v.findings.insert(v.findings.begin(), text + ".");
}

/// Two pictures are the same if their pixels are equal; zlib's compression may differ.
bool samePixels(const std::string& found, const std::string& expected, const Json& record, Verification& v) {
    const auto here = containers::pngValues(expected, "");
    const auto there = containers::pngValues(found, v.exported.string());
    if (!here || !there || here->lines != there->lines || here->beams != there->beams) return false;
    const auto [a, b] = std::mismatch(here->cells.begin(), here->cells.end(), there->cells.begin());
    if (a != here->cells.end()) {
        const auto k = a - here->cells.begin();
        v.findings.push_back("The first cell that differs is line " + std::to_string(k / here->beams) + ", beam " +
                             std::to_string(k % here->beams) + ": " + std::to_string(*b) + " instead of " + std::to_string(*a) + ".");
        return false;
    }
    const Json libraries = programOfRecords()["libraries"];
    const bool otherPacker =
        at(record, "/program/libraries/zlib") != libraries["zlib"] || at(record, "/program/libraries/libpng") != libraries["libpng"];
    if (!otherPacker || embeddedRecord(found) != sealed(record)) return false;
    v.remarks.emplace_back("Every pixel is the same; the bytes are packed by another zlib.");
    return true;
}

/// Compares the files made from the scan now with those on the disk.
void compareFiles(const std::string& found, const std::vector<FileBytes>& again, const Json& record, Verification& v) {
    for (const FileBytes& file : again) {
        if (file.path.extension() == v.exported.extension() || again.size() == 1) {
            v.expectedSha256 = sha256Of(file.bytes);
            const bool image = at(record, "/coordinates/frame") == "image";
            if (image && found != file.bytes && samePixels(found, file.bytes, record, v)) continue;
            compareBytes(found, file.bytes, v);
            continue;
        }
        const auto other = readWholeFile(file.path);
        if (!other || textOf(*other) != file.bytes)
            v.findings.push_back(file.path.filename().string() + ", which belongs to it, " + (other ? "is another." : "is missing."));
    }
}

} // namespace

bool isReport(const fs::path& file) {
    const auto held = holdFile(file); // an export may be large
    if (!held) return false;
    const std::string_view all = textOf(held->bytes()), head = all.substr(0, 64);
    if (head.starts_with("<!DOCTYPE html>") || head.starts_with("%PDF")) return true;
    const std::size_t key = head.find('"');
    if (!head.starts_with('{') || key == head.npos || head.compare(key, 8, "\"schema\"") != 0 || files::sidecarOf(file)) return false;
    return embeddedRecord(all).empty();
}

Result<Verification> verifyExport(const fs::path& exported, const std::optional<fs::path>& scansFolder) {
    Verification v;
    v.exported = exported;
    const auto bytes = readWholeFile(exported);
    if (!bytes) return bytes.error();
    const std::string found(textOf(*bytes));
    v.foundSha256 = sha256Of(found);
    const auto record = recordOf(found, v);
    if (!record) return record.error();
    const ExportKind* kind = exportKindNamed(wordAt(*record, "/content"));
    if (wordAt(*record, "/format") != kRecordFormat || kind == nullptr) return notUnderstood(v, "format");
    ExportOptions options;
    for (const Json& key : at(*record, "/choices")) {
        const auto choice =
            std::ranges::find_if(files::kWritingChoices, [&](const files::WritingChoice& known) { return key == Json(known.key); });
        if (choice == files::kWritingChoices.end()) return notUnderstood(v, "choice");
        options.choices.*choice->member = true;
    }
    options.ascii = at(*record, "/text") == true;
    options.includeAttached = at(*record, "/attached_points/included") == true;
    if (at(*record, "/coordinates/frame") != "image") {
        const auto frame = frameNamed(wordAt(*record, "/coordinates/frame"));
        if (!frame) return notUnderstood(v, "frame");
        options.frame = *frame;
    }
    const auto detection = detectionOf(*record, *kind, scansFolder, v);
    if (!detection) return detection.error();
    if (record->contains("selection")) options.selection = selectionOf(at(*record, "/selection"), (*detection)->scan->cells());
    const OwnPart* own = kind->own;
    const bool needsOwn = own != nullptr && own->needed;
    if (own != nullptr && (needsOwn || record->contains(own->key))) {
        const std::string where = "/" + std::string(own->key);
        if (auto read = own->read(at(*record, where.c_str()), *(*detection)->scan, exported.string(), options); !read) return read.error();
    }
    if (kind->needs == ExportKind::Needs::Rocks && (!needsOwn || record->contains("rocks"))) {
        const auto rocks = rocksOf(*record, **detection, v);
        if (!rocks) return rocks.error();
        options.rocks = *rocks;
    }
    const auto again = exportFiles(kind->content, **detection, exported, sealed(*record), options);
    if (!again) return again.error();
    compareRecord(*record, parsed(exportRecord(kind->content, **detection, options)), v);
    compareFiles(found, *again, *record, v);
    v.identical = v.findings.empty() && v.damage.empty();
    if (!v.findings.empty()) compareProgram(*record, v);
    return v;
}

std::string verificationText(const Verification& v) {
    std::string text = printable(v.exported.string()) + (v.findings.empty() ? ": identical to what " : ": NOT identical to what ") +
                       printable(v.scan.string()) + " gives.";
    for (const auto& sentences : {v.damage, v.findings, v.findings.empty() ? v.remarks : std::vector<std::string>()}) {
        for (const std::string& sentence : sentences) text += " " + printable(sentence);
    }
    return text;
}

Json verificationReport(const Verification& v) {
    std::vector<std::string> findings = v.damage;
    findings.insert(findings.end(), v.findings.begin(), v.findings.end());
    return {{"export", v.exported.string()},
            {"identical", v.identical},
            {"scan", v.scan.string()},
            {"first_difference", v.firstDifference ? Json(*v.firstDifference) : Json()},
            {"expected_sha256", v.expectedSha256},
            {"found_sha256", v.foundSha256},
            {"findings", findings},
            {"remarks", v.remarks}};
}

} // namespace edgescan::exports
