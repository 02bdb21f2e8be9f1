// Expands folders, patterns, lists and scans to one list of paths.
#include "core/batch/archive/listing.h"

#include "core/base/bounded_json.h"
#include "core/base/file_address.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/pipe.h"
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/pose_sidecar.h"
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
    for (fs::path name : namesOf(path)) {
        if (isThere(name.replace_extension(".u16"))) return true;
    }
    const auto bytes = readWholeFile(path, kMostDescription);
    const auto json = bytes ? parseJson(textOf(*bytes), path.string()) : Result<nlohmann::json>(nlohmann::json());
    if (!json || !json->is_object() || !json->contains("format") || !json->at("format").is_string()) return false;
    return json->at("format").get<std::string>().starts_with("edgescan-raw-grid/");
}

// A result of another run of this program: edges, pictures, clouds.
bool isExport(const fs::path& path) {
    const auto sidecar = files::sidecarOf(path);
    if (!sidecar) return false;
    const auto bytes = readWholeFile(*sidecar, kMostDescription);
    const auto record = bytes ? parseJson(textOf(*bytes), sidecar->string()) : Result<nlohmann::json>(nlohmann::json());
    const nlohmann::json::json_pointer content("/record/content");
    return record && record->is_object() && record->contains(content) && record->at(content) != "whole scan";
}

enum class Kind { Scan, LeftOut, Other };

Kind kindOf(const fs::path& path) {
    const std::string extension = scanExtension(path);
    if (!aFormatReads(extension)) return Kind::Other;
    if (extension == ".u16" && isThere(fs::path(path).replace_extension(".json"))) return Kind::Other; // it is read together with that file
    if (files::isPoseSidecar(path) && isThere(path.parent_path() / path.stem().stem())) return Kind::Other; // it is read with its scan
    if (extension == ".json" && isThere(path) && !describesGrid(path)) return Kind::LeftOut;
    return isExport(path) ? Kind::LeftOut : Kind::Scan;
}

bool sameFolder(const fs::path& a, const fs::path& b) {
    std::error_code problem;
    return fs::equivalent(a, b, problem) && !problem;
}

/// Finds the files of a folder and of all folders in it. A folder is read once: by its own path first, then by links to it.
class FolderWalk {
public:
    FolderWalk(const fs::path& results, ArchiveListing& listing) : results_(results), listing_(listing) {}

    Result<Done> add(const fs::path& asked) {
        std::error_code problem;
        asked_ = fs::canonical(asked, problem);
        if (!problem) visit(asked, problem);
        if (problem)
            return Error{"the folder cannot be read to its end (" + problem.message() + ")", asked.string(),
                         "check its rights and the disk"};
        for (std::size_t n = 0; n < links_.size(); ++n) { // those that are found on the way follow
            std::ranges::sort(links_.begin() + static_cast<std::ptrdiff_t>(n), links_.end());
            const fs::path link = links_[n];
            follow(link);
        }
        std::ranges::sort(found_);
        for (std::string& path : found_) {
            const Kind kind = kindOf(path);
            if (kind != Kind::Other) (kind == Kind::Scan ? listing_.inputs : listing_.leftOut).push_back(std::move(path));
        }
        return Done{};
    }

private:
    void notRead(const fs::path& path, std::string why) { listing_.notRead.push_back({path.string(), std::move(why)}); }

    /// A folder and those in it; links to other folders are collected.
    void visit(const fs::path& folder, std::error_code& problem) {
        const fs::path real = fs::canonical(folder, problem);
        if (problem || !visited_.insert(real.string()).second) return;
        std::vector<fs::path> inside;
        fs::directory_iterator entry(folder, problem);
        for (const fs::directory_iterator end; !problem && entry != end; entry.increment(problem)) inside.push_back(entry->path());
        std::ranges::sort(inside);
        for (const fs::path& path : inside) {
            if (!path.filename().native().starts_with('.')) addPath(path);
        }
    }

    void addPath(const fs::path& path) {
        std::error_code gone; // a file may disappear while the folder is read
        const fs::file_status status = fs::status(path, gone);
        if (fs::is_regular_file(status)) {
            found_.push_back(path.string());
        } else if (fs::is_directory(status)) {
            if (sameFolder(path, results_)) return;
            if (isThere(path / ".batch"))
                return notRead(path, "this folder holds the results of a run and is not read; name it as an input to have it read");
            if (fs::is_symlink(path, gone)) return links_.push_back(path);
            std::error_code problem;
            visit(path, problem);
            if (problem) notRead(path, "this folder cannot be read to its end (" + problem.message() + ")");
        } else if (fs::is_symlink(path, gone)) {
            // With the name of a scan it counts as a scan that cannot be read.
            if (kindOf(path) == Kind::Scan) return found_.push_back(path.string());
            if (kindOf(path) == Kind::Other) notRead(path, "this link leads nowhere, or to a folder that cannot be reached");
        } else if (kindOf(path) == Kind::Scan && fs::exists(fs::symlink_status(path, gone))) {
            notRead(path, fs::status_known(status) ? "this has the name of a scan and is not a file" : "this cannot be reached");
        }
    }

    void follow(const fs::path& link) {
        std::error_code problem;
        const fs::path real = fs::canonical(link, problem);
        const bool above = !problem && std::mismatch(real.begin(), real.end(), asked_.begin(), asked_.end()).first == real.end();
        if (above) return notRead(link, "this link leads back to a folder above it, and is not followed");
        if (!problem && visited_.contains(real.string())) return notRead(link, "this link leads to a folder that is read already");
        if (!problem) visit(link, problem);
        if (problem) notRead(link, "the folder that this link leads to cannot be read to its end (" + problem.message() + ")");
    }

    const fs::path& results_;
    ArchiveListing& listing_;
    fs::path asked_; // without links
    std::set<std::string> visited_;
    std::vector<fs::path> links_;
    std::vector<std::string> found_;
};

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

Result<Done> addPattern(const std::string& pattern, const fs::path& results, ArchiveListing& listing) {
    glob_t found{};
    const int code = ::glob(pattern.c_str(), 0, nullptr, &found);
    std::vector<std::string> paths;
    if (code == 0) paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    ::globfree(&found);
    for (std::string& path : paths) {
        std::error_code ignored;
        if (fs::is_regular_file(path, ignored)) {
            listing.inputs.push_back(std::move(path));
        } else if (!fs::is_directory(path, ignored)) {
            listing.notRead.push_back({std::move(path), "this is neither a file nor a folder"});
        } else if (!sameFolder(path, results)) {
            if (auto added = FolderWalk(results, listing).add(path); !added) return added.error();
        }
    }
    if (code == 0) return Done{};
    if (auto elsewhere = addressElsewhere(pattern)) return *elsewhere;
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
        return FolderWalk(results, listing).add(asked);
    }
    if (!fs::is_regular_file(asked, ignored)) return addPattern(asked, results, listing);
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
    ArchiveListing listing{{}, std::move(all.leftOut), std::move(all.notRead)};
    std::set<std::string> seen;
    for (const std::string& path : all.inputs) {
        std::string normal = fs::path(path).lexically_normal().string();
        if (seen.insert(normal).second) listing.inputs.push_back(std::move(normal));
    }
    if (listing.inputs.empty())
        return Error{"no scan was found in the inputs", asked.empty() ? "" : asked.front(), "give a folder, pattern or list of scans"};
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
        return Error{"this is not a part of a run", text, "give it as 3/20: the third of twenty"};
    return Shard{static_cast<int>(*number), static_cast<int>(*of)};
}

} // namespace edgescan::batch
