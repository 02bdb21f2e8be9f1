// A file in memory that is not written yet.
#pragma once

#include <filesystem>
#include <string>

namespace edgescan {

struct FileBytes {
    std::filesystem::path path;
    std::string bytes;
};

} // namespace edgescan
