// Reads .ts files.
#include "ui/base/language/catalogue.h"

#include <QFile>
#include <QXmlStreamReader>

namespace edgescan::ui {
namespace {

int sourceTextsWanted = 0;

} // namespace

SourceTexts::SourceTexts() { ++sourceTextsWanted; }
SourceTexts::~SourceTexts() { --sourceTextsWanted; }

bool Catalogue::read(const QString& path) {
    texts_.clear();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return false;
    QXmlStreamReader xml(&file);
    QString source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("source")) {
            source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            const bool unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
            const QString text = xml.readElementText();
            if (!unfinished && !text.isEmpty()) texts_.insert(source, text);
        }
    }
    if (xml.hasError()) texts_.clear();
    return !texts_.isEmpty();
}

QString Catalogue::translate(const char*, const char* source, const char*, int) const {
    return sourceTextsWanted > 0 ? QString() : texts_.value(QString::fromUtf8(source));
}

} // namespace edgescan::ui

#include "moc_catalogue.cpp"
