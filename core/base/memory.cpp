// Available memory: from /proc/meminfo, the control groups (versions 2 and 1) and the limit of the address space.
#include "core/base/memory.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kAnyMachine = std::uint64_t{1} << 60; ///< version 1 says "no limit" with a number near 2^63
/// the question takes a quarter of a millisecond; the start of a program needs more memory than this
constexpr std::uint64_t kNotAsked = std::uint64_t{1} << 20;

std::optional<std::uint64_t> numberIn(const fs::path& path) {
    std::ifstream file(path);
    std::string word;
    if (!(file >> word)) return std::nullopt;
    std::uint64_t value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc{} || end != word.data() + word.size()) return std::nullopt; // "max"
    return value;
}

/// The number behind a word, as in "inactive_file 4096".
std::optional<std::uint64_t> numberAfter(const fs::path& path, std::string_view wanted) {
    std::ifstream file(path);
    std::string key, rest;
    std::uint64_t value = 0;
    while (file >> key >> value) {
        std::getline(file, rest); // skips the unit
        if (key == wanted) return value;
    }
    return std::nullopt;
}

/// The two versions of control groups use different file names.
struct GroupFiles {
    const char* limit;
    const char* used;
    const char* reclaimable; ///< key in memory.stat: pages of files that the system gives up at once when memory is needed
};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};

std::uint64_t leftIn(const fs::path& group, const GroupFiles& files) {
    const auto limit = numberIn(group / files.limit);
    if (!limit || *limit > kAnyMachine) return kNoLimit;
    const auto used = numberIn(group / files.used);
    if (!used) return kNoLimit;
    const std::uint64_t taken = *used - std::min(*used, numberAfter(group / "memory.stat", files.reclaimable).value_or(0));
    return *limit - std::min(*limit, taken);
}

/// The smallest amount left in the groups from `root`/`path` up to `root`. A path that does not exist belongs to another name space; then
/// `root` is the process's own group.
std::uint64_t leftOnTheWay(const fs::path& root, const fs::path& path, const GroupFiles& files) {
    std::uint64_t left = leftIn(root, files);
    fs::path group = root;
    for (const fs::path& part : path.relative_path()) {
        if (part == "..") break; // inside a name space: the groups above cannot be read
        group /= part;
        left = std::min(left, leftIn(group, files));
    }
    return left;
}

std::uint64_t addressSpaceLeft() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
    const auto pages = numberIn("/proc/self/statm"); // the first number: the size of the whole address space
    const std::uint64_t used = pages.value_or(0) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used);
}

} // namespace

std::uint64_t memoryLeftInGroups(std::string_view groups, const fs::path& mount) {
    std::uint64_t left = kNoLimit;
    while (!groups.empty()) {
        const std::string_view line = groups.substr(0, groups.find('\n'));
        groups.remove_prefix(std::min(groups.size(), line.size() + 1));
        const std::size_t first = line.find(':'); // number:controllers:path
        const std::size_t second = first == std::string_view::npos ? first : line.find(':', first + 1);
        if (second == std::string_view::npos) continue;
        const std::string controllers = "," + std::string(line.substr(first + 1, second - first - 1)) + ",";
        const fs::path path(line.substr(second + 1));
        if (controllers == ",,") left = std::min(left, leftOnTheWay(mount, path, kVersion2));
        if (controllers.find(",memory,") != std::string::npos) left = std::min(left, leftOnTheWay(mount / "memory", path, kVersion1));
    }
    return left;
}

std::uint64_t availableMemoryBytes() {
    const auto kilobytes = numberAfter("/proc/meminfo", "MemAvailable:");
    const std::uint64_t available = kilobytes ? *kilobytes * 1024 : kNoLimit;
    std::ifstream file("/proc/self/cgroup");
    const std::string groups{std::istreambuf_iterator<char>(file), {}};
    return std::min({available, memoryLeftInGroups(groups, "/sys/fs/cgroup"), addressSpaceLeft()});
}

std::string sizeText(std::uint64_t bytes) {
    if (bytes < 1000) return counted(bytes, "byte");
    static constexpr std::array<const char*, 6> kUnits{"kB", "MB", "GB", "TB", "PB", "EB"};
    double value = static_cast<double>(bytes) / 1000.0;
    std::size_t unit = 0;
    while (value >= 999.95 && unit + 1 < kUnits.size()) {
        value /= 1000.0;
        ++unit;
    }
    return fixedText(value, 1) + " " + kUnits[unit];
}

Result<Done> checkMemory(std::uint64_t neededBytes, const std::string& where) {
    if (neededBytes < kNotAsked) return Done{};
    const std::uint64_t available = availableMemoryBytes();
    if (neededBytes <= available) return Done{};
    return Error{withValues("needs %1 of memory, %2 are free", {sizeText(neededBytes), sizeText(available)}), where,
                 "close other programs or open a smaller file"};
}

} // namespace edgescan
