// What a recording says of its robot: its place, how it is built, who measured (docs/reference/recordings.md, "Metadata").
#pragma once

#include "core/files/recording/recording.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/reading_options.h"

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

} // namespace edgescan::files
