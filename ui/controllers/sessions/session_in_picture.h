// Sessions in files and in screenshots of the window.
#pragma once

#include "core/inspect/session_file/session_file.h"

#include <QImage>
#include <QString>

#include <optional>

namespace edgescan::ui {

/// True for a session file: by its content whatever its name is, or by its extension, since a damaged one is refused as a session. For any
/// thread.
[[nodiscard]] bool isSessionFile(const QString& path);
/// The picture with the session text embedded.
[[nodiscard]] QImage withSession(QImage picture, const std::string& text);
/// The session text in a picture; empty: none. For any thread.
[[nodiscard]] std::string sessionIn(const QString& picture);
/// The session of a picture; empty: it has none. For any thread.
[[nodiscard]] std::optional<Result<inspect::ReadSession>> sessionOfPicture(const QString& path);

} // namespace edgescan::ui
