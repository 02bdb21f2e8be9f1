// Any bytes as a file of rock settings and edits, and as a region of interest: what can be written and read back unchanged, or an error
// sentence.
#include "core/rocks/selection/preset.h"
#include "tests/fuzz/text_file.h"

using namespace edgescan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    constexpr int kLines = 6, kBeams = 11;
    const std::string_view text = fuzz::textOf(bytes, size);
    if (const auto region = rocks::parseRegion(text); !region && !region.error().sentence().ends_with(".")) std::abort();
    const auto preset = rocks::rockPresetFromText(text, kLines, kBeams, "", "fuzz");
    if (!preset) {
        if (!preset.error().sentence().ends_with(".")) std::abort();
        return 0;
    }
    for (const rocks::Edit& edit : preset->edits) {
        for (const std::uint32_t cell : edit.cells) {
            if (cell >= kLines * kBeams) std::abort();
        }
    }
    const std::string once = rocks::rockPresetText(*preset, kLines, kBeams);
    const auto again = rocks::rockPresetFromText(once, kLines, kBeams, "", "fuzz");
    if (!again || rocks::rockPresetText(*again, kLines, kBeams) != once) std::abort();
    return 0;
}
