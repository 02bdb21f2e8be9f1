// Counts steps and bytes, and lets SQLite recover a copy of a database.
#ifdef EDGESCAN_SQLITE
#include "core/robots/bags/database_log.h"
#include "core/base/translated_text.h"

#include "core/base/memory.h"
#include "core/base/whole_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <span>
#include <system_error>

namespace edgescan::robots {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWal = "-wal";
constexpr std::size_t kLogHeader = 32, kPageHeader = 24, kLogPageSize = 8, kSalt = 16, kSaltOfPage = 8, kSaltBytes = 8; // of a -wal file

constexpr int kStepsAtATime = 1000, kLongestQuestion = 1000;
constexpr std::uint64_t kStepsAlways = 1'000'000, kStepsPerByte = 32; // of SQLite's machine; a row takes ten
constexpr std::uint64_t kFewestBytesOfRow = 5;                        // in a page: its place, two lengths, its number, a column

bool isNumber(int type) { return type == SQLITE_INTEGER || type == SQLITE_FLOAT; }

/// A folder that only this user can enter; it ends with this object.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code problem;
        std::string pattern = (fs::temp_directory_path(problem) / "edgescan-XXXXXX").string();
        if (!problem && ::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    /// Empty: it could not be made.
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::int64_t numberOf(sqlite3* database, const char* question, int column = 0) {
    sqlite3_stmt* row = nullptr;
    std::int64_t number = -1;
    if (sqlite3_prepare_v2(database, question, -1, &row, nullptr) == SQLITE_OK && sqlite3_step(row) == SQLITE_ROW)
        number = sqlite3_column_int64(row, column);
    sqlite3_finalize(row);
    return number;
}

/// A journal that names a second one makes SQLite look for files elsewhere, and delete them.
bool namesAnother(ByteView journal) {
    constexpr std::array<std::uint8_t, 8> kJournalMagic{0xd9, 0xd5, 0x05, 0xf9, 0x20, 0xa1, 0x63, 0xd7};
    return journal.size() >= kJournalMagic.size() && std::ranges::equal(journal.last(kJournalMagic.size()), kJournalMagic);
}

bool isWalLog(ByteView log) { return log.size() >= 4 && log[0] == 0x37 && log[1] == 0x7f && log[2] == 0x06 && (log[3] | 1U) == 0x83; }

/// Pages that the log began to write since its own beginning. Older ones are in the database.
std::int64_t pagesBegun(ByteView log) {
    if (log.size() < kLogHeader) return 0;
    std::size_t page = 0;
    for (std::size_t n = 0; n < 4; ++n) page = page << 8U | log[kLogPageSize + n];
    std::int64_t pages = 0;
    for (std::size_t at = kLogHeader; at < log.size(); at += kPageHeader + page) {
        const ByteView rest = log.subspan(at);
        if (rest.size() < kSaltOfPage + kSaltBytes) return pages + 1;
        if (!std::ranges::equal(rest.subspan(kSaltOfPage, kSaltBytes), log.subspan(kSalt, kSaltBytes))) break;
        ++pages;
    }
    return pages;
}

/// The pages of a database as it is with its log; empty: it cannot be read, or promises more pages than there are bytes.
Bytes pagesIn(sqlite3* database, std::size_t most) {
    const auto pages = static_cast<double>(numberOf(database, "PRAGMA page_count"));
    if (pages < 1 || pages * static_cast<double>(numberOf(database, "PRAGMA page_size")) > static_cast<double>(most)) return {};
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(sqlite3_serialize(database, "main", &size, 0), &sqlite3_free);
    return bytes ? Bytes(bytes.get(), bytes.get() + size) : Bytes();
}

void addLog(WholeDatabase& whole, ByteView database, const DatabaseLog& log, const fs::path& copy, const std::function<bool()>& goOn) {
    sqlite3* opened = nullptr;
    const bool open = sqlite3_open(copy.c_str(), &opened) == SQLITE_OK;
    const Database closing(opened);
    const std::string unread = withValues("The log %1 of the recorder could not be read: its messages are not in the scan.", {log.name});
    if (!open) return whole.warnings.push_back(unread);
    const DatabaseAllowance allowance(opened, database.size() + log.bytes.size(), goOn);
    // Alone on the file, SQLite needs no shared memory.
    sqlite3_exec(opened, "PRAGMA locking_mode=EXCLUSIVE", nullptr, nullptr, nullptr);
    const bool isWal = log.name.ends_with(kWal);
    Bytes pages = pagesIn(opened, database.size() + log.bytes.size());
    if (pages.empty()) return whole.warnings.push_back(unread);
    const bool changes = !std::ranges::equal(pages, database);
    if (isWal && !changes && log.bytes.size() >= kLogHeader && !isWalLog(log.bytes)) whole.warnings.push_back(unread);
    if (changes) whole.database = std::move(pages);
    if (changes && isWal)
        whole.warnings.push_back(withValues("The recorder was not ended: its newest messages were read from %1.", {log.name}));
    if (changes && !isWal)
        whole.warnings.push_back(
            withValues("The recorder was ended within a change: the database was read as it was before it, by %1.", {log.name}));
    if (!isWal) return;
    const std::int64_t written = std::max<std::int64_t>(0, numberOf(opened, "PRAGMA wal_checkpoint", 1));
    if (const std::int64_t left = pagesBegun(log.bytes) - written; left > 0)
        whole.warnings.push_back(withValues(
            "The log %1 of the recorder ends with %2 pages that are not whole: their messages are not in the scan.", {log.name, left}));
}

} // namespace

DatabaseAllowance::DatabaseAllowance(sqlite3* database, std::size_t bytes, const std::function<bool()>& goOn)
    : database_(database), goOn_(goOn), mayHold_(bytes), maySteps_(kStepsAlways + kStepsPerByte * bytes) {
    const auto longest = static_cast<int>(std::min<std::size_t>(bytes, std::numeric_limits<int>::max()));
    sqlite3_limit(database, SQLITE_LIMIT_LENGTH, std::max(longest, kLongestQuestion)); // no value is longer than the file
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_progress_handler(database, kStepsAtATime, &DatabaseAllowance::ends, this);
}

DatabaseAllowance::~DatabaseAllowance() { sqlite3_progress_handler(database_, 0, nullptr, nullptr); }

bool DatabaseAllowance::countRow(sqlite3_stmt* row) {
    std::uint64_t bytes = kFewestBytesOfRow;
    for (int column = 0; column < sqlite3_column_count(row); ++column) {
        if (!isNumber(sqlite3_column_type(row, column))) bytes += static_cast<std::uint64_t>(sqlite3_column_bytes(row, column));
    }
    isSpent_ = isSpent_ || bytes > mayHold_;
    mayHold_ -= isSpent_ ? 0 : bytes;
    return !isSpent_;
}

int DatabaseAllowance::ends(void* self) {
    auto& of = *static_cast<DatabaseAllowance*>(self);
    of.isCancelled_ = of.isCancelled_ || (of.goOn_ && !of.goOn_());
    of.isSpent_ = of.isSpent_ || of.maySteps_ < kStepsAtATime;
    of.maySteps_ -= of.isSpent_ ? 0 : kStepsAtATime;
    return of.isCancelled_ || of.isSpent_ ? 1 : 0;
}

Result<WholeDatabase> withLogs(ByteView database, const std::vector<DatabaseLog>& logs, const std::string& where,
                               const std::function<bool()>& goOn) {
    WholeDatabase whole;
    for (const DatabaseLog& log : logs) {
        if (!log.name.ends_with(kWal) && namesAnother(log.bytes)) {
            whole.warnings.push_back(
                withValues("The log %1 belongs to several databases and was not read: the last change may be in part.", {log.name}));
            continue;
        }
        if (auto enough = checkMemory(2 * (database.size() + log.bytes.size()), where); !enough) return enough.error();
        const TemporaryFolder folder;
        const Bytes before = whole.database;
        const ByteView now = before.empty() ? database : ByteView(before);
        const fs::path copy = folder.path() / "database";
        const std::string ending = log.name.ends_with(kWal) ? kWal : "-journal";
        if (folder.path().empty())
            return Error{withValues("the log %1 cannot be read: the folder for temporary files is missing", {log.name}), where,
                         "set TMPDIR to a folder"};
        for (const auto& [path, bytes] : {std::pair(copy, now), std::pair(fs::path(copy.string() + ending), log.bytes)}) {
            if (auto written = writeWholeFile(path, std::as_bytes(bytes)); !written) return written.error();
        }
        addLog(whole, now, log, copy, goOn);
    }
    return whole;
}

} // namespace edgescan::robots

#endif
