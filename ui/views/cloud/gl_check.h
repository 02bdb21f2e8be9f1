// Is there an OpenGL context that VTK can draw with? Asked before the main window is made, to tell the user plainly.
#pragma once

#include <QString>

namespace edgescan::ui {

struct GlCheck {
    bool available = false;
    QString renderer; ///< "llvmpipe (LLVM 15.0.6, 256 bits)", empty when not available
    QString reason;   ///< one sentence why not, empty when available
};

/// Needs a QGuiApplication. VTK 9 needs OpenGL 3.2.
[[nodiscard]] GlCheck checkGl();

} // namespace edgescan::ui
