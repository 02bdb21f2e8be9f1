// The options that the operator gives when opening a file. One table is used by the command line, by records and by "Copy as command".
#pragma once

#include "core/base/physical_limits.h"
#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// What to do with points that are not on a grid of lines and beams.
enum class Projection : std::uint8_t {
    Auto,   ///< project them if EdgeScan finds no grid
    Always, ///< project them about the sensor without searching for a grid
    Never,  ///< refuse them
};

/// The value of an empty option comes from the file, or EdgeScan detects it and reports it in Scan::warnings.
struct ReadingOptions {
    std::optional<double> beamStartDeg; ///< angle of the first beam
    std::optional<double> beamStepDeg;  ///< from beam to beam
    std::optional<double> lineStartDeg; ///< angle of the first line
    std::optional<double> lineStepDeg;  ///< from line to line
    /// how the stepper turns; decides between the two for range CSV and point lists that fit both
    std::optional<Axis> axis;
    /// millimetres per number in the file; overrides the unit that the file states or that EdgeScan detects
    std::optional<double> unitMm;
    std::optional<Eigen::Vector3d> sensorM; ///< position of the sensor, metres, in the frame of the cloud's points
    std::optional<double> gridStepDeg;      ///< size of a projected cloud's cells; empty: from the spacing of its points
    Projection projection = Projection::Auto;
    std::string pose;        ///< pose file; together with the calibration it gives the scan its place in the mine
    std::string calibration; ///< the robot's calibration file
    bool straighten = false; ///< correct the angles of interlaced beams and slipped lines; openAsAsked() does this, openScan() does not
    std::string topic;       ///< of a ROS bag: the topic that is the scan
    std::string joint;       ///< of a ROS bag: the joint that turns the laser
    /// index, from 0, of the scan in a file that holds several; empty: the first, or of sweeps and clouds of a bag the largest
    std::optional<std::size_t> scanIndex;
    std::string columns;       ///< of a list of points as text: the columns of x, y and z, by number from 1 or by name: "2,1,3"
    bool keepRepeated = false; ///< a value or point that repeats far apart from the rest is measured and not "no return"

    /// Called by the opening thread with the stage and the share of it that is done (0..1). If it returns false, opening ends with the
    /// Error "cancelled".
    std::function<bool(const char* stage, double fraction)> progress;
};

/// One row of the table. A new option needs a row and a member.
struct ReadingOption {
    enum class Kind : std::uint8_t { Number, ThreeNumbers, Whole, Word, Switch, Path, Name };
    enum Use : std::uint8_t { kFlag = 1, kRecord = 2 };

    const char* key; ///< flag without "--", and key in records
    int uses;        ///< Use flags: whether the option is accepted on the command line, stored in records, or both
    Kind kind;
    const char* help;
    std::vector<std::string> words;                   ///< the allowed values of a Word
    std::string (*get)(const ReadingOptions&);        ///< as typed ("1,2,3" for three numbers, "on" for a switch); empty if not given
    void (*set)(ReadingOptions&, const std::string&); ///< the text must be one that checked() accepts
    const PhysicalLimit* limit = nullptr;             ///< limit of its numbers; null if it has no numbers
};

[[nodiscard]] std::span<const ReadingOption> readingOptionTable();

/// Checks a typed value for an option. Error: a wrong count of numbers, a number outside its limit, a word that the option does not allow.
Result<Done> checked(const ReadingOption& option, const std::string& text);

/// The Error of a --scan that a file does not hold: "--scan 3: the file holds 2 scans; use --scan 0 to 1."
[[nodiscard]] Error noSuchScan(std::size_t asked, std::size_t held, const std::string& holder = "the file", const char* one = "one scan",
                               const char* several = "%1 scans");

/// "--axis spin --line-start -30": the flags that give these options; empty if no option is set. Paths are quoted for a POSIX shell.
[[nodiscard]] std::string readingFlags(const ReadingOptions& options);

/// "--unit cm replaces mm, which the file gives.": a warning for each option that is not what the file gives. `file` has what it gives.
[[nodiscard]] std::vector<std::string> replacedByOptions(const ReadingOptions& given, const ReadingOptions& file);

/// "--topic has no effect: WHY; leave it out.": a warning for each of these options that is given.
[[nodiscard]] std::vector<std::string> idleOptions(const ReadingOptions& given, std::span<const std::string_view> keys,
                                                   const std::string& why);

/// The given options as JSON, {"unit-mm": 10.0, "axis": "sweep", ...}; empty if there are none. Without the paths of pose and calibration,
/// which a record stores itself. With this text the scan can be opened the same way again.
[[nodiscard]] std::string readingOptionsText(const ReadingOptions& options);

/// Reads the options back; an empty text gives the defaults. Error: damaged text or an unknown key. The error names `where`.
Result<ReadingOptions> parseReadingOptions(const std::string& json, const std::string& where);

} // namespace edgescan
