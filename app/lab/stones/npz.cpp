// Reads arrays out of NPZ files.
#include "app/lab/stones/npz.h"

#include "core/base/whole_file.h"
#include "core/containers/compression/zip_archive.h"
#include "core/files/formats/numpy_header.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace edgescan::lab {
namespace {

Error damaged(const std::string& array, const std::string& what, const std::string& where) {
    return Error{"the array " + array + " " + what, where, "make the stones again"};
}

/// The bytes of an NPY file in the archive.
Result<std::vector<std::byte>> npyFile(std::span<const std::byte> file, const std::string& array, const std::string& where) {
    const auto entries = containers::zipEntries(file, where);
    if (!entries) return entries.error();
    const auto entry = std::ranges::find(*entries, array + ".npy", &containers::ZipEntry::name);
    if (entry == entries->end()) return damaged(array, "is missing", where);
    return containers::unzip(file, *entry, where, [](double) { return true; });
}

/// An array with two sides, row by row.
struct Table {
    int rows = 0, columns = 0;
    std::vector<double> values;
};

/// @param kinds of its numbers: f floating point, i and u whole; true and false are whole numbers of one byte
Result<Table> tableOf(std::span<const std::byte> file, const std::string& array, std::string_view kinds, const std::string& where) {
    auto bytes = npyFile(file, array, where);
    if (!bytes) return bytes.error();
    constexpr std::size_t kHeader = 128;
    constexpr std::string_view kTruth = "'|b1'";
    if (const std::size_t at = textOf(*bytes).substr(0, kHeader).find(kTruth); at != std::string_view::npos)
        (*bytes)[at + kTruth.find('b')] = std::byte{'u'};
    files::Source source;
    source.bytes = *bytes;
    source.path = where;
    const auto numbers = files::readNumpy(source);
    if (!numbers) return numbers.error();
    const bool fits = numbers->fields.empty() && !numbers->fortranOrder && numbers->shape.size() == 2;
    if (!fits || kinds.find(numbers->scalar.kind) == std::string_view::npos || !numbers->scalar.isNumber())
        return damaged(array, "does not have the numbers and the two sides that it should have", where);
    Table table{static_cast<int>(numbers->shape[0]), static_cast<int>(numbers->shape[1]), std::vector<double>(numbers->items())};
    for (std::size_t n = 0; n < table.values.size(); ++n)
        table.values[n] = numbers->scalar.valueAt(numbers->data.data() + n * numbers->scalar.bytes);
    return table;
}

/// The numbers of an array with three columns.
Result<std::vector<double>> rowsOfThree(std::span<const std::byte> file, const std::string& array, std::string_view kinds,
                                        const std::string& where) {
    Result<Table> table = tableOf(file, array, kinds, where);
    if (!table) return table.error();
    if (table->columns != 3) return damaged(array, "is not a list of three numbers per row", where);
    return std::move(table->values);
}

} // namespace

Result<std::vector<Eigen::Vector3f>> npzPoints(std::span<const std::byte> file, const std::string& array, const std::string& where) {
    const auto values = rowsOfThree(file, array, "f", where);
    if (!values) return values.error();
    std::vector<Eigen::Vector3f> points(values->size() / 3);
    for (std::size_t n = 0; n < points.size(); ++n) {
        points[n] = Eigen::Map<const Eigen::Vector3d>(values->data() + 3 * n).cast<float>();
        if (!points[n].allFinite()) return damaged(array, "holds a number that is not finite", where);
    }
    return points;
}

Result<std::vector<std::array<std::int32_t, 3>>> npzTriples(std::span<const std::byte> file, const std::string& array, std::size_t end,
                                                            const std::string& where) {
    const auto values = rowsOfThree(file, array, "i", where);
    if (!values) return values.error();
    std::vector<std::array<std::int32_t, 3>> triples(values->size() / 3);
    for (std::size_t n = 0; n < values->size(); ++n) {
        const double number = (*values)[n];
        if (number < 0 || number >= static_cast<double>(end)) return damaged(array, "names a point that is not there", where);
        triples[n / 3][n % 3] = static_cast<std::int32_t>(number);
    }
    return triples;
}

Result<Grid<std::uint16_t>> npzGrid(std::span<const std::byte> file, const std::string& array, const std::string& where) {
    const Result<Table> table = tableOf(file, array, "iu", where);
    if (!table) return table.error();
    Grid<std::uint16_t> grid(table->rows, table->columns);
    for (std::size_t k = 0; k < grid.size(); ++k) {
        if (table->values[k] < 0 || table->values[k] > 65535) return damaged(array, "holds a number that is not 0 to 65535", where);
        grid[k] = static_cast<std::uint16_t>(table->values[k]);
    }
    return grid;
}

} // namespace edgescan::lab
