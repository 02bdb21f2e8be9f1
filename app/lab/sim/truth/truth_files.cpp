// Reads and writes ground truth.
#include "app/lab/sim/truth/truth_files.h"

#include "app/lab/sim/scene.h"
#include "app/lab/sim/settings_json.h"
#include "app/lab/sim/simulate.h"
#include "core/base/json_text.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace edgescan::sim {
namespace {

constexpr double kSideMm = 100.0;
constexpr double kTearMm = 50.0;
constexpr float kUnsureDeg = 30.0F;
constexpr int kFewest = 2, kMost = 16; // cells of a side

// The cells of one line in beam order, or of one beam in line order.
struct Row {
    const SimulationTruth& truth;
    const std::vector<Eigen::Vector3d>& points; // mm, of all cells
    const Grid<Seam>& seams;                    // from a cell to the next one
    std::size_t first, step;
    int count;

    [[nodiscard]] std::size_t cell(int n) const { return first + static_cast<std::size_t>(n) * step; }
    [[nodiscard]] Eigen::Vector3d normal(int n) const { return truth.normal[cell(n)].cast<double>(); }
    // Whether one surface goes on from a cell to the next one.
    [[nodiscard]] bool goesOn(int n) const {
        const std::size_t a = cell(n), b = cell(n + 1);
        return truth.object[a] != 0 && truth.object[a] == truth.object[b] && truth.face[a] == truth.face[b] && seams[a].tearMm <= kTearMm;
    }
};

struct Side {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    int cells = 0;
};

// From a cell on, one way, over so much of the surface.
Side sideFrom(const Row& row, int from, int way) {
    Side side;
    double length = 0;
    for (int n = from; side.cells < kMost; n += way) {
        side.normal += row.normal(n);
        ++side.cells;
        const int next = n + way;
        if (next < 0 || next >= row.count || !row.goesOn(std::min(n, next))) break;
        length += (row.points[row.cell(next)] - row.points[row.cell(n)]).norm();
        if (length >= kSideMm && side.cells >= kFewest) break;
    }
    return side;
}

// The fold from each cell of the row to the next one; 0 where the surface ends.
std::vector<float> foldsOf(const Row& row) {
    std::vector<float> folds(static_cast<std::size_t>(std::max(0, row.count - 1)), 0.0F);
    for (int n = 0; n + 1 < row.count; ++n) {
        if (!row.goesOn(n)) continue;
        const Side before = sideFrom(row, n, -1), after = sideFrom(row, n + 1, 1);
        if (before.cells < kFewest || after.cells < kFewest) continue;
        const double cosine = std::clamp(before.normal.normalized().dot(after.normal.normalized()), -1.0, 1.0);
        folds[static_cast<std::size_t>(n)] = static_cast<float>(std::acos(cosine) * 180.0 / std::numbers::pi);
    }
    return folds;
}

void storeFolds(const Row& row, Grid<Seam>& seams) {
    const std::vector<float> folds = foldsOf(row);
    const auto at = [&folds](int n) { return n < 0 || n >= static_cast<int>(folds.size()) ? 0.0F : folds[static_cast<std::size_t>(n)]; };
    for (int n = 0; n < static_cast<int>(folds.size()); ++n) {
        const bool largest = at(n) >= std::max(at(n - 1), at(n - 2)) && at(n) > std::max(at(n + 1), at(n + 2));
        seams[row.cell(n)].foldDeg = largest ? at(n) : std::min(at(n), kUnsureDeg);
    }
}

/// The truth of a re-scanned surface with its folds. A mesh of measured points has a fold at every side of a triangle, so the truth of the
/// simulator does not know them. Here a fold between two cells is the angle between the mean normals of the 100 mm on each side, up to a
/// jump. It counts in full where it is largest across the fold, and as at most 30 degrees, which is not sure, elsewhere.
SimulationTruth withFacetFolds(const Simulation& simulation) {
    const SimulationTruth& from = *simulation.truth;
    SimulationTruth truth = from;
    const int lines = from.object.lines, beams = from.object.beams;
    const CartesianTables tables(simulation.scan);
    std::vector<Eigen::Vector3d> points;
    points.reserve(from.object.size());
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) points.push_back(tables.direction(i, j) * static_cast<double>(from.cleanMm.at(i, j)));
    }
    for (int i = 0; i < lines; ++i) storeFolds({from, points, from.toNextBeam, from.object.index(i, 0), 1, beams}, truth.toNextBeam);
    for (int j = 0; j < beams; ++j)
        storeFolds({from, points, from.toNextLine, static_cast<std::size_t>(j), static_cast<std::size_t>(beams), lines}, truth.toNextLine);
    return truth;
}

namespace fs = std::filesystem;

constexpr const char* kFacetClass = "gt_class_facets.png";
constexpr const char* kFacetIgnore = "gt_ignore_facets.png";

using Json = nlohmann::ordered_json;

// Extent of the visible part along its own principal axes, metres, longest first.
std::array<double, 3> visibleSpans(const std::vector<Eigen::Vector3d>& points) {
    std::array<double, 3> spans{};
    if (points.size() < 3) return spans;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& p : points) mean += p;
    mean /= static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& p : points) spread += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    for (int axis = 0; axis < 3; ++axis) {
        double low = 0;
        double high = 0;
        for (const auto& p : points) {
            const double along = axes.eigenvectors().col(2 - axis).dot(p - mean);
            low = std::min(low, along);
            high = std::max(high, along);
        }
        spans[static_cast<std::size_t>(axis)] = high - low;
    }
    return spans;
}

Json rocksJson(const Simulation& simulation) {
    const SimulationTruth& truth = *simulation.truth;
    const CartesianTables tables(simulation.scan);
    std::vector<std::vector<Eigen::Vector3d>> visible(65536);
    for (std::size_t k = 0; k < truth.object.size(); ++k) {
        if (truth.object[k] < sim::kFirstRock) continue;
        const int line = static_cast<int>(k / static_cast<std::size_t>(truth.object.beams));
        const int beam = static_cast<int>(k % static_cast<std::size_t>(truth.object.beams));
        visible[truth.object[k]].push_back(tables.direction(line, beam) * (0.001 * static_cast<double>(truth.cleanMm[k])));
    }
    Json rocks = Json::array();
    for (const auto& rock : truth.rocks) {
        const auto& points = visible[static_cast<std::size_t>(rock.object)];
        rocks.push_back({{"object", rock.object},
                         {"centre_m", {rock.centreM.x(), rock.centreM.y(), rock.centreM.z()}},
                         {"spans_m", rock.spansM},
                         {"volume_m3", rock.volumeM3},
                         {"visible_cells", points.size()},
                         {"visible_spans_m", visibleSpans(points)}});
    }
    return rocks;
}

} // namespace

Grid<std::uint16_t> wholeMm(const Grid<float>& mm) {
    Grid<std::uint16_t> whole(mm.lines, mm.beams);
    for (std::size_t k = 0; k < mm.size(); ++k) whole[k] = static_cast<std::uint16_t>(std::clamp(std::round(mm[k]), 0.0F, 65535.0F));
    return whole;
}

Grid<std::uint16_t> wholeTears(const Grid<sim::Seam>& seams) {
    Grid<std::uint16_t> mm(seams.lines, seams.beams);
    for (std::size_t k = 0; k < mm.size(); ++k) mm[k] = static_cast<std::uint16_t>(std::clamp(std::round(seams[k].tearMm), 0.0F, 65535.0F));
    return mm;
}

Result<Grid<std::uint16_t>> readTruthNumbers(const fs::path& path) {
    std::error_code failed;
    if (!fs::exists(path, failed)) return Grid<std::uint16_t>();
    ReadingOptions options; // placeholder angles, because a picture has no angles
    options.beamStartDeg = 0.0;
    options.beamStepDeg = 0.001;
    options.lineStartDeg = 0.0;
    options.lineStepDeg = 0.001;
    options.axis = Axis::Sweep;
    options.unitMm = 1.0;
    const auto picture = files::openScan(path, options);
    if (!picture) return picture.error();
    Grid<std::uint16_t> numbers(picture->lines(), picture->beams());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (picture->state[k] == CellState::Valid) numbers[k] = static_cast<std::uint16_t>(picture->rangeMm[k]);
    }
    return numbers;
}

TruthSet truthSetOf(const Simulation& simulation) {
    return {edgeTruth(*simulation.truth), simulation.truth->object, wholeMm(simulation.truth->cleanMm)};
}

Result<Done> writeTruthSet(const TruthSet& truth, const fs::path& folder) {
    if (auto made = makeFolder(folder); !made) return made;
    for (const auto& [name, grid] : {std::pair{"gt_class.png", &truth.edges.edgeClass}, std::pair{"gt_ignore.png", &truth.edges.ignore}}) {
        if (auto written = containers::savePng8(*grid, folder / name); !written) return written;
    }
    if (auto written = containers::savePng16(truth.object, folder / "object.png"); !written) return written;
    return containers::savePng16(truth.cleanMm, folder / "range_clean.png");
}

Result<Done> writeRockList(const Simulation& simulation, const fs::path& folder) {
    return writeWholeFile(folder / "rocks.json", jsonText(rocksJson(simulation), 2) + "\n");
}

Result<Done> writeTruth(const Simulation& simulation, const SimulationSettings& settings, const fs::path& folder) {
    if (auto written = writeTruthSet(truthSetOf(simulation), folder); !written) return written;
    if (auto written = writeRockList(simulation, folder); !written) return written;
    if (auto written = writeWholeFile(folder / "scene.json", jsonText(settingsJson(settings), 2) + "\n"); !written) return written;
    if (!settings.surface.empty()) {
        const EdgeTruth facets = edgeTruth(withFacetFolds(simulation));
        for (const auto& [name, grid] : {std::pair{kFacetClass, &facets.edgeClass}, std::pair{kFacetIgnore, &facets.ignore}}) {
            if (auto written = containers::savePng8(*grid, folder / name); !written) return written;
        }
    }
    if (auto written = containers::savePng16(simulation.truth->face, folder / "face.png"); !written) return written;
    if (auto written = containers::savePng16(wholeTears(simulation.truth->toNextBeam), folder / "tear_beam.png"); !written) return written;
    return containers::savePng16(wholeTears(simulation.truth->toNextLine), folder / "tear_line.png");
}

bool hasFacets(const fs::path& folder) {
    std::error_code failed;
    return fs::exists(folder / kFacetClass, failed);
}

Result<TruthSet> readTruth(const fs::path& folder, Facets facets) {
    const bool folds = facets == Facets::Folds && hasFacets(folder);
    auto edgeClass = containers::readPng8(folder / (folds ? kFacetClass : "gt_class.png"));
    if (!edgeClass) return edgeClass.error();
    auto ignore = containers::readPng8(folder / (folds ? kFacetIgnore : "gt_ignore.png"));
    if (!ignore) return ignore.error();
    auto object = readTruthNumbers(folder / "object.png");
    if (!object) return object.error();
    auto clean = readTruthNumbers(folder / "range_clean.png");
    if (!clean) return clean.error();
    const auto differs = [&](int lines, int beams) { return lines != edgeClass->lines || beams != edgeClass->beams; };
    const auto optionalDiffers = [&](const Grid<std::uint16_t>& grid) { return grid.size() > 0 && differs(grid.lines, grid.beams); };
    if (differs(ignore->lines, ignore->beams) || optionalDiffers(*object) || optionalDiffers(*clean))
        return Error{"the pictures of the truth have different sizes", folder.string(), "write the truth again"};
    for (std::uint8_t& value : edgeClass->cells) {
        if (value > static_cast<std::uint8_t>(EdgeClass::Void))
            return Error{"gt_class.png holds the class " + std::to_string(value), folder.string(), "classes are 0 to 4"};
    }
    return TruthSet{{std::move(*edgeClass), std::move(*ignore)}, std::move(*object), std::move(*clean)};
}

} // namespace edgescan::sim
