// Checks for an OpenGL context that VTK can use.
#include "ui/views/cloud/gl_check.h"

#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QVTKOpenGLNativeWidget.h>

namespace edgescan::ui {

GlCheck checkGl() {
    const QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create()) return {false, {}, QObject::tr("There is no OpenGL on this display, so the 3D view cannot draw.")};
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) {
        return {false, {}, QObject::tr("OpenGL is installed but does not start on this display, so the 3D view cannot draw.")};
    }
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QSurfaceFormat got = context.format();
    context.doneCurrent();
    const QString renderer = name == nullptr ? QString() : QString(QLatin1String(name));
    if (qMakePair(got.majorVersion(), got.minorVersion()) < qMakePair(3, 2)) {
        return {false, renderer,
                QObject::tr("The 3D view needs OpenGL 3.2; this display offers %1.%2 (%3).")
                    .arg(got.majorVersion())
                    .arg(got.minorVersion())
                    .arg(renderer)};
    }
    return {true, renderer, {}};
}

} // namespace edgescan::ui
