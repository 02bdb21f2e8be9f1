// The files that are in use as inputs: nothing that is written takes the place of one, by whatever name, link or case it is called.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace edgescan {

/// The claims that were made on one thread while it was bound to them; they end with the last copy of the pointer.
class InputClaims;

/// From now on `path` is an input, until the claims that this thread is bound to end. Nothing happens where the thread is bound to none, or
/// the path does not exist.
void claimInput(const std::filesystem::path& path);

/// Claims the file and reads all of it, as readWholeFile().
Result<std::vector<std::byte>> readInput(const std::filesystem::path& path);

/// The paths that were claimed, in the order in which that was.
[[nodiscard]] std::vector<std::filesystem::path> claimedPaths(const InputClaims& claims);

/// Binds the thread for as long as this lives.
class BindInputs {
public:
    BindInputs();
    ~BindInputs();
    BindInputs(const BindInputs&) = delete;
    BindInputs& operator=(const BindInputs&) = delete;
    /// To be kept as long as the inputs are in use.
    [[nodiscard]] std::shared_ptr<const InputClaims> claims() const;

private:
    std::shared_ptr<InputClaims> claims_, before_;
};

/// Error when `path` is an input by this or another name.
Result<Done> checkIsNoInput(const std::filesystem::path& path);

} // namespace edgescan
