// Journals: RESULTS/.batch/rows[-3-of-20].ndjson, and for each journal a file with the pictures of the survey.
#include "core/batch/archive/journal.h"

#include "core/base/append_file.h"
#include "core/base/bounded_json.h"
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
constexpr JsonBounds kRowJson{std::size_t{16} << 20U, 12, 100'000};
constexpr double kSyncSeconds = 1;

Error journalError(const fs::path& path, int code) {
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
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    const bool held = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(file);
    return held;
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
            const Json::json_pointer input("/input"), finished("/times/finished_utc");
            if (!row->is_object() || !row->contains(input) || !row->at(input).is_string() || !row->contains(finished))
                return Error{"this line is no row of a run", where, "take it out, or give -o another folder"};
            const std::string name = row->at(input);
            const std::string made = row->at(finished).is_string() ? row->at(finished).get<std::string>() : "";
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
        const std::string name = path.stem().string();
        const std::size_t of = name.rfind("-of-");
        const auto number = of == std::string::npos ? std::nullopt : numberOf(std::string_view(name).substr(of + 4));
        std::error_code gone;
        const auto written = fs::last_write_time(path, gone);
        if (!number || *number > 1e6 || gone || written < newest) continue;
        newest = written;
        parts = static_cast<int>(*number);
    }
    return parts;
}

Result<Journal> Journal::open(const fs::path& results, const Shard& shard, bool whole) {
    Journal journal;
    const fs::path folder = results / kFolder;
    std::error_code problem;
    fs::create_directories(folder, problem);
    if (problem) return journalError(folder, problem.value());
    journal.path_ = folder / (kRowsBegin + tailOf(shard) + kRowsEnd);
    journal.rows_ = ::open(journal.path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (journal.rows_ < 0) return journalError(journal.path_, errno);
    const Error busy{"another run works on these results", results.string(), "wait for it, or give -o another folder"};
    if (::flock(journal.rows_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return busy;
    for (const fs::path& other : journalsIn(results)) {
        const bool concerns = whole || other == folder / (std::string(kRowsBegin) + kRowsEnd); // a whole run conflicts with every part
        if (concerns && other != journal.path_ && heldByAnother(other)) return busy;
    }
    if (auto cut = cutTornLine(journal.path_, journal.rows_); !cut) return cut.error();
    journal.picturesName_ = "pictures" + tailOf(shard) + ".bin";
    journal.pictures_ = ::open((folder / journal.picturesName_).c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
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
      picturesName_(std::move(other.picturesName_)), path_(std::move(other.path_)), work_(std::move(other.work_)), synced_(other.synced_) {}

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
