// What a new sweep and a new connection leave behind.
#pragma once

namespace edgescan::ui {

struct Viewer;

/// Cells that were chosen on a sweep are not marked on the next one; a sweep with targets comes back by Undo. A new connection ends the
/// comparison with a picture of another place. To be called before others learn of new pictures.
void followScanner(Viewer& viewer);

} // namespace edgescan::ui
