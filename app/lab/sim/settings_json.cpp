// The settings of a simulation as JSON.
#include "app/lab/sim/settings_json.h"

#include "app/lab/sim/scenes.h"

#include <nlohmann/json.hpp>

namespace edgescan::sim {
namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(WallHole hole) {
    switch (hole) {
    case WallHole::Round:
        return "round";
    case WallHole::Square:
        return "square";
    default:
        return "none";
    }
}

Json holesJson(const SimulationSettings& s) {
    Json centres = Json::array();
    const auto holes = sim::wallHoles({s.distanceM, s.hole, s.holes, s.holeM}, s.seed);
    if (!holes) return centres;
    for (const Eigen::Vector2d& hole : *holes) centres.push_back({hole.x(), hole.y()});
    return centres;
}

Json treadsJson(const SimulationSettings& s) {
    Json treads = Json::array();
    std::uint16_t object = sim::kFirstRock;
    for (const sim::StaircaseTread& tread : sim::staircaseTreads(s.distanceM))
        treads.push_back({{"object", object++},
                          {"from_x_m", tread.fromXM},
                          {"to_x_m", tread.toXM},
                          {"front_m", tread.frontM},
                          {"step_mm", tread.stepMm}});
    return treads;
}

} // namespace

Json settingsJson(const SimulationSettings& s) {
    Json json{{"scene", s.scene},
              {"seed", s.seed},
              {"sweep_number", s.repeat},
              {"after_blast", s.afterBlast},
              {"lines", s.lines},
              {"beams", s.beams},
              {"axis", s.axis == Axis::Sweep ? "sweep" : "spin"},
              {"profile", s.profile == DeviceProfile::HighResolution ? "high" : "standard"},
              {"rock_count", s.rocks},
              {"rock_roughness_mm", s.rockRoughnessMm},
              {"rock_rounding", s.rockRounding},
              {"rock_size", s.rockSize},
              {"rock_lumps_mm", s.rockLumpsMm},
              {"rock_lump_m", s.rockLumpM},
              {"wall_kind", s.wallKind},
              {"wall_roughness_mm", wallRoughnessMmOf(s)},
              {"absorbing_patches", s.absorbingPatches},
              {"distance_m", s.distanceM},
              {"hole_shape", nameOf(s.hole)},
              {"hole_count", s.holes},
              {"hole_m", s.holeM},
              {"noise", s.noise},
              {"dropouts", s.dropouts},
              {"dust", s.dust},
              {"footprint", s.footprint},
              {"mixed_pixels", s.mixedPixels},
              {"echo_loss", s.echoLoss},
              {"range_step_mm", s.rangeStepMm},
              {"max_range_m", s.maxRangeM},
              {"line_jitter_deg", s.lineJitterDeg},
              {"interlace_deg", s.interlaceDeg},
              {"motor_skew_deg", s.motorSkewDeg},
              {"slips", s.slips},
              {"turn_deg", s.turnDeg},
              {"mount_t1_mm", s.assembly.t1Mm()},
              {"mount_t2_mm", s.assembly.t2Mm()},
              {"mount_tilt_deg", s.assembly.tiltDeg()},
              {"mount_index_deg", s.assembly.indexDeg()},
              {"turn_error_deg", s.assembly.turnDeg()},
              {"zero_jump_deg", s.zeroJumpDeg},
              {"status_codes", s.statusCodes},
              {"surface", s.surfaceFile.empty() ? Json(nullptr) : Json(s.surfaceFile)},
              {"surface_scale", s.surfaceScale},
              {"surface_points", s.surface.size()}};
    if (s.scene == "wall") json["hole_centres_m"] = holesJson(s);
    if (s.scene == "staircase") json["treads"] = treadsJson(s);
    return json;
}

} // namespace edgescan::sim
