// What the user says on opening a file. One table feeds command line, records and "Copy as command".
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
#include <vector>

namespace edgescan {

/// What to do with points that lie on no grid of lines and beams.
enum class Projection : std::uint8_t {
    Auto,   ///< project them when no grid is found
    Always, ///< project them about the sensor without looking for a grid
    Never,  ///< refuse them
};

/// An option that is empty is taken from the file, or found out and told in Scan::warnings.
struct ReadingOptions {
    std::optional<double> beamStartDeg;     ///< angle of the first beam
    std::optional<double> beamStepDeg;      ///< from beam to beam
    std::optional<double> lineStartDeg;     ///< angle of the first line
    std::optional<double> lineStepDeg;      ///< from line to line
    std::optional<Axis> axis;               ///< how the stepper turns; decides range CSV and point lists that fit both
    std::optional<double> unitMm;           ///< millimetres per number in the file, instead of what it says or what is detected
    std::optional<Eigen::Vector3d> sensorM; ///< where a cloud was taken from, metres, in the frame of its points
    std::optional<double> gridStepDeg;      ///< cells of a projected cloud; empty = from the spacing of its points
    Projection projection = Projection::Auto;
    std::string pose;          ///< pose file; with the calibration it gives the scan its place in the mine
    std::string calibration;   ///< the robot's calibration file
    bool straighten = false;   ///< correct the angles of interlaced beams and slipped lines: openAsAsked() does, openScan() does not
    std::size_t scanIndex = 0; ///< which scan of a file that holds several, from 0

    /// Told the stage and how much of it is done (0..1), from the thread that opens; false cancels: Error "cancelled".
    std::function<bool(const char* stage, double fraction)> progress;
};

/// One row of the table. A new option is a row and a member.
struct ReadingOption {
    enum class Kind : std::uint8_t { Number, ThreeNumbers, Whole, Word, Switch, Path };
    enum Use : std::uint8_t { kFlag = 1, kRecord = 2 };

    const char* key; ///< flag without "--", and key in records
    int uses;        ///< Use: typed on the command line, kept in records, or both
    Kind kind;
    const char* help;
    std::vector<std::string> words;                   ///< the only values of a Word
    std::string (*get)(const ReadingOptions&);        ///< as typed ("1,2,3" for three numbers, "on" for a switch); empty: not said
    void (*set)(ReadingOptions&, const std::string&); ///< of a text that checked() accepts
    const PhysicalLimit* limit = nullptr;             ///< of its numbers; null: it takes none
};

[[nodiscard]] std::span<const ReadingOption> readingOptionTable();

/// A typed value, with an option that it suits. Error: not so many numbers within the limit, none of the words.
Result<Done> checked(const ReadingOption& option, const std::string& text);

/// "--axis spin --line-start -30": the flags that give these options; empty when nothing was said. Paths are quoted for a POSIX shell.
[[nodiscard]] std::string readingFlags(const ReadingOptions& options);

/// What was said as JSON, {"unit-mm": 10.0, "axis": "sweep", ...}, without the paths of pose and calibration, which a record holds itself;
/// empty when that is nothing. With it the scan can be opened the same way again.
[[nodiscard]] std::string readingOptionsText(const ReadingOptions& options);

/// The options back; an empty text gives the defaults. Error: damaged, or an unknown key. `where` goes into it.
Result<ReadingOptions> parseReadingOptions(const std::string& json, const std::string& where);

} // namespace edgescan
