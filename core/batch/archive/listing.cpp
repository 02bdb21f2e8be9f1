// Expands folders, patterns, lists and scans to one list of paths.
#include "core/batch/archive/listing.h"

#include "core/base/bounded_json.h"
#include "core/base/number_text.h"
#include "core/base/pipe.h"
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/sidecar_grid.h"

#include <glob.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <system_error>

namespace edgescan::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLinesLookedAt = 20;             // lines read of a file that may be a list of paths
constexpr std::uint64_t kMostListBytes = 1ULL << 30U;  // ten million paths
constexpr std::uint64_t kMostDescription = 64U << 20U; // the same limit as for any JSON from outside

// ".pcd" of "a.pcd" and of "a.pcd.gz".
std::string scanExtension(const fs::path& path) {
    const std::string last = asciiLower(path.extension().string());
    return last == ".gz" ? asciiLower(path.stem().extension().string()) : last;
}

bool aFormatReads(const std::string& extension) {
    return std::ranges::any_of(files::formats(), [&](const files::Format& format) {
        return std::ranges::any_of(format.reads, [&](const char* read) { return extension == read; });
    });
}

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

// A JSON file that describes a grid, not a record, a preset or a result.
bool describesGrid(const fs::path& path) {
    if (isThere(fs::path(path).replace_extension(".u16"))) return true;
    const auto bytes = readWholeFile(path, kMostDescription);
    return bytes && textOf(*bytes).find("edgescan-raw-grid/") != std::string::npos;
}

// A result of another run of this program: edges, pictures, clouds.
bool isExport(const fs::path& path) {
    const fs::path sidecar = files::sidecarPath(path);
    if (!isThere(sidecar)) return false;
    const auto bytes = readWholeFile(sidecar, kMostDescription);
    const auto record = bytes ? parseJson(textOf(*bytes), sidecar.string()) : Result<nlohmann::json>(nlohmann::json());
    const nlohmann::json::json_pointer content("/record/content");
    return record && record->is_object() && record->contains(content) && record->at(content) != "whole scan";
}

enum class Kind { Scan, LeftOut, Other };

Kind kindOf(const fs::path& path) {
    const std::string extension = scanExtension(path);
    if (!aFormatReads(extension)) return Kind::Other;
    if (extension == ".u16" && isThere(fs::path(path).replace_extension(".json"))) return Kind::Other; // it is read together with that file
    if (extension == ".json" && isThere(path) && !describesGrid(path)) return Kind::LeftOut;
    return isExport(path) ? Kind::LeftOut : Kind::Scan;
}

bool sameFolder(const fs::path& a, const fs::path& b) {
    std::error_code problem;
    return fs::equivalent(a, b, problem) && !problem;
}

Result<Done> addFolder(const std::string& folder, const fs::path& results, ArchiveListing& listing) {
    std::vector<std::string> found;
    std::error_code problem;
    fs::recursive_directory_iterator entry(folder, problem);
    for (const fs::recursive_directory_iterator end; !problem && entry != end; entry.increment(problem)) {
        std::error_code gone; // a file may disappear while the folder is read
        const bool hidden = entry->path().filename().native().starts_with('.');
        if (entry->is_directory(gone) && (hidden || sameFolder(entry->path(), results))) entry.disable_recursion_pending();
        // counts as a scan that cannot be read, not as a missing file
        const bool leadsNowhere = entry->is_symlink(gone) && !entry->exists(gone);
        if (!hidden && (leadsNowhere || entry->is_regular_file(gone))) found.push_back(entry->path().string());
    }
    if (problem) return Error{"the folder cannot be read to its end (" + problem.message() + ")", folder, "check its rights and the disk"};
    std::ranges::sort(found);
    for (std::string& path : found) {
        const Kind kind = kindOf(path);
        if (kind != Kind::Other) (kind == Kind::Scan ? listing.inputs : listing.leftOut).push_back(std::move(path));
    }
    return Done{};
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line(text.substr(at, end - at));
        if (line.ends_with('\r')) line.pop_back();
        if (!line.empty() && !line.starts_with('#')) lines.push_back(std::move(line));
        at = end + 1;
    }
    return lines;
}

// A scan as text begins with numbers, and file names of this form do not exist.
bool namesFiles(const fs::path& path) {
    const std::string extension = asciiLower(path.extension().string());
    if (extension == ".list" || extension == ".lst") return true;
    if (extension != ".txt" && !extension.empty()) return false;
    const auto bytes = readWholeFile(path, kMostListBytes);
    if (!bytes) return false;
    std::vector<std::string> lines = linesOf(textOf(*bytes));
    lines.resize(std::min(lines.size(), kLinesLookedAt));
    return std::ranges::any_of(lines, [](const std::string& line) { return isThere(line); });
}

Result<Done> addPattern(const std::string& pattern, ArchiveListing& listing) {
    glob_t found{};
    const int code = ::glob(pattern.c_str(), 0, nullptr, &found);
    for (std::size_t i = 0; code == 0 && i < found.gl_pathc; ++i) {
        std::error_code ignored;
        if (fs::is_regular_file(found.gl_pathv[i], ignored)) listing.inputs.emplace_back(found.gl_pathv[i]);
    }
    ::globfree(&found);
    if (code == 0) return Done{};
    return Error{"there is no such folder, list or scan, and no file of this pattern", pattern, "check the spelling and the folder"};
}

Result<Done> addAsked(const std::string& asked, const fs::path& results, ArchiveListing& listing) {
    std::error_code ignored;
    if (asked == kStandardInput) {
        const auto bytes = readPipe(asked, [] { return true; });
        if (!bytes) return bytes.error();
        for (std::string& line : linesOf(textOf(*bytes))) listing.inputs.push_back(std::move(line));
        return Done{};
    }
    if (fs::is_directory(asked, ignored)) {
        if (sameFolder(asked, results)) return Error{"the results cannot lie among the scans", asked, "give -o a folder of its own"};
        return addFolder(asked, results, listing);
    }
    if (!fs::is_regular_file(asked, ignored)) return addPattern(asked, listing);
    if (!namesFiles(asked)) {
        listing.inputs.push_back(asked);
        return Done{};
    }
    const auto bytes = readWholeFile(asked, kMostListBytes);
    if (!bytes) return bytes.error();
    for (std::string& line : linesOf(textOf(*bytes))) listing.inputs.push_back(std::move(line));
    return Done{};
}

} // namespace

Result<ArchiveListing> listArchive(const std::vector<std::string>& asked, const fs::path& results) {
    ArchiveListing all;
    for (const std::string& one : asked) {
        if (auto added = addAsked(one, results, all); !added) return added.error();
    }
    ArchiveListing listing{{}, std::move(all.leftOut)};
    std::set<std::string> seen;
    for (const std::string& path : all.inputs) {
        std::string normal = fs::path(path).lexically_normal().string();
        if (seen.insert(normal).second) listing.inputs.push_back(std::move(normal));
    }
    if (listing.inputs.empty())
        return Error{"there is no scan among what was given", asked.empty() ? "" : asked.front(),
                     "give a folder, pattern or list of scans"};
    return listing;
}

bool Shard::holds(const std::string& input) const {
    if (of == 1) return true;
    const std::string hash = sha256Hex(std::as_bytes(std::span(input))).substr(0, 15); // 60 bits
    std::uint64_t value = 0;
    for (const char digit : hash) value = value * 16 + static_cast<std::uint64_t>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
    return value % static_cast<std::uint64_t>(of) == static_cast<std::uint64_t>(number - 1);
}

Result<Shard> shardOf(const std::string& text) {
    constexpr double kMost = 100'000;
    const std::size_t slash = text.find('/');
    const auto number = numberOf(std::string_view(text).substr(0, slash));
    const auto of = slash == std::string::npos ? std::nullopt : numberOf(std::string_view(text).substr(slash + 1));
    const auto whole = [](double value) { return value == std::floor(value); };
    if (!number || !of || !whole(*number) || !whole(*of) || *number < 1 || *of < *number || *of > kMost)
        return Error{"this is no part of a run", text, "give it as 3/20: the third of twenty"};
    return Shard{static_cast<int>(*number), static_cast<int>(*of)};
}

} // namespace edgescan::batch
