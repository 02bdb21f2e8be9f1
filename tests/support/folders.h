// Where this checkout and its build are. folders.cpp alone is compiled with these paths, so that a compiler cache knows every other unit of
// the tests again in another checkout.
#pragma once

#include <filesystem>
#include <string>

namespace edgescan::test {

[[nodiscard]] std::string sourceFolder();
/// Of the built programs.
[[nodiscard]] std::string programFolder();
/// A library for LD_PRELOAD: slow_disk.cpp.
[[nodiscard]] std::string slowDiskLibrary();
/// The folder `shared` next to the project. EDGESCAN_SHARED names another one; where that does not exist, tests run as in a clone without
/// it.
[[nodiscard]] std::filesystem::path sharedFolder();
/// Files of the project's own.
[[nodiscard]] std::filesystem::path ownData();

} // namespace edgescan::test
