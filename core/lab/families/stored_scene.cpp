// Reads the arrays of NumPy from a ZIP archive.
#include "core/lab/families/stored_scene.h"

#include "core/base/whole_file.h"
#include "core/containers/compression/zip_archive.h"
#include "core/files/open_save/open_scan.h"
#include "core/sim/scene.h"

#include <algorithm>
#include <regex>
#include <vector>

namespace edgescan::lab {
namespace {

namespace fs = std::filesystem;

constexpr int kNotScoredCells = 2; // around a cell that is not scored: the tolerance of the score
constexpr int kFirstStone = 10;    // in `obj`

/// One array of the archive: whole numbers of one or two bytes, by line and beam.
Result<Grid<std::uint16_t>> wholeNumbers(std::span<const std::byte> archive, const std::vector<containers::ZipEntry>& entries,
                                         const std::string& name, const std::string& where) {
    const auto entry = std::ranges::find(entries, name + ".npy", &containers::ZipEntry::name);
    const Error missing{"the array \"" + name + "\" is missing or not of whole numbers by line and beam", where, "make the scene again"};
    if (entry == entries.end()) return missing;
    const auto bytes = containers::unzip(archive, *entry, where, [](double) { return true; });
    if (!bytes) return bytes.error();
    // The format of NumPy: magic, version 1.0, two bytes with the length of a header in Python's syntax, the numbers.
    constexpr std::size_t kBeforeHeader = 10;
    if (bytes->size() < kBeforeHeader || !textOf(*bytes).starts_with("\x93NUMPY\x01")) return missing;
    const auto at = [&bytes](std::size_t k) { return static_cast<std::size_t>((*bytes)[k]); };
    const std::size_t first = kBeforeHeader + at(8) + 256 * at(9);
    if (bytes->size() < first) return missing;
    static const std::regex header(
        R"(\{'descr': '[|<][bui]([12])', 'fortran_order': False, 'shape': \(([0-9]{1,6}), ([0-9]{1,6})\), \}\s*)");
    const std::string text(textOf(*bytes).substr(kBeforeHeader, first - kBeforeHeader));
    std::smatch found;
    if (!std::regex_match(text, found, header)) return missing;
    const std::size_t width = found[1] == "2" ? 2 : 1;
    const std::size_t cells = (bytes->size() - first) / width;
    const int lines = std::stoi(found[2]), beams = std::stoi(found[3]);
    if (cells != static_cast<std::size_t>(lines) * static_cast<std::size_t>(beams)) return missing;
    Grid<std::uint16_t> numbers(lines, beams);
    for (std::size_t k = 0; k < cells; ++k) {
        const std::size_t byte = first + width * k;
        numbers[k] = static_cast<std::uint16_t>(at(byte) + (width == 2 ? 256 * at(byte + 1) : 0));
    }
    return numbers;
}

// Sure edges are scored also next to cells that are not.
Grid<std::uint8_t> notScoredAround(const Grid<std::uint16_t>& cells, const Grid<std::uint8_t>& edgeClass) {
    Grid<std::uint8_t> ignore(cells.lines, cells.beams);
    for (int i = 0; i < cells.lines; ++i) {
        for (int j = 0; j < cells.beams; ++j) {
            if (cells.at(i, j) == 0) continue;
            for (int di = -kNotScoredCells; di <= kNotScoredCells; ++di) {
                for (int dj = -kNotScoredCells; dj <= kNotScoredCells; ++dj) {
                    const bool near = di * di + dj * dj <= kNotScoredCells * kNotScoredCells;
                    if (near && ignore.contains(i + di, j + dj) && edgeClass.at(i + di, j + dj) == 0) ignore.at(i + di, j + dj) = 255;
                }
            }
        }
    }
    return ignore;
}

} // namespace

Result<MadeScene> storedScene(const fs::path& folder) {
    Result<Scan> scan = files::openScan(folder / "scan.json");
    if (!scan) return scan.error();
    const std::string where = (folder / "scan.npz").string();
    const auto archive = readWholeFile(where);
    if (!archive) return archive.error();
    const auto entries = containers::zipEntries(*archive, where);
    if (!entries) return entries.error();
    std::vector<Grid<std::uint16_t>> arrays;
    for (const char* name : {"gt", "dc", "obj"}) {
        auto array = wholeNumbers(*archive, *entries, name, where);
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
