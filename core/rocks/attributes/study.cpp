// Runs the stages of rock detection, and skips those whose inputs are unchanged.
#include "core/rocks/attributes/study.h"

#include <optional>

namespace edgescan {

RockStudy studyRocks(const RockInputs& inputs, const RockSettings& settings, const std::vector<RockEdit>& edits, const RockStudy* before) {
    RockStudy study;
    study.settings = settings;
    study.edits = edits;
    const std::vector<CutLine> cuts = cutsOf(edits);
    const bool sameLeaves = before != nullptr && before->leaves->inputs.cracks == inputs.cracks &&
                            before->leaves->inputs.responses == inputs.responses && before->leaves->inputs.scan == inputs.scan &&
                            cutsOf(before->edits) == cuts;
    study.leaves = sameLeaves ? before->leaves : std::make_shared<const RockLeaves>(rockLeaves(inputs, cuts));
    const RockLeaves& leaves = *study.leaves;
    study.tree = sameLeaves && before->edits == edits
                     ? before->tree
                     : std::make_shared<const MergeTree>(mergeTree(leaves.count(), leaves.borders, pairsOf(leaves, edits)));
    study.map = rocksAt(leaves, *study.tree, settings, calledOf(leaves, edits));
    const std::optional<RowsBefore> rows = sameLeaves ? std::optional(RowsBefore{before->map, before->rocks}) : std::nullopt;
    study.rocks = rockRows(leaves, study.map, rows ? &*rows : nullptr);
    return study;
}

} // namespace edgescan
