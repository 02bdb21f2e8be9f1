// Databases that SQL and shared pages make endless, logs of recorders that were killed, and the wish to stop.
#include "tests/support/ros_bags.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#ifdef EDGESCAN_TESTS_SQLITE

#include <fstream>

using namespace edgescan;
using namespace edgescan::robots;
using namespace edgescan::test;

namespace {

RosMessages numbers(std::uint32_t count) {
    RosMessages all;
    all.topics.push_back({"/numbers", "std_msgs/UInt32", "uint32 data"});
    for (std::uint32_t n = 0; n < count; ++n) all.message(0, n, RosWriter(Wire::CdrLittle).put(n).bytes());
    return all;
}

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

/// The file of a database that this SQL makes of a sound bag.
Bytes changedBy(const std::string& sql) {
    const TemporaryFolder folder;
    const std::string path = (folder / "bag.db3").string();
    const Bytes bag = databaseOf(numbers(50));
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bag.data()), static_cast<std::streamsize>(bag.size()));
    sqlite3* base = nullptr;
    sqlite3_open(path.c_str(), &base);
    sqlite3_db_config(base, SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
    EXPECT_EQ(sqlite3_exec(base, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(base) << sql;
    sqlite3_close(base);
    return bytesOf(fileText(path));
}

std::size_t rootOf(const Bytes& bytes, const std::string& table) {
    sqlite3* base = nullptr;
    sqlite3_open(":memory:", &base);
    Bytes own = bytes;
    const auto size = static_cast<sqlite3_int64>(own.size());
    sqlite3_deserialize(base, "main", own.data(), size, size, SQLITE_DESERIALIZE_READONLY);
    sqlite3_stmt* row = nullptr;
    sqlite3_prepare_v2(base, ("SELECT rootpage FROM sqlite_master WHERE name = '" + table + "'").c_str(), -1, &row, nullptr);
    const auto root = sqlite3_step(row) == SQLITE_ROW ? static_cast<std::size_t>(sqlite3_column_int64(row, 0)) : 0;
    sqlite3_finalize(row);
    sqlite3_close(base);
    return root;
}

/// The root names one interior page over and over, and that one a leaf: a hundred thousand rows in a small file.
Bytes withSharedPages() {
    constexpr std::size_t kPage = 512, kCell = 506, kCells = 80, kInterior = 5;
    Bytes bytes = databaseOf(numbers(5000));
    const auto number = [&](std::size_t at) {
        return std::size_t{bytes[at]} << 24U | std::size_t{bytes[at + 1]} << 16U | std::size_t{bytes[at + 2]} << 8U | bytes[at + 3];
    };
    std::size_t page = rootOf(bytes, "messages");
    for (int level = 0; level < 2; ++level) {
        const std::size_t at = (page - 1) * kPage;
        EXPECT_EQ(bytes[at], kInterior);
        const std::size_t child = number(at + 8); // the last one
        bytes[at + 3] = 0;
        bytes[at + 4] = kCells;
        for (std::size_t n = 0; n < kCells; ++n) {
            bytes[at + 12 + 2 * n] = kCell >> 8U;
            bytes[at + 13 + 2 * n] = kCell & 255U;
        }
        for (std::size_t n = 0; n < 4; ++n) bytes[at + kCell + n] = static_cast<std::uint8_t>(child >> (24 - 8 * n));
        bytes[at + kCell + 4] = 1;
        page = child;
    }
    return bytes;
}

const char* const kEndless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT ";

} // namespace

TEST(HostileDatabase, OnlyPlainTablesOfTheFileAreRead) {
    const std::string messages = "i AS id, 1 AS topic_id, i AS timestamp, zeroblob(100) AS data FROM n";
    const std::string topics = "i AS id, 'a' AS name, 'std_msgs/msg/UInt32' AS type, 'cdr' AS serialization_format FROM n";
    const std::string definitions = "'a' AS topic_type, 'a' AS encoded_message_definition, 'ros2msg' AS encoding FROM n";
    const std::string schema = "PRAGMA writable_schema=ON; ";
    struct {
        const char* name;
        std::string sql;
    } const cases[]{
        {"a view of messages", std::string("DROP TABLE messages; CREATE VIEW messages AS ") + kEndless + messages},
        {"a view of topics", std::string("DROP TABLE topics; CREATE VIEW topics AS ") + kEndless + topics},
        {"a view of definitions",
         std::string("DROP TABLE message_definitions; CREATE VIEW message_definitions AS ") + kEndless + definitions},
        {"a view that is called a table", std::string("DROP TABLE messages; CREATE VIEW messages AS ") + kEndless + messages + "; " +
                                              schema + "UPDATE sqlite_master SET type='table', rootpage=2 WHERE name='messages'"},
        {"computed columns", "DROP TABLE messages; CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, "
                             "data BLOB AS (zeroblob(900000000)));  INSERT INTO messages(topic_id, timestamp) VALUES(1, 1)"},
        {"a view with large values",
         "DROP TABLE messages; CREATE VIEW messages AS SELECT 1 AS id, 1 AS topic_id, 1 AS timestamp, zeroblob(900000000) AS data"},
    };
    for (const auto& [name, sql] : cases) {
        const auto read = readRosDatabase(changedBy(sql), "test");
        ASSERT_FALSE(read) << name;
        EXPECT_TRUE(read.error().what.find("is not a plain table") != std::string::npos ||
                    read.error().what.find("damaged") != std::string::npos)
            << name << ": " << read.error().sentence();
    }
}

TEST(HostileDatabase, MoreThanTheFileCanHoldIsRefused) {
    const auto read = readRosDatabase(withSharedPages(), "test");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().what.find("more than the file can hold"), std::string::npos) << read.error().sentence();
}

TEST(HostileDatabase, ASoundOneIsReadWholeInTheOrderOfItsNumbers) {
    const auto read = readRosDatabase(databaseOf(numbers(20000)), "test"); // small rows: the most steps for their bytes
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->messages.size(), 20000U);
    const auto turned = readRosDatabase(changedBy("CREATE TABLE m AS SELECT 100 - id AS id, topic_id, timestamp, data FROM messages; "
                                                  "DROP TABLE messages; ALTER TABLE m RENAME TO messages"),
                                        "test");
    ASSERT_TRUE(turned) << turned.error().sentence();
    ASSERT_EQ(turned->messages.size(), 50U);
    EXPECT_EQ(turned->messages.front().logNs, 49);
    EXPECT_TRUE(turned->warnings.empty());
}

TEST(HostileDatabase, TheWishToStopEndsIt) {
    int asked = 0;
    const auto read = readRosDatabase(databaseOf(numbers(5000)), "test", {}, [&] { return ++asked < 3; });
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().what, "cancelled");
    EXPECT_EQ(asked, 3);
}

namespace {

struct Killed {
    Bytes database, log;
};

/// The files of a recorder that was killed: a first half of the messages is in the database, a second one in the log.
Killed killedRecorder(const char* mode, const char* ending, const std::string& more) {
    const TemporaryFolder folder;
    const std::string path = (folder / "bag.db3").string();
    const Bytes bag = databaseOf(numbers(500));
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bag.data()), static_cast<std::streamsize>(bag.size()));
    sqlite3* base = nullptr;
    sqlite3_open(path.c_str(), &base);
    const std::string sql = std::string("PRAGMA journal_mode=") + mode + "; PRAGMA wal_autocheckpoint=0; PRAGMA cache_size=1; " + more;
    EXPECT_EQ(sqlite3_exec(base, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(base);
    const Killed files{bytesOf(fileText(path)), bytesOf(fileText(path + ending))};
    sqlite3_close(base);
    return files;
}

const std::string kAgain = "INSERT INTO messages(topic_id, timestamp, data) SELECT topic_id, timestamp + 500, data FROM messages";

bool warns(const RosBag& bag, std::string_view words) {
    return std::ranges::any_of(bag.warnings, [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

} // namespace

TEST(KilledRecorder, MessagesOfItsLogAreRead) {
    const Killed files = killedRecorder("WAL", "-wal", kAgain);
    ASSERT_FALSE(files.log.empty());
    const auto without = readRosDatabase(files.database, "test");
    ASSERT_TRUE(without) << without.error().sentence();
    EXPECT_EQ(without->messages.size(), 500U);
    const auto whole = readRosDatabase(files.database, "test", {{"bag.db3-wal", files.log}});
    ASSERT_TRUE(whole) << whole.error().sentence();
    EXPECT_EQ(whole->messages.size(), 1000U);
    EXPECT_EQ(whole->messages.back().logNs, 999);
    ASSERT_EQ(whole->warnings.size(), 1U);
    EXPECT_TRUE(warns(*whole, "newest messages were read from bag.db3-wal"));
    // A log that was cut off within its only change, one of another file, and one of nothing.
    const auto cut = readRosDatabase(files.database, "test", {{"bag.db3-wal", ByteView(files.log).first(files.log.size() - 600)}});
    ASSERT_TRUE(cut) << cut.error().sentence();
    EXPECT_EQ(cut->messages.size(), 500U);
    EXPECT_TRUE(warns(*cut, "pages that are not whole")) << cut->warnings.size();
    const Bytes other(5000, 7);
    const auto foreign = readRosDatabase(files.database, "test", {{"bag.db3-wal", other}});
    ASSERT_TRUE(foreign) << foreign.error().sentence();
    EXPECT_EQ(foreign->messages.size(), 500U);
}

TEST(KilledRecorder, AChangeThatWasNotEndedIsTakenBack) {
    const Killed files = killedRecorder("DELETE", "-journal", "BEGIN; UPDATE messages SET timestamp = 7; " + kAgain);
    ASSERT_FALSE(files.log.empty());
    const auto torn = readRosDatabase(files.database, "test");
    const auto whole = readRosDatabase(files.database, "test", {{"bag.db3-journal", files.log}});
    ASSERT_TRUE(whole) << whole.error().sentence();
    ASSERT_EQ(whole->messages.size(), 500U);
    for (std::size_t n = 0; n < 500; ++n) ASSERT_EQ(whole->messages[n].logNs, static_cast<std::int64_t>(n));
    EXPECT_TRUE(warns(*whole, "as it was before it, by bag.db3-journal"));
    // One that names a second log is not given to SQLite, which would look for that one, and delete it.
    Bytes naming = files.log;
    for (const int byte : {0xd9, 0xd5, 0x05, 0xf9, 0x20, 0xa1, 0x63, 0xd7}) naming.push_back(static_cast<std::uint8_t>(byte));
    const auto left = readRosDatabase(files.database, "test", {{"bag.db3-journal", naming}});
    ASSERT_EQ(static_cast<bool>(left), static_cast<bool>(torn));
    if (left) {
        EXPECT_TRUE(warns(*left, "belongs to several databases"));
    }
}

#endif
