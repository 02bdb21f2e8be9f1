// The folder of a bag of ROS 2: metadata.yaml names the files in it.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace edgescan::robots {

struct BagFiles {
    std::filesystem::path path;               ///< by which it is opened again: its file, else its metadata.yaml, else its folder
    std::vector<std::filesystem::path> parts; ///< in the order of their times
    std::vector<std::string> missing;         ///< parts that metadata.yaml names and that are not there
    std::vector<std::string> others;          ///< what metadata.yaml names besides, which hold no messages
    std::vector<std::string> unnamed{};       ///< further parts by their names, which metadata.yaml does not name

    [[nodiscard]] bool isSplit() const { return parts.size() + missing.size() + others.size() + unnamed.size() > 1; }
};

/// The files of messages of a bag's folder, or of its metadata.yaml; any other path is one file. Without metadata.yaml, which a bag that
/// was interrupted does not have, files NAME_0, NAME_1, ... are one bag. Error: a folder with files of several bags.
Result<BagFiles> filesOfBag(const std::filesystem::path& path);

/// A sentence that the file is one part of several, and which file opens them all; empty: it is not.
[[nodiscard]] std::string partOfBag(const std::filesystem::path& file);

} // namespace edgescan::robots
