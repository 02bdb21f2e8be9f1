// Scenes that another simulator stored as a folder: scan.json with scan.u16, and the truth in scan.npz.
#pragma once

#include "app/lab/families/made_scene.h"
#include "core/base/result.h"

#include <filesystem>

namespace edgescan::lab {

/// The arrays of scan.npz that count: `gt` (EdgeClass, thin), `dc` (cells that are not scored; nor are those within two cells of one,
/// unless they are true edges) and `obj` (0 nothing, below 10 wall and floor, from 10 on a stone each). Error: missing, damaged, of
/// different shapes.
Result<MadeScene> storedScene(const std::filesystem::path& folder);

} // namespace edgescan::lab
