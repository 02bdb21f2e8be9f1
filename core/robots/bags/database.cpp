// Databases of rosbag2, read from memory through SQLite.
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/robots/bags/bag.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#ifdef EDGESCAN_SQLITE
#include "core/robots/bags/database_log.h"
#endif

namespace edgescan::robots {

bool looksLikeSqlite(ByteView bytes) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())
        .starts_with(std::string_view("SQLite format 3\0", 16));
}

#ifdef EDGESCAN_SQLITE
namespace {

struct Closed {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, Closed>;

ByteView bytesIn(sqlite3_stmt* row, int column) {
    const void* blob = sqlite3_column_blob(row, column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, column));
    return {static_cast<const std::uint8_t*>(blob), blob != nullptr ? size : 0};
}

std::string textIn(sqlite3_stmt* row, int column) {
    const ByteView bytes = bytesIn(row, column);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class DatabaseReader {
public:
    DatabaseReader(sqlite3* database, std::size_t bytes, const std::string& where, const std::function<bool()>& goOn)
        : database_(database), where_(where), goOn_(goOn), allowance_(database, bytes, goOn) {
        bag_.kind = "ROS 2 bag (SQLite)";
        bag_.mayUnpack = mostUnpackedBytes(bytes);
    }

    Result<RosBag> read() {
        auto known = topics();
        if (known) known = messages();
        if (allowance_.isCancelled() || (goOn_ && !goOn_())) return Error{"cancelled", where_, ""};
        if (allowance_.isSpent())
            return Error{"this SQLite database is damaged: its tables give more than the file can hold", where_, "copy it again"};
        if (!known) return known.error();
        return std::move(bag_);
    }

private:
    Statement prepared(const std::string& question) {
        sqlite3_stmt* statement = nullptr;
        if (sqlite3_prepare_v2(database_, question.c_str(), -1, &statement, nullptr) != SQLITE_OK) statement = nullptr;
        return Statement(statement);
    }

    /// The first number that the question gives; 0: none.
    std::int64_t numberOf(const std::string& question) {
        const Statement row = prepared(question);
        return row && sqlite3_step(row.get()) == SQLITE_ROW ? sqlite3_column_int64(row.get(), 0) : 0;
    }

    [[nodiscard]] bool isDamaged() const {
        return sqlite3_errcode(database_) == SQLITE_CORRUPT || sqlite3_errcode(database_) == SQLITE_NOTADB;
    }

    /// Columns of a plain table: its rows are in the file. Null: the table is missing. Error: a view, a table of a module, or computed
    /// columns. SQL in the file makes the rows of these.
    Result<Statement> rowsOf(const std::string& table, const std::string& columns) {
        const std::string named = "SELECT count(*) FROM sqlite_master WHERE name = '" + table + "'";
        if (numberOf(named) == 0) return Statement();
        const bool isPlain = numberOf(named + " AND type = 'table' AND rootpage > 0") == 1 &&
                             numberOf("SELECT count(*) FROM pragma_table_xinfo('" + table + "') WHERE hidden > 0") == 0;
        if (!isPlain && !isDamaged())
            return Error{withValues("this SQLite database is not a ROS bag: \"%1\" is not a plain table", {table}), where_,
                         "choose another file"};
        return prepared("SELECT " + columns + " FROM " + table + " NOT INDEXED");
    }

    /// Calls `visit` with each row; the state that SQLite ends with.
    template <class Visit>
    int eachRow(const Statement& rows, const Visit& visit) {
        int state = rows ? sqlite3_step(rows.get()) : SQLITE_ERROR;
        for (; state == SQLITE_ROW && allowance_.countRow(rows.get()); state = sqlite3_step(rows.get())) visit(rows.get());
        return state;
    }

    Result<Done> definitions() {
        const auto rows = rowsOf("message_definitions", "topic_type, encoded_message_definition, encoding");
        if (!rows) return rows.error();
        eachRow(*rows, [&](sqlite3_stmt* row) {
            if (textIn(row, 2) == "ros2msg") definitions_[rosTypeName(textIn(row, 0))] = textIn(row, 1);
        });
        return Done{};
    }

    Result<Done> topics() {
        if (auto known = definitions(); !known) return known;
        const auto rows = rowsOf("topics", "id, name, type, serialization_format");
        if (!rows) return rows.error();
        if (!*rows && isDamaged())
            return Error{"this SQLite database is cut off or damaged: its tables cannot be read", where_, "copy it again"};
        if (!*rows) return Error{"this SQLite database is not a ROS bag: it has no table of topics", where_, "choose another file"};
        eachRow(*rows, [&](sqlite3_stmt* row) {
            if (textIn(row, 3) != "cdr") return;
            RosTopic topic{textIn(row, 1), rosTypeName(textIn(row, 2)), {}, RosEncoding::Cdr, false};
            const auto own = definitions_.find(topic.type);
            topic.assumed = own == definitions_.end();
            topic.definition = topic.assumed ? std::string(commonRosDefinition(topic.type)) : own->second;
            topics_[sqlite3_column_int64(row, 0)] = static_cast<std::uint32_t>(bag_.topics.size());
            bag_.topics.push_back(std::move(topic));
        });
        return Done{};
    }

    /// In the order of their numbers. SQLite does not sort them: it would need a copy of all before the first.
    Result<Done> messages() {
        const auto rows = rowsOf("messages", "topic_id, timestamp, data, id");
        if (!rows) return rows.error();
        std::size_t bad = 0;
        std::vector<std::pair<std::int64_t, RosBagMessage>> found;
        const int state = eachRow(*rows, [&](sqlite3_stmt* row) {
            const auto topic = topics_.find(sqlite3_column_int64(row, 0));
            if (topic == topics_.end()) return;
            const auto message = stored(bytesIn(row, 2));
            if (message)
                found.push_back({sqlite3_column_int64(row, 3), {topic->second, sqlite3_column_int64(row, 1), *message}});
            else
                ++bad;
        });
        std::ranges::stable_sort(found, {}, [](const auto& numbered) { return numbered.first; });
        for (auto& [number, message] : found) bag_.messages.push_back(message);
        if (state != SQLITE_DONE)
            bag_.warnings.push_back(withValues("The database is cut off or damaged (%1): messages behind the first %2 were not read.",
                                               {sqlite3_errmsg(database_), bag_.messages.size()}));
        if (bad > 0)
            bag_.warnings.push_back(counted(bad, "message is compressed and damaged and was left out.",
                                            "messages are compressed and damaged and were left out."));
        return Done{};
    }

    /// The message in memory of the bag's own: SQLite's is gone with the next row.
    std::optional<ByteView> stored(ByteView message) {
        const std::size_t before = bag_.unpacked.size();
        const auto plain = plainMessage(bag_, message, where_, goOn_);
        if (!plain || bag_.unpacked.size() > before) return plain;
        if (block_ == nullptr || block_->capacity() - block_->size() < message.size()) {
            block_ = &bag_.unpacked.emplace_back();
            block_->reserve(std::max(kBlock, message.size()));
        }
        const std::size_t at = block_->size();
        block_->insert(block_->end(), message.begin(), message.end()); // within its capacity: views of it stay
        return ByteView(*block_).subspan(at);
    }

    static constexpr std::size_t kBlock = 1 << 20;
    sqlite3* database_;
    const std::string& where_;
    const std::function<bool()>& goOn_;
    DatabaseAllowance allowance_;
    RosBag bag_;
    std::map<std::string, std::string> definitions_; // by type
    std::map<std::int64_t, std::uint32_t> topics_;
    Bytes* block_ = nullptr; // one of `unpacked` that takes plain messages
};

constexpr std::size_t kHeader = 100, kPageSize = 16, kPages = 28; // of the file; places of numbers in it

/// Bytes of a page and their number, as the header counts them; 0 where it does not.
std::pair<std::size_t, std::size_t> pagesOf(ByteView bytes) {
    if (bytes.size() < kHeader) return {0, 0};
    const auto at = [&](std::size_t n) { return std::size_t{bytes[n]}; };
    const std::size_t page = at(kPageSize) == 0 && at(kPageSize + 1) == 1 ? 65536 : at(kPageSize) << 8U | at(kPageSize + 1);
    return {page, at(kPages) << 24U | at(kPages + 1) << 16U | at(kPages + 2) << 8U | at(kPages + 3)};
}

/// Bytes behind the pages that the header counts, without padding.
std::size_t bytesBehind(ByteView bytes) {
    const auto [page, pages] = pagesOf(bytes);
    const std::size_t size = page * pages;
    if (size == 0 || size >= bytes.size()) return 0;
    const ByteView behind = bytes.subspan(size);
    return std::ranges::any_of(behind, [](std::uint8_t byte) { return byte != 0; }) ? behind.size() : 0;
}

/// The database in memory, read only. Error: SQLite refuses it.
Result<RosBag> readPlain(ByteView bytes, const std::string& where, const std::function<bool()>& goOn) {
    sqlite3* opened = nullptr;
    const bool open = sqlite3_open(":memory:", &opened) == SQLITE_OK;
    const Database database(opened);
    auto* own = const_cast<unsigned char*>(bytes.data()); // read only
    const auto size = static_cast<sqlite3_int64>(bytes.size());
    if (!open || sqlite3_deserialize(opened, "main", own, size, size, SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
        return Error{"this SQLite database cannot be opened", where, "copy it again"};
    return DatabaseReader(opened, bytes.size(), where, goOn).read();
}

} // namespace

Result<RosBag> readRosDatabase(ByteView bytes, const std::string& where, const std::vector<DatabaseLog>& logs,
                               const std::function<bool()>& goOn) {
    // A file in WAL mode cannot be read from memory; with its log written into it, it reads as any other file. Of a file that was cut off
    // SQLite reads what is there if the header counts no more pages.
    constexpr std::size_t kVersions = 18; // of the file format for writing and reading: 2 is WAL
    auto whole = withLogs(bytes, logs, where, goOn);
    if (!whole) return whole.error();
    const std::size_t behind = bytesBehind(bytes);
    if (!whole->database.empty()) bytes = whole->database;
    const auto [page, pages] = pagesOf(bytes);
    const bool isCut = page > 0 && pages > bytes.size() / page;
    Bytes plain;
    if (bytes.size() >= kHeader && (bytes[kVersions] == 2 || bytes[kVersions + 1] == 2 || isCut)) {
        if (auto enough = checkMemory(bytes.size(), where); !enough) return enough.error();
        plain.assign(bytes.begin(), bytes.end());
        plain[kVersions] = plain[kVersions + 1] = 1;
        if (isCut) plain.resize(std::max(kHeader, bytes.size() / page * page));
        for (std::size_t n = 0; isCut && n < 4; ++n) plain[kPages + n] = static_cast<std::uint8_t>(bytes.size() / page >> (24 - 8 * n));
        bytes = plain;
    }
    auto bag = readPlain(bytes, where, goOn);
    if (!bag) return bag;
    bag->warnings.insert(bag->warnings.begin(), whole->warnings.begin(), whole->warnings.end());
    if (behind > 0)
        bag->warnings.push_back(
            counted(behind, "byte behind the end of the database was not read.", "bytes behind the end of the database were not read."));
    return bag;
}

#else

Result<RosBag> readRosDatabase(ByteView, const std::string& where, const std::vector<DatabaseLog>&, const std::function<bool()>&) {
    return Error{"this is a ROS 2 bag in SQLite, and this program was built without SQLite", where,
                 "convert it with \"ros2 bag convert\" to MCAP, or install libsqlite3-dev and build again"};
}

#endif

} // namespace edgescan::robots
