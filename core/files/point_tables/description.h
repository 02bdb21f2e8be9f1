// The description of a grid as JSON: NAME.json of a raw grid, and the comment lines of our own PCD, PLY, XYZ and CSV.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/scan.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace edgescan::files {

/// Only what is known; without the times of the lines.
[[nodiscard]] nlohmann::ordered_json acquisitionToJson(const Acquisition& acquisition);

/// Error: an unknown key, or no text where text is needed. `where` goes into it.
Result<std::shared_ptr<const Acquisition>> acquisitionFromJson(const nlohmann::json& object, const std::string& where);

/// {"start","step"}: even angles.
struct AngleSteps {
    double startDeg = 0.0;
    double stepDeg = 0.0;
};
using AngleList = std::variant<AngleSteps, std::vector<double>>;

/// A run of cells whose state the counts cannot express (lost, masked, out of window).
struct StateRun {
    CellState state = CellState::Lost;
    std::uint64_t firstCell = 0;
    std::uint64_t cells = 0;
};

struct GridDescription {
    std::uint64_t lines = 0; ///< at least 1, at most 2^30
    std::uint64_t beams = 0;
    std::vector<std::string> unknownKeys; ///< misspelt, or of another program
    std::optional<std::string> dataFile;  ///< a relative name without ".."
    double unitMm = 1.0;
    std::vector<std::uint32_t> noReturnCodes{0};
    std::vector<std::uint32_t> statusCodes;
    std::optional<AngleList> beamDeg, lineDeg; ///< lists have exactly beams and lines numbers, all finite
    std::optional<AngleList> lineSkewDeg;      ///< key "line_skew_deg", per beam, written only when there is one
    std::optional<Axis> axis;
    double lineDirection = 1.0;             ///< key "line_direction", written only when -1
    std::optional<Eigen::Vector3d> sensorM; ///< key "sensor_m": an organised cloud without angles
    std::vector<StateRun> stateRuns;        ///< key "state_runs", written only when there are some; inside the grid
    std::string note;
    std::shared_ptr<const Placement> placement;     ///< key "placement"; null when there is none
    std::shared_ptr<const Acquisition> acquisition; ///< key "acquisition"; null when there is none
};

/// Error: not JSON, nested too deep, a key is missing or has the wrong type, numbers out of all reason. `where` is the path.
Result<GridDescription> parseDescription(std::string_view json, const std::string& where);

/// Angles of `count` beams or lines. Call it only when `count` has been checked against the file.
[[nodiscard]] std::vector<double> anglesOf(const AngleList& list, std::uint64_t count);

/// Beam and line angles, axis, direction and skew; empty where the description has not all of the first three. Call it only when lines and
/// beams have been checked.
[[nodiscard]] std::optional<PolarGeometry> polarOf(const GridDescription& grid);

/// Whether a file of this program with this description (JSON, or empty) says everything by its columns of ranges and states, because the
/// angles say the rest: then a reader can skip its x y z, line and beam.
[[nodiscard]] bool needsRangesOnly(const std::string& description);

/// Unit, codes, note, place and acquisition.
void applyDescription(Scan& scan, const GridDescription& grid);

/// The states that the counts cannot express, as far as the scan's cells go.
void applyStateRuns(Scan& scan, const GridDescription& grid);

/// {"start","step"} when that gives back the same doubles, else the list.
[[nodiscard]] AngleList shortestAngles(const std::vector<double>& degrees);

/// A scan without ranges and points, and without a note, a place and an acquisition: what its description states is left.
[[nodiscard]] Scan headOf(const Scan& scan);

/// The description of a scan. `dataFile` is named in it when not empty.
[[nodiscard]] nlohmann::ordered_json descriptionJson(const Scan& scan, const std::string& dataFile = {});

/// The same as text; `indent` as in nlohmann::json::dump (-1 = one line).
[[nodiscard]] std::string descriptionText(const Scan& scan, const std::string& dataFile, int indent);

/// Runs of the states that a count cannot express: lost, masked, out of window.
[[nodiscard]] std::vector<StateRun> stateRunsOf(const Scan& scan);

/// "lost" -> CellState::Lost.
[[nodiscard]] std::optional<CellState> cellStateNamed(std::string_view name);

} // namespace edgescan::files
