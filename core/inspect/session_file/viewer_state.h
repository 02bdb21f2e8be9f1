// All that a person did at one scan, as one value: what a session keeps, and what undo takes back (docs/session.md).
#pragma once

#include "core/edges/settings/settings.h"
#include "core/edges/tuning/marked_edges.h"
#include "core/inspect/measure/cell_sets.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/selection/preset.h"
#include "core/scan/grid/reading_options.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::inspect {

/// The first lines of a sweep that is being recorded: they stay as they are while the file grows, or is cut off by a crash.
struct ScanHead {
    int lines = 0;
    std::string sha256; ///< of their ranges
    bool operator==(const ScanHead&) const = default;
};
/// Of the first `lines` lines, or of those that there are.
[[nodiscard]] ScanHead scanHead(const Scan& scan, int lines = 16);

/// A scan that a session is about: where it lay, how it was read, and by what it is known again.
struct SessionScan {
    enum class Kind : std::uint8_t { File, Demo, DemoAfterBlast, Recording };

    Kind kind = Kind::File;
    std::filesystem::path path; ///< absolute; empty for the demo
    NotebookScan identity;      ///< of a recording that is still being written without a hash, and with the lines that there were
    ScanHead head;              ///< of a recording alone
    ReadingOptions reading;     ///< paths of pose and calibration absolute; no progress
};

/// Of a file, or of a recording that was being written.
[[nodiscard]] constexpr bool hasPath(SessionScan::Kind kind) {
    return kind == SessionScan::Kind::File || kind == SessionScan::Kind::Recording;
}

/// A file that was read with these; all paths absolute.
[[nodiscard]] SessionScan fileScan(const std::filesystem::path& path, ReadingOptions reading, const NotebookScan& identity = {});

/// A of A/B.
struct EarlierScan {
    SessionScan scan;
    edges::Settings settings;
};

/// Local metres of the cloud, as ui/views/cloud has it.
struct SessionCamera {
    Eigen::Vector3d position{0, 0, 0}, focus{0, 0, 1}, up{0, 1, 0};
    double viewAngleDeg = 45.0; ///< vertical
    bool parallel = false;
    bool operator==(const SessionCamera&) const = default;
};

/// What part of the images is seen: x = beam, y = line.
struct SessionImages {
    double beam = 0, line = 0; ///< in the middle
    double zoom = 1;           ///< pixels per line
    bool operator==(const SessionImages&) const = default;
};

struct TuningPart {
    edges::Settings settings;
    std::string preset; ///< name or path; empty: none
};

struct TargetsPart {
    Notebook notebook;
    std::optional<std::uint32_t> active; ///< the cell whose card is shown
};

/// In order, none empty.
struct SelectionPart {
    std::vector<CellRun> selected, hidden;
};

struct ViewPart {
    std::optional<SessionCamera> camera;
    std::optional<SessionImages> images; ///< empty: the whole image
};

/// What one sees and has done at a scan, as one value. Each controller has one part of it.
struct ViewerState {
    SessionScan scan;
    TuningPart tuning;
    TargetsPart targets;
    SelectionPart selection;
    std::optional<rocks::Preset> rocks; ///< empty: rocks were not shown
    edges::EdgeMarks marks;
    std::optional<EarlierScan> earlier; ///< A
    ViewPart view;
    std::map<std::string, bool> switches;      ///< of menus, by key
    std::map<std::string, std::string> looks;  ///< of the views, what is no switch: colours of the cloud, range window, size of points ...
    std::map<std::string, std::string> layout; ///< of docks and splitters: base64, by name
    std::filesystem::path keptIn;              ///< of what is saved by itself: the file that the person saved it as; may be empty
};

/// What of it names cells below `cells` alone: a recording may have lost its last lines in a crash.
[[nodiscard]] ViewerState cutTo(ViewerState state, std::size_t cells);

} // namespace edgescan::inspect
