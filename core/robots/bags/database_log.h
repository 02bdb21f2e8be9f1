// What reading a database may cost, and the logs of one that was not closed, written into it.
#pragma once

#include "core/robots/bags/bag.h"

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace edgescan::robots {

struct DatabaseClosed {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
using Database = std::unique_ptr<sqlite3, DatabaseClosed>;

/// Steps and bytes by the size of the file: pages that several others name, and SQL that the file holds, give more rows than the file has
/// bytes. SQLite ends what it does with SQLITE_INTERRUPT where they are spent. It must outlive all use of the database.
class DatabaseAllowance {
public:
    /// Views, triggers and functions of the file's own SQL are off from now on. `goOn` is asked many times a second; it may be empty.
    DatabaseAllowance(sqlite3* database, std::size_t bytes, const std::function<bool()>& goOn);
    ~DatabaseAllowance();
    DatabaseAllowance(const DatabaseAllowance&) = delete;
    DatabaseAllowance& operator=(const DatabaseAllowance&) = delete;

    /// Counts the bytes of a row. False: the rows so far need more than the file has.
    bool countRow(sqlite3_stmt* row);
    [[nodiscard]] bool isSpent() const { return isSpent_; }
    [[nodiscard]] bool isCancelled() const { return isCancelled_; }

private:
    static int ends(void* self); // called by SQLite

    sqlite3* database_;
    const std::function<bool()>& goOn_;
    std::uint64_t mayHold_, maySteps_;
    bool isSpent_ = false, isCancelled_ = false;
};

struct WholeDatabase {
    Bytes database;                    ///< empty: no log changes it
    std::vector<std::string> warnings; ///< what was taken from the logs, and what was left
};

/// SQLite itself does it, on a copy in a folder of its own: the files given are not touched. Error: the copy cannot be written.
Result<WholeDatabase> withLogs(ByteView database, const std::vector<DatabaseLog>& logs, const std::string& where,
                               const std::function<bool()>& goOn);

} // namespace edgescan::robots
