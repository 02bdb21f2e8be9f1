// Any bytes as a session file: the result is a session that can be written and read back unchanged, or an error sentence.
#include "core/inspect/session_file/session_file.h"

#include <cstdint>
#include <cstdlib>

using namespace edgescan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    const auto read = inspect::sessionFromText(text, "/sessions", "fuzz");
    if (!read) {
        if (!read.error().sentence().ends_with(".")) std::abort();
        return 0;
    }
    const std::string once = inspect::sessionText(read->state, "/sessions", read->savedUtc);
    const auto again = inspect::sessionFromText(once, "/sessions", "fuzz");
    if (!again || inspect::sessionText(again->state, "/sessions", again->savedUtc) != once) std::abort();
    return 0;
}
