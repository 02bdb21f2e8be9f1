// Evidence on cracks, added up to borders.
#include "core/rocks/leaf_borders.h"

#include "core/depth/depth_field.h"
#include "core/rocks/rock_barrier.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

// z = log odds "two rocks" (docs/rocks-method.md, "Step 4").
constexpr double kWeightCrack = 7.0;
constexpr double kWeightEdge = 9.0;
constexpr double kWeightValley = 2.0;
constexpr double kOdds = -10.5;
constexpr double kValleyUnitMm = 30.0;
constexpr double kMostValleyMm = 60.0;
constexpr float kChordM = 0.12F;
constexpr float kFewestChord = 2;
constexpr float kMostChord = 12;
constexpr float kContactJump = 0.5F;
constexpr float kContactFold = -0.3F;

} // namespace

CrackMeasure::CrackMeasure(const RockInputs& inputs, const Grid<std::uint32_t>& leaf)
    : inputs_(inputs), cracks_(*inputs.cracks), leaf_(leaf) {}

bool CrackMeasure::isContact(std::size_t p, std::size_t q, Along along) const {
    const Grid<float>& fold = along == Along::Beams ? cracks_.foldBeams : cracks_.foldLines;
    return jump(p, along) <= kContactJump && std::min(fold[p], fold[q]) < kContactFold;
}

// The chord ends up to 120 mm from the crack on both sides, within both leaves.
double CrackMeasure::valleyMm(int line, int beam, Along along) const {
    const Grid<float>& u = cracks_.smoothed;
    const bool isBeams = along == Along::Beams;
    const std::size_t step = isBeams ? 1 : static_cast<std::size_t>(leaf_.beams);
    const std::size_t p = leaf_.index(line, beam);
    const std::size_t q = p + step;
    const float nearest = std::max(u[p], u[q]);
    const AngularSteps& steps = inputs_.surface->steps;
    const float angle = isBeams ? steps.beam[static_cast<std::size_t>(beam)] : steps.lineAt(line, beam);
    const int reach = static_cast<int>(std::clamp(std::round(kChordM * nearest / angle), kFewestChord, kMostChord));
    const int before = isBeams ? beam : line;
    const int after = (isBeams ? leaf_.beams : leaf_.lines) - before - 2;
    int a = 0;
    while (a < std::min(reach, before) && leaf_[p - static_cast<std::size_t>(a + 1) * step] == leaf_[p]) ++a;
    int b = 0;
    while (b < std::min(reach, after) && leaf_[q + static_cast<std::size_t>(b + 1) * step] == leaf_[q]) ++b;
    if (a == 0 || b == 0) return 0.0;
    const auto from = static_cast<double>(u[p - static_cast<std::size_t>(a) * step]);
    const auto to = static_cast<double>(u[q + static_cast<std::size_t>(b) * step]);
    const double slope = (to - from) / static_cast<double>(a + b + 1);
    const double underP = from + slope * a - static_cast<double>(u[p]);
    const double underQ = from + slope * (a + 1) - static_cast<double>(u[q]);
    return 1000.0 * std::max(underP, underQ) / (static_cast<double>(nearest) * static_cast<double>(nearest));
}

CrackEvidence CrackMeasure::at(int line, int beam, Along along) const {
    const bool isBeams = along == Along::Beams;
    const std::size_t step = isBeams ? 1 : static_cast<std::size_t>(leaf_.beams);
    const std::size_t p = leaf_.index(line, beam);
    const std::size_t q = p + step;
    const Grid<float>& fold = isBeams ? cracks_.foldBeams : cracks_.foldLines;
    float edge = std::max(partingStrength(*inputs_.responses, p), partingStrength(*inputs_.responses, q));
    const int place = isBeams ? beam : line;
    if (place > 0) edge = std::max(edge, partingStrength(*inputs_.responses, p - step));
    if (place + 2 < (isBeams ? leaf_.beams : leaf_.lines)) edge = std::max(edge, partingStrength(*inputs_.responses, q + step));
    CrackEvidence evidence;
    evidence.e1 = static_cast<double>(std::clamp(std::max({jump(p, along), -fold[p], -fold[q]}), 0.0F, 1.0F));
    evidence.e2 = static_cast<double>(std::min(edge, 1.0F));
    evidence.valleyMm = valleyMm(line, beam, along);
    evidence.v = std::clamp(evidence.valleyMm, -kMostValleyMm, kMostValleyMm) / kValleyUnitMm;
    evidence.z = kWeightCrack * evidence.e1 + kWeightEdge * evidence.e2 + kWeightValley * evidence.v + kOdds;
    return evidence;
}

std::vector<LeafBorder> leafBorders(const RockInputs& inputs, const Grid<std::uint32_t>& leaf) {
    const CrackMeasure measure(inputs, leaf);
    std::vector<LeafBorder> cracks;
    const auto look = [&](int line, int beam, Along along) {
        const std::size_t p = leaf.index(line, beam);
        const std::size_t q = p + (along == Along::Beams ? 1 : static_cast<std::size_t>(leaf.beams));
        if (leaf[p] == leaf[q] || leaf[p] == kOpen || leaf[q] == kOpen) return;
        const CrackEvidence evidence = measure.at(line, beam, along);
        const auto whole = [](double value) { return static_cast<std::int64_t>(std::llround(value / kEvidenceStep)); };
        LeafBorder crack{leaf[p], leaf[q], whole(evidence.z), 1, 0, 0, 0, whole(evidence.e1), whole(evidence.e2), whole(evidence.v)};
        if (measure.jump(p, along) > 1.0F) (measure.isNearer(p, q) ? crack.jumpsA : crack.jumpsB) = 1;
        crack.valleys = measure.isContact(p, q, along) ? 1 : 0;
        cracks.push_back(crack.a < crack.b ? crack : crack.turned());
    };
    for (int i = 0; i < leaf.lines; ++i) {
        for (int j = 0; j < leaf.beams; ++j) {
            if (j + 1 < leaf.beams) look(i, j, Along::Beams);
            if (i + 1 < leaf.lines) look(i, j, Along::Lines);
        }
    }
    return addedUp(std::move(cracks));
}

std::vector<LeafBorder> addedUp(std::vector<LeafBorder> parts) {
    const auto place = [](const LeafBorder& border) { return (static_cast<std::uint64_t>(border.a) << 32U) | border.b; };
    std::sort(parts.begin(), parts.end(), [&](const LeafBorder& x, const LeafBorder& y) { return place(x) < place(y); });
    std::size_t count = 0;
    for (const LeafBorder& part : parts) {
        if (count > 0 && place(parts[count - 1]) == place(part))
            parts[count - 1].add(part);
        else
            parts[count++] = part;
    }
    parts.resize(count);
    return parts;
}

} // namespace edgescan
