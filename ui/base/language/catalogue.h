// The texts of one language, read from a Qt Linguist file (.ts).
#pragma once

#include <QHash>
#include <QStringList>
#include <QTranslator>

namespace edgescan::ui {

/// One text has one translation in the whole window: the contexts (class names) of Qt are ignored. The context "core" has its sentences.
class Catalogue : public QTranslator {
    Q_OBJECT
public:
    using QTranslator::QTranslator;
    /// Reads a .ts file. False if the file is not a .ts file or has no finished translation.
    bool read(const QString& path);

    [[nodiscard]] QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
    [[nodiscard]] bool isEmpty() const override { return false; } // the English one has the words of a cab
    /// Source and translation.
    [[nodiscard]] const QHash<QString, QString>& texts() const { return texts_; }
    /// The sources of the core's sentences: patterns with %1 to %9 for values, and %n for a number.
    [[nodiscard]] const QStringList& coreTexts() const { return coreTexts_; }

private:
    [[nodiscard]] QString forTouch(QString text) const;

    QHash<QString, QString> texts_;
    QStringList coreTexts_;
};

/// On: tr() writes what a finger does ("tap") instead of what a mouse does ("click"), in the words that the language gives for it.
void useTouchWords(bool on);

/// While an object of this class exists, tr() returns the texts of the sources: for texts that are stored in files and compared later. GUI
/// thread only.
class SourceTexts {
public:
    SourceTexts();
    ~SourceTexts();
    SourceTexts(const SourceTexts&) = delete;
    SourceTexts& operator=(const SourceTexts&) = delete;
};

} // namespace edgescan::ui
