// Header and XML part of an E57 file. Every place and length is compared with the bytes that are there before anything is read.
#include "core/containers/e57/file.h"
#include "core/base/translated_text.h"

#include "core/base/memory.h"

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace edgescan::containers {
namespace {

constexpr const char* kCutOff = "copy the file again, it may be cut off";
constexpr const char* kExportAgain = "export the file again";

static_assert(std::endian::native == std::endian::little, "E57 is read as the machine stores numbers");

struct E57Header {
    std::uint32_t major = 0, minor = 0;
    std::uint64_t fileBytes = 0, xmlAt = 0, xmlBytes = 0, pageBytes = 0;
};

Result<E57Header> readHeader(std::span<const std::byte> bytes, const std::string& where) {
    constexpr std::size_t kHeaderBytes = 48;
    if (bytes.size() < kHeaderBytes) return Error{"the file ends within its E57 header", where, kCutOff};
    E57Header header;
    const auto read = [&](auto& value, std::size_t at) { std::memcpy(&value, bytes.data() + at, sizeof value); };
    read(header.major, 8);
    read(header.minor, 12);
    read(header.fileBytes, 16);
    read(header.xmlAt, 24);
    read(header.xmlBytes, 32);
    read(header.pageBytes, 40);
    if (header.major != 1) {
        return Error{withValues("this is E57 version %1.%2, and version 1 is known", {header.major, header.minor}), where,
                     "export it as E57 version 1.0"};
    }
    constexpr std::uint64_t kLeastPage = 64, kMostPage = 1U << 20U;
    if (header.pageBytes < kLeastPage || header.pageBytes > kMostPage || !std::has_single_bit(header.pageBytes))
        return Error{withValues("the E57 header says that pages have %1 bytes", {header.pageBytes}), withValues("%1: byte 40", {where}),
                     kCutOff};
    if (header.fileBytes > bytes.size()) {
        return Error{withValues("the E57 header promises %1 bytes and the file holds %2", {header.fileBytes, bytes.size()}), where,
                     kCutOff};
    }
    return header;
}

/// The text of an element; numbers that are not written are 0 by the standard.
double numberIn(const pugi::xml_node& node) {
    const std::string_view text = node.child_value();
    std::size_t from = text.find_first_not_of(" \t\r\n+");
    if (from == std::string_view::npos) return 0.0;
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data() + from, text.data() + text.size(), value);
    return problem == std::errc{} ? value : std::numeric_limits<double>::quiet_NaN();
}

double numberOf(const pugi::xml_attribute& attribute, double missing) {
    if (!attribute) return missing;
    const std::string_view text = attribute.value();
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc{} ? value : std::numeric_limits<double>::quiet_NaN();
}

/// A whole number, also when it was written with a fraction of zero.
template <class Whole>
std::optional<Whole> wholeOf(std::string_view text) {
    Whole value = 0;
    const char* const end = text.data() + text.size();
    const auto [after, problem] = std::from_chars(text.data(), end, value);
    const std::string_view rest(after, static_cast<std::size_t>(end - after));
    if (problem != std::errc{} || (!rest.empty() && rest.find_first_not_of(".0") != std::string_view::npos)) return std::nullopt;
    return value;
}

std::int64_t wholeIn(const pugi::xml_node& node) { return wholeOf<std::int64_t>(node.child_value()).value_or(0); }

std::optional<E57Field> fieldOf(const pugi::xml_node& node) {
    E57Field field;
    field.name = node.name();
    const std::string_view type = node.attribute("type").value();
    if (type == "Float") {
        field.kind = std::string_view(node.attribute("precision").value()) == "single" ? E57Field::Kind::Single : E57Field::Kind::Double;
        return field;
    }
    if (type != "Integer" && type != "ScaledInteger") {
        field.kind = E57Field::Kind::Other;
        return field;
    }
    const auto limit = [&](const char* name, std::int64_t missing) -> std::optional<std::int64_t> {
        const pugi::xml_attribute attribute = node.attribute(name);
        return attribute ? wholeOf<std::int64_t>(attribute.value()) : missing;
    };
    const auto least = limit("minimum", std::numeric_limits<std::int64_t>::min());
    const auto most = limit("maximum", std::numeric_limits<std::int64_t>::max());
    if (!least || !most || *least > *most) return std::nullopt;
    field.minimum = *least;
    field.maximum = *most;
    field.kind = type == "Integer" ? E57Field::Kind::Integer : E57Field::Kind::ScaledInteger;
    if (field.kind == E57Field::Kind::ScaledInteger) {
        field.scale = numberOf(node.attribute("scale"), 1.0);
        field.offset = numberOf(node.attribute("offset"), 0.0);
        if (!std::isfinite(field.scale) || !std::isfinite(field.offset)) return std::nullopt;
    }
    return field;
}

/// The columns in the order of their streams; those of structures inside follow at the place of the structure.
Result<Done> readFields(const pugi::xml_node& parent, std::vector<E57Field>& fields, int depth, const std::string& where) {
    constexpr int kDeepest = 16;
    if (depth > kDeepest) return Error{"the columns of points in this E57 file are nested too deep", where, kExportAgain};
    for (const pugi::xml_node& node : parent.children()) {
        if (node.type() != pugi::node_element) continue;
        const std::string_view type = node.attribute("type").value();
        if (type == "Structure" || type == "Vector") {
            if (auto taken = readFields(node, fields, depth + 1, where); !taken) return taken;
            continue;
        }
        auto field = fieldOf(node);
        if (!field) {
            return Error{withValues("the limits of the column %1 in this E57 file are not possible", {std::string(node.name())}), where,
                         kExportAgain};
        }
        fields.push_back(std::move(*field));
    }
    return Done{};
}

void readPose(const pugi::xml_node& node, E57Scan& scan) {
    if (!node) return;
    E57Pose pose;
    const pugi::xml_node move = node.child("translation");
    pose.translationM = {numberIn(move.child("x")), numberIn(move.child("y")), numberIn(move.child("z"))};
    if (const pugi::xml_node turn = node.child("rotation")) {
        const Eigen::Quaterniond q(numberIn(turn.child("w")), numberIn(turn.child("x")), numberIn(turn.child("y")),
                                   numberIn(turn.child("z")));
        const double norm = q.norm();
        scan.poseIsNone = !(std::abs(norm - 1.0) < 0.01); // written with few digits it is not quite 1
        if (!scan.poseIsNone) pose.rotation = q.normalized().toRotationMatrix();
    }
    constexpr double kFarthestM = 1e12;
    scan.poseIsNone = scan.poseIsNone || !(pose.translationM.cwiseAbs().maxCoeff() < kFarthestM);
    if (!scan.poseIsNone) scan.pose = pose;
}

void readBounds(const pugi::xml_node& node, E57Scan& scan) {
    if (!node.child("rowMaximum") || !node.child("columnMaximum")) return;
    const E57IndexBounds bounds{wholeIn(node.child("rowMinimum")), wholeIn(node.child("rowMaximum")), wholeIn(node.child("columnMinimum")),
                                wholeIn(node.child("columnMaximum"))};
    if (bounds.firstRow <= bounds.lastRow && bounds.firstColumn <= bounds.lastColumn) scan.bounds = bounds;
}

Result<E57Scan> scanOf(const pugi::xml_node& node, std::size_t number, const std::string& where) {
    E57Scan scan;
    scan.name = node.child_value("name");
    scan.description = node.child_value("description");
    scan.vendor = node.child_value("sensorVendor");
    scan.model = node.child_value("sensorModel");
    scan.serial = node.child_value("sensorSerialNumber");
    scan.firmware = node.child_value("sensorFirmwareVersion");
    scan.lineIndex = node.child("pointGroupingSchemes").child("groupingByLine").child_value("idElementName");
    readPose(node.child("pose"), scan);
    readBounds(node.child("indexBounds"), scan);
    const pugi::xml_node points = node.child("points");
    const auto count = wholeOf<std::uint64_t>(points.attribute("recordCount").value());
    const auto at = wholeOf<std::uint64_t>(points.attribute("fileOffset").value());
    if (!points || !count || !at) {
        return Error{withValues("scan %1 of this E57 file does not say where its points are and how many", {number}), where, kExportAgain};
    }
    scan.points = *count;
    scan.sectionAt = *at;
    if (auto taken = readFields(points.child("prototype"), scan.fields, 0, where); !taken) return taken.error();
    return scan;
}

std::size_t elementsIn(const pugi::xml_node& parent) {
    std::size_t count = 0;
    for (const pugi::xml_node& node : parent.children()) count += node.type() == pugi::node_element ? 1 : 0;
    return count;
}

} // namespace

unsigned E57Field::bits() const {
    switch (kind) {
    case Kind::Single:
        return 32;
    case Kind::Double:
        return 64;
    case Kind::Integer:
    case Kind::ScaledInteger:
        return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(maximum) - static_cast<std::uint64_t>(minimum)));
    case Kind::Other:
        return 0;
    }
    return 0;
}

std::optional<std::size_t> E57Scan::field(std::string_view wanted) const {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].name == wanted && fields[i].kind != E57Field::Kind::Other) return i;
    }
    return std::nullopt;
}

Result<E57File> openE57(std::span<const std::byte> bytes, const std::string& where) {
    const auto header = readHeader(bytes, where);
    if (!header) return header.error();
    E57File file{PagedBytes(bytes.first(header->fileBytes), header->pageBytes, where), {}, 0, bytes.subspan(header->fileBytes)};
    const auto xmlAt = file.pages.logical(header->xmlAt);
    if (!xmlAt || header->xmlBytes > file.pages.size() - *xmlAt) {
        return Error{withValues("the E57 header says that the XML part is at byte %1 and has %2 bytes, which are not in the file",
                                {header->xmlAt, header->xmlBytes}),
                     withValues("%1: byte 24", {where}), kCutOff};
    }
    constexpr std::uint64_t kMemoryPerByte = 32; // of the tree that is made of the shortest elements
    if (auto enough = checkMemory(header->xmlBytes * kMemoryPerByte, where); !enough) return enough.error();
    std::vector<std::byte> text;
    if (auto read = file.pages.read(*xmlAt, header->xmlBytes, text); !read) return read.error();
    pugi::xml_document xml;
    const pugi::xml_parse_result parsed = xml.load_buffer_inplace(text.data(), text.size());
    if (!parsed) {
        const auto offset = static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(0, parsed.offset));
        return Error{std::string("the XML part of this E57 file cannot be read: ") + parsed.description(),
                     withValues("%1: byte %2", {where, file.pages.physical(*xmlAt + offset)}), kExportAgain};
    }
    const pugi::xml_node root = xml.child("e57Root");
    if (!root)
        return Error{"the XML part of this E57 file has no e57Root", withValues("%1: byte %2", {where, header->xmlAt}), kExportAgain};
    for (const pugi::xml_node& node : root.child("data3D").children()) {
        if (node.type() != pugi::node_element) continue;
        auto scan = scanOf(node, file.scans.size() + 1, where);
        if (!scan) return scan.error();
        file.scans.push_back(std::move(*scan));
    }
    file.pictures = elementsIn(root.child("images2D"));
    return file;
}

} // namespace edgescan::containers
