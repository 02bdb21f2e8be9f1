// Appends lines with hashes while it holds a lock on the file.
#include "core/base/audit_log/audit_log.h"

#include "core/base/append_file.h"
#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/sha256.h"
#include "core/base/utc_time.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <span>
#include <system_error>

namespace edgescan {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kHashKey = ",\"sha256\":\"";
constexpr std::size_t kHashDigits = 64;
constexpr std::size_t kTailBytes = kHashKey.size() + kHashDigits + 2; // with quote and brace
constexpr JsonBounds kLineJson{std::size_t{1} << 20U, 8, 10'000};

std::string hashOf(std::string_view text) { return sha256Hex(std::as_bytes(std::span(text))); }

// A file that is open and locked during the lifetime of this object.
class LockedFile {
public:
    explicit LockedFile(const std::filesystem::path& path)
        : file_(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)), code_(file_ < 0 ? errno : 0) {
        while (code_ == 0 && ::flock(file_, LOCK_EX) != 0) {
            if (errno != EINTR) code_ = errno;
        }
    }
    ~LockedFile() {
        if (file_ >= 0) ::close(file_);
    }
    LockedFile(const LockedFile&) = delete;
    LockedFile& operator=(const LockedFile&) = delete;
    [[nodiscard]] int file() const { return file_; }
    [[nodiscard]] int code() const { return code_; }

private:
    int file_, code_;
};

// The end of the file: the last complete line, and the bytes behind it that a crash left.
struct Tail {
    std::string lastLine, torn;
};
std::optional<Tail> tailOf(int file) {
    const off_t size = ::lseek(file, 0, SEEK_END);
    std::string text;
    for (off_t at = size; at > 0;) {
        const auto piece = std::min<off_t>(at, 65536);
        at -= piece;
        std::string bytes(static_cast<std::size_t>(piece), '\0');
        if (::pread(file, bytes.data(), bytes.size(), at) != piece) return std::nullopt;
        text.insert(0, bytes);
        const std::size_t end = text.rfind('\n');
        const std::size_t begin = end == std::string::npos || end == 0 ? std::string::npos : text.rfind('\n', end - 1);
        if (begin != std::string::npos) return Tail{text.substr(begin + 1, end - begin - 1), text.substr(end + 1)};
    }
    const std::size_t end = text.rfind('\n');
    return end == std::string::npos ? Tail{{}, text} : Tail{text.substr(0, end), text.substr(end + 1)};
}

Error cannotAppend(const std::filesystem::path& path, const std::string& why) {
    return {"what is done is not noted (" + why + ")", path.string(), "free some space or check the rights of the audit log"};
}

} // namespace

std::string auditText(const AuditLine& line) {
    const Json object{{"n", line.n}, {"utc", line.utc}, {"event", line.event}, {"details", line.details}, {"before", line.before}};
    std::string text = jsonText(object);
    text.pop_back();
    const std::string hash = hashOf(text);
    return text.append(kHashKey) + hash + "\"}";
}

Result<AuditLine> auditLine(std::string_view text, const std::string& where) {
    const auto object = parseOrderedJson(text, where, kLineJson);
    if (!object) return object.error();
    const Error none{"this is not a line of an audit log", where, "it was altered, or the file is another one"};
    if (!object->is_object() || object->size() != 6 || text.size() < kTailBytes) return none;
    for (const char* key : {"utc", "event", "before", "sha256"}) {
        if (!object->contains(key) || !(*object)[key].is_string()) return none;
    }
    if (!object->contains("n") || !(*object)["n"].is_number_unsigned() || !object->contains("details")) return none;
    AuditLine line{(*object)["n"], (*object)["utc"], (*object)["event"], (*object)["details"], (*object)["before"], (*object)["sha256"]};
    const std::string_view hashed = text.substr(0, text.size() - kTailBytes);
    if (text.substr(hashed.size(), kHashKey.size()) != kHashKey || hashOf(hashed) != line.sha256)
        return Error{"the line does not have its hash", where, "it was altered after it was written"};
    return line;
}

Result<Done> AuditLog::append(const std::string& event, const Json& details) const {
    std::error_code problem;
    if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), problem);
    const LockedFile locked(path_);
    if (locked.code() != 0) return cannotAppend(path_, std::strerror(locked.code()));
    const auto tail = tailOf(locked.file());
    if (!tail) return cannotAppend(path_, "its end cannot be read");
    AuditLine line{1, utcText(utcNow()), event, details, kNoLineBefore, {}};
    if (!tail->lastLine.empty()) {
        const auto last = auditLine(tail->lastLine, path_.string());
        if (!last) return last.error();
        line.n = last->n + 1;
        line.before = last->sha256;
    }
    std::string text;
    if (!tail->torn.empty()) { // the torn line stays in the file as evidence
        const AuditLine recovered{line.n, line.utc, kRecoveredEvent, {{"torn_bytes", tail->torn.size()}}, line.before, {}};
        const std::string whole = auditText(recovered);
        text = "\n" + whole + "\n";
        ++line.n;
        line.before = auditLine(whole, "")->sha256;
    }
    text += auditText(line) + "\n";
    if (const int code = appendWhole(locked.file(), text)) return cannotAppend(path_, std::strerror(code));
    if (::fdatasync(locked.file()) != 0) return cannotAppend(path_, std::strerror(errno));
    return Done{};
}

} // namespace edgescan
