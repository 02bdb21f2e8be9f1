// Formats whose readers and writers are not there yet.
#include "core/files/cloud_columns.h"
#include "core/files/pcd.h"
#include "core/files/ply.h"
#include "core/files/point_text.h"
#include "core/files/range_csv.h"

namespace edgescan {
namespace {
Error notYet(const std::filesystem::path& p) { return {"this format is not yet supported", p.string(), "use a raw grid"}; }
} // namespace
bool looksLikePcd(std::string_view) { return false; }
Result<Scan> readPcd(const Source& s) { return notYet(s.path); }
bool looksLikePly(std::string_view) { return false; }
Result<Scan> readPly(const Source& s) { return notYet(s.path); }
std::optional<std::size_t> firstByteThatIsNoText(std::string_view) { return {}; }
Result<TextLayout> textLayoutOf(const Source& s) { return notYet(s.path); }
bool looksLikeRangeCsv(const TextLayout&, const Source&) { return false; }
Result<Scan> readRangeCsv(const Source& s, const TextLayout&) { return notYet(s.path); }
Result<Scan> readPointText(const Source& s, const TextLayout&) { return notYet(s.path); }
CloudColumns everyCell(const Scan&) { return {}; }
CloudColumns validPoints(const Scan&, const Grid<std::uint8_t>*) { return {}; }
CloudColumns edgePoints(const Scan&, const Grid<std::uint8_t>&) { return {}; }
Result<Done> savePcd(const CloudColumns&, const std::filesystem::path& p, bool) { return notYet(p); }
Result<Done> savePly(const CloudColumns&, const std::filesystem::path& p, bool) { return notYet(p); }
Result<Done> savePointText(const CloudColumns&, const std::filesystem::path& p, char) { return notYet(p); }
} // namespace edgescan
