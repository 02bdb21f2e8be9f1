// Checks for an OpenGL context that VTK can use, before the main window is made, so that a missing one is reported in plain words.
#pragma once

#include <QString>

namespace edgescan::ui {

struct GlCheck {
    bool available = false;
    QString renderer; ///< "llvmpipe (LLVM 15.0.6, 256 bits)", empty when not available
    QString reason;   ///< one sentence with the cause, empty if available
};

/// Needs a QGuiApplication. VTK 9 needs OpenGL 3.2.
[[nodiscard]] GlCheck checkGl();

} // namespace edgescan::ui
