// From streams of bytes to a recording in memory, and from there like any recording.
#include "core/files/packet_capture/read_capture.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/base/memory.h"
#include "core/files/addons/addon.h"
#include "core/files/packet_capture/tcp_streams.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/writer.h"
#include "core/scan/grid/acquisition.h"
#include "core/scanner/cola/frames.h"
#include "core/scanner/sick_lms/scan_telegram.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <algorithm>
#include <map>
#include <optional>

namespace edgescan::files {
namespace {

/// Telegrams out of one or more streams of one scanner.
struct Heard {
    std::vector<RecordingMessagePtr> messages;
    std::size_t scans = 0;
    std::uint64_t skipped = 0; ///< bytes that belong to no telegram
    scanner::Dialect dialect = scanner::Dialect::B;

    void addFrame(scanner::ColaFrame&& frame, std::int64_t hostNs) {
        const bool scan = scanner::isScanTelegram(frame.payload());
        if (scan && scans++ == 0) dialect = frame.dialect;
        messages.push_back(
            std::make_shared<const RecordingMessage>(RecordingMessage{RecordingTopic::ColaRx, hostNs, std::move(frame.bytes)}));
    }
};

Heard heardIn(const TcpStream& stream) {
    Heard heard;
    scanner::ColaStream frames;
    std::int64_t latestNs = 0; // packets that came out of order must not turn time back
    for (const StreamPiece& piece : stream.pieces) {
        latestNs = std::max(latestNs, piece.timeNs);
        for (scanner::ColaFrame& frame : frames.push(piece.bytes, {latestNs, latestNs})) {
            const std::int64_t receivedNs = frame.received.utcNs;
            heard.addFrame(std::move(frame), receivedNs);
        }
    }
    heard.skipped = frames.counts().skipped + frames.waiting();
    return heard;
}

Result<Scan> scanOfHeard(Heard heard, const char* format, const Source& source) {
    const std::string where = source.path.string();
    std::uint64_t bytes = 0;
    for (const auto& message : heard.messages) bytes += message->payload.size();
    if (auto enough = checkMemory(3 * bytes, where); !enough) return enough.error();
    const scanner::SweepMetadata said{{"lidar.dialect", heard.dialect == scanner::Dialect::A ? "cola-a" : "cola-b"}};
    const auto recording = Recording::fromBytes(recordingBytes(said, heard.messages), where);
    if (!recording) return recording.error();
    heard.messages.clear();
    auto scan = scanOf(*recording, where, *source.options, source.played);
    if (!scan) return scan;
    scan->format = format;
    return scan;
}

/// The scanner's own clock as time, for a stream without times: it wraps every 71.6 minutes and restarts with the scanner.
class DeviceTime {
public:
    std::int64_t of(const scanner::ColaFrame& frame) {
        constexpr std::int64_t kStartNs = kNsPerSecondWhole; // no date is known
        if (scanner::isScanTelegram(frame.payload())) {
            const auto telegram = scanner::decodeScanTelegram(frame);
            if (telegram) advanceTo(telegram->transmittedUs);
        }
        return kStartNs + us_ * 1000;
    }

private:
    static constexpr std::int64_t kNsPerSecondWhole = 1'000'000'000;

    void advanceTo(std::uint32_t now) {
        const std::int64_t ahead = last_ ? static_cast<std::int32_t>(now - *last_) : 0;
        us_ += std::max<std::int64_t>(0, ahead); // a clock that was set back stops once
        last_ = now;
    }

    std::optional<std::uint32_t> last_;
    std::int64_t us_ = 0;
};

/// The streams of one scanner, one after the other: a program may have connected to it again.
struct Speaker {
    Endpoint from;
    std::vector<const TcpStream*> streams;
    Heard heard;
};

using Candidate = std::pair<const TcpStream*, Heard>;

/// The streams of a sender that do not overlap in time, in the order of time; of two that do (two programs listened at once) the fuller.
std::vector<Candidate> oneAfterTheOther(std::vector<Candidate> streams) {
    std::ranges::stable_sort(streams, std::greater{}, [](const Candidate& c) { return c.second.scans; });
    std::map<std::int64_t, std::int64_t> busy; // from when to when, of those that are taken
    std::vector<Candidate> taken;
    for (Candidate& candidate : streams) {
        if (!taken.empty() && candidate.second.scans == 0) break;
        const auto [begin, end] = std::minmax(candidate.first->pieces.front().timeNs, candidate.first->pieces.back().timeNs);
        const auto next = busy.lower_bound(begin);
        const bool overlaps = (next != busy.end() && next->first <= end) || (next != busy.begin() && std::prev(next)->second >= begin);
        if (overlaps) continue;
        busy[begin] = end;
        taken.push_back(std::move(candidate));
    }
    std::ranges::stable_sort(taken, {}, [](const Candidate& c) { return c.first->pieces.front().timeNs; });
    return taken;
}

/// Joins the streams of each sender.
std::vector<Speaker> speakersOf(const TcpStreams& tcp) {
    std::map<Endpoint, std::vector<Candidate>> bySender;
    for (const TcpStream& stream : tcp.streams) bySender[stream.from].emplace_back(&stream, heardIn(stream));
    std::vector<Speaker> speakers;
    for (auto& [from, streams] : bySender) {
        Speaker speaker{from, {}, {}};
        for (auto& [stream, heard] : oneAfterTheOther(std::move(streams))) {
            speaker.streams.push_back(stream);
            if (speaker.heard.scans == 0) speaker.heard.dialect = heard.dialect;
            speaker.heard.scans += heard.scans;
            speaker.heard.skipped += heard.skipped;
            std::ranges::move(heard.messages, std::back_inserter(speaker.heard.messages));
        }
        speakers.push_back(std::move(speaker));
    }
    return speakers;
}

void tellLosses(std::vector<std::string>& warnings, const PacketFile& file, const TcpStreams& tcp, const Speaker& speaker) {
    std::uint64_t missing = 0;
    std::size_t gaps = 0, repeated = 0, late = 0;
    for (const TcpStream* stream : speaker.streams) {
        missing += stream->missing;
        gaps += stream->gaps;
        repeated += stream->repeated;
        late += stream->late;
    }
    if (file.cutOff) warnings.emplace_back("The capture was cut off: everything up to the cut is here.");
    if (file.outOfTime > 0)
        warnings.push_back(counted(file.outOfTime, "packet has a time before 1970 or after 2262 and count as of 1970.",
                                   "packets have a time before 1970 or after 2262 and count as of 1970."));
    if (missing > 0) {
        warnings.push_back(
            withValues(counted(missing, "byte that the scanner sent is missing in the capture, in %1: the telegrams there are lost.",
                               "bytes that the scanner sent are missing in the capture, in %1: the telegrams there are lost."),
                       {counted(gaps, "place", "places")}));
    }
    if (missing == 0 && speaker.heard.skipped > 0)
        warnings.push_back(counted(speaker.heard.skipped, "byte that the scanner sent belongs to no whole telegram.",
                                   "bytes that the scanner sent belong to no whole telegram."));
    if (repeated > 0 || late > 0) {
        warnings.push_back(withValues(counted(late, "packet came out of order and %1 brought bytes again; they were put in order.",
                                              "packets came out of order and %1 brought bytes again; they were put in order."),
                                      {repeated}));
    }
    if (tcp.fragments > 0)
        warnings.push_back(
            counted(tcp.fragments, "fragment of IP packets were not put together.", "fragments of IP packets were not put together."));
}

} // namespace

bool looksLikePackets(const Source& source) { return isPacketFile(source.octets()); }

bool looksLikeColaStream(const Source& source) {
    constexpr std::size_t kFirstPart = 4 * scanner::kLongestFrame;
    const ByteView bytes = source.octets();
    if (bytes.empty() || source.text().substr(0, kFirstPart).find('\x02') == std::string_view::npos) return false;
    scanner::ColaStream stream;
    return !stream.push(bytes.first(std::min(bytes.size(), kFirstPart))).empty();
}

Result<Scan> readPacketCapture(const Source& source) {
    const std::string where = source.path.string();
    constexpr std::uint64_t kMemoryPerByte = 4; // the shortest packets that carry anything take 70 bytes, and we a little more of each
    if (auto enough = checkMemory(source.bytes.size() * kMemoryPerByte, where); !enough) return enough.error();
    const auto file = readPackets(source.octets(), where);
    if (!file) return file.error();
    if (!source.goOn("putting packets together", 0.1)) return source.cancelled();
    const TcpStreams tcp = tcpStreams(file->packets);
    std::vector<Speaker> speakers = speakersOf(tcp);
    const auto best = std::ranges::max_element(speakers, {}, [](const Speaker& s) { return s.heard.scans; });
    if (best == speakers.end() || best->heard.scans == 0) {
        const auto readOther = addon().readPackets;
        if (readOther == nullptr)
            return source.refused(withValues("this capture holds no scan telegram of a SICK scanner, and %1", {kNoRobots}),
                                  kBuildWithRobots);
        if (auto other = readOther(*file, source)) return std::move(*other);
        return source.refused(
            withValues(
                "this capture holds %1, %2 of them TCP, and no scan telegram of a SICK scanner and no packet of a VLP-16 or an Ouster",
                {counted(file->packets.size(), "packet", "packets"), tcp.packets}),
            "capture the connection to the scanner's port (2111 or 2112) while it scans");
    }
    std::vector<std::string> warnings;
    const auto others = std::ranges::count_if(speakers, [](const Speaker& s) { return s.heard.scans > 0; }) - 1;
    if (tcp.streams.size() > 1) {
        const std::string more = counted(static_cast<std::size_t>(others), "other sender has some too", "other senders have some too");
        warnings.push_back(
            withValues(others > 0 ? "The capture holds %1 streams; that of %2 with %3 was opened, and %4."
                                  : "The capture holds %1 streams; that of %2 with %3 was opened.",
                       {tcp.streams.size(), best->from.text(), counted(best->heard.scans, "scan telegram", "scan telegrams"), more}));
    }
    tellLosses(warnings, *file, tcp, *best);
    auto scan = scanOfHeard(std::move(best->heard), "capture", source);
    if (scan) scan->warnings.insert(scan->warnings.begin(), warnings.begin(), warnings.end());
    return scan;
}

Result<Scan> readColaCapture(const Source& source) {
    constexpr std::size_t kAtOnce = 1U << 20U;
    const ByteView bytes = source.octets();
    Heard heard;
    scanner::ColaStream stream;
    DeviceTime time;
    for (std::size_t at = 0; at < bytes.size(); at += kAtOnce) {
        for (scanner::ColaFrame& frame : stream.push(bytes.subspan(at, std::min(kAtOnce, bytes.size() - at)))) {
            const std::int64_t hostNs = time.of(frame);
            heard.addFrame(std::move(frame), hostNs);
        }
        if (!source.goOn("finding telegrams", 0.1)) return source.cancelled();
    }
    if (heard.scans == 0) {
        return source.refused(
            withValues("these are %1 of a SICK device and none is a scan", {counted(heard.messages.size(), "telegram", "telegrams")}),
            "capture while the scanner sends scans (sEN LMDscandata 1)");
    }
    const std::uint64_t skipped = stream.counts().skipped + stream.waiting();
    auto scan = scanOfHeard(std::move(heard), "CoLa stream", source);
    if (!scan) return scan;
    if (skipped > 0)
        scan->warnings.insert(scan->warnings.begin(), counted(skipped, "byte of the stream belongs to no whole telegram.",
                                                              "bytes of the stream belong to no whole telegram."));
    if (scan->acquisition) { // the scanner's clock measures durations and not the time of day
        auto named = std::make_shared<Acquisition>(*scan->acquisition);
        named->startUtc.clear();
        named->endUtc.clear();
        named->clockSource.clear();
        named->lineTimesS.clear();
        scan->acquisition = std::move(named);
    }
    return scan;
}

} // namespace edgescan::files
