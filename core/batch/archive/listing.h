// Finds the files that a run over an archive reads (docs/reference/batch.md, "What is read").
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace edgescan::batch {

struct ArchiveListing {
    std::vector<std::string> inputs;  ///< paths in the order of the tables, without duplicates
    std::vector<std::string> leftOut; ///< files of a folder with the extension of a scan that are not scans: records, exports

    /// A folder, link or file in a folder that cannot be read, or that is read by another path.
    struct NotRead {
        std::string path, why;
    };
    std::vector<NotRead> notRead{};
};

/// Each of `asked` is a folder, a pattern of the shell, a list of paths (a text file, or "-" for standard input), or a scan. Links to
/// folders are followed. The folder `results` is not searched. Error: one of these does not exist, a pattern without matches, an empty
/// list.
Result<ArchiveListing> listArchive(const std::vector<std::string>& asked, const std::filesystem::path& results);

/// One of several parts of a run. The part of a scan depends only on its path, not on the other scans of the archive.
struct Shard {
    int number = 1; ///< from 1
    int of = 1;
    [[nodiscard]] bool holds(const std::string& input) const;
};

/// "3/20". Error: the text has another form.
Result<Shard> shardOf(const std::string& text);

} // namespace edgescan::batch
