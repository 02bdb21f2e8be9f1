// Polygon files (PLY 1.0): the scalar properties of the vertices; ascii, little and big endian. Lists of a vertex and elements before the
// vertices are stepped over.

#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/files/formats/format.h"

#include "core/base/checked_size.h"
#include "core/base/foreign_text.h"
#include "core/base/memory.h"
#include "core/files/point_tables/axis_words.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/point_columns.h"

#include <algorithm>
#include <array>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::size_t kMostProperties = 4096;

/// One property in the order of the file. A list is a count and then so many items.
struct Property {
    Scalar scalar = Scalar::Float32;  ///< of the items, for a list
    std::optional<Scalar> count = {}; ///< empty: one number and not a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
    std::vector<RecordField> fields; ///< of the single numbers, as if there were no lists
    std::size_t recordBytes = 0;     ///< of the single numbers
    bool hasList = false;
};

struct PlyHeader {
    std::string encoding;
    std::vector<Element> elements;
    std::string description;
    std::optional<double> unitMm; ///< of a comment
    std::size_t firstByte = 0;
    std::size_t firstLine = 1;
    bool ended = false;
    bool unnamedByte = false; ///< behind the colours of each vertex
};

std::optional<Scalar> scalarNamed(std::string_view name) {
    using Named = std::pair<const char*, Scalar>;
    static constexpr std::array<Named, 17> kNames{{{"char", Scalar::Int8},
                                                   {"int8", Scalar::Int8},
                                                   {"uchar", Scalar::UInt8},
                                                   {"uint8", Scalar::UInt8},
                                                   {"bool", Scalar::UInt8},
                                                   {"short", Scalar::Int16},
                                                   {"int16", Scalar::Int16},
                                                   {"ushort", Scalar::UInt16},
                                                   {"uint16", Scalar::UInt16},
                                                   {"int", Scalar::Int32},
                                                   {"int32", Scalar::Int32},
                                                   {"uint", Scalar::UInt32},
                                                   {"uint32", Scalar::UInt32},
                                                   {"float", Scalar::Float32},
                                                   {"float32", Scalar::Float32},
                                                   {"double", Scalar::Float64},
                                                   {"float64", Scalar::Float64}}};
    for (const auto& [known, scalar] : kNames) {
        if (name == known) return scalar;
    }
    return std::nullopt;
}

bool readProperty(const std::vector<std::string_view>& words, Element& element) {
    if (element.properties.size() >= kMostProperties) return false;
    if (words.size() == 5 && words[1] == "list") {
        const auto count = scalarNamed(words[2]), item = scalarNamed(words[3]);
        if (!count || !item) return false;
        element.properties.push_back({*item, count});
        return element.hasList = true;
    }
    const auto scalar = words.size() == 3 ? scalarNamed(words[1]) : std::nullopt;
    if (!scalar) return false;
    element.properties.push_back({*scalar});
    element.fields.push_back({std::string(words[2]), *scalar, element.fields.size(), element.recordBytes, 0});
    element.recordBytes += sizeOf(*scalar);
    return true;
}

bool readHeaderLine(std::string_view line, PlyHeader& header) {
    const auto words = wordsOf(line);
    if (words.empty() || words[0] == "obj_info" || words[0] == "ply") return true;
    if (words[0] == "comment") {
        const std::string_view comment = line.substr(std::min<std::size_t>(line.size(), 8));
        const auto unit = addToDescription(comment, header.description) ? std::nullopt : unitInComment(comment);
        if (unit) header.unitMm = unit;
        return true;
    }
    if (words[0] == "end_header") return header.ended = true;
    if (words[0] == "format") return header.encoding = words.size() > 1 ? std::string(words[1]) : std::string(), true;
    if (words[0] == "element" && words.size() == 3) {
        const auto count = wholeNumber(words[2]);
        if (!count) return false;
        header.elements.push_back({std::string(words[1]), *count, {}, {}, 0, false});
        return true;
    }
    return words[0] == "property" && !header.elements.empty() && readProperty(words, header.elements.back());
}

Result<PlyHeader> readPlyHeader(const Source& source) {
    PlyHeader header;
    HeaderLines lines(source.text());
    while (!header.ended && lines.next()) {
        if (!readHeaderLine(lines.line(), header)) {
            return source.refusedAtLine(lines.number(), "this header line of the PLY file is not understood", "export the file again");
        }
    }
    if (!header.ended) return source.refused("the PLY header has no end_header line", kCopyAgain);
    header.firstByte = lines.nextByte();
    header.firstLine = lines.number() + 1;
    return header;
}

/// The bytes of the elements behind the vertices; none where lists leave them unknown.
std::optional<std::uint64_t> bytesBehindVertices(const PlyHeader& header) {
    std::uint64_t bytes = 0;
    bool behind = false;
    for (const Element& element : header.elements) {
        if (behind && element.hasList && element.count > 0) return std::nullopt;
        if (behind) bytes += productOf({element.count, element.recordBytes});
        behind = behind || element.name == "vertex";
    }
    return bytes;
}

/// PCL writes colours that are whole numbers with a fourth byte that its header leaves out. True: that is so here, and the fields are
/// moved.
bool hasUnnamedColourByte(Element& vertex, const PlyHeader& header, std::uint64_t held) {
    const auto blue =
        std::find_if(vertex.fields.begin(), vertex.fields.end(), [](const RecordField& field) { return field.name == "blue"; });
    const auto behind = bytesBehindVertices(header);
    if (header.encoding != "binary_little_endian" || blue == vertex.fields.end() || !behind) return false;
    if (held != productOf({vertex.count, vertex.recordBytes + 1}) + *behind) return false;
    for (auto field = blue + 1; field != vertex.fields.end(); ++field) ++field->offset;
    ++vertex.recordBytes;
    return true;
}

/// Where a record of an element ends that begins at `at`; empty where the bytes end before. Appends its single numbers to `numbers` unless
/// that is null.
std::optional<std::size_t> endOfRecord(const Element& element, std::span<const std::byte> bytes, std::size_t at, bool bigEndian,
                                       std::vector<std::byte>* numbers) {
    for (const Property& property : element.properties) {
        const std::size_t size = sizeOf(property.scalar);
        std::size_t items = 1;
        if (property.count) {
            if (bytes.size() - at < sizeOf(*property.count)) return std::nullopt;
            const double stated = readScalar(*property.count, bytes.data() + at, bigEndian);
            at += sizeOf(*property.count);
            if (!(stated >= 0) || stated > static_cast<double>(bytes.size())) return std::nullopt;
            items = static_cast<std::size_t>(stated);
        }
        if (items > (bytes.size() - at) / size) return std::nullopt;
        if (!property.count && numbers != nullptr) {
            const auto number = bytes.subspan(at, size);
            numbers->insert(numbers->end(), number.begin(), number.end());
        }
        at += items * size;
    }
    return at;
}

/// Moves the header's first byte and line behind an element that precedes the vertices.
Result<Done> stepOver(const Element& element, PlyHeader& header, const Source& source) {
    const Error cut = source.refused("the file ends before its vertices", kCopyAgain);
    if (header.encoding == "ascii") { // a row of text each
        for (std::uint64_t n = 0; n < element.count; ++n, ++header.firstLine) {
            if (header.firstByte >= source.bytes.size()) return cut;
            header.firstByte = textLineAt(source.text(), header.firstByte).next;
        }
        return Done{};
    }
    const std::uint64_t held = source.bytes.size() - header.firstByte;
    if (!element.hasList) {
        if (element.recordBytes > 0 && element.count > held / element.recordBytes) return cut;
        header.firstByte += productOf({element.count, element.recordBytes});
        return Done{};
    }
    for (std::uint64_t n = 0; n < element.count; ++n) {
        const auto end = endOfRecord(element, source.bytes, header.firstByte, header.encoding == "binary_big_endian", nullptr);
        if (!end) return cut;
        header.firstByte = *end;
        if (n % 65536 == 0 && !source.goOn("reading points", 0.0)) return source.cancelled();
    }
    return Done{};
}

/// The vertices' place, after the elements before them.
Result<const Element*> vertexElement(PlyHeader& header, const Source& source) {
    for (Element& element : header.elements) {
        if (element.name == "vertex") {
            if (element.count == 0 || element.count > kMostPoints)
                return source.refused(withValues("the header promises %1", {counted(element.count, "point")}), "check the file");
            header.unnamedByte = !element.hasList && hasUnnamedColourByte(element, header, source.bytes.size() - header.firstByte);
            for (RecordField& field : element.fields) field.stride = element.recordBytes;
            return static_cast<const Element*>(&element);
        }
        if (auto passed = stepOver(element, header, source); !passed) return passed.error();
    }
    return source.refused("the PLY file has no vertices", "choose another file");
}

/// The text of the vertices without the words of their lists, a row each as before.
std::string rowsWithoutLists(const Element& vertex, std::string_view text) {
    std::string rows;
    std::size_t at = 0;
    for (std::uint64_t n = 0; n < vertex.count && at < text.size(); ++n) {
        const TextLine line = textLineAt(text, at);
        at = line.next;
        const auto words = wordsOf(line.text);
        std::size_t next = 0;
        const auto put = [&](std::string_view word) { (rows += word) += ' '; };
        for (const Property& property : vertex.properties) {
            if (next >= words.size()) break; // the reader of rows says that some are missing
            if (!property.count)
                put(words[next++]);
            else
                next += std::min<std::uint64_t>(wholeNumber(words[next]).value_or(0), words.size()) + 1;
        }
        for (; next < words.size(); ++next) put(words[next]); // and that there are too many
        rows += '\n';
    }
    return rows;
}

/// Vertices with lists: their single numbers alone, and read from there.
Result<Done> readVerticesWithLists(PointTable& table, const PlyHeader& header, const Element& vertex, const PointFields& fields,
                                   const Source& source) {
    const auto held = source.bytes.subspan(header.firstByte);
    table.remarks.emplace_back("The lists that each vertex of this file has were not read.");
    if (auto enough = checkMemory(held.size(), source.path.string()); !enough) return enough;
    if (header.encoding == "ascii") {
        const std::string rows = rowsWithoutLists(vertex, source.text().substr(header.firstByte));
        Source plain = source;
        plain.bytes = std::as_bytes(std::span(rows));
        return readRows(table, fields, {vertex.count, vertex.fields.size(), 0, header.firstLine, false}, plain);
    }
    const bool bigEndian = header.encoding == "binary_big_endian";
    std::vector<std::byte> numbers;
    std::size_t at = 0;
    for (std::uint64_t n = 0; n < vertex.count; ++n) {
        const auto end = endOfRecord(vertex, held, at, bigEndian, &numbers);
        if (!end)
            return source.refused(
                withValues("the header promises %1 and the file ends after %2", {counted(vertex.count, "vertex", "vertices"), n}),
                kCopyAgain);
        at = *end;
        if (n % 65536 == 0 && !source.goOn("reading points", 0.0)) return source.cancelled();
    }
    if (!readRecords(table, fields, vertex.count, numbers, bigEndian, source)) return source.cancelled();
    return Done{};
}

Result<Done> readVertices(PointTable& table, const PlyHeader& header, const Element& vertex, const PointFields& fields,
                          const Source& source) {
    const std::uint64_t held = source.bytes.size() - header.firstByte;
    const bool known = header.encoding == "ascii" || header.encoding == "binary_little_endian" || header.encoding == "binary_big_endian";
    if (!known)
        return source.refused(withValues("the format \"%1\" is none that PLY knows", {header.encoding.substr(0, 40)}),
                              "export the file again");
    const std::uint64_t least = header.encoding == "ascii" ? vertex.fields.size() * 2 : vertex.recordBytes;
    if ((held + 2) / least < vertex.count) {
        return source.refused(
            withValues("the header promises %1 and the file holds %2 bytes of them", {counted(vertex.count, "vertex", "vertices"), held}),
            kCopyAgain);
    }
    if (auto enough = checkMemory(productOf({vertex.count, 32}), source.path.string()); !enough) return enough.error();
    if (vertex.hasList) return readVerticesWithLists(table, header, vertex, fields, source);
    const bool last = &vertex == &header.elements.back();
    if (header.encoding == "ascii")
        return readRows(table, fields, {vertex.count, vertex.fields.size(), header.firstByte, header.firstLine, last}, source);
    if (held / vertex.recordBytes < vertex.count) return source.refused("the file is cut off in its last vertex", kCopyAgain);
    const bool bigEndian = header.encoding == "binary_big_endian";
    const auto bytes = source.bytes.subspan(header.firstByte);
    if (const auto behind = bytesBehindVertices(header); behind && *behind <= bytes.size() - vertex.count * vertex.recordBytes) {
        const auto vertices = bytes.first(bytes.size() - *behind);
        if (auto whole = checkRest(table, vertex.count, vertex.recordBytes, vertices, source); !whole) return whole;
    }
    if (header.unnamedByte)
        table.remarks.push_back("Each vertex has a byte that the header does not name, as PCL writes it behind colours: it was skipped.");
    if (!readRecords(table, fields, vertex.count, bytes, bigEndian, source)) return source.cancelled();
    return Done{};
}

bool looksLikePly(const Source& source) { return source.text().starts_with("ply\n") || source.text().starts_with("ply\r"); }

Result<PointTable> readPlyPoints(const Source& source) {
    auto header = readPlyHeader(source);
    if (!header) return header.error();
    const auto vertex = vertexElement(*header, source);
    if (!vertex) return vertex.error();
    const auto fields = pickFields((*vertex)->fields);
    if (!fields) return source.refused("the vertices have no x, y and z", "export the file with coordinates");
    PointTable table;
    table.format = "PLY";
    table.description = header->description;
    takeUnitOfComment(table, header->unitMm, source);
    if (auto read = readVertices(table, *header, **vertex, *fields, source); !read) return read.error();
    std::string others;
    for (const Element* other = *vertex + 1; other <= &header->elements.back(); ++other)
        others += (others.empty() ? "" : ", ") + std::to_string(other->count) + " " + printable(other->name.substr(0, 40));
    if (!others.empty()) table.remarks.push_back(withValues("Only the vertices were read, not what follows them: %1.", {others}));
    table.width = table.points.size();
    return table;
}

/// Of each kind of column.
constexpr std::array<const char*, 4> kPlyTypes{"float", "double", "uint", "uchar"};

Result<std::string> plyBytes(CloudColumns cloud, const std::string& where, bool ascii) {
    if (auto enough = checkRoom(cloud, where, ascii ? 12 : 8); !enough) return enough.error();
    std::string text = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") + " 1.0\n";
    text += "comment " + frameText(cloud) + "\n";
    appendComments(text, cloud, "comment ");
    text += "element vertex " + std::to_string(rowsOf(cloud)) + "\n";
    for (const CloudColumn& column : cloud.columns)
        text += std::string("property ") + kPlyTypes[column.values.index()] + " " + column.name + "\n";
    text += "end_header\n";
    if (ascii)
        appendRows(text, cloud, ' ');
    else
        appendRecords(text, cloud);
    return text;
}

} // namespace

Format plyFormat() {
    return {.title = "Polygon file",
            .reads = {".ply"},
            .writes = {".ply"},
            .recognises = looksLikePly,
            .read = readingOf<readPlyPoints>,
            .write = plyBytes,
            .keepsIntensity = true,
            .inFloats = {"MeshLab", "PCL", "ParaView", "Blender", "loaders.gl"},
            .writesByLines = true};
}

} // namespace edgescan::files
