// A live scanner of another kind than SICK's: its connection, and what its messages are. An add-on makes it.
#pragma once

#include "core/files/recording/layout.h"
#include "core/scanner/sick_lms/scanner_connection.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::files {

struct LiveStatus;
struct OfferedTopic;

/// Everything but connect(), heard() of a message and finish() is called with the feed's lock.
class LiveSource {
public:
    struct Events {
        std::function<void(const scanner::ConnectionState&)> stateChanged;
        /// Every message before it is parsed, without its time of receipt. `isLine`: of the topic that is shown.
        std::function<void(RecordingMessage message, const scanner::HostTime& time, bool isLine)> received;
    };
    virtual ~LiveSource() = default;

    virtual std::unique_ptr<scanner::LiveConnection> connect(scanner::ConnectionSettings settings, Events events) = 0;
    /// Counts a message that came at this monotonic time.
    virtual void heard(const RecordingMessagePtr& message, std::int64_t monotonicNs) = 0;
    /// Gives the number of lines or whole scans that the message makes known.
    virtual int play(const RecordingMessagePtr& message, scanner::SweepAssembler& to) = 0;
    virtual void useSweep(const scanner::SweepSettings& settings) = 0;

    /// The newest scan, where each message is a whole one; empty: messages are lines.
    [[nodiscard]] virtual std::optional<scanner::SweepState> newest() const = 0;
    /// What the source knows in addition to what is in the status.
    virtual void complete(LiveStatus& status) const = 0;
    [[nodiscard]] virtual std::vector<OfferedTopic> offered() const = 0;
    /// Messages that come only once.
    [[nodiscard]] virtual const std::vector<RecordingMessagePtr>& standing() const = 0;
    /// After the last message.
    virtual void finish() = 0;
};

} // namespace edgescan::files
