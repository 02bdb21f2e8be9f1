// A transform is twelve numbers: the three rows of the rotation, then the translation.
#include "core/scan/georef/placement_json.h"
#include "core/base/translated_text.h"

#include "core/base/json_fields.h"
#include "core/scan/georef/rotations.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <optional>

namespace edgescan {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRotationTolerance = 1e-5;
constexpr const char* kPlacementHint = "save the scan again, or remove \"placement\"";

Json transformJson(const RigidTransform& t) {
    Json numbers = Json::array();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) numbers.push_back(t.rotation(i, j));
    }
    for (int i = 0; i < 3; ++i) numbers.push_back(t.translationM[i]);
    return numbers;
}

RigidTransform transformOf(const std::vector<double>& numbers) {
    RigidTransform t;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) t.rotation(i, j) = numbers[static_cast<std::size_t>(3 * i + j)];
        t.translationM[i] = numbers[static_cast<std::size_t>(9 + i)];
    }
    return t;
}

bool isTransform(const nlohmann::json& value) {
    if (!value.is_array() || value.size() != 12) return false;
    std::vector<double> numbers;
    for (const auto& item : value) {
        if (!item.is_number() || !physical::kPlaceM.hold(item.get<double>())) return false;
        numbers.push_back(item.get<double>());
    }
    return rotationError(transformOf(numbers).rotation) < kRotationTolerance;
}

std::optional<Boom> boomFrom(JsonFields& fields) {
    if (!fields.has("boom")) return std::nullopt;
    JsonFields object = fields.object("boom");
    const Boom boom{object.neededVector("pivot_m", physical::kPlaceM.limits), object.neededVector("head_m", physical::kPlaceM.limits)};
    if (boom.pivotM == boom.headM) object.refuse("head_m", "must not be where the pivot is");
    object.done();
    return boom;
}

} // namespace

Json placementToJson(const Placement& p) {
    Json poses = Json::array();
    for (const RigidTransform& pose : p.poses) poses.push_back(transformJson(pose));
    Json object{{"origin_enh_m", {p.originEnhM.x(), p.originEnhM.y(), p.originEnhM.z()}},
                {"grid_scale", p.gridScale},
                {"grid", p.grid},
                {"source", p.source},
                {"robot", p.robot},
                {"scan_start", p.scanStartUtc},
                {"scan_end", p.scanEndUtc},
                {"time", p.timeUtc},
                {"age_s", std::isfinite(p.ageSeconds) ? Json(p.ageSeconds) : Json()},
                {"out_of_spec", p.outOfSpec},
                {"warnings", p.warnings},
                {"stepper",
                 {{"mover_from_sensor", transformJson(p.mount.sensorInMover)},
                  {"axis", {p.mount.axis.x(), p.mount.axis.y(), p.mount.axis.z()}},
                  {"zero_deg", p.mount.zeroDeg},
                  {"direction", p.mount.direction}}}};
    if (p.boom) {
        object["boom"] = {{"pivot_m", {p.boom->pivotM.x(), p.boom->pivotM.y(), p.boom->pivotM.z()}},
                          {"head_m", {p.boom->headM.x(), p.boom->headM.y(), p.boom->headM.z()}}};
    }
    object["poses"] = std::move(poses);
    return object;
}

Result<std::shared_ptr<const Placement>> placementFromJson(const nlohmann::json& object, std::uint64_t lines, const std::string& where) {
    if (!object.is_object()) return Error{"\"placement\" must be an object {...}", where, kPlacementHint};
    auto placement = std::make_shared<Placement>();
    Placement& p = *placement;
    JsonFields fields(object, where, kPlacementHint);
    p.originEnhM = fields.neededVector("origin_enh_m", physical::kPlaceM.limits);
    p.gridScale = fields.number("grid_scale", 1.0, physical::kGridScale.limits);
    p.grid = fields.text("grid");
    p.source = fields.text("source");
    p.robot = fields.text("robot");
    p.scanStartUtc = fields.text("scan_start");
    p.scanEndUtc = fields.text("scan_end");
    p.timeUtc = fields.text("time");
    p.ageSeconds = fields.number("age_s", std::numeric_limits<double>::quiet_NaN());
    p.outOfSpec = fields.boolean("out_of_spec", false);
    p.warnings = fields.texts("warnings");
    JsonFields stepper = fields.object("stepper");
    if (const nlohmann::json& mount = stepper.value("mover_from_sensor"); isTransform(mount))
        p.mount.sensorInMover = transformOf(mount.get<std::vector<double>>());
    else
        stepper.refuse("mover_from_sensor", "must be a rotation and a translation, twelve numbers");
    p.mount.axis = stepper.neededVector("axis", {-1e3, 1e3});
    if (!(p.mount.axis.norm() > 1e-6)) stepper.refuse("axis", "has no direction");
    p.mount.zeroDeg = stepper.neededNumber("zero_deg", physical::kLineDeg.limits);
    p.mount.direction = stepper.neededNumber("direction");
    if (std::abs(p.mount.direction) != 1.0) stepper.refuse("direction", "must be 1 or -1");
    stepper.done();
    p.boom = boomFrom(fields);
    const nlohmann::json& poses = fields.value("poses");
    const std::size_t count = poses.is_array() ? poses.size() : 0;
    if (count != 1 && count != lines) fields.refuse("poses", withValues("must hold one pose or %1, one per line", {lines}));
    p.poses.clear();
    for (std::size_t i = 0; i < count && !fields.problem(); ++i) {
        const nlohmann::json& pose = poses[i];
        if (!isTransform(pose))
            fields.refuse("poses", "must hold rotations and translations, twelve numbers each");
        else
            p.poses.push_back(transformOf(pose.get<std::vector<double>>()));
    }
    fields.done();
    if (fields.problem()) return *fields.problem();
    return std::shared_ptr<const Placement>(placement);
}

} // namespace edgescan
