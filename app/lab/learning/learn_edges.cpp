// Asks of every drawn edge whether it is the border of a body.
#include "app/lab/learning/learn_edges.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/rock_borders/border_features.h"

#include <algorithm>
#include <vector>

namespace edgescan::lab {
namespace {

constexpr int kReach = 2;              // cells between an edge and the true one, as in the score
constexpr std::size_t kLeastBody = 25; // cells; smaller bodies are not scored

void markAround(Grid<std::uint8_t>& marks, int line, int beam, int reach) {
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            if (i * i + j * j <= reach * reach && marks.contains(line + i, beam + j)) marks.at(line + i, beam + j) = 1;
        }
    }
}

bool isOutline(std::uint8_t edgeClass) {
    return edgeClass != static_cast<std::uint8_t>(sim::EdgeClass::None) && edgeClass != static_cast<std::uint8_t>(sim::EdgeClass::Crease);
}

} // namespace

Grid<std::uint8_t> trueBorders(const sim::TruthSet& truth) {
    const Grid<std::uint8_t>& classes = truth.edges.edgeClass;
    const Grid<std::uint16_t>& object = truth.object;
    Grid<std::uint8_t> marks(classes.lines, classes.beams);
    std::vector<std::size_t> cells(65536);
    for (const std::uint16_t body : object.cells) ++cells[body];
    const auto differ = [&](int i, int j, int besideLine, int besideBeam) {
        if (object.size() == 0 || !object.contains(besideLine, besideBeam)) return false;
        const std::uint16_t a = object.at(i, j), b = object.at(besideLine, besideBeam);
        return a != b && cells[a] >= kLeastBody && cells[b] >= kLeastBody;
    };
    for (int i = 0; i < classes.lines; ++i) {
        for (int j = 0; j < classes.beams; ++j) {
            if (isOutline(classes.at(i, j))) markAround(marks, i, j, kReach);
            if (differ(i, j, i, j + 1) || differ(i, j, i + 1, j) || differ(i, j, i, j - 1) || differ(i, j, i - 1, j))
                markAround(marks, i, j, 1);
        }
    }
    return marks;
}

void addEdgeSamples(const std::shared_ptr<const Scan>& scan, const sim::TruthSet& truth, std::size_t most, TreeSamples& samples) {
    const auto detection = edges::detectEdges(scan, edges::Settings{});
    const Grid<std::uint8_t> border = trueBorders(truth);
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t k : *detection->edges) {
        const edges::DepthEdge kind = (*detection->classes)[k];
        const bool isResponse = kind == edges::DepthEdge::Jump || kind == edges::DepthEdge::Convex || kind == edges::DepthEdge::Concave;
        if (isResponse && (border[k] != 0 || truth.edges.ignore[k] == 0)) cells.push_back(k);
    }
    const edges::BorderMeasure measure(*detection->surface, *detection->responses, detection->settings);
    edges::BorderFeatures features{};
    const std::size_t count = std::min(most, cells.size());
    for (std::size_t n = 0; n < count; ++n) {
        const std::uint32_t k = cells[n * cells.size() / count];
        if (measure.measure(k, features)) samples.add(features, border[k] != 0, 1.0F);
    }
}

} // namespace edgescan::lab
