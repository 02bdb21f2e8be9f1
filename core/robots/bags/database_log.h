// The logs of a database that was not closed, written into it.
#pragma once

#include "core/robots/bags/bag.h"

#include <sqlite3.h>

#include <memory>

namespace edgescan::robots {

struct DatabaseClosed {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
using Database = std::unique_ptr<sqlite3, DatabaseClosed>;

struct WholeDatabase {
    Bytes database;                    ///< empty: no log changes it
    std::vector<std::string> warnings; ///< what was taken from the logs, and what was left
};

/// SQLite itself does it, on a copy in a folder of its own: the files given are not touched. Error: the copy cannot be written.
Result<WholeDatabase> withLogs(ByteView database, const std::vector<DatabaseLog>& logs, const std::string& where,
                               const std::function<bool()>& goOn);

} // namespace edgescan::robots
