// Runs the stages of rock detection, and skips those whose inputs are unchanged.
#include "core/rocks/attributes/study.h"

#include <optional>

namespace edgescan::rocks {

Study studyRocks(const Inputs& inputs, const RockSettings& settings, const std::vector<Edit>& edits, const Study* before) {
    Study study;
    study.settings = settings;
    study.edits = edits;
    const std::vector<CutLine> cuts = cutsOf(edits);
    const bool sameLeaves = before != nullptr && before->segmentation->inputs.cracks == inputs.cracks &&
                            before->segmentation->inputs.responses == inputs.responses &&
                            before->segmentation->inputs.scan == inputs.scan && cutsOf(before->edits) == cuts;
    study.segmentation = sameLeaves ? before->segmentation : std::make_shared<const Segmentation>(segmentRocks(inputs, cuts));
    const Segmentation& leaves = *study.segmentation;
    study.tree = sameLeaves && before->edits == edits
                     ? before->tree
                     : std::make_shared<const MergeTree>(mergeTree(leaves.count(), leaves.borders, pairsOf(leaves, edits)));
    study.map = rocksAt(leaves, *study.tree, settings, rockCallsOf(leaves, edits));
    const std::optional<EarlierRows> rows = sameLeaves ? std::optional(EarlierRows{before->map, before->rocks}) : std::nullopt;
    study.rocks = rockRows(leaves, study.map, rows ? &*rows : nullptr);
    return study;
}

} // namespace edgescan::rocks
