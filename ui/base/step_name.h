// The name of an undo step: in the language of the sources for the audit log, and in the language of the window.
#pragma once

#include <QObject>
#include <QString>

namespace edgescan::ui {

/// In the form that QUndoCommand takes: text() before the line break, the menu's text after it. `given` fills %1, %2 ...
template <class... Given>
[[nodiscard]] QString stepName(const char* text, const Given&... given) {
    QString source = QString::fromUtf8(text), shown = QObject::tr(text);
    ((source = source.arg(given)), ...);
    ((shown = shown.arg(given)), ...);
    return source + '\n' + shown;
}

} // namespace edgescan::ui
