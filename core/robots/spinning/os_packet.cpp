// Bytes of an Ouster as columns.
#include "core/robots/spinning/os_packet.h"

#include "core/base/bounded_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace edgescan::robots {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostPixels = 1024, kMostColumns = 16384;

struct Layout {
    std::size_t packetHead, columnHead, pixel, columnFoot, packetFoot;
};
constexpr std::array<Layout, 4> kLayouts{{{0, 16, 12, 4, 0}, {32, 12, 12, 0, 32}, {32, 12, 16, 0, 32}, {32, 12, 4, 0, 32}}};

std::size_t bytesOf(const Layout& layout, std::size_t columns, std::size_t pixels) {
    return layout.packetHead + columns * (layout.columnHead + pixels * layout.pixel + layout.columnFoot) + layout.packetFoot;
}

/// Range in millimetres and reflectivity of a pixel; of two returns the stronger, which comes first.
std::pair<float, float> pixelOf(OsProfile profile, ByteView bytes) {
    const auto word = static_cast<std::uint32_t>(littleEndian(bytes.first(4)));
    switch (profile) {
    case OsProfile::Legacy:
        return {static_cast<float>(word & 0xFFFFFU), static_cast<float>(bytes[4])};
    case OsProfile::Single:
        return {static_cast<float>(word & 0x7FFFFU), static_cast<float>(bytes[4])};
    case OsProfile::Dual:
        return {static_cast<float>(word & 0x7FFFFU), static_cast<float>(word >> 24U)};
    case OsProfile::LowRate:
        break;
    }
    constexpr unsigned kMmPerCount = 8;
    return {static_cast<float>((word & 0x7FFFU) * kMmPerCount), static_cast<float>(word >> 16U & 0xFFU)};
}

/// A value at the top or in one of the objects that newer sensors group them in.
const Json* valueIn(const Json& all, const char* key) {
    if (all.contains(key)) return &all[key];
    for (const char* group : {"beam_intrinsics", "lidar_data_format", "data_format", "config_params", "sensor_info"}) {
        if (all.contains(group) && all[group].is_object() && all[group].contains(key)) return &all[group][key];
    }
    return nullptr;
}

std::vector<double> anglesIn(const Json& all, const char* key) {
    const Json* list = valueIn(all, key);
    std::vector<double> angles;
    for (std::size_t n = 0; list != nullptr && list->is_array() && n < std::min(list->size(), kMostPixels); ++n) {
        const Json& one = (*list)[n];
        if (!one.is_number() || !(std::abs(one.get<double>()) <= 90)) return {};
        angles.push_back(one.get<double>());
    }
    return angles;
}

std::size_t wholeIn(const Json& all, const char* key) {
    const Json* number = valueIn(all, key);
    return number != nullptr && number->is_number_unsigned() ? static_cast<std::size_t>(number->get<std::uint64_t>()) : 0;
}

std::string textIn(const Json& all, const char* key) {
    const Json* text = valueIn(all, key);
    return text != nullptr && text->is_string() ? text->get<std::string>() : std::string();
}

std::optional<OsProfile> profileOf(ByteView datagram, const OsSensor& sensor) {
    for (std::size_t n = 0; n < kLayouts.size(); ++n) {
        if (datagram.size() == bytesOf(kLayouts[n], sensor.columnsPerPacket, sensor.altitudeDeg.size())) return static_cast<OsProfile>(n);
    }
    return std::nullopt;
}

} // namespace

Result<OsSensor> osSensor(std::string_view json, const std::string& where) {
    const auto parsed = parseJson(json, where);
    if (!parsed) return parsed.error();
    const Json& all = *parsed;
    OsSensor sensor;
    if (all.is_object()) {
        sensor.model = textIn(all, "prod_line").substr(0, 40);
        sensor.altitudeDeg = anglesIn(all, "beam_altitude_angles");
        sensor.azimuthDeg = anglesIn(all, "beam_azimuth_angles");
        sensor.columnsPerFrame = wholeIn(all, "columns_per_frame");
        if (const std::size_t columns = wholeIn(all, "columns_per_packet"); columns > 0) sensor.columnsPerPacket = columns;
        const std::string mode = textIn(all, "lidar_mode"); // "1024x10"
        if (sensor.columnsPerFrame == 0) std::from_chars(mode.data(), mode.data() + mode.size(), sensor.columnsPerFrame);
    }
    const bool fits = !sensor.altitudeDeg.empty() && sensor.altitudeDeg.size() == sensor.azimuthDeg.size();
    const bool columns = sensor.columnsPerFrame > 0 && sensor.columnsPerFrame <= kMostColumns && sensor.columnsPerPacket <= kMostColumns;
    if (!fits || !columns)
        return Error{"this is not the metadata of an Ouster: beam angles or columns of a frame are missing", where,
                     "save the sensor's metadata again"};
    return sensor;
}

std::optional<std::vector<SpinningColumn>> decodeOs(ByteView datagram, const OsSensor& sensor, std::int64_t timeNs) {
    const auto profile = profileOf(datagram, sensor);
    if (!profile) return std::nullopt;
    const Layout& layout = kLayouts[static_cast<std::size_t>(*profile)];
    const std::size_t pixels = sensor.altitudeDeg.size(), length = layout.columnHead + pixels * layout.pixel + layout.columnFoot;
    const std::uint64_t firstNs = littleEndian(datagram.subspan(layout.packetHead, 8));
    std::vector<SpinningColumn> columns;
    for (std::size_t c = 0; c < sensor.columnsPerPacket; ++c) {
        const ByteView bytes = datagram.subspan(layout.packetHead + c * length, length);
        const std::uint64_t measurement = littleEndian(bytes.subspan(8, 2));
        const bool valid =
            *profile == OsProfile::Legacy ? littleEndian(bytes.subspan(length - 4, 4)) == 0xFFFFFFFFU : (bytes[10] & 1U) != 0;
        if (!valid || measurement >= sensor.columnsPerFrame) continue;
        SpinningColumn column;
        column.azimuthDeg = 360.0 * static_cast<double>(measurement) / static_cast<double>(sensor.columnsPerFrame);
        constexpr std::int64_t kLongest = 1'000'000'000; // of a packet: a clock that jumps within it is not followed
        const auto since = static_cast<std::int64_t>(littleEndian(bytes.first(8)) - firstNs);
        column.timeNs = timeNs + (since >= 0 && since < kLongest ? since : 0);
        column.rangeMm.resize(pixels);
        column.reflection.resize(pixels);
        for (std::size_t p = 0; p < pixels; ++p) {
            const auto [range, reflection] = pixelOf(*profile, bytes.subspan(layout.columnHead + p * layout.pixel, layout.pixel));
            column.rangeMm[pixels - 1 - p] = range;
            column.reflection[pixels - 1 - p] = reflection;
        }
        columns.push_back(std::move(column));
    }
    return columns;
}

std::optional<std::int64_t> osClockNs(ByteView datagram, const OsSensor& sensor) {
    const auto profile = profileOf(datagram, sensor);
    if (!profile) return std::nullopt;
    return static_cast<std::int64_t>(littleEndian(datagram.subspan(kLayouts[static_cast<std::size_t>(*profile)].packetHead, 8)));
}

SpinningBeams osBeams(const OsSensor& sensor) {
    SpinningBeams beams;
    beams.vendor = "Ouster";
    beams.model = sensor.model;
    beams.elevationDeg.assign(sensor.altitudeDeg.rbegin(), sensor.altitudeDeg.rend());
    beams.azimuthDeg.assign(sensor.azimuthDeg.rbegin(), sensor.azimuthDeg.rend());
    return beams;
}

bool looksLikeOs(ByteView datagram) {
    for (const Layout& layout : kLayouts) {
        for (const std::size_t pixels : {16U, 32U, 64U, 128U}) {
            if (datagram.size() == bytesOf(layout, 16, pixels)) return true;
        }
    }
    return false;
}

} // namespace edgescan::robots
