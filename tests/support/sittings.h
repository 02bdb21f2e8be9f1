// A session that holds something of everything.
#pragma once

#include "core/edges/settings/presets.h"
#include "core/inspect/session_file/session_file.h"

#include <string>

namespace edgescan::test {

/// Of a scan of 100 x 1200 cells at `path`.
inline Sitting exampleSitting(const std::filesystem::path& path) {
    Sitting sitting;
    sitting.scan.path = path;
    sitting.scan.identity = {std::string(64, 'a'), "bell", 100, 1200};
    sitting.scan.reading.unitMm = 2.5;
    sitting.scan.reading.axis = Axis::Spin;
    sitting.scan.reading.pose = path.parent_path() / "pose.json";
    sitting.preset = "thesis";
    sitting.settings.classes = 3;
    PinnedTarget target;
    target.number = 4;
    target.name = "keystone";
    target.cell = 77;
    target.locked = true;
    target.pinnedUtc = "2026-11-21T07:00:00Z";
    target.asPinned = {{"Cell", "line 0, beam 77"}};
    sitting.notebook.targets.push_back(target);
    sitting.notebook.measures.push_back({MeasureKind::Distance, {77, 1277}});
    sitting.active = 77;
    sitting.selected = {{5, 3}, {2000, 1}};
    sitting.hidden = {{0, 2}, {119999, 1}};
    RockSettings rocks;
    rocks.level = 1.5;
    sitting.rocks = RockPreset{rocks, {{RockEditKind::Join, {10, 20}}, {RockEditKind::NotRock, {30}}}, sitting.scan.identity.sha256};
    sitting.marks = {{9, 3}, {12}};
    sitting.kept = SittingKept{sitting.scan, cannySettings()};
    sitting.kept->scan.path = path.parent_path() / "before.json";
    sitting.camera = SittingCamera{{1, 2, 3}, {4, 5, 6}, {0, -1, 0}, 40.0, true};
    sitting.images = SittingImages{600.5, 50.25, 3.5};
    sitting.switches = {{"rocks/shown", true}, {"view/overlay", false}};
    sitting.looks = {{"cloud-colour", "range"}, {"range-window-m", "2.5 9 locked"}};
    sitting.layout = {{"window", std::string("AAAA/wAAAAD9")}};
    return sitting;
}

} // namespace edgescan::test
