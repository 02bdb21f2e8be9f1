// The table of families, and the draw of their scenes.
#include "app/lab/families/families.h"

#include "app/lab/families/scene_sources.h"
#include "core/base/sha256.h"

#include <algorithm>

namespace edgescan::lab {
namespace {

using Settings = sim::SimulationSettings;

FamilyVariant rescanAt(const char* name, double scale, double distanceM) {
    return {name, [=](Settings& s) { s.surfaceScale = scale, s.distanceM = distanceM; }};
}
FamilyVariant wallAt(const char* name, double distanceM, sim::WallHole hole) {
    return {name, [=](Settings& s) { s.distanceM = distanceM, s.hole = hole; }};
}
FamilyVariant stairsAt(const char* name, double distanceM, Axis axis) {
    return {name, [=](Settings& s) { s.distanceM = distanceM, s.axis = axis; }};
}
FamilyVariant spinOf(const char* scene) {
    return {scene, [=](Settings& s) { s.scene = scene, s.axis = Axis::Spin; }};
}

std::vector<Family> allFamilies() {
    constexpr sim::WallHole kNone = sim::WallHole::None, kRound = sim::WallHole::Round;
    return {
        {.name = "real hangup", .source = &kRealStones, .kind = "hangup", .small = 1},
        {.name = "real bench", .source = &kRealStones, .kind = "bench", .small = 1},
        {.name = "real pile", .source = &kRealStones, .kind = "pile", .small = 1},
        {.name = "real hangup x3", .source = &kRealStones, .kind = "hangup", .noise = 3},
        {.name = "real bench x3", .source = &kRealStones, .kind = "bench", .noise = 3},
        {.name = "real pile x3", .source = &kRealStones, .kind = "pile", .noise = 3},
        {.name = "real hangup full", .source = &kRealStones, .kind = "hangup", .full = true},
        {.name = "real bench full", .source = &kRealStones, .kind = "bench", .full = true},
        {.name = "real pile full", .source = &kRealStones, .kind = "pile", .full = true},
        {.name = "polar", .source = &kPolar, .kind = "polar", .small = 1},
        {.name = "rescan", .source = &kRescans, .kind = "rescan", .variants = {rescanAt("4", 4, 4.5), rescanAt("2.5", 2.5, 4)}},
        {.name = "kinect", .source = &kKinect, .kind = "kinect"},
        {.name = "hangup", .source = &kSimulator, .kind = "hangup", .small = 2},
        {.name = "pile", .source = &kSimulator, .kind = "pile", .small = 2},
        {.name = "hangup x3", .source = &kSimulator, .kind = "hangup", .noise = 3, .small = 1},
        {.name = "pile x3", .source = &kSimulator, .kind = "pile", .noise = 3, .small = 1},
        {.name = "spin", .source = &kSimulator, .kind = "hangup", .small = 1, .variants = {spinOf("hangup"), spinOf("pile")}},
        {.name = "hangup full", .source = &kSimulator, .kind = "hangup", .full = true},
        {.name = "pile full", .source = &kSimulator, .kind = "pile", .full = true},
        {.name = "staircase",
         .source = &kSimulator,
         .kind = "staircase",
         .small = 1,
         .variants = {stairsAt("4 m", 4, Axis::Sweep), stairsAt("8 m", 8, Axis::Spin), stairsAt("3 m", 3, Axis::Spin),
                      stairsAt("6 m", 6, Axis::Sweep), stairsAt("10 m", 10, Axis::Sweep)}},
        {.name = "walls",
         .source = &kSimulator,
         .kind = "wall",
         .measure = Measure::FalseCells,
         .variants = {wallAt("3 m", 3, kNone), wallAt("6 m", 6, kNone), wallAt("10 m", 10, kNone), wallAt("15 m", 15, kNone),
                      wallAt("3 m, hole", 3, kRound), wallAt("6 m, hole", 6, kRound), wallAt("10 m, hole", 10, kRound),
                      wallAt("15 m, hole", 15, kRound)}},
        {.name = "corridors", .source = &kCorridors, .kind = "corridor", .measure = Measure::Counts},
    };
}

SceneOrder freshScene(const Family& family, const SceneDraw& draw, std::size_t n) {
    SceneOrder order;
    // The heaps of one kind are the same with any noise and grid, because stones take long to settle.
    order.seed = drawnSeed(draw.text, family.source == &kRealStones ? std::string("real ") + family.kind : family.name, n);
    order.variant = family.variants.empty() ? 0 : n % family.variants.size();
    order.name = family.name;
    if (!family.variants.empty()) order.name += std::string(", ") + family.variants[order.variant].name;
    order.name += " " + std::to_string(order.seed);
    return order;
}

} // namespace

std::span<const Family> families() {
    static const std::vector<Family> all = allFamilies();
    return all;
}

bool hasViews(const Family& family) { return family.source == &kRealStones; }

const Family* findFamily(const std::string& name) {
    const auto found = std::ranges::find_if(families(), [&name](const Family& family) { return family.name == name; });
    return found == families().end() ? nullptr : &*found;
}

std::uint64_t drawnSeed(const std::string& draw, const std::string& family, std::size_t scene) {
    constexpr std::size_t kDigits = 12; // 2^48 is below 10^15
    const std::string text = draw + "\n" + family + "\n" + std::to_string(scene);
    return std::stoull(sha256Hex(std::as_bytes(std::span(text))).substr(0, kDigits), nullptr, 16);
}

Result<std::vector<SceneOrder>> drawnScenes(const Family& family, const SceneDraw& draw, const FamilyPlaces& places) {
    std::vector<SceneOrder> orders;
    const bool hasStored = family.source->stored != nullptr;
    const std::size_t variants = std::max<std::size_t>(1, family.variants.size());
    const std::size_t whole = draw.fresh == 1 ? 1 : (draw.fresh + variants - 1) / variants * variants; // as many of each variant
    const std::size_t fresh = draw.small ? family.small : whole;
    Result<Done> ready = family.source->ready == nullptr
                             ? Error{family.source->without, places.shared.string(), "name the folder with --shared"}
                             : family.source->ready(family, places);
    for (std::size_t n = 0; ready && !(draw.small && hasStored) && n < fresh; ++n) orders.push_back(freshScene(family, draw, n));
    // Scenes that were known before judge only where there are no others.
    if (hasStored && orders.empty()) {
        for (const std::filesystem::path& file : family.source->stored(family, places)) {
            if (draw.small && orders.size() >= family.small) break;
            orders.push_back({std::string(family.name) + " " + file.filename().string(), 0, 0, file});
        }
    }
    if (!orders.empty()) return orders;
    return ready ? Error{family.source->without, places.shared.string(), "name the folder with --shared"} : ready.error();
}

Result<MadeScene> makeScene(const Family& family, const SceneOrder& order, const FamilyPlaces& places, const GoOn& goOn) {
    return family.source->make(family, order, places, goOn);
}

} // namespace edgescan::lab
