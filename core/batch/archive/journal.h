// What a run over an archive has done so far: a line per scan, appended when all its results are on the disk. Whatever ends the run, what
// stands there is done, and what does not is done again (docs/batch.md, "Interrupted and continued").
#pragma once

#include "core/base/result.h"
#include "core/batch/archive/listing.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace edgescan {

/// The newest row of each input, as its line of JSON.
using JournalRows = std::map<std::string, std::string>;

/// Rows of all journals under a folder of results; lines cut off by a crash are left out. Error: a journal cannot be read, or is none.
Result<JournalRows> readJournals(const std::filesystem::path& results);

/// Into how many parts the last run was cut whose journals lie there; 1 where none was.
[[nodiscard]] int shardsIn(const std::filesystem::path& results);

/// A journal that this process alone may write, from open() to its end.
class Journal {
public:
    /// Makes the folder where it is missing. `whole`: no part may be running elsewhere either. Error: another process works on the same
    /// results, or they cannot be written to.
    static Result<Journal> open(const std::filesystem::path& results, const Shard& shard, bool whole);
    Journal(Journal&& other) noexcept;
    Journal& operator=(Journal&&) = delete;
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    ~Journal();

    /// One row, whole or not at all; `picture` (may be empty) is kept beside the journal. Error: the disk is full ...
    Result<Done> append(nlohmann::ordered_json row, const std::string& picture);

    /// Where results stand until all of one scan are complete: a folder of this journal's own, empty when it was opened.
    [[nodiscard]] const std::filesystem::path& workFolder() const { return work_; }

private:
    Journal() = default;
    int rows_ = -1, pictures_ = -1; // descriptors
    long long pictureBytes_ = 0;
    std::string picturesName_;
    std::filesystem::path path_, work_;
    double synced_ = 0;
};

/// The picture that append() kept with a row; empty when there is none.
[[nodiscard]] std::string pictureOf(const nlohmann::ordered_json& row, const std::filesystem::path& results);

} // namespace edgescan
