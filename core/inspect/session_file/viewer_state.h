// All of the operator's work on one scan, as one value: sessions store it, and undo restores it (docs/guide/sessions.md).
#pragma once

#include "core/edges/settings/settings.h"
#include "core/edges/tuning/marked_edges.h"
#include "core/inspect/measure/cell_sets.h"
#include "core/inspect/measure/notebook.h"
#include "core/inspect/registration/stations.h"
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

/// The first lines of a sweep that is being recorded. They do not change while the file grows, or if a crash truncates it.
struct ScanHead {
    int lines = 0;
    std::string sha256; ///< SHA-256 of their ranges
    bool operator==(const ScanHead&) const = default;
};
/// For the first `lines` lines, or for all lines if there are fewer.
[[nodiscard]] ScanHead scanHead(const Scan& scan, int lines = 16);

/// The scan of a session: its path, its reading options, and the values that identify it.
struct SessionScan {
    enum class Kind : std::uint8_t { File, Demo, DemoAfterBlast, Recording };

    Kind kind = Kind::File;
    std::filesystem::path path; ///< absolute; empty for the demo
    NotebookScan identity;      ///< for a recording that is still being written: without a hash, and with the number of lines at that time
    ScanHead head;              ///< only for a recording
    double startS = 0.0;        ///< only for a recording: of its sweep, s since 1970; 0: not known
    ReadingOptions reading;     ///< paths of pose and calibration are absolute; without progress
};

/// Sweeps of one scanner start later than that after each other, s. A sweep's own start differs less between scanner and recording.
inline constexpr double kSameStartS = 0.3;
/// That a scan is the sweep of a recording that `scan` names: by its first ranges, and by its start where both are known.
[[nodiscard]] bool isSweepOf(const SessionScan& scan, const Scan& sweep);

/// For a file, and for a recording that was being written.
[[nodiscard]] constexpr bool hasPath(SessionScan::Kind kind) {
    return kind == SessionScan::Kind::File || kind == SessionScan::Kind::Recording;
}

/// A file that was read with these options; all paths are absolute.
[[nodiscard]] SessionScan fileScan(const std::filesystem::path& path, ReadingOptions reading, const NotebookScan& identity = {});

/// A, the earlier scan of a comparison A/B.
struct EarlierScan {
    SessionScan scan;
    edges::Settings settings;
};

/// The same content of the same file.
[[nodiscard]] inline bool isSame(const NotebookScan& a, const NotebookScan& b) {
    return a.sha256 == b.sha256 && a.name == b.name && a.lines == b.lines && a.beams == b.beams;
}

/// Where a layer is.
struct LayerPlace {
    RigidTransform toFirst; ///< scanner frame of the layer -> scanner frame of the scan that was the first layer
    StationBasis by = StationBasis::Poses;
    std::optional<double> residualM; ///< of the surfaces; empty: they did not correct the place
    std::optional<double> pairsM;    ///< root mean square distance of the picked points
    std::vector<std::string> warnings;
    bool operator==(const LayerPlace&) const = default;
};

inline constexpr std::size_t kMostLayers = 50;

/// One of several scans of one place that are drawn in one cloud.
struct Layer {
    SessionScan scan;
    bool visible = true;
    std::optional<LayerPlace> place; ///< empty: not known yet
};

/// Local metres of the cloud, as in ui/views/cloud.
struct SessionCamera {
    Eigen::Vector3d position{0, 0, 0}, focus{0, 0, 1}, up{0, 1, 0};
    double viewAngleDeg = 45.0; ///< vertical
    bool parallel = false;
    bool operator==(const SessionCamera&) const = default;
};

/// The visible part of the images: x = beam, y = line.
struct SessionImages {
    double beam = 0, line = 0; ///< in the middle
    double zoom = 1;           ///< pixels per line
    bool operator==(const SessionImages&) const = default;
};

struct TuningPart {
    edges::Settings settings;
    std::string preset; ///< name or path; empty: no preset
};

struct TargetsPart {
    Notebook notebook;
    std::optional<std::uint32_t> active; ///< the cell whose card is shown
};

/// In order, without empty runs.
struct SelectionPart {
    std::vector<CellRun> selected, hidden;
};

struct ViewPart {
    std::optional<SessionCamera> camera;
    std::optional<SessionImages> images; ///< empty: the whole image
};

/// The operator's view of a scan and work on it, as one value. Each controller owns one part of it.
struct ViewerState {
    SessionScan scan;
    TuningPart tuning;
    TargetsPart targets;
    SelectionPart selection;
    std::optional<rocks::Preset> rocks; ///< empty: rocks were not shown
    edges::EdgeMarks marks;
    std::optional<EarlierScan> earlier; ///< A
    std::vector<Layer> layers;          ///< with the scan of the session; empty: it is alone
    ViewPart view;
    std::map<std::string, bool> switches; ///< switches of menus, by key
    /// settings of the views that are not switches: colours of the cloud, range window, size of points ...
    std::map<std::string, std::string> looks;
    std::map<std::string, std::string> layout; ///< state of docks and splitters: base64, by name
    std::filesystem::path keptIn;              ///< for automatic saves: the file under which the operator saved the session; may be empty
};

/// The state without references to cells from `cells` on: a recording may have lost its last lines in a crash.
[[nodiscard]] ViewerState cutTo(ViewerState state, std::size_t cells);

} // namespace edgescan::inspect
