// Which files a run over an archive reads (docs/batch.md, "What is read").
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace edgescan {

struct ArchiveListing {
    std::vector<std::string> inputs;  ///< paths in the order of the tables, none twice
    std::vector<std::string> leftOut; ///< files of a folder that a format claims by name and that are no scans: records, exports
};

/// Each of `asked` is a folder, a pattern of the shell, a list of paths (a text file, or "-" for standard input), or a scan. The folder
/// `results` is not looked into. Error: one of these does not exist, a pattern that nothing matches, nothing at all.
Result<ArchiveListing> listArchive(const std::vector<std::string>& asked, const std::filesystem::path& results);

/// One of so many parts of a run. A scan belongs to a part by its path alone, whatever else is in the archive.
struct Shard {
    int number = 1; ///< from 1
    int of = 1;
    [[nodiscard]] bool holds(const std::string& input) const;
};

/// "3/20". Error: no such text.
Result<Shard> shardOf(const std::string& text);

} // namespace edgescan
