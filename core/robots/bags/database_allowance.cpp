// Counts steps and bytes.
#ifdef EDGESCAN_SQLITE
#include "core/robots/bags/database_allowance.h"

#include <algorithm>
#include <limits>

namespace edgescan::robots {
namespace {

constexpr int kStepsAtATime = 1000, kLongestQuestion = 1000;
constexpr std::uint64_t kStepsAlways = 1'000'000, kStepsPerByte = 32; // of SQLite's machine; a row takes ten
constexpr std::uint64_t kFewestBytesOfRow = 5;                        // in a page: its place, two lengths, its number, a column

bool isNumber(int type) { return type == SQLITE_INTEGER || type == SQLITE_FLOAT; }

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

} // namespace edgescan::robots

#endif
