// The name of a step of undo in the words of the sources, for the audit log, and in those of the window.
#pragma once

#include <QObject>
#include <QString>

namespace edgescan::ui {

/// As QUndoCommand takes it: what text() gives, and behind a new line what the menu shows. `given` fills %1, %2 ...
template <class... Given>
[[nodiscard]] QString stepName(const char* text, const Given&... given) {
    QString source = QString::fromUtf8(text), shown = QObject::tr(text);
    ((source = source.arg(given)), ...);
    ((shown = shown.arg(given)), ...);
    return source + '\n' + shown;
}

} // namespace edgescan::ui
