// One scan of an archive, from its file to its row: the work of one worker of `edgescan-cli batch`.
#pragma once

#include "app/shared/options.h"
#include "core/batch/archive/journal.h"

#include <filesystem>
#include <string>
#include <vector>

namespace edgescan::cli {

/// A result that the user wants for every scan, as typed: "mask", "edges.ply".
struct WantedFile {
    std::string typed;
    const exports::ExportKind* kind = nullptr; ///< null: JSON or the report
    [[nodiscard]] bool isOfRocks() const { return kind != nullptr && kind->needs == exports::ExportKind::Needs::Rocks; }
    std::string stem, extension; ///< of the file's name; of a kind, its table gives the stem
};

/// Error: a word that is not a result, or a format that cannot hold it. Duplicates are dropped.
Result<std::vector<WantedFile>> wantedFiles(const std::string& commaSeparated);

/// "mask, gray, ...", for the help.
[[nodiscard]] std::string wantedWords();

struct BatchWork {
    std::vector<std::string> inputs; ///< paths
    std::vector<std::string> names;  ///< the folder of each input's results, below results/scans
    batch::JournalRows before;       ///< the earlier rows of the inputs
    std::filesystem::path results, workFolder;
    ReadFlags read;
    MethodFlags method;
    WriteFlags write;
    std::vector<WantedFile> wanted;
    bool withRocks = false;
    RockFlags rocks;
    std::string settingsSha256;    ///< of everything that can change a result, including the program's version
    std::uint64_t memoryBytes = 0; ///< of a worker
    bool sidecars = true;
    bool retry = false;      ///< refused scans are tried again
    bool trustTimes = false; ///< a file with the same size and modification time counts as unchanged without reading it
};

/// Reads, detects, writes. Returns the row as one line of JSON, a line feed, and the bytes of a small picture for the survey. Returns an
/// empty string if the earlier row is still valid.
[[nodiscard]] std::string scanForArchive(const BatchWork& work, std::size_t job, int worker);

/// The row of a scan whose worker process died; `death` gives the reason.
[[nodiscard]] nlohmann::ordered_json failedRow(const BatchWork& work, std::size_t job, const std::string& death);

} // namespace edgescan::cli
