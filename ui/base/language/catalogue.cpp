// Reads .ts files.
#include "ui/base/language/catalogue.h"

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <atomic>

namespace edgescan::ui {
namespace {

int sourceTextsWanted = 0;
std::atomic<bool> touchWordsWanted = false;

// A translation has the pairs of its own language: longer words first, in lower case.
constexpr const char* kTouchWords =
    QT_TRANSLATE_NOOP("QObject", "right-click > hold a finger on | clicked > tapped | clicks > taps | click > tap");

/// French has spaces before ":;?!%»" and after "«", at which no line may end. The words of a finger are pairs, not a text.
QString withoutBreaks(QString text) {
    static const QRegularExpression before(" (?=[:;?!%»](?:\\s|$|[.,)]))"), after("« ");
    return text.replace(before, QString(QChar(0x00A0))).replace(after, QString("«") + QChar(0x00A0));
}

} // namespace

void useTouchWords(bool on) { touchWordsWanted = on; }

SourceTexts::SourceTexts() { ++sourceTextsWanted; }
SourceTexts::~SourceTexts() { --sourceTextsWanted; }

bool Catalogue::read(const QString& path) {
    texts_.clear();
    coreTexts_.clear();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return false;
    QXmlStreamReader xml(&file);
    QString source, context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("source")) {
            source = xml.readElementText();
            if (context == "core") coreTexts_ << source;
        } else if (xml.name() == QLatin1String("translation")) {
            const bool unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
            const QString text = xml.readElementText();
            if (!unfinished && !text.isEmpty()) texts_.insert(source, withoutBreaks(text));
        }
    }
    if (xml.hasError()) texts_.clear();
    return !texts_.isEmpty();
}

QString Catalogue::translate(const char*, const char* source, const char*, int) const {
    if (sourceTextsWanted > 0) return {};
    const QString key = QString::fromUtf8(source), text = texts_.value(key);
    return touchWordsWanted ? forTouch(text.isNull() ? key : text) : text;
}

QString Catalogue::forTouch(QString text) const {
    // A cab has no keyboard and no wheel: "Undo (Ctrl+Z)" names its button only.
    static const QRegularExpression key(" ?\\((?:[A-Z]|(?:(?:(?:Ctrl|Shift|Alt|Strg|Mayús|Maj)\\+)+|wheel|rueda|molette|roda)[^)]+)\\)");
    text.remove(key).replace("Ctrl+Z", texts_.value("Undo", "Undo"));
    const QString pairs = QString::fromUtf8(kTouchWords);
    for (const QString& pair : texts_.value(pairs, pairs).split(" | ")) {
        const QString word = pair.section(" > ", 0, 0), instead = pair.section(" > ", 1);
        if (!text.contains(word, Qt::CaseInsensitive)) continue;
        const auto replace = [&](const QString& from, const QString& to) {
            text.replace(QRegularExpression("\\b" + from + "\\b", QRegularExpression::UseUnicodePropertiesOption), to);
        };
        replace(word, instead);
        replace(word.left(1).toUpper() + word.mid(1), instead.left(1).toUpper() + instead.mid(1));
    }
    return text;
}

} // namespace edgescan::ui

#include "moc_catalogue.cpp"
