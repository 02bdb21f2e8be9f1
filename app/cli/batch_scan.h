// One scan of an archive, from its file to its row: what a worker of `edgescan-cli batch` does.
#pragma once

#include "app/cli/rock_flags.h"
#include "app/shared/options.h"
#include "core/batch/archive/journal.h"

#include <filesystem>
#include <string>
#include <vector>

namespace edgescan::cli {

/// One of the files that are asked for of every scan, as typed: "mask", "edges.ply".
struct WantedFile {
    std::string typed;
    const ExportKind* kind = nullptr; ///< null: JSON or the report
    [[nodiscard]] bool isOfRocks() const { return kind != nullptr && kind->needs == ExportKind::Needs::Rocks; }
    std::string stem, extension; ///< of the file's name without a kind
};

/// Error: a word that names no result, or a format that cannot hold it. Each is given once.
Result<std::vector<WantedFile>> wantedFiles(const std::string& commaSeparated);

/// "mask, gray, ...", for the help.
[[nodiscard]] std::string wantedWords();

struct BatchWork {
    std::vector<std::string> inputs; ///< paths
    std::vector<std::string> names;  ///< the folder of each one's results, below results/scans
    JournalRows before;              ///< what is known of them
    std::filesystem::path results, workFolder;
    ReadFlags read;
    MethodFlags method;
    WriteFlags write;
    std::vector<WantedFile> wanted;
    bool withRocks = false;
    RockFlags rocks;
    std::string settingsSha256;    ///< of all that can change a result, the program's version included
    std::uint64_t memoryBytes = 0; ///< of a worker
    bool sidecars = true;
    bool retry = false;      ///< what was refused is tried again
    bool trustTimes = false; ///< a file of the same size and time is not read to see that it is the same
};

/// Reads, detects, writes. Gives the row as one line of JSON, a line feed, and the bytes of a small picture for the survey; nothing where
/// the row before still holds.
[[nodiscard]] std::string scanForArchive(const BatchWork& work, std::size_t job, int worker);

/// The row of a scan that ended its worker: `death` says how.
[[nodiscard]] nlohmann::ordered_json failedRow(const BatchWork& work, std::size_t job, const std::string& death);

} // namespace edgescan::cli
