// Reads arrays out of NPZ files.
#include "core/lab/stones/npz.h"

#include "core/containers/compression/zip_archive.h"
#include "core/files/formats/numpy_header.h"

#include <algorithm>

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

/// The numbers of an array with three columns, row by row. @param kind f or i
Result<std::vector<double>> rowsOfThree(std::span<const std::byte> file, const std::string& array, char kind, const std::string& where) {
    const auto bytes = npyFile(file, array, where);
    if (!bytes) return bytes.error();
    files::Source source;
    source.bytes = *bytes;
    source.path = where;
    const auto numbers = files::readNumpy(source);
    if (!numbers) return numbers.error();
    const bool fits = numbers->fields.empty() && !numbers->fortranOrder && numbers->shape.size() == 2 && numbers->shape[1] == 3;
    if (!fits || numbers->scalar.kind != kind || !numbers->scalar.isNumber())
        return damaged(array, "is not a list of three numbers per row", where);
    std::vector<double> values(numbers->items());
    for (std::size_t n = 0; n < values.size(); ++n) values[n] = numbers->scalar.valueAt(numbers->data.data() + n * numbers->scalar.bytes);
    return values;
}

} // namespace

Result<std::vector<Eigen::Vector3f>> npzPoints(std::span<const std::byte> file, const std::string& array, const std::string& where) {
    const auto values = rowsOfThree(file, array, 'f', where);
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
    const auto values = rowsOfThree(file, array, 'i', where);
    if (!values) return values.error();
    std::vector<std::array<std::int32_t, 3>> triples(values->size() / 3);
    for (std::size_t n = 0; n < values->size(); ++n) {
        const double number = (*values)[n];
        if (number < 0 || number >= static_cast<double>(end)) return damaged(array, "names a point that is not there", where);
        triples[n / 3][n % 3] = static_cast<std::int32_t>(number);
    }
    return triples;
}

} // namespace edgescan::lab
