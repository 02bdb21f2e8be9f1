// Polygon files (PLY 1.0): vertices with scalar properties; ascii, little and big endian.

#include "core/files/formats/format.h"

#include "core/base/checked_size.h"
#include "core/base/foreign_text.h"
#include "core/base/memory.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/point_columns.h"

#include <algorithm>
#include <array>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::size_t kMostProperties = 4096;

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<RecordField> fields;
    std::size_t recordBytes = 0;
    bool hasList = false;
};

struct PlyHeader {
    std::string encoding;
    std::vector<Element> elements;
    std::string description;
    std::size_t firstByte = 0;
    std::size_t firstLine = 1;
    bool ended = false;
};

std::optional<Scalar> scalarNamed(std::string_view name) {
    using Named = std::pair<const char*, Scalar>;
    static constexpr std::array<Named, 16> kNames{{{"char", Scalar::Int8},
                                                   {"int8", Scalar::Int8},
                                                   {"uchar", Scalar::UInt8},
                                                   {"uint8", Scalar::UInt8},
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
    if (words.size() == 5 && words[1] == "list") return element.hasList = true;
    const auto scalar = words.size() == 3 ? scalarNamed(words[1]) : std::nullopt;
    if (!scalar || element.fields.size() >= kMostProperties) return false;
    element.fields.push_back({std::string(words[2]), *scalar, element.fields.size(), element.recordBytes, 0});
    element.recordBytes += sizeOf(*scalar);
    return true;
}

bool readHeaderLine(std::string_view line, PlyHeader& header) {
    const auto words = wordsOf(line);
    if (words.empty() || words[0] == "obj_info" || words[0] == "ply") return true;
    if (words[0] == "comment") return addToDescription(line.substr(std::min<std::size_t>(line.size(), 8)), header.description), true;
    if (words[0] == "end_header") return header.ended = true;
    if (words[0] == "format") return header.encoding = words.size() > 1 ? std::string(words[1]) : std::string(), true;
    if (words[0] == "element" && words.size() == 3) {
        const auto count = wholeNumber(words[2]);
        if (!count) return false;
        header.elements.push_back({std::string(words[1]), *count, {}, 0, false});
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

/// The vertices' place, after elements whose length is known.
Result<const Element*> vertexElement(PlyHeader& header, const Source& source) {
    for (Element& element : header.elements) {
        if (element.name == "vertex") {
            if (element.hasList)
                return source.refused("the vertices have lists of numbers, which cannot be read", "export the file without them");
            for (RecordField& field : element.fields) field.stride = element.recordBytes;
            if (element.count == 0 || element.count > kMostPoints)
                return source.refused("the header promises " + std::to_string(element.count) + " points", "check the file");
            return static_cast<const Element*>(&element);
        }
        if (element.hasList || header.encoding == "ascii") {
            return source.refused("the vertices do not come first in this PLY file", "export the file with the vertices first");
        }
        const std::uint64_t held = source.bytes.size() - header.firstByte;
        if (element.recordBytes > 0 && element.count > held / element.recordBytes)
            return source.refused("the file ends before its vertices", kCopyAgain);
        header.firstByte += productOf({element.count, element.recordBytes});
    }
    return source.refused("the PLY file has no vertices", "choose another file");
}

Result<Done> readVertices(PointTable& table, const PlyHeader& header, const Element& vertex, const PointFields& fields,
                          const Source& source) {
    const std::uint64_t held = source.bytes.size() - header.firstByte;
    const std::uint64_t least = header.encoding == "ascii" ? vertex.fields.size() * 2 : vertex.recordBytes;
    if ((held + 2) / least < vertex.count) {
        return source.refused("the header promises " + std::to_string(vertex.count) + " vertices and the file holds " +
                                  std::to_string(held) + " bytes of them",
                              kCopyAgain);
    }
    if (auto enough = checkMemory(productOf({vertex.count, 32}), source.path.string()); !enough) return enough.error();
    const bool last = &vertex == &header.elements.back();
    if (header.encoding == "ascii")
        return readRows(table, fields, {vertex.count, vertex.fields.size(), header.firstByte, header.firstLine, last}, source);
    if (held / vertex.recordBytes < vertex.count) return source.refused("the file is cut off in its last vertex", kCopyAgain);
    const bool bigEndian = header.encoding == "binary_big_endian";
    if (!bigEndian && header.encoding != "binary_little_endian") {
        return source.refused("the format \"" + header.encoding.substr(0, 40) + "\" is none that PLY knows", "export the file again");
    }
    const auto bytes = source.bytes.subspan(header.firstByte);
    if (last) {
        if (auto whole = checkRest(table, vertex.count, vertex.recordBytes, bytes, source); !whole) return whole;
    }
    if (!readRecords(table, fields, vertex.count, bytes, bigEndian, source)) return source.cancelled();
    return Done{};
}

bool looksLikePly(const Source& source) { return source.text().starts_with("ply\n") || source.text().starts_with("ply\r\n"); }

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
    if (auto read = readVertices(table, *header, **vertex, *fields, source); !read) return read.error();
    std::string others;
    for (const Element* other = *vertex + 1; other <= &header->elements.back(); ++other)
        others += (others.empty() ? "" : ", ") + std::to_string(other->count) + " " + printable(other->name.substr(0, 40));
    if (!others.empty()) table.remarks.push_back("Only the vertices were read, not what follows them: " + others + ".");
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
            .inFloats = {"MeshLab", "ParaView", "Blender"},
            .writesByLines = true};
}

} // namespace edgescan::files
