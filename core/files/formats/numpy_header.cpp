// Reads the little of Python's syntax that numpy writes into headers.
#include "core/files/formats/numpy_header.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/files/point_tables/point_columns.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace edgescan::files {
namespace {

using namespace std::string_view_literals;
constexpr std::string_view kNumpyMagic = "\x93NUMPY"sv;
constexpr std::uint64_t kLongestNumpyHeader = 1U << 20U;
constexpr std::uint64_t kMostItems = std::uint64_t{1} << 31U; // two of them multiplied still fit 64 bits

/// Words, texts, numbers and signs of a Python literal, one after the other.
class Literal {
public:
    explicit Literal(std::string_view text) : text_(text) { skip(); }

    /// Takes the sign when it comes next.
    bool sign(char wanted) {
        if (text_.empty() || text_.front() != wanted) return false;
        text_.remove_prefix(1);
        skip();
        return true;
    }
    std::optional<std::string> quoted() {
        if (text_.empty() || (text_.front() != '\'' && text_.front() != '"')) return std::nullopt;
        const std::size_t end = text_.find(text_.front(), 1);
        if (end == std::string_view::npos) return std::nullopt;
        std::string found(text_.substr(1, end - 1));
        text_.remove_prefix(end + 1);
        skip();
        return found;
    }
    std::optional<std::uint64_t> whole() {
        std::uint64_t value = 0;
        const auto [end, problem] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        if (problem != std::errc{}) return std::nullopt;
        text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
        if (!text_.empty() && text_.front() == 'L') text_.remove_prefix(1); // Python 2
        skip();
        return value;
    }
    std::optional<bool> boolean() {
        for (const bool value : {false, true}) {
            const std::string_view word = value ? "True" : "False";
            if (!text_.starts_with(word)) continue;
            text_.remove_prefix(word.size());
            skip();
            return value;
        }
        return std::nullopt;
    }
    /// "(3, 4)", "(3,)", "()".
    std::optional<std::vector<std::uint64_t>> numbers() {
        std::vector<std::uint64_t> found;
        if (!sign('(')) return std::nullopt;
        while (!sign(')')) {
            const auto value = whole();
            if (!value) return std::nullopt;
            found.push_back(*value);
            if (!sign(',') && !text_.starts_with(')')) return std::nullopt;
        }
        return found;
    }
    [[nodiscard]] bool next(char c) const { return text_.starts_with(c); }

private:
    void skip() { text_.remove_prefix(std::min(text_.find_first_not_of(" \t\r\n"), text_.size())); }

    std::string_view text_;
};

/// "<f8", "|u1", ">i2"; any other kind stays as its letter.
std::optional<NumpyScalar> numpyScalarNamed(std::string_view text) {
    NumpyScalar scalar;
    if (text.size() < 2) return std::nullopt;
    scalar.bigEndian = text.front() == '>';
    if ("<>|="sv.find(text.front()) != std::string_view::npos) text.remove_prefix(1);
    if (text.empty()) return std::nullopt;
    scalar.kind = text.front();
    const char* const end = text.data() + text.size();
    std::from_chars(text.data() + 1, end, scalar.bytes);
    constexpr std::size_t kLargestItem = 1U << 20U;
    return scalar.bytes <= kLargestItem ? std::optional(scalar) : std::nullopt;
}

/// [('x', '<f4'), ('rgb', '<u4'), ('n', '<f4', (3,))]; a field of several numbers is named n[0], n[1] ...
bool parseRecord(Literal& literal, NumpyArray& array) {
    constexpr std::size_t kMostFields = 4096;
    if (!literal.sign('[')) return false;
    while (!literal.sign(']')) {
        if (!literal.sign('(')) return false;
        auto name = literal.quoted();
        if (!name && literal.sign('(')) { // (title, name)
            (void)literal.quoted();
            if (!literal.sign(',')) return false;
            name = literal.quoted();
            if (!literal.sign(')')) return false;
        }
        if (!name || !literal.sign(',')) return false;
        const auto type = literal.quoted();
        const auto scalar = type ? numpyScalarNamed(*type) : std::nullopt;
        if (!scalar) return false;
        std::uint64_t count = 1;
        bool several = false;
        if (literal.sign(',') && literal.next('(')) {
            const auto shape = literal.numbers();
            if (!shape) return false;
            several = true;
            for (const std::uint64_t side : *shape)
                count = side > kMostFields ? kMostFields + 1 : std::min<std::uint64_t>(count * side, kMostFields + 1);
        }
        if (!literal.sign(')') || array.fields.size() + count > kMostFields) return false;
        const std::size_t bytes = scalar->kind == 'U' ? 4 * scalar->bytes : scalar->bytes;
        for (std::uint64_t n = 0; n < count; ++n) {
            array.fields.push_back({several ? *name + "[" + std::to_string(n) + "]" : *name, *scalar, array.itemBytes});
            array.itemBytes += bytes;
        }
        if (!literal.sign(',') && !literal.next(']')) return false;
    }
    return !array.fields.empty();
}

bool parseDictionary(std::string_view text, NumpyArray& array) {
    Literal literal(text);
    bool type = false, order = false, shape = false;
    if (!literal.sign('{')) return false;
    while (!literal.sign('}')) {
        const auto key = literal.quoted();
        if (!key || !literal.sign(':')) return false;
        if (*key == "descr" && !type) {
            if (literal.next('[')) {
                type = parseRecord(literal, array);
            } else if (const auto name = literal.quoted()) {
                const auto scalar = numpyScalarNamed(*name);
                type = scalar.has_value();
                if (scalar) array.scalar = *scalar;
                array.itemBytes = array.scalar.bytes;
            }
            if (!type) return false;
        } else if (*key == "fortran_order" && !order) {
            const auto value = literal.boolean();
            order = value.has_value();
            if (!order) return false;
            array.fortranOrder = *value;
        } else if (*key == "shape" && !shape) {
            auto sides = literal.numbers();
            shape = sides.has_value();
            if (!shape) return false;
            array.shape = std::move(*sides);
        } else {
            return false;
        }
        if (!literal.sign(',') && !literal.next('}')) return false;
    }
    return type && order && shape;
}

/// What cannot be read as numbers, in words.
std::string notNumbers(const NumpyScalar& scalar) {
    switch (scalar.kind) {
    case 'O':
        return "Python objects, which only Python can open";
    case 'b':
        return "true and false";
    case 'c':
        return "complex numbers";
    case 'U':
    case 'S':
    case 'a':
        return "texts";
    case 'M':
    case 'm':
        return "dates or times";
    default:
        return withValues("values of type %1", {scalar.kind + std::to_string(scalar.bytes)});
    }
}

double halfAt(const std::byte* at, bool bigEndian) {
    const unsigned low = std::to_integer<unsigned>(at[bigEndian ? 1 : 0]);
    const unsigned half = std::to_integer<unsigned>(at[bigEndian ? 0 : 1]) << 8U | low;
    const unsigned exponent = half >> 10U & 31U;
    const double fraction = static_cast<double>(half & 1023U) / 1024;
    double value = exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1 + fraction, static_cast<int>(exponent) - 15);
    if (exponent == 31) value = fraction == 0 ? HUGE_VAL : std::nan("");
    return (half & 0x8000U) != 0 ? -value : value;
}

} // namespace

std::optional<Scalar> NumpyScalar::scalar() const {
    const auto sized = [&](Scalar one, Scalar two, Scalar four, Scalar eight) -> std::optional<Scalar> {
        return bytes == 1   ? std::optional(one)
               : bytes == 2 ? std::optional(two)
               : bytes == 4 ? std::optional(four)
               : bytes == 8 ? std::optional(eight)
                            : std::nullopt;
    };
    if (kind == 'i') return sized(Scalar::Int8, Scalar::Int16, Scalar::Int32, Scalar::Int64);
    if (kind == 'u') return sized(Scalar::UInt8, Scalar::UInt16, Scalar::UInt32, Scalar::UInt64);
    if (kind == 'f' && bytes == 4) return Scalar::Float32;
    if (kind == 'f' && bytes == 8) return Scalar::Float64;
    return std::nullopt;
}

double NumpyScalar::valueAt(const std::byte* at) const { return isHalf() ? halfAt(at, bigEndian) : readScalar(*scalar(), at, bigEndian); }

std::uint64_t NumpyArray::items() const {
    std::uint64_t count = 1;
    for (const std::uint64_t side : shape) count *= side; // bounded where the header was read
    return count;
}

std::string NumpyArray::shapeText() const {
    std::string text = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
    return text + (shape.size() == 1 ? ",)" : ")");
}

bool isNumpy(std::span<const std::byte> bytes) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).starts_with(kNumpyMagic);
}

Result<NumpyArray> readNumpy(const Source& source) {
    constexpr const char* kSaveAgain = "save the array again with numpy.save";
    const std::string_view text = source.text();
    if (text.size() < 10) return source.refused("the file ends within its numpy header", kCopyAgain);
    const auto byte = [&](std::size_t at) { return std::uint64_t{static_cast<std::uint8_t>(text[at])}; };
    const bool wide = byte(6) >= 2; // version 1 has two bytes for the length, later ones four
    const std::size_t from = wide ? 12 : 10;
    if (byte(6) < 1 || byte(6) > 3) return source.refused(withValues("this is version %1 of numpy's format", {byte(6)}), kSaveAgain);
    const std::uint64_t length =
        text.size() < from ? kLongestNumpyHeader : byte(8) | byte(9) << 8U | (wide ? byte(10) << 16U | byte(11) << 24U : 0);
    if (length >= kLongestNumpyHeader || text.size() - from < length)
        return source.refused("the file ends within its numpy header", kCopyAgain);
    NumpyArray array;
    if (!parseDictionary(text.substr(from, length), array))
        return source.refusedAtByte(from, "the numpy header does not say type, order and shape", kSaveAgain);
    std::uint64_t items = 1;
    for (const std::uint64_t side : array.shape) {
        if (side > kMostItems || items * side > kMostItems)
            return source.refusedAtByte(from, withValues("the numpy header promises an array of shape %1", {array.shapeText()}),
                                        kCopyAgain);
        items *= side;
    }
    if (array.fields.empty() && !array.scalar.isNumber())
        return source.refused(withValues("this numpy array holds %1", {notNumbers(array.scalar)}),
                              "save it as an array of numbers (ranges.astype(numpy.float32))");
    if (array.itemBytes == 0 || array.items() == 0)
        return source.refused(withValues("this numpy array of shape %1 is empty", {array.shapeText()}), "choose another file");
    const std::uint64_t held = text.size() - from - length;
    if (held / array.itemBytes < array.items()) {
        return source.refused(
            withValues("the numpy header promises an array of shape %1, %2 of %3 bytes, and the file holds %4 bytes of them",
                       {array.shapeText(), counted(array.items(), "item"), array.itemBytes, held}),
            kCopyAgain);
    }
    array.data = source.bytes.subspan(from + length, array.items() * array.itemBytes);
    array.rest = source.bytes.subspan(from + length + array.data.size());
    return array;
}

} // namespace edgescan::files
