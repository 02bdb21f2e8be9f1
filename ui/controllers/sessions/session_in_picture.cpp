// PNG text and session files.
#include "ui/controllers/sessions/session_in_picture.h"

#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "ui/base/shown_text.h"

#include <QFileInfo>

namespace edgescan::ui {
namespace {

const QString kSessionKey = QStringLiteral("EdgeScanSession");
// Base64, because texts of a PNG are Latin-1.
constexpr std::size_t kMostCarried = std::size_t{4} << 20U; // PNG readers refuse texts of more than 8 MB
constexpr std::uint64_t kLargestPicture = std::uint64_t{256} << 20U;

} // namespace

bool isSessionFile(const QString& path) {
    return path.endsWith(inspect::kSessionEnding, Qt::CaseInsensitive) || inspect::isSession(exactBytes(path));
}

QImage withSession(QImage picture, const std::string& text) {
    if (!text.empty() && text.size() <= kMostCarried)
        picture.setText(kSessionKey, exactText(QByteArray::fromStdString(text).toBase64().toStdString()));
    return picture;
}

std::string sessionIn(const QString& picture) {
    if (!picture.endsWith(".png", Qt::CaseInsensitive)) return {};
    const auto bytes = readWholeFile(exactBytes(picture), kLargestPicture);
    if (!bytes) return {};
    const std::string text = containers::pngText(textOf(*bytes), kSessionKey.toStdString());
    return QByteArray::fromBase64(QByteArray::fromStdString(text)).toStdString();
}

std::optional<Result<inspect::ReadSession>> sessionOfPicture(const QString& path) {
    const std::string text = sessionIn(path);
    if (text.empty()) return std::nullopt;
    return inspect::sessionFromText(text, exactBytes(QFileInfo(absolutePath(path)).path()), exactBytes(path));
}

} // namespace edgescan::ui
