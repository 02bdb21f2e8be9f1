// PNG text and session files.
#include "ui/controllers/sessions/session_store.h"

#include "ui/base/shown_text.h"

#include <QFileInfo>
#include <QImageReader>

namespace edgescan::ui {
namespace {

const QString kSittingKey = QStringLiteral("EdgeScanSession");
// Base64: Qt changes blanks of such texts when it reads them.
constexpr std::size_t kMostCarried = std::size_t{4} << 20U; // readers of PNG refuse texts of more than 8 MB
constexpr qint64 kLargestPicture = qint64{256} << 20U;

} // namespace

bool isSittingName(const QString& path) { return path.endsWith(kSittingEnding, Qt::CaseInsensitive); }

QImage withSitting(QImage picture, const std::string& text) {
    if (!text.empty() && text.size() <= kMostCarried)
        picture.setText(kSittingKey, exactText(QByteArray::fromStdString(text).toBase64().toStdString()));
    return picture;
}

std::string sittingIn(const QString& picture) {
    const QFileInfo file(picture);
    if (file.suffix().toLower() != "png" || !file.isFile() || file.size() > kLargestPicture) return {};
    QImageReader reader(picture, "png");
    return QByteArray::fromBase64(reader.text(kSittingKey).toLatin1()).toStdString();
}

std::optional<Result<ReadSitting>> sittingOf(const QString& path) {
    if (isSittingName(path)) return readSitting(path.toStdString());
    const std::string text = sittingIn(path);
    if (text.empty()) return std::nullopt;
    return sittingFromText(text, QFileInfo(path).absolutePath().toStdString(), path.toStdString());
}

} // namespace edgescan::ui
