// Turns the arrays of another simulator into a scene with truth.
#include "app/lab/families/stored_scene.h"

#include "app/lab/sim/scene.h"
#include "app/lab/stones/creases.h"
#include "app/lab/stones/npz.h"
#include "core/base/whole_file.h"
#include "core/files/open_save/open_scan.h"

#include <utility>
#include <vector>

namespace edgescan::lab {
namespace {

namespace fs = std::filesystem;

constexpr int kNotScoredCells = 2; // around a cell that is not scored: the tolerance of the score
constexpr int kFirstStone = 10;    // in `obj`

// Sure edges are scored also next to cells that are not.
Grid<std::uint8_t> notScoredAround(const Grid<std::uint16_t>& cells, const Grid<std::uint8_t>& edgeClass) {
    Grid<std::uint8_t> notScored(cells.lines, cells.beams);
    for (std::size_t k = 0; k < cells.size(); ++k) notScored[k] = cells[k] != 0 ? 1 : 0;
    Grid<std::uint8_t> ignore = grown(std::move(notScored), kNotScoredCells);
    for (std::size_t k = 0; k < ignore.size(); ++k) ignore[k] = ignore[k] != 0 && edgeClass[k] == 0 ? 255 : 0;
    return ignore;
}

} // namespace

Result<MadeScene> storedScene(const fs::path& folder) {
    Result<Scan> scan = files::openScan(folder / "scan.json");
    if (!scan) return scan.error();
    const std::string where = (folder / "scan.npz").string();
    const auto archive = readWholeFile(where);
    if (!archive) return archive.error();
    std::vector<Grid<std::uint16_t>> arrays;
    for (const char* name : {"gt", "dc", "obj"}) {
        auto array = npzGrid(*archive, name, where);
        if (!array) return array.error();
        if (array->lines != scan->lines() || array->beams != scan->beams())
            return Error{std::string("the array \"") + name + "\" has another shape than the scan", where, "make the scene again"};
        arrays.push_back(std::move(*array));
    }
    sim::TruthSet truth;
    truth.edges.edgeClass = Grid<std::uint8_t>(scan->lines(), scan->beams());
    for (std::size_t k = 0; k < arrays[0].size(); ++k) {
        if (arrays[0][k] > static_cast<std::uint16_t>(sim::EdgeClass::Void))
            return Error{"the array \"gt\" has the class " + std::to_string(arrays[0][k]), where, "classes are 0 to 4"};
        truth.edges.edgeClass[k] = static_cast<std::uint8_t>(arrays[0][k]);
    }
    truth.edges.ignore = notScoredAround(arrays[1], truth.edges.edgeClass);
    truth.object = std::move(arrays[2]);
    for (std::uint16_t& object : truth.object.cells)
        object = static_cast<std::uint16_t>(object == 0            ? 0
                                            : object < kFirstStone ? sim::kWallObject
                                                                   : sim::kFirstRock + object - kFirstStone);
    return MadeScene{std::make_shared<const Scan>(std::move(*scan)), std::move(truth)};
}

} // namespace edgescan::lab
