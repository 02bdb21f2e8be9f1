// Reads a layer and finds its place, off the GUI thread.
#pragma once

#include "core/base/inputs.h"
#include "core/base/result.h"
#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

struct LayerAsked {
    inspect::Layer layer;
    std::vector<inspect::PointPair> pairs; ///< picked in both scans; come before poses
    std::shared_ptr<const Scan> shown;     ///< the scan on the screen: a layer without a place is placed against it
    RigidTransform placeOfShown;           ///< LayerPlace::toFirst of the scan on the screen
    std::function<bool(const Asker& asker, const char* stage, double fraction)> show;
};

/// A layer that is read but whose place is not found has no place, and the reason in `trouble`.
struct LoadedLayer {
    inspect::Layer layer; ///< with identity and place
    std::shared_ptr<const CloudGeometry> cloud;
    std::shared_ptr<const InputClaims> inputs; ///< no export replaces the layer's files
    std::optional<Error> trouble;
};

/// The same ranges, whatever the name of the file.
[[nodiscard]] inline bool isSameContent(const inspect::NotebookScan& a, const inspect::NotebookScan& b) {
    return !a.sha256.empty() && a.sha256 == b.sha256 && a.lines == b.lines && a.beams == b.beams;
}

/// Bytes that the window holds of it.
[[nodiscard]] std::uint64_t bytesOf(const CloudGeometry& cloud);

/// Error: the file cannot be read, has another content than it had when its place was found, or needs more memory than is free.
[[nodiscard]] Result<LoadedLayer> loadLayer(const LayerAsked& asked, const Asker& asker);

} // namespace edgescan::ui
