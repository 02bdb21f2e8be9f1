// Nodes of the text by their ancestors; keys by their numbers (OGC 19-008, "GeoTIFF").
#include "core/files/formats/las_records.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/formats/las_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <vector>

#ifdef EDGESCAN_WITH_PROJ
#include <proj.h>
#endif

namespace edgescan::files::las {
namespace {

constexpr std::uint16_t kWktId = 2112, kKeysId = 34735, kDoublesId = 34736;
constexpr double kMmPerM = 1000.0;

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) { return std::ranges::find(words, word) != words.end(); }

/// The system that a node of the text belongs to: the nearest of its ancestors that is one. Empty inside of what has units of its own.
std::string_view systemOf(const std::vector<std::string_view>& ancestors) {
    for (auto node = ancestors.rbegin(); node != ancestors.rend(); ++node) {
        if (isOneOf(*node, {"DATUM", "SPHEROID", "ELLIPSOID", "PRIMEM", "PARAMETER", "CONVERSION", "METHOD", "PROJECTION", "BBOX",
                            "VERTICALEXTENT"}))
            return {};
        if (node->ends_with("CS") ? *node != "CS" : node->ends_with("CRS")) return *node;
    }
    return {};
}

/// "UNIT["US survey foot",0.3048006096]": the name and the number, from behind the bracket.
struct UnitNode {
    std::string name;
    double factor = 0;
};
std::optional<UnitNode> unitNodeAt(std::string_view text) {
    const std::size_t open = text.find('"');
    const std::size_t close = open == std::string_view::npos ? open : text.find('"', open + 1);
    if (close == std::string_view::npos) return std::nullopt;
    UnitNode unit{std::string(text.substr(open + 1, std::min<std::size_t>(close - open - 1, 40)))};
    const std::size_t number = text.find_first_not_of(", \t\r\n", close + 1);
    if (number == std::string_view::npos) return std::nullopt;
    const auto [end, problem] = std::from_chars(text.data() + number, text.data() + text.size(), unit.factor);
    if (problem != std::errc{} || !(unit.factor > 1e-6) || unit.factor > 1e6) return std::nullopt;
    return unit;
}

void storeUnit(StatedUnits& stated, std::string_view keyword, std::string_view system, const UnitNode& unit) {
    const bool vertical = isOneOf(system, {"VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS"});
    const bool geographic = isOneOf(system, {"GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS", "BASEGEOGCRS", "BASEGEODCRS"});
    const bool angle = keyword == "ANGLEUNIT" || (geographic && keyword == "UNIT");
    if (system.empty() || system.starts_with("BASE")) return;
    if (vertical && !angle) {
        stated.heightMm = stated.heightMm.value_or(unit.factor * kMmPerM);
    } else if (!angle && !stated.mm && !geographic) {
        stated.mm = unit.factor * kMmPerM;
        stated.name = unit.name;
    } else if (angle) {
        stated.degrees = true;
    }
}

struct Keys {
    std::span<const std::byte> directory, doubles;
};

std::uint16_t u16At(std::span<const std::byte> bytes, std::size_t at) {
    std::uint16_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// Calls visit(user, id, content) for each of the records from `at` on; damaged ones end it.
template <class Visit>
void eachRecord(std::span<const std::byte> file, std::uint64_t at, std::uint64_t records, std::uint64_t end, bool extended, Visit visit) {
    const std::uint64_t header = extended ? kExtendedHeader : kRecordHeader;
    end = std::min<std::uint64_t>(end, file.size());
    for (std::uint64_t n = 0; n < records && at <= end && end - at >= header; ++n) {
        std::uint64_t length = u16At(file, at + kRecordLength);
        if (extended) std::memcpy(&length, file.data() + at + kRecordLength, sizeof length);
        const std::uint64_t from = at + header;
        if (length > end - from) return;
        std::array<char, 17> user{};
        std::memcpy(user.data(), file.data() + at + kRecordUser, 16);
        visit(std::string_view(user.data()), u16At(file, at + kRecordId), file.subspan(from, length));
        at = from + length;
    }
}

std::optional<double> linearUnitMm(std::uint16_t code) {
    constexpr std::uint16_t kMetre = 9001, kFoot = 9002, kUsFoot = 9003;
    if (code == kMetre) return kMmPerM;
    if (code == kFoot) return kFootMm;
    if (code == kUsFoot) return kUsSurveyFootMm;
    return std::nullopt;
}

/// The first axis of a system by its number, from the table that PROJ brings; empty without PROJ, and for what has an angle.
std::optional<UnitNode> axisOfCode([[maybe_unused]] std::uint16_t code) {
    std::optional<UnitNode> unit;
#ifdef EDGESCAN_WITH_PROJ
    PJ_CONTEXT* context = proj_context_create();
    proj_log_level(context, PJ_LOG_NONE);
    PJ* system = proj_create_from_database(context, "EPSG", std::to_string(code).c_str(), PJ_CATEGORY_CRS, 0, nullptr);
    PJ* whole = system != nullptr && proj_get_type(system) == PJ_TYPE_COMPOUND_CRS ? proj_crs_get_sub_crs(context, system, 0) : nullptr;
    PJ* single = whole != nullptr ? whole : system;
    PJ* axes = single == nullptr ? nullptr : proj_crs_get_coordinate_system(context, single);
    const char* name = nullptr;
    double metres = 0;
    if (axes != nullptr && proj_cs_get_type(context, axes) != PJ_CS_TYPE_ELLIPSOIDAL &&
        proj_cs_get_axis_info(context, axes, 0, nullptr, nullptr, nullptr, &metres, &name, nullptr, nullptr) != 0 && metres > 0)
        unit = UnitNode{name == nullptr ? "" : name, metres};
    for (PJ* each : {axes, whole, system}) proj_destroy(each);
    proj_context_destroy(context);
#endif
    return unit;
}

StatedUnits unitsOfKeys(const Keys& keys) {
    constexpr std::size_t kHead = 8, kEntry = 8;
    constexpr std::uint16_t kModelType = 1024, kSystem = 3072, kLinear = 3076, kLinearSize = 3077, kHeights = 4096, kVertical = 4099,
                            kGeographic = 2;
    StatedUnits stated;
    std::uint16_t model = 0, system = 0, heights = 0;
    for (std::size_t at = kHead; at + kEntry <= keys.directory.size(); at += kEntry) {
        const std::uint16_t key = u16At(keys.directory, at), location = u16At(keys.directory, at + 2),
                            value = u16At(keys.directory, at + 6);
        if (key == kModelType) model = value;
        if (key == kSystem) system = value;
        if (key == kHeights) heights = value;
        if (key == kLinear && linearUnitMm(value)) stated.mm = linearUnitMm(value);
        if (key == kVertical) stated.heightMm = linearUnitMm(value);
        if (key != kLinearSize || location != kDoublesId || keys.doubles.size() < (std::size_t{value} + 1) * sizeof(double)) continue;
        double metres = 0;
        std::memcpy(&metres, keys.doubles.data() + value * sizeof metres, sizeof metres);
        if (metres > 1e-6 && metres < 1e6) stated.mm = metres * kMmPerM;
    }
    stated.degrees = model == kGeographic;
    if (stated.mm) stated.name = significantText(*stated.mm / kMmPerM, 10) + " m";
    if (!stated.mm && !stated.degrees && system != 0) {
        const auto unit = axisOfCode(system);
        if (unit) stated.mm = unit->factor * kMmPerM;
        stated.name = unit ? unit->name : "EPSG:" + std::to_string(system);
    }
    if (const auto unit = stated.heightMm || heights == 0 ? std::nullopt : axisOfCode(heights)) stated.heightMm = unit->factor * kMmPerM;
    return stated;
}

// Extra bytes of points: further columns by name (ASPRS LAS 1.4 R15, "Extra Bytes").
constexpr std::size_t kDescriptor = 192;
constexpr std::size_t kTypeAt = 2, kOptionsAt = 3, kNameAt = 4, kNameBytes = 32;
constexpr std::uint16_t kExtraBytes = 4; // record id, of user LASF_Spec

constexpr std::array<Scalar, 10> kTypes{Scalar::UInt8, Scalar::Int8,   Scalar::UInt16, Scalar::Int16,   Scalar::UInt32,
                                        Scalar::Int32, Scalar::UInt64, Scalar::Int64,  Scalar::Float32, Scalar::Float64};

std::string nameIn(std::span<const std::byte> descriptor) {
    std::string name(reinterpret_cast<const char*>(descriptor.data() + kNameAt), kNameBytes);
    return name.substr(0, name.find('\0'));
}

/// The fields of one record of descriptors; those of types that are not a single number only move the next ones on.
std::vector<RecordField> fieldsIn(std::span<const std::byte> record, std::size_t from, std::size_t pointBytes) {
    std::vector<RecordField> fields;
    for (std::size_t at = 0; at + kDescriptor <= record.size() && from < pointBytes; at += kDescriptor) {
        const auto descriptor = record.subspan(at, kDescriptor);
        const auto type = std::to_integer<std::size_t>(descriptor[kTypeAt]);
        if (type == 0) { // so many undescribed bytes
            from += std::to_integer<std::size_t>(descriptor[kOptionsAt]);
            continue;
        }
        if (type > 3 * kTypes.size()) break;
        const Scalar scalar = kTypes[(type - 1) % kTypes.size()];
        const std::size_t count = (type - 1) / kTypes.size() + 1; // two or three of them, in old files
        if (count == 1 && from + sizeOf(scalar) <= pointBytes) fields.push_back({nameIn(descriptor), scalar, 0, from, pointBytes});
        from += count * sizeOf(scalar);
    }
    return fields;
}

} // namespace

StatedUnits unitsOfWkt(std::string_view text) {
    constexpr std::size_t kDeepest = 64;
    StatedUnits stated;
    std::vector<std::string_view> ancestors;
    std::size_t word = 0; // where the word before a bracket begins
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') {
            const std::size_t close = text.find('"', at + 1);
            if (close == std::string_view::npos) break;
            at = close;
        } else if (c == '[' || c == '(') {
            const std::string_view keyword = text.substr(word, at - word);
            if (isOneOf(keyword, {"UNIT", "LENGTHUNIT", "ANGLEUNIT"})) {
                if (const auto unit = unitNodeAt(text.substr(at))) storeUnit(stated, keyword, systemOf(ancestors), *unit);
            }
            if (ancestors.size() == kDeepest) break;
            ancestors.push_back(keyword);
        } else if ((c == ']' || c == ')') && !ancestors.empty()) {
            ancestors.pop_back();
        }
        const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        if (!letter) word = at + 1;
    }
    if (stated.mm) stated.degrees = false; // those of the system that it was projected from
    return stated;
}

StatedUnits statedUnits(std::span<const std::byte> file, const RecordPlaces& places) {
    StatedUnits text;
    Keys keys;
    const auto read = [&](std::string_view user, std::uint16_t id, std::span<const std::byte> content) {
        if (user != "LASF_Projection") return;
        if (id == kWktId) text = unitsOfWkt({reinterpret_cast<const char*>(content.data()), content.size()});
        if (id == kKeysId) keys.directory = content;
        if (id == kDoublesId) keys.doubles = content;
    };
    eachRecord(file, places.recordsAt, places.records, places.recordsEnd, false, read);
    if (places.extendedAt > 0) eachRecord(file, places.extendedAt, places.extended, file.size(), true, read);
    return text.mm || text.degrees ? text : unitsOfKeys(keys);
}

std::vector<RecordField> extraFields(std::span<const std::byte> file, std::uint64_t recordsAt, std::uint64_t records,
                                     std::uint64_t recordsEnd, std::size_t from, std::size_t pointBytes) {
    std::optional<std::vector<RecordField>> fields; // of the first such record
    eachRecord(file, recordsAt, records, recordsEnd, false,
               [&](std::string_view user, std::uint16_t id, std::span<const std::byte> content) {
                   if (!fields && user == "LASF_Spec" && id == kExtraBytes) fields = fieldsIn(content, from, pointBytes);
               });
    return std::move(fields).value_or(std::vector<RecordField>());
}

} // namespace edgescan::files::las
