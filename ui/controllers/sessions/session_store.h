// Sessions in files and in pictures of the window.
#pragma once

#include "core/inspect/session_file/session_file.h"

#include <QImage>
#include <QString>

#include <optional>

namespace edgescan::ui {

/// Whether the name says so.
[[nodiscard]] bool isSessionName(const QString& path);
/// The picture with the session of these words in it.
[[nodiscard]] QImage withSession(QImage picture, const std::string& text);
/// What a picture carries; empty: nothing. For any thread.
[[nodiscard]] std::string sessionIn(const QString& picture);
/// From a session file or a picture that carries one; empty: the file is neither. For any thread.
[[nodiscard]] std::optional<Result<ReadSession>> sessionOf(const QString& path);

} // namespace edgescan::ui
