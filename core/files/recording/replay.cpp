// Playing recordings.
#include "core/files/recording/replay.h"
#include "core/base/translated_text.h"

#include "core/base/bounded_json.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/utc_time.h"
#include "core/files/recording/recorded_grid.h"
#include "core/scan/georef/rotations.h"
#include "core/scan/grid/acquisition.h"
#include "core/scanner/cola/commands.h"
#include "core/scanner/cola/frames.h"
#include "core/scanner/sick_lms/scan_telegram.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace edgescan::files {
namespace {

using PlainJson = nlohmann::json;

constexpr std::size_t kLongestAnswer = 1024; // of the scanner to what it was asked: its name, its firmware
constexpr double kStillM = 0.05;             // a base at rest does not seem to move farther than this ...
constexpr double kStillDeg = 0.2;            // ... nor to turn by more
constexpr double kRotationTolerance = 1e-5;

/// Null where the text cannot be used.
PlainJson jsonOf(std::string_view text) {
    auto json = parseJson(text, "", kReadingJson);
    return json ? std::move(*json) : PlainJson();
}

/// The robot's keys of a metadata record. A value that cannot be used is a warning, and then nothing of it is used.
class RobotKeys {
public:
    explicit RobotKeys(const scanner::SweepMetadata& metadata) : metadata_(metadata) {}

    [[nodiscard]] bool has(const char* key) const { return metadata_.contains(key); }
    [[nodiscard]] std::string text(const char* key) const {
        const auto found = metadata_.find(key);
        return found == metadata_.end() ? std::string() : found->second;
    }
    double number(const char* key, double missing, double most) {
        if (!has(key)) return missing;
        const std::string given = text(key);
        double value = 0;
        const auto [end, problem] = std::from_chars(given.data(), given.data() + given.size(), value);
        if (problem == std::errc{} && end == given.data() + given.size() && std::abs(value) <= most) return value;
        return refuse(key), missing;
    }
    Eigen::Vector3d vector(const char* key, const Eigen::Vector3d& missing, double most) {
        if (!has(key)) return missing;
        if (const auto v = three(jsonOf(text(key))); v && v->cwiseAbs().maxCoeff() <= most) return *v;
        return refuse(key), missing;
    }
    Eigen::Matrix3d rotation(const char* key) {
        const PlainJson rows = jsonOf(text(key));
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
        bool sound = rows.is_array() && rows.size() == 3;
        for (std::size_t i = 0; sound && i < 3; ++i) {
            const auto row = three(rows[i]);
            sound = row.has_value();
            if (sound) matrix.row(static_cast<Eigen::Index>(i)) = row->transpose();
        }
        if (!sound || !(rotationError(matrix) < kRotationTolerance)) refuse(key);
        return matrix;
    }
    [[nodiscard]] const std::vector<std::string>& refused() const { return refused_; }

private:
    static std::optional<Eigen::Vector3d> three(const PlainJson& list) {
        if (!list.is_array() || list.size() != 3) return std::nullopt;
        Eigen::Vector3d v;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!list[i].is_number()) return std::nullopt;
            v[static_cast<Eigen::Index>(i)] = list[i].get<double>();
        }
        return v;
    }
    void refuse(const char* key) {
        refused_.push_back(
            withValues("the recording's \"%1\" is \"%2\", which cannot be used.", {std::string(key), text(key).substr(0, 40)}));
    }

    const scanner::SweepMetadata& metadata_;
    std::vector<std::string> refused_;
};

std::optional<Calibration> calibrationOf(const scanner::SweepMetadata& metadata, std::vector<std::string>& warnings) {
    RobotKeys keys(metadata);
    if (!keys.has("R_IA") || !keys.has("talin_in_robot_m")) return std::nullopt;
    Calibration c;
    c.robot = keys.text("robot");
    c.mountRpyDeg = keys.vector("mount.rpy_deg", c.mountRpyDeg, 360);
    c.mountM = keys.vector("mount.t_m", c.mountM, 2);
    c.axis = keys.vector("stepper.axis", c.axis, 1e3);
    if (!(c.axis.norm() > 1e-6)) c.axis = Eigen::Vector3d::UnitZ();
    // The sweep counts its line angles about +z or +x: an axis that points the other way is in their sign.
    Eigen::Index along = 0;
    c.axis.cwiseAbs().maxCoeff(&along);
    if (c.axis[along] < 0) c.axis = -c.axis;
    c.viewing = Viewing::Matrix;
    c.viewingMatrix = keys.rotation("R_IA");
    c.inclinometerM = keys.vector("t_IA_m", c.inclinometerM, 5);
    if (keys.text("inclinometer.reads") == "pitch_roll") c.tilt = TiltReading::PitchRoll;
    c.headInRobotM = keys.vector("head_in_robot_m", c.headInRobotM, 100);
    c.talinInRobotM = keys.vector("talin_in_robot_m", c.talinInRobotM, 100);
    c.boresightRpyDeg = keys.vector("boresight_rpy_deg", c.boresightRpyDeg, 360);
    c.convergenceDeg = keys.number("convergence_deg", 0, 180);
    c.gridScale = keys.number("grid_scale", 1, 1.01);
    if (keys.refused().empty() && c.gridScale >= 0.99) return c;
    warnings.insert(warnings.end(), keys.refused().begin(), keys.refused().end());
    return std::nullopt;
}

/// A number of a reading; NaN when it is not a number or out of all reason.
double numberOf(const PlainJson& reading, const char* key, const PhysicalLimit& limit) {
    const auto found = reading.find(key);
    if (found == reading.end() || !found->is_number()) return kUnknownTime;
    const auto value = found->get<double>();
    return limit.hold(value) ? value : kUnknownTime;
}

double timeOf(const PlainJson& reading, std::int64_t logNs) {
    const auto found = reading.find("t_host_ns");
    const bool stated = found != reading.end() && found->is_number_unsigned() && found->get<std::uint64_t>() <= std::uint64_t{kLatestNs};
    return static_cast<double>(stated ? found->get<std::int64_t>() : logNs) * 1e-9;
}

std::optional<InclinometerReading> inclinometerOf(const PlainJson& reading, double timeS) {
    const InclinometerReading r{timeS, numberOf(reading, "tilt_x_deg", physical::kTiltDeg),
                                numberOf(reading, "tilt_y_deg", physical::kTiltDeg)};
    return std::isfinite(r.tiltXDeg) && std::isfinite(r.tiltYDeg) ? std::optional(r) : std::nullopt;
}

std::optional<TalinReading> talinOf(const PlainJson& reading, double timeS) {
    if (reading.value("status", PlainJson(0)) != PlainJson(0)) return std::nullopt; // it says itself that it is not to be used
    TalinReading r;
    r.timeS = timeS;
    r.enhM = {numberOf(reading, "easting_m", physical::kPlaceM), numberOf(reading, "northing_m", physical::kPlaceM),
              numberOf(reading, "elevation_m", physical::kElevationM)};
    r.headingDeg = numberOf(reading, "heading_deg", physical::kBeamDeg);
    r.pitchDeg = numberOf(reading, "pitch_deg", physical::kTiltDeg);
    r.rollDeg = numberOf(reading, "roll_deg", physical::kRollDeg);
    r.trueNorth = reading.value("heading_ref", PlainJson("true")) != PlainJson("grid");
    const bool whole = r.enhM.allFinite() && std::isfinite(r.headingDeg) && std::isfinite(r.pitchDeg) && std::isfinite(r.rollDeg);
    return whole ? std::optional(r) : std::nullopt;
}

std::string gridOf(const PlainJson& reading) {
    const auto word = [&](const char* key) {
        const auto found = reading.find(key);
        return found != reading.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    const std::string zone = word("zone"), datum = word("datum");
    return zone + (zone.empty() || datum.empty() ? "" : ", ") + datum;
}

template <class Reading>
void keep(std::vector<Reading>& readings, const std::optional<Reading>& reading, int& unusable) {
    if (!reading)
        ++unusable;
    else if (readings.empty() || reading->timeS > readings.back().timeS) // the same moment twice adds nothing
        readings.push_back(*reading);
}

/// From the last reading before the sweep to the first one behind it.
template <class Reading>
void cutToSweep(std::vector<Reading>& readings, double startS, double endS) {
    const auto time = [](const Reading& r, double t) { return r.timeS < t; };
    if (std::isfinite(endS)) {
        auto last = std::lower_bound(readings.begin(), readings.end(), endS, time);
        if (last != readings.end()) ++last;
        readings.erase(last, readings.end());
    }
    if (!std::isfinite(startS)) return;
    auto first = std::lower_bound(readings.begin(), readings.end(), startS, time);
    if (first != readings.begin()) --first;
    readings.erase(readings.begin(), first);
}

/// One or two readings around the sweep bracket it; a static sweep takes those within it, where there are any.
template <class Reading>
void keepWithin(std::vector<Reading>& readings, double startS, double endS) {
    std::vector<Reading> within;
    for (const Reading& r : readings) {
        if (r.timeS >= startS && r.timeS <= endS) within.push_back(r);
    }
    if (!within.empty()) readings = std::move(within);
}

bool moved(const std::vector<TalinReading>& readings) {
    const TalinReading& first = readings.front();
    return std::any_of(readings.begin(), readings.end(), [&](const TalinReading& r) {
        const double turned = std::max({std::abs(std::remainder(r.headingDeg - first.headingDeg, 360.0)),
                                        std::abs(r.pitchDeg - first.pitchDeg), std::abs(std::remainder(r.rollDeg - first.rollDeg, 360.0))});
        return (r.enhM - first.enhM).norm() > kStillM || turned > kStillDeg;
    });
}

std::optional<PoseTrack> posesOf(const Recording& recording, double startS, double endS, std::vector<std::string>& warnings) {
    PoseTrack poses;
    int unusable = 0;
    for (const RecordedMessage& message : recording.messages()) {
        const bool talin = message.topic == RecordingTopic::Talin;
        if (!talin && message.topic != RecordingTopic::Inclinometer) continue;
        const PlainJson reading = jsonOf({reinterpret_cast<const char*>(message.payload.data()), message.payload.size()});
        if (!reading.is_object()) {
            ++unusable;
            continue;
        }
        const double timeS = timeOf(reading, message.logNs);
        if (!talin) {
            keep(poses.inclinometer, inclinometerOf(reading, timeS), unusable);
            continue;
        }
        keep(poses.talin, talinOf(reading, timeS), unusable);
        if (poses.grid.empty()) poses.grid = gridOf(reading);
    }
    if (unusable > 0)
        warnings.push_back(
            counted(unusable, "reading of inclinometer or TALIN cannot be used.", "readings of inclinometer or TALIN cannot be used."));
    cutToSweep(poses.inclinometer, startS, endS);
    cutToSweep(poses.talin, startS, endS);
    if (poses.inclinometer.empty() || poses.talin.empty()) return std::nullopt;
    poses.moving = moved(poses.talin);
    if (!poses.moving) {
        keepWithin(poses.inclinometer, startS, endS);
        keepWithin(poses.talin, startS, endS);
    }
    RobotKeys keys(recording.metadata());
    poses.robot = keys.text("robot");
    poses.source = "the recording's own readings";
    if (poses.grid.empty()) poses.grid = keys.text("crs");
    poses.scanStartS = startS;
    poses.scanEndS = endS;
    poses.boomAzimuthDeg = keys.number("boom_azimuth_deg", kUnknownTime, 360);
    poses.headInRobotM = keys.vector("head_in_robot_m", poses.headInRobotM, 100);
    warnings.insert(warnings.end(), keys.refused().begin(), keys.refused().end());
    if (std::isfinite(poses.boomAzimuthDeg)) return poses;
    if (!keys.has("boom_azimuth_deg"))
        warnings.emplace_back("The recording holds readings of TALIN and does not say where the boom pointed (boom_azimuth_deg).");
    return std::nullopt;
}

/// Both, each from a file where one was given. Empty: neither flag was given and the recording does not say enough.
struct Known {
    std::optional<Calibration> calibration;
    std::optional<PoseTrack> poses;
    std::string source;
};
Result<Known> knownOf(RecordedRobot robot, const ReadingOptions& options, const std::string& where) {
    Known known{std::move(robot.calibration), std::move(robot.poses), {}};
    known.source = "the recording";
    if (!options.pose.empty()) {
        auto poses = openPoses(options.pose);
        if (!poses) return poses.error();
        if (poses->calibration) known.calibration = poses->calibration;
        known.poses = std::move(*poses);
        const auto source = sourceOf(options.pose);
        if (!source) return source.error();
        known.source = *source;
    }
    if (!options.calibration.empty()) {
        auto calibration = openCalibration(options.calibration);
        if (!calibration) return calibration.error();
        known.calibration = *calibration;
        const auto source = sourceOf(options.calibration);
        if (!source) return source.error();
        known.source += withValues(" with %1", {*source});
    }
    if (!options.pose.empty() && !known.calibration)
        return Error{"a pose needs the robot's calibration, and the recording holds none", where, "give --calibration ROBOT.json too"};
    if (!options.calibration.empty() && !known.poses)
        return Error{"a calibration needs a pose, and the recording holds none that can be used", where, "give --pose POSE.json too"};
    return known;
}

/// Where the payload of a frame begins, to know a scan telegram without taking the frame apart.
bool isScanTelegram(const RecordedMessage& message) {
    if (message.topic != RecordingTopic::ColaRx || message.payload.size() < 2) return false;
    constexpr std::size_t kBinaryPayload = 8;
    const bool binary = message.payload.size() > kBinaryPayload && message.payload[1] == 2;
    return scanner::isScanTelegram(message.payload.subspan(binary ? kBinaryPayload : 1));
}

} // namespace

RecordedRobot recordedRobot(const Recording& recording, double startS, double endS) {
    RecordedRobot robot;
    robot.calibration = calibrationOf(recording.metadata(), robot.warnings);
    robot.poses = posesOf(recording, startS, endS, robot.warnings);
    if (robot.poses && !robot.calibration)
        robot.warnings.emplace_back("The recording holds poses and not how the robot is built: --calibration ROBOT.json places the scan.");
    return robot;
}

Result<Done> placeRecordedSweep(Scan& scan, const Recording& recording, const ReadingOptions& options, const std::string& where) {
    const bool asked = !options.pose.empty() || !options.calibration.empty();
    if (scan.placement && !asked) return Done{};
    const std::vector<double> times = scan.acquisition ? scan.acquisition->lineTimesS : std::vector<double>{};
    const double startS = times.empty() ? kUnknownTime : times.front();
    RecordedRobot robot = recordedRobot(recording, startS, times.empty() ? kUnknownTime : times.back());
    const std::vector<std::string> warnings = robot.warnings;
    if (robot.poses && !options.pose.empty())
        scan.warnings.push_back(
            withValues("The pose in %1 replaces those of the recording.", {std::filesystem::path(options.pose).filename().string()}));
    const auto known = knownOf(std::move(robot), options, where);
    if (!known) return known.error();
    if (!asked) scan.warnings.insert(scan.warnings.end(), warnings.begin(), warnings.end());
    if (!known->poses || !known->calibration) return Done{};
    const auto placed = placeScan(scan, *known->calibration, *known->poses, times);
    if (!placed && asked) return Error{placed.error().what, where, placed.error().hint};
    if (!placed) {
        scan.warnings.push_back(withValues("The recording's pose cannot be used: %1.", {placed.error().what}));
        return Done{};
    }
    auto named = std::make_shared<Placement>(**placed);
    named->source = known->source;
    scan.placement = std::move(named);
    return Done{};
}

void nameScanner(Scan& scan, const Recording& recording) {
    auto named = scan.acquisition ? std::make_shared<Acquisition>(*scan.acquisition) : std::make_shared<Acquisition>();
    const RobotKeys keys(recording.metadata());
    named->model = keys.text("lidar.model");
    named->firmware = keys.text("lidar.firmware");
    if (named->serial.empty()) named->serial = keys.text("lidar.serial");
    scanner::ColaStream stream;
    for (const RecordedMessage& message : recording.messages()) {
        if (message.topic != RecordingTopic::ColaRx || message.payload.size() > kLongestAnswer) continue;
        for (const scanner::ColaFrame& frame : stream.push(message.payload)) {
            if (scanner::isScanTelegram(frame.payload())) continue;
            const auto answer = scanner::parseAnswer(frame.payload(), frame.dialect);
            if (!answer) continue;
            if (answer->name == "DeviceIdent") {
                if (const auto identity = scanner::parseDeviceIdentity(*answer)) named->model = identity->name;
            } else if (answer->name == "FirmwareVersion") {
                if (const auto text = scanner::parseText(*answer)) named->firmware = *text;
            }
        }
    }
    scan.acquisition = std::move(named);
}

bool feedMessage(scanner::SweepFeed& feed, const RecordedMessage& message) {
    if (message.topic == RecordingTopic::ColaRx) return feed.frames(message.payload, message.logNs);
    if (message.topic != RecordingTopic::Stepper) return false;
    if (const auto reading = parseStepper(message.payload, message.logNs)) feed.assembler().push(*reading);
    return false;
}

namespace {

/// The user's word instead of a guess; over what a recording says itself it goes when the scan is opened.
void sayAssumed(scanner::SweepSettings& settings, const ReadingOptions& options) {
    if (options.axis) {
        if (settings.axisAssumed || settings.firstAssumed) settings.axis = *options.axis;
        settings.axisAssumed = false;
    }
    if (options.lineStepDeg) {
        if (settings.stepAssumed && settings.degPerLine) settings.degPerLine = options.lineStepDeg;
        settings.stepAssumed = false;
    }
    if (settings.firstAssumed && options.lineStartDeg) settings.firstLineDeg = *options.lineStartDeg;
    settings.firstAssumed = settings.firstAssumed && !options.lineStartDeg && (!options.axis || scanner::guessesFirst(settings));
}

} // namespace

Replay::Replay(std::shared_ptr<const Recording> recording, const ReadingOptions& options)
    : recording_(std::move(recording)), warnings_(recording_->warnings()), feed_(settings_) {
    scanner::SettingsFound found = scanner::settingsOf(recording_->metadata());
    settings_ = found.settings;
    sayAssumed(settings_, options);
    warnings_.insert(warnings_.end(), found.warnings.begin(), found.warnings.end());
    if (recording_->source() != nullptr) player_ = atBegin_ = recording_->source()->player(settings_, options);
    feed_ = scanner::SweepFeed(settings_);
    for (std::size_t i = 0; i < recording_->messages().size(); ++i) {
        if (isLine(recording_->messages()[i])) lineAt_.push_back(i);
    }
}

bool Replay::isLine(const RecordedMessage& message) const {
    if (message.topic == RecordingTopic::Bridge) return player_.has_value() && player_->isLine(message);
    return isScanTelegram(message);
}

std::int64_t Replay::timeNs(int line) const {
    if (lineAt_.empty()) return 0;
    const auto last = static_cast<int>(lineAt_.size()) - 1;
    return recording_->messages()[lineAt_[static_cast<std::size_t>(std::clamp(line, 0, last))]].logNs;
}

void Replay::playOne() {
    const std::size_t message = next_++;
    const RecordedMessage& played = recording_->messages()[message];
    if (played.topic != RecordingTopic::Bridge)
        feedMessage(feed_, played);
    else if (player_)
        player_->play(played, feed_.assembler());
    const auto line = static_cast<std::size_t>(position_);
    if (line < lineAt_.size() && lineAt_[line] == message) ++position_;
    if (atEnd()) feed_.assembler().finish();
}

bool Replay::step() {
    if (atEnd()) return false;
    seek(position_ + 1);
    return true;
}

void Replay::seek(int line) {
    if (line < position_) {
        feed_ = scanner::SweepFeed(settings_);
        player_ = atBegin_;
        next_ = 0;
        position_ = 0;
    }
    // The messages between this line and the next one (the stepper's report of it) belong to this line.
    const auto behind = static_cast<std::size_t>(std::max(line, 0));
    const std::size_t end = behind < lineAt_.size() ? lineAt_[behind] : recording_->messages().size();
    while (next_ < end) playOne();
}

Result<Scan> describedSweep(Scan sweep, const Recording& recording, const std::string& where, const ReadingOptions& options) {
    const scanner::SweepMetadata& metadata = recording.metadata();
    sweep.format = "recording";
    if (const auto note = metadata.find("note"); note != metadata.end()) sweep.note = note->second;
    if (recording.source() != nullptr) sweep.format = recording.source()->kind();
    if (metadata.contains(kMadeFromKey))
        sweep.acquisition.reset(); // telegrams made of another file: neither their times nor their sender are real
    else if (recording.source() == nullptr)
        nameScanner(sweep, recording);
    if (options.unitMm && *options.unitMm != sweep.unitMm)
        return Error{"--unit does not apply: the telegrams of a recording say their unit themselves", where, "leave --unit out"};
    auto whole = withRecordedGrid(std::move(sweep), metadata, where);
    if (!whole) return whole;
    if (options.axis) std::get<PolarGeometry>(whole->geometry).axis = *options.axis;
    if (auto placed = placeRecordedSweep(*whole, recording, options, where); !placed) return placed.error();
    return whole;
}

Result<Scan> scanOf(const std::shared_ptr<const Recording>& recording, const std::string& where, const ReadingOptions& options,
                    const LinePlayed& played) {
    Replay replay(recording, options);
    scanner::FinishedSweep best;
    int sweeps = 0;
    const auto collect = [&] {
        for (scanner::FinishedSweep& sweep : replay.feed().assembler().popFinished()) {
            const bool asked = options.scanIndex ? *options.scanIndex == static_cast<std::size_t>(sweeps)
                                                 : !best.scan || sweep.progress.received > best.progress.received;
            ++sweeps;
            if (asked) best = std::move(sweep);
        }
    };
    while (replay.step()) {
        collect();
        const int line = replay.position() - 1;
        if (played && line >= 0)
            played({line, replay.timeNs(line), line + 1 < replay.lines() ? replay.timeNs(line + 1) : 0, replay.progress()});
    }
    collect();
    const std::int64_t undecodable = replay.feed().undecodable();
    const scanner::TelegramAccount account = replay.progress().account;
    if (!best.scan && sweeps > 0)
        return noSuchScan(*options.scanIndex, static_cast<std::size_t>(sweeps), "the recording", "one sweep", "%1 sweeps");
    if (!best.scan) {
        const std::string why = replay.feed().whyUndecodable();
        return Error{account.telegrams > 0
                         ? withValues("the %1 scan telegrams in this recording hold no line of ranges", {account.telegrams})
                     : undecodable > 0 ? withValues("no scan telegram in this recording can be decoded%1", {why.empty() ? why : ": " + why})
                                       : withValues("this recording holds no scan telegram%1", {recording->whatWasLeftOut()}),
                     where, "choose another recording"};
    }
    Scan scan = *best.scan;
    scan.warnings.insert(scan.warnings.begin(), replay.warnings().begin(), replay.warnings().end());
    if (sweeps > 1 && !options.scanIndex) {
        scan.warnings.push_back(
            withValues("The recording holds %1 sweeps; sweep %2 was opened; no other has more lines.", {sweeps, best.progress.number + 1}));
    }
    if (undecodable > 0)
        scan.warnings.push_back(withValues("%1 scan telegrams could not be decoded: %2.", {undecodable, replay.feed().whyUndecodable()}));
    if (const std::int64_t torn = replay.feed().torn(); torn > 0)
        scan.warnings.push_back(counted(torn, "message holds bytes that are not a whole telegram: what was in it is lost.",
                                        "messages hold bytes that are not a whole telegram: what was in them is lost."));
    if (!recording->clean() && best.progress.expected == 0)
        scan.warnings.push_back(withValues("INCOMPLETE: %1 lines are there, how many there were is not known.", {best.progress.received}));
    return describedSweep(std::move(scan), *recording, where, options);
}

Result<Scan> readRecording(const Source& source) {
    const ByteView bytes = source.octets();
    const auto recording =
        Recording::fromBytes(Bytes(bytes.begin(), bytes.end()), source.path.string(), [&] { return source.goOn("reading", 0.0); });
    if (!recording) return recording.error();
    return scanOf(*recording, source.path.string(), *source.options, source.played);
}

} // namespace edgescan::files
