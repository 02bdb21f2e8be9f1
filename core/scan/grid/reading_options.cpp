// One row per reading option.
#include "core/scan/grid/reading_options.h"
#include "core/base/translated_text.h"

#include "core/base/bounded_json.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/shell_quoted.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan {
namespace {

using Json = nlohmann::ordered_json;
using Kind = ReadingOption::Kind;
using Options = ReadingOptions;

std::string textOf(const std::optional<double>& value) {
    std::string text;
    if (value) appendShortest(text, *value);
    return text;
}
std::string textOf(const std::optional<Eigen::Vector3d>& v) {
    return v ? textOf(v->x()) + "," + textOf(v->y()) + "," + textOf(v->z()) : std::string();
}
std::string textOf(const std::optional<std::size_t>& value) { return value ? std::to_string(*value) : std::string(); }
std::string textOf(bool value) { return value ? "on" : ""; }
std::string textOf(const std::string& value) { return value; }

// Finite numbers separated by commas; empty for any other text.
std::vector<double> numbersOf(std::string_view text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        double value = 0;
        const auto [after, code] = std::from_chars(at, end, value);
        if (code != std::errc{} || !std::isfinite(value)) return {};
        numbers.push_back(value);
        if (after == end) return numbers;
        if (*after != ',') return {};
        at = after + 1;
    }
}

void read(std::optional<double>& value, const std::string& text) { value = numbersOf(text).at(0); }
void read(std::optional<Eigen::Vector3d>& value, const std::string& text) {
    const std::vector<double> numbers = numbersOf(text);
    value = Eigen::Vector3d(numbers.at(0), numbers.at(1), numbers.at(2));
}
void read(std::optional<std::size_t>& value, const std::string& text) { value = static_cast<std::size_t>(numbersOf(text).at(0)); }
void read(bool& value, const std::string& text) { value = text == "on"; }
void read(std::string& value, const std::string& text) { value = text; }

struct LengthUnit {
    const char* word;
    double mm;
};
constexpr std::array<LengthUnit, 6> kUnits{
    {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}, {"ft", kFootMm}, {"usft", kUsSurveyFootMm}}};

std::vector<std::string> unitWords() {
    std::vector<std::string> words;
    for (const LengthUnit& unit : kUnits) words.emplace_back(unit.word);
    return words;
}
std::string unitText(const std::optional<double>& mm) {
    const auto* unit = std::ranges::find_if(kUnits, [&](const LengthUnit& one) { return mm == one.mm; });
    return unit == kUnits.end() ? textOf(mm) : unit->word;
}
double unitOf(const std::string& text) {
    const auto* unit = std::ranges::find_if(kUnits, [&](const LengthUnit& one) { return text == one.word; });
    return unit == kUnits.end() ? numbersOf(text).at(0) : unit->mm;
}

#define EDGESCAN_OPTION(member)                                                                                                            \
    [](const Options& o) { return textOf(o.member); }, [](Options& o, const std::string& text) { read(o.member, text); }

constexpr PhysicalLimit kScanIndex{"scan of a file", "", {0, 1e6}, "no file holds more"};

constexpr int kBoth = ReadingOption::kFlag | ReadingOption::kRecord;

// clang-format off
const std::vector<ReadingOption>& table() {
    static const std::vector<ReadingOption> rows{
        {"beam-start", kBoth, Kind::Number, "Angle of the first beam [degrees]", {}, EDGESCAN_OPTION(beamStartDeg), &physical::kBeamDeg},
        {"beam-step", kBoth, Kind::Number, "Angle from beam to beam [degrees]", {}, EDGESCAN_OPTION(beamStepDeg), &physical::kStepDeg},
        {"line-start", kBoth, Kind::Number, "Angle of the first line [degrees]", {}, EDGESCAN_OPTION(lineStartDeg), &physical::kLineDeg},
        {"line-step", kBoth, Kind::Number, "Angle from line to line [degrees]", {}, EDGESCAN_OPTION(lineStepDeg), &physical::kStepDeg},
        {"unit", ReadingOption::kFlag, Kind::Word, "Unit of the numbers in the file; replaces the one that the file gives", unitWords(),
         [](const Options& o) { return unitText(o.unitMm); }, [](Options& o, const std::string& text) { o.unitMm = unitOf(text); },
         &physical::kUnitMm},
        {"unit-mm", ReadingOption::kRecord, Kind::Number, "Millimetres per number in the file", {}, EDGESCAN_OPTION(unitMm), &physical::kUnitMm},
        {"grid-step", kBoth, Kind::Number, "Cells of a cloud that is projected [degrees]; else from the spacing of its points", {},
         EDGESCAN_OPTION(gridStepDeg), &physical::kGridStepDeg},
        {"axis", kBoth, Kind::Word, "What the stepper turns about: spin (viewing direction) or sweep (0/180 degree line)", {"spin", "sweep"},
         [](const Options& o) -> std::string { return !o.axis ? "" : *o.axis == Axis::Spin ? "spin" : "sweep"; },
         [](Options& o, const std::string& text) { o.axis = text == "spin" ? Axis::Spin : Axis::Sweep; }},
        {"sensor", kBoth, Kind::ThreeNumbers, "Place of the scanner for a cloud without a grid, as X,Y,Z [m]", {}, EDGESCAN_OPTION(sensorM), &physical::kPlaceM},
        {"project", kBoth, Kind::Word,
         "Points without a scanner grid: project them about the sensor (auto), do so without looking for a grid (always), or refuse them (never)",
         {"auto", "always", "never"},
         [](const Options& o) -> std::string { return o.projection == Projection::Auto ? "" : o.projection == Projection::Always ? "always" : "never"; },
         [](Options& o, const std::string& text) {
             o.projection = text == "always" ? Projection::Always : text == "never" ? Projection::Never : Projection::Auto;
         }},
        {"straighten", kBoth, Kind::Switch,
         "Correct the angles of beams that were interlaced from two passes, and of lines at which the stepper slipped", {},
         EDGESCAN_OPTION(straighten)},
        {"scan", kBoth, Kind::Whole, "Which scan of a file that holds several, from 0", {}, EDGESCAN_OPTION(scanIndex), &kScanIndex},
        {"topic", kBoth, Kind::Name, "Topic of a ROS bag that is the scan; otherwise a laser that is turned", {}, EDGESCAN_OPTION(topic)},
        {"joint", kBoth, Kind::Name, "Joint of a ROS bag that turns the laser; otherwise from the transforms", {}, EDGESCAN_OPTION(joint)},
        {"columns", kBoth, Kind::Name, "Columns of x, y and z in a list of points, by number from 1 or by name: 2,1,3", {}, EDGESCAN_OPTION(columns)},
        {"keep-repeated", kBoth, Kind::Switch,
         "Take a value or point that repeats exactly, far apart from the rest, as measured and not as no return", {}, EDGESCAN_OPTION(keepRepeated)},
        {"pose", ReadingOption::kFlag, Kind::Path, "Pose file of the scan; a recording may hold its own", {}, EDGESCAN_OPTION(pose)},
        {"calibration", ReadingOption::kFlag, Kind::Path, "Calibration file of the robot; a recording may hold its own", {}, EDGESCAN_OPTION(calibration)},
    };
    return rows;
}
// clang-format on

Json recordOf(Kind kind, const std::string& text) {
    switch (kind) {
    case Kind::Number:
        return numbersOf(text).front();
    case Kind::ThreeNumbers:
        return numbersOf(text);
    case Kind::Whole:
        return static_cast<std::size_t>(numbersOf(text).front());
    case Kind::Switch:
        return true;
    default:
        return text;
    }
}

double limited(const ReadingOption& option, JsonFields& fields) {
    const double number = fields.number(option.key, 0.0, option.limit->limits);
    if (!option.limit->hold(number)) fields.refuse(option.key, "must not be 0");
    return number;
}

// The option's text from a record; `fields` stores the first fault.
std::string textOf(const ReadingOption& option, JsonFields& fields) {
    switch (option.kind) {
    case Kind::Number:
        return textOf(std::optional<double>(limited(option, fields)));
    case Kind::ThreeNumbers:
        return textOf(std::optional<Eigen::Vector3d>(fields.neededVector(option.key, option.limit->limits)));
    case Kind::Whole:
        return std::to_string(static_cast<std::size_t>(fields.number(option.key, 0.0, option.limit->limits)));
    case Kind::Switch:
        return textOf(fields.boolean(option.key, false));
    case Kind::Word:
        return option.words[fields.choice(option.key, option.words)];
    default:
        return fields.text(option.key);
    }
}

} // namespace

std::span<const ReadingOption> readingOptionTable() { return table(); }

Result<Done> checked(const ReadingOption& option, const std::string& text) {
    const std::string flag = std::string("--") + option.key;
    const bool isWord = std::ranges::find(option.words, text) != option.words.end();
    const bool isNumber = option.limit != nullptr && numbersOf(text).size() == 1; // a unit is a word or a number
    if (option.kind == Kind::Word && !isWord && !isNumber) {
        std::string words;
        for (const std::string& word : option.words) words += (words.empty() ? "" : &word == &option.words.back() ? " or " : ", ") + word;
        if (option.limit != nullptr) words = withValues("%1, or a number of %2", {words, option.limit->unit});
        return Error{withValues("\"%1\" is not one of its values", {text}), flag, withValues("use %1", {words})};
    }
    if (option.limit == nullptr || isWord) return Done{};
    const std::vector<double> numbers = numbersOf(text);
    const NumberLimits& limits = option.limit->limits;
    const std::string unit = *option.limit->unit == '\0' ? std::string() : std::string(" ") + option.limit->unit;
    const std::string within = withValues("from %1 to %2%3", {significantText(limits.least, 9), significantText(limits.most, 9), unit});
    const bool whole = option.kind == Kind::Whole;
    const std::string hint =
        option.kind == Kind::ThreeNumbers
            ? withValues("give three numbers %1: X,Y,Z", {within})
            : withValues(whole ? "give a whole number %1" : "give a number %1", {within}) + (option.limit->zero ? "" : " that is not 0");
    if (numbers.size() != (option.kind == Kind::ThreeNumbers ? 3 : 1)) {
        return Error{withValues(option.kind == Kind::ThreeNumbers ? "\"%1\" is not three numbers" : "\"%1\" is not a number", {text}), flag,
                     hint};
    }
    if (std::ranges::all_of(numbers, [&](double n) { return option.limit->hold(n) && (!whole || n == std::floor(n)); })) return Done{};
    return Error{withValues("%1 is out of reason for a %2", {text, option.limit->what}), flag, hint};
}

Error noSuchScan(std::size_t asked, std::size_t held, const std::string& holder, const char* one, const char* several) {
    return {withValues("%1 holds %2", {holder, held == 1 ? one : withValues(several, {held})}), withValues("--scan %1", {asked}),
            held == 0   ? "choose another file"
            : held == 1 ? "use --scan 0"
                        : withValues("use --scan 0 to %1", {held - 1})};
}

std::string readingFlags(const ReadingOptions& options) {
    std::string flags;
    for (const ReadingOption& option : table()) {
        const std::string text = option.get(options);
        if ((option.uses & ReadingOption::kFlag) == 0 || text.empty()) continue;
        flags += (flags.empty() ? "--" : " --") + std::string(option.key);
        if (option.kind != Kind::Switch) flags += " " + (option.kind == Kind::Path || option.kind == Kind::Name ? shellQuoted(text) : text);
    }
    return flags;
}

std::vector<std::string> replacedByOptions(const ReadingOptions& given, const ReadingOptions& file) {
    std::vector<std::string> warnings;
    for (const ReadingOption& option : table()) {
        const std::string now = option.get(given), was = option.get(file);
        if ((option.uses & ReadingOption::kFlag) != 0 && !now.empty() && !was.empty() && now != was)
            warnings.push_back(withValues("--%1 %2 replaces %3, which the file gives.", {option.key, now, was}));
    }
    return warnings;
}

std::vector<std::string> idleOptions(const ReadingOptions& given, std::span<const std::string_view> keys, const std::string& why) {
    std::vector<std::string> warnings;
    for (const ReadingOption& option : table()) {
        if (std::ranges::find(keys, option.key) != keys.end() && !option.get(given).empty())
            warnings.push_back(withValues("--%1 has no effect: %2; leave it out.", {option.key, why}));
    }
    return warnings;
}

std::string readingOptionsText(const ReadingOptions& options) {
    Json object = Json::object();
    for (const ReadingOption& option : table()) {
        const std::string text = option.get(options);
        if ((option.uses & ReadingOption::kRecord) != 0 && !text.empty()) object[option.key] = recordOf(option.kind, text);
    }
    return object.empty() ? std::string() : jsonText(object);
}

Result<ReadingOptions> parseReadingOptions(const std::string& json, const std::string& where) {
    ReadingOptions options;
    if (json.empty()) return options;
    const auto object = parseJson(json, where, kSettingsJson);
    if (!object || !object->is_object()) return Error{"what the scan was opened with is damaged", where, "export again"};
    JsonFields fields(*object, where, "verify with the version that made the export");
    for (const ReadingOption& option : table()) {
        if ((option.uses & ReadingOption::kRecord) == 0 || !fields.has(option.key)) continue;
        const std::string text = textOf(option, fields);
        if (!fields.problem()) option.set(options, text);
    }
    fields.done();
    if (fields.problem()) return *fields.problem();
    return options;
}

} // namespace edgescan
