// libFuzzer: any bytes as a stream from the scanner. In whatever pieces they are pushed, the frames are the same and every byte is
// accounted for.
#include "core/scanner/cola/frames.h"

#include <algorithm>
#include <cstdlib>

using namespace edgescan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    if (size < 2) return 0;
    // The first byte chooses the dialect, the second one the length of the pieces.
    std::optional<scanner::Dialect> only;
    if (bytes[0] % 3 != 0) only = bytes[0] % 3 == 1 ? scanner::Dialect::A : scanner::Dialect::B;
    const std::size_t piece = std::size_t{bytes[1]} + 1;
    const ByteView input(bytes + 2, size - 2);
    scanner::ColaStream whole(only), pieces(only);
    const std::vector<scanner::ColaFrame> expected = whole.push(input);
    std::vector<scanner::ColaFrame> found;
    for (std::size_t at = 0; at < input.size(); at += piece) {
        for (scanner::ColaFrame& frame : pieces.push(input.subspan(at, std::min(piece, input.size() - at))))
            found.push_back(std::move(frame));
        if (pieces.waiting() > scanner::kLongestFrame) std::abort();
    }
    std::uint64_t inFrames = 0;
    for (const scanner::ColaFrame& frame : expected) {
        inFrames += frame.bytes.size();
        if (scanner::framed(frame.payload(), frame.dialect) != frame.bytes) std::abort();
        if (!std::equal(frame.bytes.begin(), frame.bytes.end(), input.begin() + static_cast<std::ptrdiff_t>(frame.offset))) std::abort();
    }
    if (found != expected || !(pieces.counts() == whole.counts())) std::abort();
    if (inFrames + whole.counts().skipped + whole.waiting() != input.size()) std::abort();
    return 0;
}
