// PNG text and session files.
#include "ui/controllers/sessions/session_in_picture.h"

#include "ui/base/shown_text.h"

#include <QFileInfo>
#include <QImageReader>

namespace edgescan::ui {
namespace {

const QString kSessionKey = QStringLiteral("EdgeScanSession");
// Base64: Qt changes spaces of such texts when it reads them.
constexpr std::size_t kMostCarried = std::size_t{4} << 20U; // PNG readers refuse texts of more than 8 MB
constexpr qint64 kLargestPicture = qint64{256} << 20U;

} // namespace

bool isSessionName(const QString& path) { return path.endsWith(inspect::kSessionEnding, Qt::CaseInsensitive); }

QImage withSession(QImage picture, const std::string& text) {
    if (!text.empty() && text.size() <= kMostCarried)
        picture.setText(kSessionKey, exactText(QByteArray::fromStdString(text).toBase64().toStdString()));
    return picture;
}

std::string sessionIn(const QString& picture) {
    const QFileInfo file(picture);
    if (file.suffix().toLower() != "png" || !file.isFile() || file.size() > kLargestPicture) return {};
    QImageReader reader(picture, "png");
    return QByteArray::fromBase64(reader.text(kSessionKey).toLatin1()).toStdString();
}

std::optional<Result<inspect::ReadSession>> sessionOf(const QString& path) {
    if (isSessionName(path)) return inspect::readSession(path.toStdString());
    const std::string text = sessionIn(path);
    if (text.empty()) return std::nullopt;
    return inspect::sessionFromText(text, QFileInfo(path).absolutePath().toStdString(), path.toStdString());
}

} // namespace edgescan::ui
