// CoLa A and B framing over a byte stream. Bytes that cannot be a frame are dropped one at a time, so that a good frame behind a bad one is
// never lost.
#include "core/scanner/cola/frames.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>

namespace edgescan::scanner {

namespace {

constexpr std::uint8_t kStx = 0x02;
constexpr std::uint8_t kEtx = 0x03;
constexpr std::size_t kMark = 4; ///< number of STX bytes that start a CoLa B frame
constexpr std::size_t kHead = 8; ///< including the length

std::uint8_t checksum(ByteView payload) { return std::reduce(payload.begin(), payload.end(), std::uint8_t{0}, std::bit_xor<>{}); }

std::size_t lengthWord(ByteView head) {
    return std::size_t{head[4]} << 24U | std::size_t{head[5]} << 16U | std::size_t{head[6]} << 8U | std::size_t{head[7]};
}

} // namespace

const char* dialectName(Dialect dialect) { return dialect == Dialect::A ? "CoLa A" : "CoLa B"; }

ByteView ColaFrame::payload() const {
    const std::size_t head = dialect == Dialect::A ? 1 : kHead;
    return bytes.size() > head ? ByteView(bytes).subspan(head, bytes.size() - head - 1) : ByteView();
}

std::vector<ColaFrame> ColaStream::push(ByteView bytes, HostTime received) {
    std::vector<ColaFrame> frames;
    if (bytes.empty()) return frames;
    arrivals_.push_back({counts_.bytes, received});
    counts_.bytes += bytes.size();
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    std::uint8_t sum = sums_.empty() ? std::uint8_t{0} : sums_.back();
    for (const std::uint8_t byte : bytes) sums_.push_back(sum ^= byte);
    ColaFrame frame;
    for (Step step = tryStep(frame); step != Step::Wait; step = tryStep(frame)) {
        if (step == Step::Frame) frames.push_back(std::move(frame));
    }
    compact();
    return frames;
}

ColaStream::Step ColaStream::tryStep(ColaFrame& frame) {
    const ByteView bytes = rest();
    if (bytes.empty()) return Step::Wait;
    if (bytes[0] != kStx) {
        const void* next = std::memchr(bytes.data(), kStx, bytes.size());
        return drop(next == nullptr ? bytes.size() : static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - bytes.data()));
    }
    if (only_) return *only_ == Dialect::A ? tryText(frame) : tryBinary(frame);
    if (bytes.size() < 2) return Step::Wait;
    return bytes[1] == kStx ? tryBinary(frame) : tryText(frame);
}

ColaStream::Step ColaStream::tryText(ColaFrame& frame) {
    const ByteView bytes = rest();
    if (bytes.size() < 2) return Step::Wait;
    if (bytes[1] != 's') {
        ++counts_.notCola;
        return drop(1);
    }
    const std::size_t limit = std::min(bytes.size(), kLongestPayload + 2);
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(searched_, 2));
    const auto to = bytes.begin() + static_cast<std::ptrdiff_t>(limit);
    const auto mark = std::find_if(from, to, [](std::uint8_t byte) { return byte == kStx || byte == kEtx; });
    if (mark == to) {
        searched_ = limit;
        if (limit < kLongestPayload + 2) return Step::Wait;
        ++counts_.tooLong;
        return drop(1);
    }
    if (*mark == kStx) {
        ++counts_.torn;
        return drop(1);
    }
    return popFrame(frame, Dialect::A, static_cast<std::size_t>(mark - bytes.begin()) + 1);
}

ColaStream::Step ColaStream::tryBinary(ColaFrame& frame) {
    const ByteView bytes = rest();
    const auto marks = bytes.first(std::min(kMark, bytes.size()));
    if (std::any_of(marks.begin(), marks.end(), [](std::uint8_t byte) { return byte != kStx; })) return drop(1);
    if (bytes.size() < kHead) return Step::Wait;
    const std::size_t length = lengthWord(bytes);
    if (length > kLongestPayload) {
        ++counts_.tooLong;
        return drop(1);
    }
    if (bytes.size() == kHead) return Step::Wait;
    // Two ranges of 514 mm look like the start mark, and the next two like a length. Only the 's' shows that it is a frame.
    if (bytes[kHead] != 's') {
        ++counts_.notCola;
        return drop(1);
    }
    if (bytes.size() < kHead + length + 1) return Step::Wait;
    const std::size_t before = start_ + kHead - 1;
    if ((sums_[before] ^ sums_[before + length]) != bytes[kHead + length]) {
        ++counts_.badChecksum;
        return drop(1);
    }
    return popFrame(frame, Dialect::B, kHead + length + 1);
}

ColaStream::Step ColaStream::popFrame(ColaFrame& frame, Dialect dialect, std::size_t length) {
    const ByteView bytes = rest().first(length);
    while (arrivals_.size() > 1 && arrivals_[1].offset <= offset_) arrivals_.pop_front();
    frame = {dialect, Bytes(bytes.begin(), bytes.end()), arrivals_.front().time, offset_, skippedSince_};
    ++counts_.frames;
    skippedSince_ = 0;
    searched_ = 0;
    start_ += length;
    offset_ += length;
    return Step::Frame;
}

ColaStream::Step ColaStream::drop(std::size_t count) {
    counts_.skipped += count;
    skippedSince_ += count;
    searched_ = 0;
    start_ += count;
    offset_ += count;
    return Step::Drop;
}

void ColaStream::compact() {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(start_));
    sums_.erase(sums_.begin(), sums_.begin() + static_cast<std::ptrdiff_t>(start_));
    start_ = 0;
    if (buffer_.empty()) arrivals_.clear();
    while (arrivals_.size() > 1 && arrivals_[1].offset <= offset_) arrivals_.pop_front();
}

Bytes framed(ByteView payload, Dialect dialect) {
    Bytes bytes;
    bytes.reserve(payload.size() + kHead + 1);
    if (dialect == Dialect::A) {
        bytes.push_back(kStx);
    } else {
        bytes.assign(kMark, kStx);
        for (unsigned shift = 32; shift > 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(payload.size() >> (shift - 8)));
    }
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    bytes.push_back(dialect == Dialect::A ? kEtx : checksum(payload));
    return bytes;
}

} // namespace edgescan::scanner
