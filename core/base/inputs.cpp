// Identifies inputs by device and inode, so that every name, link and spelling of a name leads to the same input.
#include "core/base/inputs.h"
#include "core/base/translated_text.h"

#include "core/base/whole_file.h"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

using FileNumber = std::pair<dev_t, ino_t>;

std::optional<FileNumber> numberOf(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return FileNumber{status.st_dev, status.st_ino};
}

std::mutex mutex;                           // protects the map
std::multimap<FileNumber, fs::path> inputs; // with the name under which each was read

} // namespace

class InputClaims {
public:
    InputClaims() = default;
    InputClaims(const InputClaims&) = delete;
    InputClaims& operator=(const InputClaims&) = delete;
    ~InputClaims() {
        const std::lock_guard lock(mutex);
        for (const auto& entry : entries_) inputs.erase(entry);
    }
    void add(std::multimap<FileNumber, fs::path>::iterator entry) { entries_.push_back(entry); }
    [[nodiscard]] std::vector<fs::path> paths() const {
        std::vector<fs::path> all;
        for (const auto& entry : entries_) all.push_back(entry->second);
        return all;
    }

private:
    std::vector<std::multimap<FileNumber, fs::path>::iterator> entries_;
};

namespace {
thread_local std::shared_ptr<InputClaims> bound;
}

void claimInput(const fs::path& path) {
    if (!bound) return;
    const auto number = numberOf(path);
    if (!number) return;
    const std::lock_guard lock(mutex);
    bound->add(inputs.emplace(*number, path));
}

std::vector<fs::path> namesOf(const fs::path& input) {
    std::error_code none;
    if (!fs::is_symlink(input, none)) return {input};
    const fs::path target = fs::canonical(input, none);
    return none ? std::vector{input} : std::vector{input, target};
}

Result<std::vector<std::byte>> readInput(const fs::path& path) {
    claimInput(path);
    return readWholeFile(path);
}

std::vector<fs::path> claimedPaths(const InputClaims& claims) {
    const std::lock_guard lock(mutex);
    return claims.paths();
}

BindInputs::BindInputs() : claims_(std::make_shared<InputClaims>()), before_(std::exchange(bound, claims_)) {}
BindInputs::~BindInputs() { bound = before_; }
std::shared_ptr<const InputClaims> BindInputs::claims() const { return claims_; }

Result<Done> checkIsNoInput(const fs::path& path) {
    const auto number = numberOf(path);
    if (!number) return Done{};
    const std::lock_guard lock(mutex);
    const auto [first, last] = inputs.equal_range(*number);
    for (auto entry = first; entry != last; ++entry) {
        if (numberOf(entry->second) != number) continue; // another program has replaced the file since
        const std::string read = entry->second.string();
        return Error{read == path.string() ? "this file was read as an input"
                                           : withValues("this is the file that was read as an input under the name %1", {read}),
                     path.string(), "choose another name"};
    }
    return Done{};
}

} // namespace edgescan
