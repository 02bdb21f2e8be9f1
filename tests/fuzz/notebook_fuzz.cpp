// Any bytes as a file of targets and measured lengths: what can be written and read back unchanged, or an error sentence.
#include "core/inspect/measure/notebook.h"
#include "tests/fuzz/text_file.h"

using namespace edgescan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const inspect::NotebookScan scan{std::string(64, 'a'), "bell", 6, 11};
    const auto notebook = inspect::notebookFromText(fuzz::textOf(bytes, size), scan, "fuzz");
    if (!notebook) {
        if (!notebook.error().sentence().ends_with(".")) std::abort();
        return 0;
    }
    const std::string once = inspect::notebookText(*notebook, scan);
    const auto again = inspect::notebookFromText(once, scan, "fuzz");
    if (!again || inspect::notebookText(*again, scan) != once) std::abort();
    return 0;
}
