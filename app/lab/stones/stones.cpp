// Reads scanned stones.
#include "app/lab/stones/stones.h"

#include "app/lab/stones/npz.h"
#include "core/base/bounded_json.h"
#include "core/base/json_fields.h"
#include "core/base/whole_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

namespace edgescan::lab {
namespace {

Result<Stone> readStone(Stone stone, const std::filesystem::path& path) {
    const auto file = readWholeFile(path);
    if (!file) return file.error();
    auto points = npzPoints(*file, "V", path.string());
    if (!points) return points.error();
    auto triangles = npzTriples(*file, "F", points->size(), path.string());
    if (!triangles) return triangles.error();
    auto hull = npzPoints(*file, "hull", path.string());
    if (!hull) return hull.error();
    if (triangles->empty() || hull->empty()) return Error{"the stone has no surface", path.string(), "make the stones again"};
    stone.mesh = std::make_shared<const sim::StoredMesh>(std::move(*points), std::move(*triangles));
    stone.hull = std::move(*hull);
    return stone;
}

Result<std::vector<Stone>> tableOf(const std::filesystem::path& path, const std::string& set) {
    const auto file = readWholeFile(path);
    if (!file) return file.error();
    const auto rows = parseJson(textOf(*file), path.string());
    if (!rows) return rows.error();
    std::vector<Stone> stones;
    for (const nlohmann::json& row : *rows) {
        if (!row.is_object() || !row.contains("name") || !row["name"].is_string() || !row.contains("edge") || !row["edge"].is_number())
            return Error{"a row is not a stone with a name and an edge", path.string(), "make the stones again"};
        const std::string name = row["name"];
        if (isInSet(name, set)) stones.push_back({name, row["edge"].get<double>(), nullptr, {}});
    }
    if (stones.empty()) return Error{"no stone of the set " + set, path.string(), "choose another set, or another folder"};
    return stones;
}

} // namespace

const Stone* Stones::named(std::string_view name) const {
    const auto found = std::ranges::find(stones, name, &Stone::name);
    return found == stones.end() ? nullptr : &*found;
}

const std::vector<std::string>& stoneSets() {
    static const std::vector<std::string> sets{"free", "lab", "all"};
    return sets;
}

bool isInSet(std::string_view stone, std::string_view set) {
    const bool lab = stone.starts_with("epfl") || stone.starts_with("savaas");
    return set == "all" || (set == "lab" ? lab : !lab);
}

Result<Stones> readStones(const std::filesystem::path& folder, const std::string& set, int threads) {
    if (std::ranges::find(stoneSets(), set) == stoneSets().end())
        return Error{"there is no set \"" + set + "\"", "stones", "use free, lab or all"};
    auto table = tableOf(folder / "rocks.json", set);
    if (!table) return table.error();
    std::atomic<std::size_t> next{0};
    std::vector<std::optional<Error>> errors(table->size());
    const auto share = [&] {
        for (std::size_t n = next++; n < table->size(); n = next++) {
            auto stone = readStone((*table)[n], folder / ((*table)[n].name + ".npz"));
            if (stone)
                (*table)[n] = std::move(*stone);
            else
                errors[n] = stone.error();
        }
    };
    {
        const unsigned cores = threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
        std::vector<std::jthread> others;
        for (unsigned t = 1; t < cores; ++t) others.emplace_back(share);
        share();
    }
    for (const std::optional<Error>& error : errors) {
        if (error) return *error;
    }
    return Stones{std::move(*table)};
}

} // namespace edgescan::lab
