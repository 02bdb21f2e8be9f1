// Runs the stages of rock detection, and skips those whose inputs are unchanged.
#include "core/rocks/attributes/study.h"

#include "core/rocks/attributes/part_distances.h"

#include <optional>

namespace edgescan::rocks {

Study studyRocks(const Inputs& inputs, const RockSettings& settings, const std::vector<Edit>& edits, const Study* before) {
    Study study;
    study.settings = settings;
    study.edits = edits;
    const std::vector<CutLine> cuts = cutsOf(edits);
    const bool sameSegments = before != nullptr && before->segmentation->inputs.cracks == inputs.cracks &&
                              before->segmentation->inputs.responses == inputs.responses &&
                              before->segmentation->inputs.scan == inputs.scan && cutsOf(before->edits) == cuts;
    study.segmentation = sameSegments ? before->segmentation : std::make_shared<const Segmentation>(segmentRocks(inputs, cuts));
    const Segmentation& segments = *study.segmentation;
    study.tree = sameSegments && before->edits == edits
                     ? before->tree
                     : std::make_shared<const MergeTree>(mergeTree(segments.count(), segments.borders, pairsOf(segments, edits)));
    study.map = rocksAt(segments, *study.tree, settings, rockCallsOf(segments, edits));
    const std::optional<EarlierRows> rows = sameSegments ? std::optional(EarlierRows{before->map, before->rocks}) : std::nullopt;
    study.rocks = rockRows(segments, study.map, rows ? &*rows : nullptr);
    addPartDistances(segments, study.map, edits, study.rocks);
    return study;
}

} // namespace edgescan::rocks
