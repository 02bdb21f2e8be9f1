// Journals: RESULTS/.batch/rows[-3-of-20].ndjson, and for each journal a file with the pictures of the survey.
#include "core/batch/archive/journal.h"

#include "core/base/append_file.h"
#include "core/base/bounded_json.h"
#include "core/base/descriptor.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace edgescan::batch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kFolder = ".batch";
constexpr const char* kRowsBegin = "rows";
constexpr const char* kRowsEnd = ".ndjson";
constexpr const char* kSettingsBegin = "settings";
constexpr const char* kSettingsEnd = ".sha256";
constexpr JsonBounds kRowJson{std::size_t{16} << 20U, 12, 100'000};
constexpr double kSyncSeconds = 1;

Error journalError(const fs::path& path, int code) {
    if (code == ELOOP)
        return {"this is a link, and a run removes and cuts files of the journal", path.string(),
                "remove the link, or give -o another folder"};
    return {std::string("what was done cannot be noted (") + std::strerror(code) + ")", path.string(),
            "free some space or check the rights, then run the same command again: it goes on from here"};
}

std::vector<fs::path> journalsIn(const fs::path& results) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(results / kFolder, none)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(kRowsBegin) && name.ends_with(kRowsEnd)) found.push_back(entry.path());
    }
    std::ranges::sort(found);
    return found;
}

bool heldByAnother(const fs::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    return file.isOpen() && ::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

// Removes a line that a crash tore, so that the next line does not continue it.
Result<Done> cutTornLine(const fs::path& path, int file) {
    const auto bytes = readWholeFile(path);
    if (!bytes) return bytes.error();
    const auto last = std::find(bytes->rbegin(), bytes->rend(), std::byte{'\n'});
    if (last == bytes->rbegin()) return Done{};
    if (::ftruncate(file, static_cast<off_t>(bytes->rend() - last)) != 0) return journalError(path, errno);
    return Done{};
}

std::string tailOf(const Shard& shard) {
    return shard.of == 1 ? std::string() : "-" + std::to_string(shard.number) + "-of-" + std::to_string(shard.of);
}

/// The part of a run whose journal this is, from its name.
Shard shardOfJournal(const fs::path& journal) {
    const std::string name = journal.stem().string();
    const std::size_t of = name.rfind("-of-"), begin = std::string_view(kRowsBegin).size() + 1;
    const auto parts = of == std::string::npos || of < begin ? std::nullopt : numberOf(std::string_view(name).substr(of + 4));
    const auto number = parts ? numberOf(std::string_view(name).substr(begin, of - begin)) : std::nullopt;
    constexpr double kMost = 1e6;
    if (!number || *parts > kMost || *number > kMost) return {};
    return {static_cast<int>(*number), static_cast<int>(*parts)};
}

fs::path settingsOf(const fs::path& journal) {
    return journal.parent_path() / (kSettingsBegin + tailOf(shardOfJournal(journal)) + kSettingsEnd);
}

bool isListOfObjects(const Json& list, const std::vector<const char*>& words) {
    return list.is_array() && std::ranges::all_of(list, [&](const Json& one) {
               return one.is_object() &&
                      std::ranges::all_of(words, [&](const char* word) { return one.contains(word) && one[word].is_string(); });
           });
}

/// Whether the members that a run reads again have the types that a run writes.
bool isRow(const Json& row) {
    if (!row.is_object() || !row.contains("input") || !row.contains("times") || !row["times"].contains("finished_utc")) return false;
    const auto missingOr = [](const Json& in, const char* name, auto is) { return !in.contains(name) || is(in[name]); };
    const auto word = [](const Json& value) { return value.is_string(); };
    const auto list = [](const Json& value) { return value.is_array(); };
    const auto number = [](const Json& value) { return value.is_number_unsigned(); };
    return row["input"].is_string() && missingOr(row, "outcome", word) && missingOr(row, "results", word) &&
           missingOr(row, "settings_sha256", word) && missingOr(row, "warnings", list) && missingOr(row["times"], "modified", list) &&
           missingOr(row["times"], "memory_bytes", number) &&
           missingOr(row, "files", [](const Json& files) { return isListOfObjects(files, {"file"}); }) &&
           missingOr(row, "outputs", [](const Json& files) { return isListOfObjects(files, {"file"}); });
}

/// The other parts whose settings are not these; to be called while no other journal is opened. A whole run does everything of other
/// settings again. A part cannot: a scan of one of two parts is in another one of three, and parts that run at the same time would mix
/// their results. Error: such a part, or the whole.
Result<std::string> partsOfOtherSettings(const fs::path& results, const Shard& shard, const std::string& settingsSha256) {
    std::string parts;
    for (const fs::path& journal : journalsIn(results)) {
        const Shard part = shardOfJournal(journal);
        const auto bytes = readWholeFile(settingsOf(journal));
        const bool own = part.number == shard.number && part.of == shard.of;
        if (own || !bytes || textOf(*bytes) == settingsSha256) continue;
        const std::string words = part.of == 1 ? "the whole run" : "part " + std::to_string(part.number) + " of " + std::to_string(part.of);
        if (part.of != shard.of || heldByAnother(journal))
            return Error{"other settings were used in " + words + " of these results", results.string(),
                         "give -o another folder, or the same settings"};
        parts += (parts.empty() ? "" : ", ") + words;
    }
    return parts;
}

/// Locks the folder while a journal is opened, so that of two that exclude each other one sees the other.
class OpeningLock {
public:
    explicit OpeningLock(const fs::path& folder) : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        while (folder_.isOpen() && ::flock(folder_.number(), LOCK_EX) != 0 && errno == EINTR) continue;
    }

private:
    Descriptor folder_;
};

} // namespace

Result<JournalRows> readJournals(const fs::path& results) {
    JournalRows rows;
    std::map<std::string, std::string> newest; // time of the row of each input
    for (const fs::path& path : journalsIn(results)) {
        const auto bytes = readWholeFile(path);
        if (!bytes) return bytes.error();
        const std::string_view text = textOf(*bytes);
        int number = 0;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = text.find('\n', at);
            if (end == std::string_view::npos) break; // torn
            ++number;
            const std::string_view line = text.substr(at, end - at);
            at = end + 1;
            const std::string where = path.string() + ": line " + std::to_string(number);
            const auto row = parseOrderedJson(line, where, kRowJson);
            if (!row) return row.error();
            if (!isRow(*row))
                return Error{"this line is not a row of a run", where,
                             "remove the line and its scan is done again, or give -o another folder"};
            const std::string name = (*row)["input"];
            const Json& finished = (*row)["times"]["finished_utc"];
            const std::string made = finished.is_string() ? finished.get<std::string>() : "";
            if (newest.contains(name) && newest[name] > made) continue;
            newest[name] = made;
            rows[name] = line;
        }
    }
    return rows;
}

int shardsIn(const fs::path& results) {
    int parts = 1;
    fs::file_time_type newest = fs::file_time_type::min();
    for (const fs::path& path : journalsIn(results)) {
        const Shard shard = shardOfJournal(path);
        std::error_code gone;
        const auto written = fs::last_write_time(path, gone);
        if (shard.of == 1 || gone || written < newest) continue;
        newest = written;
        parts = shard.of;
    }
    return parts;
}

Result<Journal> Journal::open(const fs::path& results, const Shard& shard, bool whole, const std::string& settingsSha256) {
    Journal journal;
    const fs::path folder = results / kFolder;
    std::error_code problem;
    if (fs::is_symlink(folder, problem)) return journalError(folder, ELOOP);
    fs::create_directories(folder, problem);
    if (problem) return journalError(folder, problem.value());
    const OpeningLock opening(folder);
    journal.path_ = folder / (kRowsBegin + tailOf(shard) + kRowsEnd);
    const Error busy{"another run works on these results", results.string(), "wait for it, or give -o another folder"};
    const auto others = journalsIn(results);
    for (const fs::path& other : others) {
        const bool concerns = whole || other == folder / (std::string(kRowsBegin) + kRowsEnd); // a whole run conflicts with every part
        if (concerns && heldByAnother(other)) return busy;
    }
    if (!whole) {
        auto parts = partsOfOtherSettings(results, shard, settingsSha256);
        if (!parts) return parts.error();
        journal.otherSettings_ = std::move(*parts);
    }
    journal.rows_ = ::open(journal.path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (journal.rows_ < 0) return journalError(journal.path_, errno);
    if (::flock(journal.rows_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return busy;
    if (!settingsSha256.empty()) {
        for (const fs::path& other : others) {
            if (whole) fs::remove(settingsOf(other), problem);
        }
        if (auto noted = writeWholeFile(settingsOf(journal.path_), settingsSha256); !noted) return noted.error();
    }
    if (auto cut = cutTornLine(journal.path_, journal.rows_); !cut) return cut.error();
    journal.picturesName_ = "pictures" + tailOf(shard) + ".bin";
    journal.pictures_ = ::open((folder / journal.picturesName_).c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (journal.pictures_ < 0) return journalError(folder / journal.picturesName_, errno);
    journal.pictureBytes_ = ::lseek(journal.pictures_, 0, SEEK_END);
    journal.work_ = folder / ("work" + tailOf(shard));
    fs::remove_all(journal.work_, problem);
    fs::create_directories(journal.work_, problem);
    if (problem) return journalError(journal.work_, problem.value());
    return journal;
}

Journal::Journal(Journal&& other) noexcept
    : rows_(std::exchange(other.rows_, -1)), pictures_(std::exchange(other.pictures_, -1)), pictureBytes_(other.pictureBytes_),
      picturesName_(std::move(other.picturesName_)), path_(std::move(other.path_)), work_(std::move(other.work_)),
      otherSettings_(std::move(other.otherSettings_)), synced_(other.synced_) {}

Journal::~Journal() {
    if (rows_ < 0) return;
    std::error_code ignored;
    if (!work_.empty()) fs::remove_all(work_, ignored);
    static_cast<void>(::fdatasync(rows_));
    ::close(rows_); // this releases the lock, too
    if (pictures_ >= 0) ::close(pictures_);
}

Result<Done> Journal::append(Json row, const std::string& picture) {
    if (!picture.empty()) {
        if (const int code = appendWhole(pictures_, picture)) return journalError(path_.parent_path() / picturesName_, code);
        row["picture"] = {picturesName_, pictureBytes_, picture.size()};
        pictureBytes_ += static_cast<long long>(picture.size());
    }
    if (const int code = appendWhole(rows_, jsonText(row) + "\n")) return journalError(path_, code);
    if (const double now = utcNow(); now - synced_ > kSyncSeconds || now < synced_) {
        static_cast<void>(::fdatasync(rows_)); // after a power failure, the work of the last second is repeated
        synced_ = now;
    }
    return Done{};
}

std::string pictureOf(const Json& row, const fs::path& results) {
    constexpr std::size_t kMostPicture = 1U << 20U;
    if (!row.contains("picture") || !row["picture"].is_array() || row["picture"].size() != 3) return {};
    const Json& place = row["picture"];
    if (!place[0].is_string() || !place[1].is_number_unsigned() || !place[2].is_number_unsigned()) return {};
    const std::string name = place[0];
    const auto size = place[2].get<std::size_t>();
    if (size > kMostPicture || name.find('/') != std::string::npos) return {};
    const int file = ::open((results / kFolder / name).c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return {};
    std::string bytes(size, '\0');
    const ssize_t got = ::pread(file, bytes.data(), size, static_cast<off_t>(place[1].get<std::uint64_t>()));
    ::close(file);
    return got == static_cast<ssize_t>(size) ? bytes : std::string();
}

} // namespace edgescan::batch
