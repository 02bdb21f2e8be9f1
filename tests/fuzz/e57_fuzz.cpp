// Fuzzes the reader of E57. The checksums of the pages are corrected first; otherwise hardly any input would pass them.
#include "core/containers/e57/paged_bytes.h"
#include "tests/fuzz/open_bytes.h"

#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    std::vector<std::uint8_t> file(bytes, bytes + size);
    for (std::size_t page = 0; page + 1024 <= file.size(); page += 1024) {
        const std::uint32_t crc = edgescan::containers::crc32c(std::as_bytes(std::span(file).subspan(page, 1020)));
        for (std::size_t i = 0; i < 4; ++i) file[page + 1020 + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
    }
    return edgescan::fuzz::openBytes(file.data(), file.size(), ".e57");
}
