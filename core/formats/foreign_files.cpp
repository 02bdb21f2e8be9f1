// Files that are no scans, known by their first bytes.
#include "core/formats/format.h"

#include <array>

namespace edgescan {
namespace {

/// First bytes of files that people pick by mistake, so that the sentence can name them.
const char* kindOf(const Source& source) {
    struct Magic {
        std::string_view bytes;
        const char* what;
    };
    using namespace std::string_view_literals;
    static constexpr std::array<Magic, 6> kMagics{{
        {"\xff\xd8\xff"sv, "a JPEG picture"},
        {"\x7f\x45LF"sv, "a program"},
        {"%PDF"sv, "a PDF document"},
        {"PK\x03\x04"sv, "a ZIP archive"},
        {"\x1f\x8b"sv, "a gzip archive"},
        {"ASTM-E57"sv, "an E57 file, which this version cannot read"},
    }};
    for (const Magic& magic : kMagics) {
        if (source.text().starts_with(magic.bytes)) return magic.what;
    }
    return nullptr;
}

bool isForeign(const Source& source) { return kindOf(source) != nullptr; }

Result<Scan> refuse(const Source& source) {
    return source.refused(std::string("this is ") + kindOf(source) + ", not a scan", "choose a scan file");
}

} // namespace

Format fileThatIsNoScan() { return {.title = "", .recognises = isForeign, .read = refuse}; }

} // namespace edgescan
