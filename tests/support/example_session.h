// A session that holds something of everything.
#pragma once

#include "core/edges/settings/presets.h"
#include "core/inspect/session_file/session_file.h"

#include <string>

namespace edgescan::test {

/// Of a scan of 100 x 1200 cells at `path`.
inline inspect::ViewerState exampleSession(const std::filesystem::path& path) {
    inspect::ViewerState state;
    state.scan.path = path;
    state.scan.identity = {std::string(64, 'a'), "bell", 100, 1200};
    state.scan.reading.unitMm = 2.5;
    state.scan.reading.axis = Axis::Spin;
    state.scan.reading.pose = path.parent_path() / "pose.json";
    state.tuning.preset = "thesis";
    state.tuning.settings.classes = 3;
    inspect::PinnedTarget target;
    target.number = 4;
    target.name = "keystone";
    target.note = "do not blast";
    target.cell = 77;
    target.locked = true;
    target.pinnedUtc = "2026-11-21T07:00:00Z";
    target.asPinned = {{"Cell", "line 0, beam 77"}};
    state.targets.notebook.targets.push_back(target);
    state.targets.notebook.measures.push_back({.kind = inspect::MeasureKind::Distance, .cells = {77, 1277}, .number = 1});
    state.targets.active = 77;
    state.selection.selected = {{5, 3}, {2000, 1}};
    state.selection.hidden = {{0, 2}, {119999, 1}};
    rocks::RockSettings rocks;
    rocks.level = 1.5;
    state.rocks = rocks::Preset{rocks, {{rocks::EditKind::Join, {10, 20}}, {rocks::EditKind::NotRock, {30}}}, state.scan.identity.sha256};
    state.marks = {{9, 3}, {12}};
    state.earlier = inspect::EarlierScan{state.scan, edges::cannySettings()};
    state.earlier->scan.path = path.parent_path() / "before.json";
    state.layers = {{state.scan, true, inspect::LayerPlace{}}, {state.earlier->scan, false, std::nullopt}};
    state.layers.front().place->toFirst.translationM = {1.5, -2.0, 0.25};
    state.layers.front().place->by = inspect::StationBasis::Surfaces;
    state.layers.front().place->residualM = 0.0042;
    state.layers.front().place->warnings = {"OUT OF SPEC: far away."};
    state.view.camera = inspect::SessionCamera{{1, 2, 3}, {4, 5, 6}, {0, -1, 0}, 40.0, true};
    state.view.images = inspect::SessionImages{600.5, 50.25, 3.5};
    state.switches = {{"rocks/shown", true}, {"view/overlay", false}};
    state.looks = {{"cloud-colour", "range"}, {"range-window-m", "2.5 9 locked"}};
    state.layout = {{"window", std::string("AAAA/wAAAAD9")}};
    return state;
}

} // namespace edgescan::test
