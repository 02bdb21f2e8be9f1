// Finds the files of a bag's folder by metadata.yaml, or by what is there.
#include "core/robots/sweeps/bag_folder.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/base/whole_file.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace edgescan::robots {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = "metadata.yaml";
constexpr std::size_t kMostParts = 100'000;

std::string unpackedName(const fs::path& path) {
    std::string name = path.filename().string();
    for (const char* packed : {".zstd", ".zst", ".gz"}) {
        if (name.ends_with(packed)) name.erase(name.rfind('.'));
    }
    return name;
}

bool holdsMessages(const fs::path& path) {
    const std::string name = unpackedName(path);
    return name.ends_with(".mcap") || name.ends_with(".db3") || name.ends_with(".bag");
}

/// "bell_12.db3" -> "bell", 12.
std::optional<std::pair<std::string, unsigned>> numbered(const fs::path& path) {
    const std::string stem = fs::path(unpackedName(path)).stem().string();
    const std::size_t line = stem.rfind('_');
    unsigned number = 0;
    if (line == std::string::npos) return std::nullopt;
    const auto [end, code] = std::from_chars(stem.data() + line + 1, stem.data() + stem.size(), number);
    if (code != std::errc{} || end != stem.data() + stem.size()) return std::nullopt;
    return std::pair(stem.substr(0, line), number);
}

std::string trimmed(const std::string& text) {
    const char* around = " \t\r\"'";
    const std::size_t from = text.find_first_not_of(around), to = text.find_last_not_of(around);
    return from == std::string::npos ? std::string() : text.substr(from, to - from + 1);
}

/// The files that metadata.yaml lists below relative_file_paths, one a line; old ones have the folder's name before them.
std::vector<std::string> namesIn(const fs::path& metadata) {
    constexpr std::size_t kLongest = 4096;
    std::vector<std::string> names;
    const auto bytes = readWholeFile(metadata); // a pipe is refused
    if (!bytes) return names;
    bool inList = false;
    for (std::string_view rest = textOf(*bytes); !rest.empty() && names.size() < kMostParts;) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        if (line.size() >= kLongest) break;
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        const std::string text = trimmed(std::string(line));
        if (inList && !text.starts_with("- ")) break;
        if (inList) {
            const fs::path name = fs::path(trimmed(text.substr(2))).filename();
            if (std::ranges::find(names, name.string()) == names.end()) names.push_back(name.string());
        }
        inList = inList || text == "relative_file_paths:";
    }
    return names;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::error_code problem;
    std::vector<fs::path> files;
    for (auto at = fs::directory_iterator(folder, problem); !problem && at != fs::directory_iterator(); at.increment(problem)) {
        if (holdsMessages(at->path()) && at->is_regular_file(problem)) files.push_back(at->path());
    }
    std::ranges::sort(files);
    return files;
}

/// Files NAME_0, NAME_1, ... by their numbers. False: they are not those of one bag.
bool orderParts(std::vector<fs::path>& files) {
    std::string name;
    for (const fs::path& file : files) {
        const auto part = numbered(file);
        if (!part || (!name.empty() && part->first != name)) return false;
        name = part->first;
    }
    std::ranges::stable_sort(files, {}, [](const fs::path& file) { return numbered(file)->second; });
    return true;
}

} // namespace

Result<BagFiles> filesOfBag(const fs::path& path) {
    std::error_code problem;
    const BagFiles asItIs{path, {path}, {}, {}, {}};
    fs::path folder = path.filename() == kMetadata ? path.parent_path() : path;
    if (folder.empty()) folder = ".";
    if (!fs::is_directory(folder, problem)) return asItIs;
    BagFiles bag;
    for (const std::string& name : namesIn(folder / kMetadata)) {
        if (!holdsMessages(name))
            bag.others.push_back(name);
        else if (fs::is_regular_file(folder / name, problem))
            bag.parts.push_back(folder / name);
        else
            bag.missing.push_back(name);
    }
    const auto first = bag.parts.empty() ? std::nullopt : numbered(bag.parts.front());
    for (const fs::path& file : first ? filesIn(folder) : std::vector<fs::path>()) {
        const auto part = numbered(file);
        if (part && part->first == first->first && std::ranges::find(bag.parts, file) == bag.parts.end())
            bag.unnamed.push_back(file.filename().string());
    }
    if (bag.parts.empty()) {
        bag.parts = filesIn(folder);
        std::vector<std::string> named = bag.missing;
        named.insert(named.end(), bag.others.begin(), bag.others.end());
        if (bag.parts.empty() && !named.empty())
            return Error{withValues("no file of messages that metadata.yaml names is in this folder: %1%2",
                                    {named.front(), named.size() > 1 ? withValues(" and %1 more", {named.size() - 1}) : ""}),
                         folder.string(), "copy the files of the bag into it"};
        if (bag.parts.empty()) return asItIs;
        if (bag.parts.size() > 1 && !orderParts(bag.parts))
            return Error{withValues("this folder holds %1 of several bags", {counted(bag.parts.size(), "file")}), path.string(),
                         withValues("open one of them, as %1", {bag.parts.front().filename().string()})};
    }
    const bool hasMetadata = fs::is_regular_file(folder / kMetadata, problem);
    bag.path = !bag.isSplit() ? bag.parts.front() : hasMetadata ? folder / kMetadata : folder;
    return bag;
}

std::string partOfBag(const fs::path& file) {
    if (!holdsMessages(file)) return {};
    const fs::path metadata = file.parent_path() / kMetadata;
    std::vector<std::string> names = namesIn(metadata);
    std::erase_if(names, [](const std::string& name) { return !holdsMessages(name); });
    const auto own = std::ranges::find(names, file.filename().string());
    if (names.size() < 2 || own == names.end()) return {};
    return withValues("This file is part %1 of %2 of a bag. Open %3 for all of it.",
                      {own - names.begin() + 1, names.size(), metadata.string()});
}

} // namespace edgescan::robots
