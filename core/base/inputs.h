// The files in use as inputs. EdgeScan never overwrites an input, whatever name, link or spelling is used for it.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace edgescan {

/// The inputs claimed on one thread while it was bound to them. The claims end with the last copy of the pointer.
class InputClaims;

/// Makes `path` an input until the claims that this thread is bound to end. Does nothing if the thread is not bound or the path does not
/// exist.
void claimInput(const std::filesystem::path& path);

/// Claims the file and reads all of it, as readWholeFile() does.
Result<std::vector<std::byte>> readInput(const std::filesystem::path& path);

/// The names by which files that belong to an input are found: its own, and for a link also that of the file it leads to.
[[nodiscard]] std::vector<std::filesystem::path> namesOf(const std::filesystem::path& input);

/// The claimed paths, in the order in which they were claimed.
[[nodiscard]] std::vector<std::filesystem::path> claimedPaths(const InputClaims& claims);

/// Binds the thread during the lifetime of this object.
class BindInputs {
public:
    BindInputs();
    ~BindInputs();
    BindInputs(const BindInputs&) = delete;
    BindInputs& operator=(const BindInputs&) = delete;
    /// Hold the pointer as long as the inputs are in use.
    [[nodiscard]] std::shared_ptr<const InputClaims> claims() const;

private:
    std::shared_ptr<InputClaims> claims_, before_;
};

/// Error if `path` is an input under this or another name.
Result<Done> checkIsNoInput(const std::filesystem::path& path);

} // namespace edgescan
