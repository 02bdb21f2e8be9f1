// Files of settled heaps.
#include "app/lab/stones/heap.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/whole_file.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace edgescan::lab {
namespace {

constexpr const char* kHeapFormat = "edgescan-settled-stones/1";

} // namespace

std::string heapFileName(const std::string& kind, const std::string& set, std::uint64_t seed) {
    return kind + "-" + set + "-" + std::to_string(seed) + ".json";
}

Result<Done> writeHeap(const Heap& heap, const std::filesystem::path& folder, const std::string& name) {
    if (auto made = makeFolder(folder); !made) return made;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const RestingStone& stone : heap)
        rows.push_back({{"stone", stone.stone},
                        {"size_m", stone.sizeM},
                        {"place_m", {stone.placeM.x(), stone.placeM.y(), stone.placeM.z()}},
                        {"turn_xyzw", {stone.turn.x(), stone.turn.y(), stone.turn.z(), stone.turn.w()}},
                        {"speed_mps", stone.speedMps}});
    const nlohmann::ordered_json json{{"format", kHeapFormat}, {"stones", std::move(rows)}};
    return writeWholeFile(folder / name, jsonText(json, 1) + "\n");
}

Result<Heap> readHeap(const std::filesystem::path& path) {
    const auto file = readWholeFile(path);
    if (!file) return file.error();
    const auto json = parseJsonObject(textOf(*file), kHeapFormat, path.string());
    if (!json) return json.error();
    JsonFields fields(*json, path.string(), "remove the file; then the stones settle again");
    static_cast<void>(fields.text("format"));
    Heap heap;
    for (JsonFields& row : fields.objects("stones")) {
        RestingStone stone;
        stone.stone = row.text("stone");
        stone.sizeM = row.neededNumber("size_m", {0.001, 1000});
        stone.placeM = row.neededVector("place_m");
        const std::vector<double> turn = row.numbers("turn_xyzw", 4, {-1.001, 1.001});
        if (turn.size() == 4) stone.turn = Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]);
        if (std::abs(stone.turn.norm() - 1) > 0.001)
            return Error{"the length of \"turn_xyzw\" is not 1", path.string(), "remove the file; then the stones settle again"};
        stone.speedMps = row.neededNumber("speed_mps");
        row.done();
        heap.push_back(std::move(stone));
    }
    fields.done();
    if (fields.problem()) return *fields.problem();
    return heap;
}

} // namespace edgescan::lab
