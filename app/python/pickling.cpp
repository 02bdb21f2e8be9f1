// Scans and results as bytes, for pickle: every member, so that another process of the same program has the same scan and the same mask.
#include "app/python/result.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/scan/grid/acquisition.h"

#include <nlohmann/json.hpp>

#include <concepts>
#include <cstring>
#include <optional>
#include <string_view>
#include <tuple>
#include <variant>

namespace edgescan::python {
namespace {

template <class T, class Of>
concept Some = std::same_as<std::remove_const_t<T>, Of>;

// The members of each type, in their order. A binding names all members: a type with a new one does not compile until it is here.
template <Some<RigidTransform> T>
auto partsOf(T& of) {
    auto& [rotation, translation] = of;
    return std::tie(rotation, translation);
}
template <Some<StepperMount> T>
auto partsOf(T& of) {
    auto& [sensor, axis, zero, direction] = of;
    return std::tie(sensor, axis, zero, direction);
}
template <Some<Boom> T>
auto partsOf(T& of) {
    auto& [pivot, head] = of;
    return std::tie(pivot, head);
}
template <Some<Placement> T>
auto partsOf(T& of) {
    auto& [mount, poses, origin, scale, grid, source, robot, scanStart, scanEnd, time, age, outOfSpec, warnings, boom] = of;
    return std::tie(mount, poses, origin, scale, grid, source, robot, scanStart, scanEnd, time, age, outOfSpec, warnings, boom);
}
template <Some<Acquisition> T>
auto partsOf(T& of) {
    auto& [vendor, model, serial, firmware, start, end, clock, contamination, filter, lines, times] = of;
    return std::tie(vendor, model, serial, firmware, start, end, clock, contamination, filter, lines, times);
}
template <Some<PolarGeometry> T>
auto partsOf(T& of) {
    auto& [beams, lines, axis, direction, skew] = of;
    return std::tie(beams, lines, axis, direction, skew);
}
template <Some<PointGeometry> T>
auto partsOf(T& of) {
    auto& [points, sensor, angles] = of;
    return std::tie(points, sensor, angles);
}
template <Some<AttachedPoint> T>
auto partsOf(T& of) {
    auto& [cell, point] = of;
    return std::tie(cell, point);
}
template <Some<edges::StageTime> T>
auto partsOf(T& of) {
    auto& [stage, milliseconds, cpuMilliseconds, kind] = of;
    return std::tie(stage, milliseconds, cpuMilliseconds, kind);
}
template <Some<Scan> T>
auto partsOf(T& of) {
    auto& [name, path, format, sha256, openedWith, rangeMm, state, intensity, geometry, attached, unitMm, noReturns, statusCodes, warnings,
           pointsRead, leftOut, note, placement, acquisition] = of;
    return std::tie(name, path, format, sha256, openedWith, rangeMm, state, intensity, geometry, attached, unitMm, noReturns, statusCodes,
                    warnings, pointsRead, leftOut, note, placement, acquisition);
}

template <class T>
inline constexpr bool kIsFlat = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_base_of_v<Eigen::MatrixBase<T>, T>;

class Writer {
public:
    std::string bytes;

    template <class T>
    void add(const T& value) {
        if constexpr (kIsFlat<T>)
            addFlat(&value, 1);
        else
            std::apply([this](const auto&... part) { (add(part), ...); }, partsOf(value));
    }
    void add(const std::string& text) { addRow(text); }
    template <class T>
    void add(const std::vector<T>& values) {
        addRow(values);
    }
    template <class T>
    void add(const Grid<T>& grid) {
        add(grid.lines);
        add(grid.beams);
        add(grid.cells);
    }
    template <class T>
    void add(const std::optional<T>& value) {
        addIfThere(value);
    }
    template <class T>
    void add(const std::shared_ptr<const T>& value) {
        addIfThere(value);
    }
    template <class... T>
    void add(const std::variant<T...>& value) {
        add(value.index());
        std::visit([this](const auto& held) { add(held); }, value);
    }

private:
    template <class T>
    void addFlat(const T* values, std::size_t count) {
        bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
    }
    template <class Row>
    void addRow(const Row& row) {
        add(row.size());
        if constexpr (kIsFlat<typename Row::value_type>)
            addFlat(row.data(), row.size());
        else
            for (const auto& each : row) add(each);
    }
    template <class Pointer>
    void addIfThere(const Pointer& value) {
        add(bool{value});
        if (value) add(*value);
    }
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}
    void end() const { check(rest_.empty()); }
    static void check(bool right) {
        if (!right) throw Refused{{"these bytes are not a whole pickle", "pickle", "make it again"}};
    }

    template <class T>
    void read(T& value) {
        if constexpr (kIsFlat<T>)
            readFlat(&value, 1);
        else
            std::apply([this](auto&... part) { (read(part), ...); }, partsOf(value));
    }
    void read(std::string& text) { readRow(text); }
    template <class T>
    void read(std::vector<T>& values) {
        readRow(values);
    }
    template <class T>
    void read(Grid<T>& grid) {
        read(grid.lines);
        read(grid.beams);
        read(grid.cells);
        check(grid.lines >= 0 && grid.beams >= 0 && grid.size() == grid.index(grid.lines, 0));
    }
    template <class T>
    void read(std::optional<T>& value) {
        if (read<bool>()) read(value.emplace());
    }
    template <class T>
    void read(std::shared_ptr<const T>& value) {
        if (read<bool>()) value = std::make_shared<const T>(read<T>());
    }
    void read(Geometry& value) {
        if (read<std::size_t>() == 0)
            value = read<PolarGeometry>();
        else
            value = read<PointGeometry>();
    }
    template <class T>
    T read() {
        T value{};
        read(value);
        return value;
    }

private:
    template <class T>
    void readFlat(T* values, std::size_t count) {
        check(count <= rest_.size() / sizeof(T));
        if (count > 0) std::memcpy(static_cast<void*>(values), rest_.data(), count * sizeof(T));
        rest_.remove_prefix(count * sizeof(T));
    }
    template <class Row>
    void readRow(Row& row) {
        const auto count = read<std::size_t>();
        if constexpr (kIsFlat<typename Row::value_type>)
            check(count <= rest_.size() / sizeof(typename Row::value_type));
        else
            check(count <= rest_.size());
        row.resize(count);
        if constexpr (kIsFlat<typename Row::value_type>)
            readFlat(row.data(), count);
        else
            for (auto& each : row) read(each);
    }

    std::string_view rest_;
};

std::string program() { return std::string(version()) + " " + commit(); }

template <class... T>
py::bytes bytesOf(const T&... parts) {
    return unlocked([&] {
        Writer writer;
        writer.add(program());
        (writer.add(parts), ...);
        return std::move(writer.bytes);
    });
}

Reader readerOf(std::string_view bytes) {
    Reader reader(bytes);
    if (const auto by = reader.read<std::string>(); by != program())
        throw Refused{
            {"it was pickled by EdgeScan " + by + ", and this is " + program(), "pickle", "use one program; for keeping, save() files"}};
    return reader;
}

ScanObject scanOf(const std::string& bytes) {
    return unlocked([&]() -> ScanObject {
        Reader reader = readerOf(bytes);
        auto scan = std::make_shared<Scan>();
        reader.read(*scan);
        reader.end();
        const auto fits = [&](const auto& grid) { return grid.lines == scan->lines() && grid.beams == scan->beams(); };
        Reader::check(fits(scan->state) && (scan->intensity.size() == 0 || fits(scan->intensity)));
        return {std::move(scan)};
    });
}

/// Settings, mask and times; all else is computed from scan and settings when it is asked for.
py::bytes bytesOfResult(const ResultObject& result) {
    const edges::Detection& d = *result.detection;
    return bytesOf(jsonText(edges::settingsToJson(d.settings)), *d.mask, d.classes, d.timings, d.totalMs);
}

ResultObject resultOf(const ScanObject& scan, const std::string& bytes) {
    return unlocked([&]() -> ResultObject {
        Reader reader = readerOf(bytes);
        auto detection = std::make_shared<edges::Detection>();
        detection->scan = scan.scan;
        const auto settings = valueOf(parseJson(reader.read<std::string>(), "pickle"));
        detection->settings = valueOf(edges::settingsFromJson(edges::settingsOfRecord(settings, 0), {}, "pickle"));
        auto mask = std::make_shared<Grid<std::uint8_t>>();
        reader.read(*mask);
        reader.read(detection->classes);
        reader.read(detection->timings);
        reader.read(detection->totalMs);
        reader.end();
        Reader::check(mask->lines == scan.scan->lines() && mask->beams == scan.scan->beams());
        auto edges = std::make_shared<std::vector<std::uint32_t>>();
        for (std::size_t k = 0; k < mask->size(); ++k) {
            if ((*mask)[k] != 0) edges->push_back(static_cast<std::uint32_t>(k));
        }
        detection->mask = std::move(mask);
        detection->edges = std::move(edges);
        return {std::move(detection)};
    });
}

} // namespace

std::shared_ptr<const edges::Detection> whole(const ResultObject& result) {
    if (result.detection->gray) return result.detection;
    ResultObject::Later& later = *result.later;
    std::call_once(later.again, [&] {
        auto again = edges::detectEdges(result.detection->scan, result.detection->settings);
        if (*again->mask != *result.detection->mask)
            throw Refused{{"the mask of the pickle is not that of its scan and settings", "pickle", "detect() again"}};
        later.detection = std::move(again);
    });
    return later.detection;
}

void bindPickling(py::module_& module) {
    module.def("bytes_of_scan", [](const ScanObject& scan) { return bytesOf(*scan.scan); });
    module.def("scan_of_bytes", &scanOf);
    module.def("bytes_of_result", &bytesOfResult);
    module.def("result_of_bytes", &resultOf);
}

} // namespace edgescan::python
