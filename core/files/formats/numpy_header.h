// The header of an array that numpy saved (numpy.lib.format): a Python dictionary of type, order and shape.
#pragma once

#include "core/files/point_tables/binary_field.h"
#include "core/files/point_tables/source.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

/// How one number is stored.
struct NumpyScalar {
    char kind = 'f';       ///< i, u, f; others ("O", "c", "b", "U" ...) are not ranges
    std::size_t bytes = 0; ///< of one
    bool bigEndian = false;

    /// Empty for what no machine number is, and for halves, which have two bytes and are read on their own.
    [[nodiscard]] std::optional<Scalar> scalar() const;
    [[nodiscard]] bool isHalf() const { return kind == 'f' && bytes == 2; }
    [[nodiscard]] bool isNumber() const { return isHalf() || scalar().has_value(); }
    /// The number at `at`; isNumber() and the bytes are there.
    [[nodiscard]] double valueAt(const std::byte* at) const;
};

struct NumpyField {
    std::string name;
    NumpyScalar scalar;
    std::size_t offset = 0; ///< in a record
};

struct NumpyArray {
    NumpyScalar scalar;             ///< of an array of plain numbers
    std::vector<NumpyField> fields; ///< of an array of records; empty for plain numbers
    std::size_t itemBytes = 0;
    bool fortranOrder = false; ///< the first index runs fastest
    std::vector<std::uint64_t> shape;
    std::span<const std::byte> data; ///< exactly the items that the shape promises
    std::span<const std::byte> rest; ///< what follows them

    [[nodiscard]] std::uint64_t items() const;
    /// "(1000, 1141)"
    [[nodiscard]] std::string shapeText() const;
};

[[nodiscard]] bool isNumpy(std::span<const std::byte> bytes);

/// Error: damaged, cut off, or of things that are not numbers (Python objects, text ...).
Result<NumpyArray> readNumpy(const Source& source);

} // namespace edgescan::files
