// Reads a log and compares each line with its neighbours.
#include "core/base/audit_log/audit_check.h"

#include "core/base/whole_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace edgescan {
namespace {

struct Placed {
    std::uint64_t place;
    std::size_t bytes;
    std::optional<AuditLine> line; // empty: the bytes of the line were altered
};

std::vector<Placed> placedLines(std::string_view text) {
    std::vector<Placed> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view one = text.substr(at, end - at);
        auto line = auditLine(one, "");
        const bool isWhole = line && end < text.size();
        lines.push_back({lines.size() + 1, one.size(), isWhole ? std::optional(std::move(*line)) : std::nullopt});
        at = end + 1;
    }
    return lines;
}

// Whether the next line reports that a crash tore this line.
bool isRecovered(const std::vector<Placed>& lines, std::size_t i) {
    if (lines[i].line || i + 1 >= lines.size() || !lines[i + 1].line) return false;
    const AuditLine& next = *lines[i + 1].line;
    return next.event == kRecoveredEvent && next.details.is_object() && next.details.contains("torn_bytes") &&
           next.details["torn_bytes"] == lines[i].bytes;
}

std::string numbered(std::uint64_t n) { return "line " + std::to_string(n); }

// Finds faults between the last good line and the current one. `altered`: altered lines between these two.
class Walk {
public:
    explicit Walk(const std::vector<Placed>& lines) {
        for (const Placed& placed : lines) {
            if (placed.line) ++there_[placed.line->n];
        }
    }

    void checkLine(const Placed& placed, AuditCheck& check) {
        if (!placed.line) {
            check.faults.push_back({AuditFaultKind::Altered, placed.place, expected_ + altered_,
                                    numbered(placed.place) + " of the file was altered after it was written"});
            ++altered_;
            return;
        }
        const AuditLine& line = *placed.line;
        ++check.lines;
        if (line.n < expected_ || !seen_.insert(line.n).second) {
            check.faults.push_back({AuditFaultKind::Moved, placed.place, line.n,
                                    numbered(placed.place) + " of the file was moved: it was written as " + numbered(line.n)});
            return;
        }
        const bool follows = line.n == expected_ + altered_;
        if (follows && altered_ == 0 && line.before != before_)
            check.faults.push_back({AuditFaultKind::Altered, placed.place - 1, line.n - 1,
                                    "what stood before " + numbered(placed.place) + " of the file was replaced by another line"});
        if (!follows) reportMissing(placed, line, check);
        expected_ = line.n + 1;
        altered_ = 0;
        before_ = line.sha256;
        check.last = line.sha256;
    }

private:
    // Lines are missing at this place: they were moved to another place of the file, or deleted.
    void reportMissing(const Placed& placed, const AuditLine& line, AuditCheck& check) {
        std::vector<std::uint64_t> gone;
        for (std::uint64_t n = expected_; n < line.n && gone.size() < 1000; ++n) {
            if (!there_.contains(n)) gone.push_back(n);
        }
        gone.erase(gone.begin(), gone.begin() + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(altered_, gone.size())));
        if (gone.empty()) return; // these are reported at their present place
        std::string which = numbered(gone.front());
        if (gone.size() > 1) which += " and " + std::to_string(gone.size() - 1) + " more";
        check.faults.push_back({AuditFaultKind::Dropped, placed.place, gone.front(),
                                which + " as written " + (gone.size() > 1 ? "are" : "is") + " gone: dropped before " +
                                    numbered(placed.place) + " of the file"});
    }

    std::map<std::uint64_t, int> there_;
    std::set<std::uint64_t> seen_;
    std::uint64_t expected_ = 1, altered_ = 0;
    std::string before_ = kNoLineBefore;
};

} // namespace

const char* auditFaultName(AuditFaultKind kind) {
    constexpr const char* kNames[]{"altered", "dropped", "moved"};
    return kNames[static_cast<std::size_t>(kind)];
}

Result<AuditCheck> checkAudit(const std::filesystem::path& path, const std::string& expectedLast) {
    const auto bytes = readWholeFile(path);
    if (!bytes) return bytes.error();
    const std::vector<Placed> lines = placedLines(textOf(*bytes));
    if (lines.empty()) return Error{"the log holds no line", path.string(), "give the audit.jsonl that was written, or a copy of it"};
    // Every line of a log has this key, and an altered log still has some of them.
    if (!lines.empty() && textOf(*bytes).find("\"before\":\"") == std::string_view::npos)
        return Error{"this is not an audit log", path.string(), "give audit.jsonl"};
    AuditCheck check;
    Walk walk(lines);
    bool hasExpected = expectedLast.empty();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (isRecovered(lines, i)) {
            ++check.recovered;
            continue;
        }
        hasExpected = hasExpected || (lines[i].line && lines[i].line->sha256 == expectedLast);
        walk.checkLine(lines[i], check);
    }
    if (!hasExpected)
        check.faults.push_back(
            {AuditFaultKind::Dropped, lines.size() + 1, 0,
             "the line with the hash that was noted elsewhere is gone: the end of the log was dropped, or it is another log"});
    return check;
}

} // namespace edgescan
