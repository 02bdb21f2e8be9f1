// Messages of a recording that are not telegrams of a SICK scanner, and how they become scan lines. An add-on makes these objects.
#pragma once

#include "core/base/bytes.h"
#include "core/files/recording/layout.h"
#include "core/scan/grid/reading_options.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <memory>
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

/// Makes scan lines of messages of RecordingTopic::Bridge.
class LinePlayer {
public:
    virtual ~LinePlayer() = default;
    [[nodiscard]] virtual bool isLine(const RecordedMessage& message) const = 0;
    virtual void play(const RecordedMessage& message, scanner::SweepAssembler& to) = 0;
    /// From the first message again.
    virtual void restart() = 0;
};

class RecordedSource {
public:
    virtual ~RecordedSource() = default;
    /// The format of its scans.
    [[nodiscard]] virtual const std::string& kind() const = 0;
    /// In the order of their times.
    [[nodiscard]] virtual std::vector<RecordedMessage> messages() const = 0;
    /// What openScan() takes. Null: no topic gives lines.
    [[nodiscard]] virtual std::unique_ptr<LinePlayer> player(const scanner::SweepSettings& settings,
                                                             const ReadingOptions& options) const = 0;
};

} // namespace edgescan::files
