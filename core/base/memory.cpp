// Available memory, from /proc/meminfo and the control group (version 2, then 1).
#include "core/base/memory.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>

namespace edgescan {
namespace {

std::optional<std::uint64_t> numberIn(const char* path) {
    std::ifstream file(path);
    std::string word;
    if (!(file >> word)) return std::nullopt;
    std::uint64_t value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc{} || end != word.data() + word.size()) return std::nullopt; // "max"
    return value;
}

std::optional<std::uint64_t> memAvailable() {
    std::ifstream file("/proc/meminfo");
    std::string key;
    std::uint64_t kilobytes = 0;
    std::string unit;
    while (file >> key >> kilobytes) {
        std::getline(file, unit);
        if (key == "MemAvailable:") return kilobytes * 1024;
    }
    return std::nullopt;
}

std::optional<std::uint64_t> leftIn(const char* limitPath, const char* usedPath) {
    const auto limit = numberIn(limitPath);
    const auto used = numberIn(usedPath);
    if (!limit || !used) return std::nullopt;
    return *limit > *used ? *limit - *used : 0;
}

} // namespace

std::uint64_t availableMemoryBytes() {
    std::uint64_t available = memAvailable().value_or(std::numeric_limits<std::uint64_t>::max());
    static constexpr std::array<std::array<const char*, 2>, 2> kGroups{{
        {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
        {"/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes"},
    }};
    for (const auto& group : kGroups) {
        if (const auto left = leftIn(group[0], group[1])) available = std::min(available, *left);
    }
    return available;
}

std::string sizeText(std::uint64_t bytes) {
    if (bytes < 1000) return std::to_string(bytes) + " bytes";
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
    const std::uint64_t available = availableMemoryBytes();
    if (neededBytes <= available) return Done{};
    return Error{"needs " + sizeText(neededBytes) + " of memory, " + sizeText(available) + " are free", where,
                 "close other programs or open a smaller file"};
}

} // namespace edgescan
