// The progress of a run over an archive: a line per scan, appended after all its results are on the disk. After an interruption, scans in
// the journal are done, and all others are processed again (docs/reference/batch.md, "Interrupted and continued").
#pragma once

#include "core/base/result.h"
#include "core/batch/archive/listing.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace edgescan::batch {

/// The newest row of each input, as its line of JSON.
using JournalRows = std::map<std::string, std::string>;

/// Rows of all journals in a folder of results, without lines torn by a crash. Error: a journal cannot be read, or a file is not a journal.
Result<JournalRows> readJournals(const std::filesystem::path& results);

/// Number of parts of the last run whose journals are in the folder; 1 if there are no journals.
[[nodiscard]] int shardsIn(const std::filesystem::path& results);

/// A journal that only this process may write, from open() to its end.
class Journal {
public:
    /// Creates the folder if it does not exist. `whole`: no other process may be running a part either. `settingsSha256`: of the run;
    /// empty: it only merges. Error: another process works on the same results, other settings were used in parts of another number or in a
    /// part that is running, the folder or a file of the journal is a link, or they cannot be written.
    static Result<Journal> open(const std::filesystem::path& results, const Shard& shard, bool whole, const std::string& settingsSha256);
    Journal(Journal&& other) noexcept;
    Journal& operator=(Journal&&) = delete;
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    ~Journal();

    /// Appends one row completely, or leaves the journal unchanged; `picture` (may be empty) is stored in the picture file. Error: the disk
    /// is full ...
    Result<Done> append(nlohmann::ordered_json row, const std::string& picture);

    /// Folder for the results of one scan until all of them are complete. It belongs to this journal only and was empty when the journal
    /// was opened.
    [[nodiscard]] const std::filesystem::path& workFolder() const { return work_; }

    /// The parts that other settings were used in, and which must run again before the merge: "part 2 of 4, part 3 of 4".
    [[nodiscard]] const std::string& otherSettings() const { return otherSettings_; }

private:
    Journal() = default;
    int rows_ = -1, pictures_ = -1; // descriptors
    long long pictureBytes_ = 0;
    std::string picturesName_;
    std::filesystem::path path_, work_;
    std::string otherSettings_;
    double synced_ = 0;
};

/// The picture that append() stored with a row; empty if there is none.
[[nodiscard]] std::string pictureOf(const nlohmann::ordered_json& row, const std::filesystem::path& results);

} // namespace edgescan::batch
