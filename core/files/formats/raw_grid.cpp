// Raw grid: NAME.json describes, NAME.u16 holds lines x beams counts (docs/reference/formats.md, "Raw grid").

#include "core/files/formats/format.h"

#include "core/base/checked_size.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/simd.h"
#include "core/base/translated_text.h"
#include "core/base/whole_file.h"
#include "core/files/formats/range_geometry.h"
#include "core/files/point_tables/description.h"
#include "core/scan/grid/count_states.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <system_error>

namespace edgescan::files {
namespace {

namespace fs = std::filesystem;

Result<Done> checkSize(const GridDescription& grid, const fs::path& countsPath, std::size_t bytes) {
    const std::uint64_t cells = productOf({grid.lines, grid.beams});
    const std::uint64_t needed = productOf({cells, 2});
    if (bytes == needed) return Done{};
    const std::string promised = withValues("%1 lines x %2 beams", {grid.lines, grid.beams});
    return Error{withValues("holds %1 bytes where %2 need %3", {bytes, promised, needed}), countsPath.string(),
                 bytes < needed ? "copy the file again, it may be cut off" : "check lines and beams in the .json file"};
}

Result<Done> readGeometry(const GridDescription& grid, const Source& source, Scan& scan) {
    const ReadingOptions& options = *source.options;
    std::string missing;
    const bool beamsKnown = grid.beamDeg || (options.beamStartDeg && options.beamStepDeg);
    const bool linesKnown = grid.lineDeg || (options.lineStartDeg && options.lineStepDeg);
    if (!beamsKnown)
        missing = "\"beam_deg\" is missing";
    else if (!linesKnown)
        missing = "\"line_deg\" is missing";
    else if (!grid.axis && !options.axis)
        missing = "\"axis\" is missing";
    if (!missing.empty())
        return source.refused(missing, "add it to the .json file, or give --beam-start --beam-step --line-start --line-step --axis");
    PolarGeometry polar;
    polar.beamDeg =
        anglesOf(grid.beamDeg.value_or(AngleSteps{options.beamStartDeg.value_or(0), options.beamStepDeg.value_or(0)}), grid.beams);
    polar.lineDeg =
        anglesOf(grid.lineDeg.value_or(AngleSteps{options.lineStartDeg.value_or(0), options.lineStepDeg.value_or(0)}), grid.lines);
    polar.axis = grid.axis ? *grid.axis : *options.axis;
    polar.lineDirection = grid.lineDirection;
    if (grid.lineSkewDeg) polar.lineSkewDeg = anglesOf(*grid.lineSkewDeg, grid.beams);
    scan.geometry = std::move(polar);
    return Done{};
}

static_assert(std::endian::native == std::endian::little, "counts lie in the file as the machine stores them");

EDGESCAN_INLINE void rangesOfCounts(const std::uint16_t* counts, int beams, double unitMm, float* __restrict rangeMm) {
    for (int j = 0; j < beams; ++j) rangeMm[j] = static_cast<float>(counts[j] * unitMm);
}

/// What a hand may have written wrong: names of keys, and the unit.
void warnOfDescription(Scan& scan, const GridDescription& grid, bool unitGiven) {
    for (const std::string& key : grid.unknownKeys)
        scan.warnings.push_back(withValues("\"%1\" is not a key of a raw grid and was not used: check its spelling.", {printable(key)}));
    if (!unitGiven) std::ranges::move(seldomMeasured(scan, "unit_mm"), std::back_inserter(scan.warnings));
}

Result<Scan> readPair(const GridDescription& grid, const Source& source, const fs::path& countsPath, std::span<const std::byte> counts) {
    if (auto fits = checkSize(grid, countsPath, counts.size()); !fits) return fits.error();
    if (auto enough = checkMemory(productOf({grid.lines, grid.beams, 16}), countsPath.string()); !enough) return enough.error();
    Scan scan;
    if (auto known = readGeometry(grid, source, scan); !known) return known.error();
    applyDescription(scan, grid);
    scan.unitMm = source.options->unitMm.value_or(grid.unitMm);
    ReadingOptions file;
    file.unitMm = grid.unitMm;
    scan.warnings = replacedByOptions(*source.options, file);
    constexpr std::array<std::string_view, 1> kIdle{"keep-repeated"};
    std::ranges::move(idleOptions(*source.options, kIdle, "the file names the counts of missing returns"),
                      std::back_inserter(scan.warnings));
    const CountStates states = countStates(grid.noReturnCodes, grid.statusCodes);
    scan.rangeMm = Grid<float>(static_cast<int>(grid.lines), static_cast<int>(grid.beams));
    scan.state = Grid<CellState>(static_cast<int>(grid.lines), static_cast<int>(grid.beams));
    std::vector<std::uint16_t> line(static_cast<std::size_t>(scan.beams()));
    for (int i = 0; i < scan.lines(); ++i) {
        std::memcpy(line.data(), counts.data() + 2 * scan.rangeMm.index(i, 0), 2 * line.size());
        vectorised<rangesOfCounts>(line.data(), scan.beams(), scan.unitMm, scan.rangeMm.line(i));
        CellState* state = scan.state.line(i);
        for (std::size_t j = 0; j < line.size(); ++j) state[j] = states[line[j]];
    }
    applyStateRuns(scan, grid);
    warnOfDescription(scan, grid, source.options->unitMm.has_value());
    scan.format = "raw grid";
    scan.sha256 = sha256Hex(counts);
    return scan;
}

/// In memory: the description, a NUL byte, the counts.
Result<Scan> readBothInOne(const Source& source) {
    const std::string_view text = source.text();
    const std::size_t end = std::min(text.find('\0'), text.size());
    const auto grid = parseDescription(text.substr(0, end), source.path.string());
    if (!grid) return grid.error();
    return readPair(*grid, source, source.path, source.bytes.subspan(std::min(end + 1, text.size())));
}

fs::path withExtension(const fs::path& path, const char* extension) {
    fs::path other = path;
    return other.replace_extension(extension);
}

/// Counts of a scan, or why they cannot be counts.
class Counter {
public:
    explicit Counter(const Scan& scan) : scan_(&scan), statusCodes_(scan.statusCodes), noReturnCodes_(scan.noReturnCodes) {
        if (noReturnCodes_.empty()) noReturnCodes_.push_back(0);
        states_ = countStates(noReturnCodes_, statusCodes_);
    }
    [[nodiscard]] const std::vector<std::uint32_t>& statusCodes() const { return statusCodes_; }
    [[nodiscard]] const std::vector<std::uint32_t>& noReturnCodes() const { return noReturnCodes_; }

    /// Empty when a count cannot express the cell.
    std::optional<std::uint16_t> countOf(std::size_t k) {
        auto count = whole(static_cast<double>(scan_->rangeMm[k]) / scan_->unitMm);
        // What is read back must be what was written, to the last bit.
        if (count && static_cast<float>(*count * scan_->unitMm) != scan_->rangeMm[k]) count.reset();
        switch (scan_->state[k]) {
        case CellState::Valid:
            if (!count || states_[*count] != CellState::Valid) return std::nullopt;
            return count;
        case CellState::DeviceStatus:
            if (!count || states_[*count] == CellState::NoReturn) return std::nullopt;
            if (states_[*count] == CellState::Valid) statusCodes_.push_back(*count);
            states_[*count] = CellState::DeviceStatus;
            return count;
        case CellState::NoReturn:
            if (count && states_[*count] == CellState::NoReturn) return count;
            return noReturnCount();
        default:
            return count ? count : noReturnCount(); // state_runs has its state
        }
    }

private:
    /// The first code that 16 bits can hold.
    [[nodiscard]] std::optional<std::uint16_t> noReturnCount() const {
        const auto fits = std::find_if(noReturnCodes_.begin(), noReturnCodes_.end(), [](std::uint32_t code) { return code <= 65535; });
        if (fits == noReturnCodes_.end()) return std::nullopt;
        return static_cast<std::uint16_t>(*fits);
    }
    static std::optional<std::uint16_t> whole(double value) {
        if (!(value > -0.5 && value < 65535.5) || std::abs(value - std::round(value)) > 1e-3) return std::nullopt;
        return static_cast<std::uint16_t>(std::lround(value));
    }
    const Scan* scan_;
    std::vector<std::uint32_t> statusCodes_, noReturnCodes_;
    CountStates states_{};
};

/// The counts are in the file that the description names, or in NAME.u16 of the same folder.
fs::path countsOf(const GridDescription& grid, const fs::path& describedIn) {
    std::error_code ignored;
    for (const fs::path& name : namesOf(describedIn)) {
        if (grid.dataFile && fs::exists(name.parent_path() / *grid.dataFile, ignored)) return name.parent_path() / *grid.dataFile;
        if (fs::path counts = withExtension(name, ".u16"); fs::exists(counts, ignored)) return counts;
    }
    return grid.dataFile ? describedIn.parent_path() / *grid.dataFile : withExtension(describedIn, ".u16");
}

/// Through the description.
Result<Scan> readRawGridJson(const Source& source) {
    if (source.inMemory) return readBothInOne(source);
    const auto grid = parseDescription(source.text(), source.path.string());
    if (!grid) return grid.error();
    const fs::path countsPath = countsOf(*grid, source.path);
    const bool renamed = grid->dataFile && countsPath.filename() != fs::path(*grid->dataFile).filename();
    const auto counts = readInput(countsPath);
    if (std::error_code ignored; !counts && grid->dataFile && !fs::exists(countsPath, ignored))
        return Error{counts.error().what, source.path.string() + ": " + *grid->dataFile, counts.error().hint};
    if (!counts) return counts.error();
    Result<Scan> scan = readPair(*grid, source, countsPath, *counts);
    if (scan && renamed) {
        scan->warnings.push_back(
            withValues("The data file %1 is missing; %2 was read in its place.", {*grid->dataFile, countsPath.filename().string()}));
    }
    return scan;
}

/// Through the counts; the description is NAME.json of the same folder.
Result<Scan> readRawGridCounts(const Source& source) {
    if (source.inMemory) return source.refused("counts alone are not a raw grid", "give the description before them");
    fs::path describedIn = withExtension(source.path, ".json");
    std::error_code ignored;
    for (const fs::path& name : namesOf(source.path)) {
        if (fs::exists(describedIn, ignored)) break;
        describedIn = withExtension(name, ".json");
    }
    const auto json = readInput(describedIn);
    if (!json) {
        return source.refused(
            withValues("these counts need their description %1 next to them, and it cannot be read", {describedIn.filename().string()}),
            "copy it into the same folder");
    }
    const Source description{describedIn, *json, source.options};
    const auto grid = parseDescription(description.text(), describedIn.string());
    if (!grid) return grid.error();
    return readPair(*grid, description, source.path, source.bytes);
}

/// The pair, counts first: the description must not appear before them. `path` names either of the two.
Result<std::vector<FileBytes>> rawGridFiles(const Scan& scan, const fs::path& path) {
    const Error refused{"", path.string(), "save it as PCD, which carries every scan"};
    if (!std::holds_alternative<PolarGeometry>(scan.geometry)) {
        return Error{"a raw grid needs beam and line angles and this cloud has none", refused.where, refused.hint};
    }
    Counter counter(scan);
    std::string counts;
    counts.reserve(scan.cells() * 2);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const auto count = counter.countOf(k);
        if (!count) {
            const std::string cell =
                withValues("line %1, beam %2", {k / static_cast<std::size_t>(scan.beams()), k % static_cast<std::size_t>(scan.beams())});
            return Error{
                withValues("a raw grid holds whole counts of its unit up to 65535, and the range at %1 is none or means no return", {cell}),
                refused.where, refused.hint};
        }
        counts.push_back(static_cast<char>(*count & 255U));
        counts.push_back(static_cast<char>(*count >> 8U));
    }
    const fs::path countsPath = withExtension(path, ".u16");
    Scan head = headOf(scan);
    head.noReturnCodes = counter.noReturnCodes();
    head.statusCodes = counter.statusCodes();
    head.note = scan.note;
    head.placement = scan.placement;
    head.acquisition = scan.acquisition;
    std::string json = descriptionText(head, countsPath.filename().string(), 1) + "\n";
    return std::vector<FileBytes>{{countsPath, std::move(counts)}, {withExtension(path, ".json"), std::move(json)}};
}

bool looksLikeRawGrid(const Source& source) {
    if (source.extension() == ".u16") return true;
    const std::size_t first = source.text().find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && source.text()[first] == '{';
}

Result<Scan> readRawGrid(const Source& source) {
    return source.extension() == ".u16" ? readRawGridCounts(source) : readRawGridJson(source);
}

} // namespace

Format rawGridFormat() {
    return {.title = "Raw grid",
            .reads = {".json", ".u16"},
            .writes = {".json", ".u16"},
            .recognises = looksLikeRawGrid,
            .read = readingOf<readRawGrid>,
            .writeScan = rawGridFiles};
}

} // namespace edgescan::files
