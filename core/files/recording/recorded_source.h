// Messages of a recording that are not telegrams of a SICK scanner, and how they become scan lines. An add-on makes these objects.
#pragma once

#include "core/base/bytes.h"
#include "core/files/recording/layout.h"
#include "core/scan/grid/reading_options.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

struct RecordedMessage {
    RecordingTopic topic = RecordingTopic::ColaRx;
    std::int64_t logNs = 0;     ///< when it was received, ns since 1970 UTC
    std::int64_t publishNs = 0; ///< a line's own time
    ByteView payload;
    std::uint32_t sourceTopic = 0; ///< of Bridge: its topic, as the RecordedSource counts them
};

/// Makes scan lines of messages of RecordingTopic::Bridge. A copy goes on from where it is.
struct LinePlayer {
    std::function<bool(const RecordedMessage& message)> isLine;
    std::function<void(const RecordedMessage& message, scanner::SweepAssembler& to)> play;
};

class RecordedSource {
public:
    virtual ~RecordedSource() = default;
    /// The format of its scans.
    [[nodiscard]] virtual const std::string& kind() const = 0;
    /// In the order of their times.
    [[nodiscard]] virtual std::vector<RecordedMessage> messages() const = 0;
    /// Of what openScan() takes, at its begin; the source must outlive it. Empty: no topic gives lines.
    [[nodiscard]] virtual std::optional<LinePlayer> player(const scanner::SweepSettings& settings, const ReadingOptions& options) const = 0;
};

} // namespace edgescan::files
