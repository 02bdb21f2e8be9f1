// The texts of one language, as Qt Linguist keeps them (.ts).
#pragma once

#include <QHash>
#include <QTranslator>

namespace edgescan::ui {

/// One text has one translation, wherever in the window it stands: the classes that Qt calls contexts are not looked at.
class Catalogue : public QTranslator {
    Q_OBJECT
public:
    using QTranslator::QTranslator;
    /// Reads a .ts file. False when it is none, or holds no finished translation.
    bool read(const QString& path);

    [[nodiscard]] QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
    [[nodiscard]] bool isEmpty() const override { return texts_.isEmpty(); }
    /// Source and translation.
    [[nodiscard]] const QHash<QString, QString>& texts() const { return texts_; }

private:
    QHash<QString, QString> texts_;
};

/// While one lives, texts are those of the sources: for what is kept in files and compared with them. GUI thread only.
class SourceTexts {
public:
    SourceTexts();
    ~SourceTexts();
    SourceTexts(const SourceTexts&) = delete;
    SourceTexts& operator=(const SourceTexts&) = delete;
};

} // namespace edgescan::ui
