// Messages to and from the program that links PCL: numbers in the computer's own byte order, because both programs are from one build.
#pragma once

#include "app/lab/peers/peers.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace edgescan::lab {

struct PclRequest {
    PclMethod peer = PclMethod::BoundaryNeighbours;
    PclLimits limits;
    PclScan scan;
};

class MessageWriter {
public:
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void value(const T& v) { bytes_.append(reinterpret_cast<const char*>(&v), sizeof v); }
    void text(const std::string& t) {
        value(static_cast<std::uint64_t>(t.size()));
        bytes_ += t;
    }
    template <class T>
    void grid(const Grid<T>& g) {
        value(g.lines);
        value(g.beams);
        bytes_.append(reinterpret_cast<const char*>(g.cells.data()), g.cells.size() * sizeof(T));
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Reads what a MessageWriter wrote. isWhole() is false after any value was missing; later values are then empty.
class MessageReader {
public:
    explicit MessageReader(std::string_view bytes) : left_(bytes) {}

    template <class T>
    requires std::is_trivially_copyable_v<T> T value() {
        T v{};
        if (has(sizeof v)) std::memcpy(&v, popBytes(sizeof v).data(), sizeof v);
        return v;
    }
    std::string text() {
        const auto size = value<std::uint64_t>();
        return has(size) ? std::string(popBytes(static_cast<std::size_t>(size))) : std::string();
    }
    template <class T>
    Grid<T> grid() {
        const auto lines = value<int>();
        const auto beams = value<int>();
        if (lines < 0 || beams < 0 || !has(static_cast<std::uint64_t>(lines) * static_cast<std::uint64_t>(beams) * sizeof(T))) {
            whole_ = false;
            return {};
        }
        Grid<T> g(lines, beams);
        std::memcpy(static_cast<void*>(g.cells.data()), popBytes(g.size() * sizeof(T)).data(), g.size() * sizeof(T));
        return g;
    }
    [[nodiscard]] bool isWhole() const { return whole_; }

private:
    bool has(std::uint64_t count) { return whole_ = whole_ && count <= left_.size(); }
    std::string_view popBytes(std::size_t count) {
        const std::string_view taken = left_.substr(0, count);
        left_.remove_prefix(count);
        return taken;
    }

    std::string_view left_;
    bool whole_ = true;
};

/// All bytes of a file in memory, from its beginning; fewer if reading fails.
inline std::string readAll(int fd) {
    std::string bytes(static_cast<std::size_t>(std::max<off_t>(0, lseek(fd, 0, SEEK_END))), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = pread(fd, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
}

inline bool writeAll(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

inline std::string requestBytes(PclMethod peer, const PclScan& scan, const PclLimits& limits) {
    MessageWriter out;
    out.value(peer);
    out.value(limits);
    for (const auto* grid : {&scan.pointsM, &scan.directions, &scan.unrolledM}) out.grid(*grid);
    return out.bytes();
}

inline std::optional<PclRequest> readRequest(std::string_view bytes) {
    MessageReader in(bytes);
    PclRequest request{in.value<PclMethod>(), in.value<PclLimits>(), {}};
    for (auto* grid : {&request.scan.pointsM, &request.scan.directions, &request.scan.unrolledM}) *grid = in.grid<Eigen::Vector3f>();
    if (!in.isWhole()) return std::nullopt;
    return request;
}

inline std::string answerBytes(const Result<PclEdges>& answer) {
    MessageWriter out;
    out.value(static_cast<bool>(answer));
    if (!answer) {
        for (const std::string& text : {answer.error().what, answer.error().where, answer.error().hint}) out.text(text);
        return out.bytes();
    }
    out.grid(answer->mask);
    out.value(static_cast<std::uint64_t>(answer->classes.size()));
    for (const PclClass& one : answer->classes) {
        out.text(one.name);
        out.grid(one.mask);
        out.value(one.counts);
    }
    out.value(static_cast<std::uint64_t>(answer->steps.size()));
    for (const edges::StageTime& step : answer->steps) {
        out.text(step.stage);
        out.value(step.milliseconds);
    }
    out.value(answer->share);
    out.grid(answer->segments);
    return out.bytes();
}

/// Null if the answer is incomplete.
inline std::optional<Result<PclEdges>> readAnswer(std::string_view bytes) {
    MessageReader in(bytes);
    if (!in.value<bool>()) {
        Error error{in.text(), in.text(), in.text()};
        if (!in.isWhole()) return std::nullopt;
        return error;
    }
    PclEdges edges;
    edges.mask = in.grid<std::uint8_t>();
    for (auto n = in.value<std::uint64_t>(); n > 0 && in.isWhole(); --n) {
        PclClass one{in.text(), in.grid<std::uint8_t>(), true};
        one.counts = in.value<bool>();
        edges.classes.push_back(std::move(one));
    }
    for (auto n = in.value<std::uint64_t>(); n > 0 && in.isWhole(); --n) {
        std::string stage = in.text();
        edges.steps.push_back({std::move(stage), in.value<double>()});
    }
    edges.share = in.value<double>();
    edges.segments = in.grid<std::uint32_t>();
    if (!in.isWhole()) return std::nullopt;
    return edges;
}

} // namespace edgescan::lab
