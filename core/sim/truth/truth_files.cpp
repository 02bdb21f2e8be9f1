// Reads and writes ground truth.
#include "core/sim/truth/truth_files.h"

#include "core/base/json_text.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/cartesian.h"
#include "core/sim/scene.h"
#include "core/sim/settings_json.h"
#include "core/sim/truth/facets.h"

#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace edgescan::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFacetClass = "gt_class_facets.png";
constexpr const char* kFacetIgnore = "gt_ignore_facets.png";

using Json = nlohmann::ordered_json;

Grid<std::uint16_t> wholeMm(const Grid<float>& mm) {
    Grid<std::uint16_t> whole(mm.lines, mm.beams);
    for (std::size_t k = 0; k < mm.size(); ++k) whole[k] = static_cast<std::uint16_t>(std::clamp(std::round(mm[k]), 0.0F, 65535.0F));
    return whole;
}

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

Result<Done> writeTruth(const Simulation& simulation, const SimulationSettings& settings, const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return Error{"the folder cannot be made (" + failed.message() + ")", folder.string(), "choose one that can be written to"};
    const TruthSet truth = truthSetOf(simulation);
    const auto texts = {std::pair{"rocks.json", jsonText(rocksJson(simulation), 2) + "\n"},
                        std::pair{"scene.json", jsonText(settingsJson(settings), 2) + "\n"}};
    for (const auto& [name, text] : texts) {
        if (auto written = writeWholeFile(folder / name, text); !written) return written;
    }
    for (const auto& [name, grid] : {std::pair{"gt_class.png", &truth.edges.edgeClass}, std::pair{"gt_ignore.png", &truth.edges.ignore}}) {
        if (auto written = containers::savePng8(*grid, folder / name); !written) return written;
    }
    if (!settings.surface.empty()) {
        const EdgeTruth facets = edgeTruth(withFacetFolds(simulation));
        for (const auto& [name, grid] : {std::pair{kFacetClass, &facets.edgeClass}, std::pair{kFacetIgnore, &facets.ignore}}) {
            if (auto written = containers::savePng8(*grid, folder / name); !written) return written;
        }
    }
    if (auto written = containers::savePng16(truth.object, folder / "object.png"); !written) return written;
    if (auto written = containers::savePng16(simulation.truth->face, folder / "face.png"); !written) return written;
    if (auto written = containers::savePng16(wholeTears(simulation.truth->toNextBeam), folder / "tear_beam.png"); !written) return written;
    if (auto written = containers::savePng16(wholeTears(simulation.truth->toNextLine), folder / "tear_line.png"); !written) return written;
    return containers::savePng16(truth.cleanMm, folder / "range_clean.png");
}

Result<TruthSet> readTruth(const fs::path& folder, Facets facets) {
    std::error_code failed;
    const bool folds = facets == Facets::Folds && fs::exists(folder / kFacetClass, failed);
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
