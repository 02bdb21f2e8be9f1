// sensor_msgs/PointCloud2 as a table of points.
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/base/translated_text.h"
#include "core/files/point_tables/point_columns.h"
#include "core/robots/sweeps/bag_sweep.h"
#include "core/robots/sweeps/frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace edgescan::robots {
namespace {

constexpr std::size_t kFewestPoints = 8; // of the ring with most points
constexpr double kSameShot = 0.1;        // of a period: a second return of one shot
constexpr double kMostFirings = 10'000'000;

/// A period and the time of the first firing.
struct Clock {
    double first = 0, period = 0;
};

std::optional<Clock> clockOf(std::vector<double> times) {
    std::ranges::sort(times);
    std::vector<double> steps;
    for (std::size_t n = 1; n < times.size(); ++n) {
        if (times[n] > times[n - 1]) steps.push_back(times[n] - times[n - 1]);
    }
    if (steps.size() < kFewestPoints) return std::nullopt;
    const double usual = valueInOrder(steps, steps.size() / 4); // points that are missing make longer steps
    double firings = 0;
    for (std::size_t n = 1; n < times.size(); ++n) {
        const double step = (times[n] - times[n - 1]) / usual;
        if (step > kSameShot) firings += std::max(1.0, std::round(step));
    }
    const Clock clock{times.front(), (times.back() - times.front()) / firings};
    return firings < kMostFirings && clock.period > 0 ? std::optional(clock) : std::nullopt;
}

/// A firing begins behind the pause of all rings.
double behindWidestGap(std::vector<double> phases) {
    std::ranges::sort(phases);
    double begin = phases.front(), widest = phases.front() + 1 - phases.back();
    for (std::size_t n = 1; n < phases.size(); ++n) {
        if (phases[n] - phases[n - 1] <= widest) continue;
        widest = phases[n] - phases[n - 1];
        begin = phases[n];
    }
    return begin;
}

/// PointField.datatype, from 1 on.
constexpr std::array<files::Scalar, 8> kScalars{files::Scalar::Int8,    files::Scalar::UInt8,  files::Scalar::Int16,
                                                files::Scalar::UInt16,  files::Scalar::Int32,  files::Scalar::UInt32,
                                                files::Scalar::Float32, files::Scalar::Float64};

std::size_t wholeIn(const RosValue& message, const char* path) {
    return static_cast<std::size_t>(std::max(0.0, message.number(path).value_or(0)));
}

std::vector<files::RecordField> fieldsOf(const RosValue& message, std::size_t pointBytes) {
    const RosValue* all = message.at("fields");
    std::vector<files::RecordField> fields;
    for (std::size_t n = 0; all != nullptr && n < all->inside.size(); ++n) {
        const RosValue& field = all->inside[n];
        const std::size_t type = wholeIn(field, "datatype"), offset = wholeIn(field, "offset");
        if (type < 1 || type > kScalars.size()) continue;
        const files::Scalar scalar = kScalars[type - 1];
        if (offset > pointBytes || sizeOf(scalar) > pointBytes - offset) continue;
        fields.push_back({std::string(field.text("name")), scalar, 0, offset, pointBytes});
    }
    return fields;
}

const files::RecordField* oneOf(const std::vector<files::RecordField>& fields, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        const auto found = std::ranges::find(fields, name, &files::RecordField::name);
        if (found != fields.end()) return &*found;
    }
    return nullptr;
}

/// Lines and beams of a scanner with several beams: its rings are the beams. Of an organised cloud the columns are the firings, of another
/// one the times say them.
void setCellsFromRings(files::PointTable& table, const std::vector<files::RecordField>& fields, std::span<const std::byte> bytes,
                       bool bigEndian) {
    const files::RecordField* ring = oneOf(fields, {"ring", "line", "channel", "laser_id"});
    const files::RecordField* time = oneOf(fields, {"t", "time", "timestamp", "time_stamp", "offset_time", "time_offset"});
    const std::size_t points = table.points.size();
    if (ring == nullptr || !table.line.empty()) return;
    if (table.height > 1) {
        for (std::size_t n = 0; n < points; ++n) {
            table.line.push_back(static_cast<std::uint32_t>(n % table.width));
            table.beam.push_back(static_cast<std::uint32_t>(n / table.width));
        }
    } else if (time != nullptr) {
        std::vector<std::uint32_t> rings(points);
        std::vector<double> times(points);
        forEachScalar(ring->scalar, bytes.data() + ring->offset, ring->stride, points, bigEndian,
                      [&](std::size_t n, double value) { rings[n] = files::indexOf(value); });
        forEachScalar(time->scalar, bytes.data() + time->offset, time->stride, points, bigEndian,
                      [&](std::size_t n, double value) { times[n] = value; });
        if (auto firings = firingsOf(rings, times)) {
            table.line = std::move(*firings);
            table.beam = std::move(rings);
        }
    }
    if (table.line.empty()) return;
    table.gridIsGiven = true;
    table.remarks.emplace_back("The cloud is of a scanner with several beams: its rings are the beams, and its firings the lines.");
}

/// Rows may end with bytes that belong to no point.
std::vector<std::byte> rowsOf(std::span<const std::byte> data, std::size_t height, std::size_t rowBytes, std::size_t stride) {
    std::vector<std::byte> rows;
    rows.reserve(height * rowBytes);
    for (std::size_t row = 0; row < height; ++row) {
        const auto bytes = data.subspan(row * stride, rowBytes);
        rows.insert(rows.end(), bytes.begin(), bytes.end());
    }
    return rows;
}

Result<files::PointTable> tableOf(const RosValue& message, const files::Source& source) {
    const std::size_t height = wholeIn(message, "height"), width = wholeIn(message, "width"), pointBytes = wholeIn(message, "point_step");
    const RosValue* data = message.at("data");
    const std::vector<files::RecordField> all = fieldsOf(message, pointBytes);
    const auto fields = pickFields(all);
    if (!fields || data == nullptr) return source.refused("the cloud has no fields x, y and z", "choose another topic");
    const std::size_t rowBytes = width * pointBytes, stride = std::max(wholeIn(message, "row_step"), rowBytes);
    const std::size_t held = data->bytes.size();
    if (height == 0 || width == 0 || pointBytes == 0 || width > held / pointBytes || height > (held - rowBytes) / stride + 1)
        return source.refused(
            withValues("the cloud promises %1 x %2 points of %3 bytes and holds %4 bytes", {width, height, pointBytes, held}),
            "choose another topic or message");
    if (auto enough = checkMemory(std::uint64_t{height} * width * (sizeof(Eigen::Vector3d) + 16), source.path.string()); !enough)
        return enough.error();
    files::PointTable table;
    table.format = "PointCloud2";
    table.width = width;
    table.height = height;
    table.unitMm = 1000.0;
    const auto bytes = std::as_bytes(std::span(data->bytes.data(), held));
    const bool bigEndian = message.number("is_bigendian").value_or(0) != 0;
    const std::vector<std::byte> packed = stride == rowBytes ? std::vector<std::byte>() : rowsOf(bytes, height, rowBytes, stride);
    const std::span<const std::byte> records = packed.empty() ? bytes : std::span<const std::byte>(packed);
    if (!readRecords(table, *fields, height * width, records, bigEndian, source)) return source.cancelled();
    if (!source.placesOnly) setCellsFromRings(table, all, records, bigEndian);
    return table;
}

} // namespace

// The period of the firings comes from the ring with most points, and then the delay of each ring in it.
std::optional<std::vector<std::uint32_t>> firingsOf(std::span<const std::uint32_t> rings, std::span<const double> times) {
    struct Ring {
        std::vector<double> times;
        double cosine = 0, sine = 0; // sums of the phases
        double phase = 0;            // 0..1 of a period
    };
    std::map<std::uint32_t, Ring> all;
    for (std::size_t n = 0; n < rings.size(); ++n) {
        if (!std::isfinite(times[n])) return std::nullopt;
        all[rings[n]].times.push_back(times[n]);
    }
    if (all.size() < 2) return std::nullopt;
    const auto longest = std::ranges::max_element(all, {}, [](const auto& ring) { return ring.second.times.size(); });
    const auto clock = clockOf(longest->second.times);
    if (!clock) return std::nullopt;
    constexpr double kTurn = 2 * std::numbers::pi;
    double least = 0;
    for (auto& [number, ring] : all) {
        for (const double time : ring.times) {
            const double phase = kTurn * (time - clock->first) / clock->period;
            if (std::abs(phase) > kTurn * kMostFirings) return std::nullopt;
            ring.cosine += std::cos(phase);
            ring.sine += std::sin(phase);
        }
    }
    std::vector<double> phases;
    for (auto& [number, ring] : all) {
        const double phase = std::atan2(ring.sine, ring.cosine) / kTurn;
        phases.push_back(ring.phase = phase - std::floor(phase));
    }
    const double begin = behindWidestGap(phases);
    std::vector<double> firings(rings.size());
    for (std::size_t n = 0; n < rings.size(); ++n) {
        const double phase = all[rings[n]].phase - begin;
        firings[n] = std::round((times[n] - clock->first) / clock->period - begin - (phase - std::floor(phase)));
        least = std::min(least, firings[n]);
    }
    std::vector<std::uint32_t> numbers(rings.size());
    for (std::size_t n = 0; n < rings.size(); ++n) numbers[n] = static_cast<std::uint32_t>(firings[n] - least);
    return numbers;
}

Result<files::PointTable> cloudOfBag(const RosBag& bag, const BagTopic& topic, const files::Source& source) {
    const std::string where = source.path.string();
    const RosTopic& of = bag.topics[topic.topic];
    const auto definition = rosDefinition(of.type, of.definition, where);
    if (!definition) return definition.error();
    const std::optional<std::size_t> wanted = source.options->scanIndex;
    const RosBagMessage* chosen = nullptr;
    std::size_t number = 0, index = 0;
    for (const RosBagMessage& message : bag.messages) {
        if (message.topic != topic.topic) continue;
        const bool better = chosen == nullptr || (wanted ? number == *wanted : message.bytes.size() > chosen->bytes.size());
        if (better) {
            chosen = &message;
            index = number;
        }
        ++number;
    }
    if (wanted.value_or(0) >= number)
        return noSuchScan(wanted.value_or(0), number, withValues("the topic %1", {of.name}), "one cloud", "%1 clouds");
    const auto message = rosMessage(*definition, of.encoding, chosen->bytes, where);
    if (!message) return message.error();
    auto table = tableOf(*message, source);
    if (!table) return table;
    table->remarks.insert(table->remarks.end(), bag.warnings.begin(), bag.warnings.end());
    if (auto guess = guessText(bag, topic, source.options->topic)) table->remarks.push_back(std::move(*guess));
    if (of.assumed)
        table->remarks.emplace_back("The bag holds no definition of its messages: that of the ROS 2 release of 2022 was ASSUMED.");
    if (number > 1)
        table->remarks.push_back(
            withValues("The topic %1 holds a cloud in each message; message %2, counted from 0, was opened. --scan chooses another.",
                       {topicText(bag, topic), index}));
    return table;
}

} // namespace edgescan::robots
