// File dialog filters of formats.
#pragma once

#include "core/files/formats/formats.h"

#include <QObject>
#include <QStringList>

#include <vector>

namespace edgescan::ui {

/// "Point Cloud Library (*.pcd)"; empty if the format has no extensions of that kind.
[[nodiscard]] inline QString filterOf(const files::Format& format, const std::vector<const char*>& extensions) {
    QStringList patterns;
    for (const char* extension : extensions) patterns << QString("*") + extension;
    return patterns.isEmpty() ? QString() : QString("%1 (%2)").arg(QObject::tr(format.title), patterns.join(' '));
}

} // namespace edgescan::ui
