// A recording played through the same path as live: frames or messages of another source, telegrams, sweep assembly; at any speed, line by
// line.
#pragma once

#include "core/files/point_tables/source.h"
#include "core/files/recording/recording.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/reading_options.h"
#include "core/scanner/sick_lms/sweep_feed.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

struct RecordedRobot {
    std::optional<Calibration> calibration; ///< metadata R_IA, head_in_robot_m, talin_in_robot_m and their like
    std::optional<PoseTrack> poses;         ///< messages /inclinometer and /talin that belong to the sweep
    std::vector<std::string> warnings;      ///< what is there and cannot be used
};

/// The readings from the last one before `startS` to the first one after `endS` (UTC seconds); all of them when these are NaN.
[[nodiscard]] RecordedRobot recordedRobot(const Recording& recording, double startS, double endS);

/// Gives a sweep of this recording its place: by --pose and --calibration where given, each instead of the recording's own. Without
/// them a scan that cannot be placed stays in the scanner's frame, with a warning when readings are there. Error: as openPlacement,
/// or one of the two files is missing and the recording does not make up for it.
Result<Done> placeRecordedSweep(Scan& scan, const Recording& recording, const ReadingOptions& options, const std::string& where);

/// Model, serial number and firmware from metadata and from the scanner's recorded answers.
void nameScanner(Scan& scan, const Recording& recording);

/// Feeds a message of a recording: a telegram or a reading of the stepper. True if it contained a line.
bool feedMessage(scanner::SweepFeed& feed, const RecordedMessage& message);

/// A value: a place in a recording and the sweep as it was then. Lines are counted over the whole recording, from 0.
class Replay {
public:
    /// `options` say what of the mounting the recording only assumes, and which topic is played.
    explicit Replay(std::shared_ptr<const Recording> recording, const ReadingOptions& options = {});

    [[nodiscard]] const Recording& recording() const { return *recording_; }
    /// Lines, that is scan telegrams or messages of the laser, in the recording.
    [[nodiscard]] int lines() const { return static_cast<int>(lineAt_.size()); }
    /// Lines played so far.
    [[nodiscard]] int position() const { return position_; }
    [[nodiscard]] bool atEnd() const { return next_ == recording_->messages().size(); }
    /// When line `line` was received; recordings hold it even where nothing else gives the time.
    [[nodiscard]] std::int64_t timeNs(int line) const;

    /// The next line with all that belongs to it. False at the end.
    bool step();
    /// To just behind `line` lines, forward or backward; the end is lines().
    void seek(int line);

    [[nodiscard]] std::shared_ptr<const Scan> snapshot() { return feed_.assembler().snapshot(); }
    [[nodiscard]] scanner::SweepProgress progress() const { return feed_.assembler().progress(); }
    [[nodiscard]] scanner::SweepFeed& feed() { return feed_; }
    /// What the recording and its settings gave reason to say.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    void playOne();
    [[nodiscard]] bool isLine(const RecordedMessage& message) const;

    std::shared_ptr<const Recording> recording_;
    scanner::SweepSettings settings_;
    std::vector<std::string> warnings_;
    std::vector<std::size_t> lineAt_; // message of each line
    scanner::SweepFeed feed_;
    std::optional<LinePlayer> player_, atBegin_; // of a source that is not a SICK scanner
    std::size_t next_ = 0;                       // message
    int position_ = 0;
};

/// A sweep of this recording, whole or growing, as it is shown and measured: with the grid, the scanner and the place that the recording
/// names in addition to its telegrams. `where` goes into errors.
Result<Scan> describedSweep(Scan sweep, const Recording& recording, const std::string& where, const ReadingOptions& options);

/// Plays all of a recording and gives the sweep of which most lines were received. Warnings say what is missing: INCOMPLETE n/N, lost
/// lines, a cut. Error: no line in it.
Result<Scan> scanOf(const std::shared_ptr<const Recording>& recording, const std::string& where, const ReadingOptions& options = {},
                    const LinePlayed& played = {});
/// The same for openScan().
Result<Scan> readRecording(const Source& source);

} // namespace edgescan::files
