// Runs the stages of rock detection, and skips those whose inputs are unchanged.
#include "core/rocks/attributes/study.h"

#include "core/rocks/attributes/part_distances.h"

#include <optional>
#include <utility>

namespace edgescan::rocks {

namespace {

bool sameInputs(const Inputs& a, const Inputs& b) { return a.cracks == b.cracks && a.responses == b.responses && a.scan == b.scan; }

// Edits change the tree of the uncut segments; that is made once.
std::shared_ptr<const MergeTree> treeOf(const Study& study, const std::vector<Edit>& edits, const Study* before) {
    const auto tree = before != nullptr ? before->tree : std::make_shared<const MergeTree>(mergeTree(*study.uncut));
    if (edits.empty() && !tree->plain) return tree;
    return std::make_shared<const MergeTree>(withPairs(*tree, *study.segmentation, pairsOf(*study.segmentation, edits)));
}

} // namespace

std::vector<const Rock*> rocksToList(const Study& study) {
    std::vector<const Rock*> rocks;
    if (!study.listed) {
        for (const Rock& rock : study.rocks) rocks.push_back(&rock);
        return rocks;
    }
    for (const std::uint32_t label : *study.listed) {
        if (const Rock* rock = rockOf(study.rocks, label)) rocks.push_back(rock);
    }
    return rocks;
}

Study studyRocks(const Inputs& inputs, const RockSettings& settings, const std::vector<Edit>& edits, const Study* before) {
    Study study;
    study.settings = settings;
    study.edits = edits;
    if (before != nullptr && !sameInputs(before->segmentation->inputs, inputs)) before = nullptr;
    const std::vector<CutLine> cuts = cutsOf(edits);
    const bool sameSegments = before != nullptr && cutsOf(before->edits) == cuts;
    study.uncut = before != nullptr ? before->uncut : std::make_shared<const Segmentation>(segmentRocks(inputs));
    study.segmentation = sameSegments   ? before->segmentation
                         : cuts.empty() ? study.uncut
                                        : std::make_shared<const Segmentation>(segmentRocks(inputs, cuts));
    const Segmentation& segments = *study.segmentation;
    study.tree = sameSegments && before->edits == edits ? before->tree : treeOf(study, edits, before);
    study.map = rocksAt(segments, *study.tree, settings, rockCallsOf(segments, edits));
    if (!edits.empty()) {
        const RegionMap plain = rocksAt(*study.uncut, {*study.tree->plain}, settings);
        study.map = withKeptNumbers(std::move(study.map), segments, plain, *study.uncut, edits);
    }
    const std::optional<EarlierRows> rows = sameSegments ? std::optional(EarlierRows{before->map, before->rocks}) : std::nullopt;
    study.rocks = rockRows(segments, study.map, rows ? &*rows : nullptr);
    addLikelyJoins(*study.tree, study.map, study.rocks);
    addPartDistances(segments, *study.tree, study.map, edits, study.rocks);
    return study;
}

} // namespace edgescan::rocks
