// Text that is shortened to the available width.
#pragma once

#include <QLabel>
#include <QPainter>
#include <QStringList>
#include <QTextLayout>
#include <QTextOption>

namespace edgescan::ui {

/// Text that does not fit ends in "…" after a whole word.
class ElidedLabel : public QLabel {
public:
    /// `most`: lines, if one line is too short for the text.
    explicit ElidedLabel(QWidget* parent = nullptr, int most = 1) : QLabel(parent), most_(most) {
        setTextFormat(Qt::PlainText);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }
    [[nodiscard]] QString shown() const { return lines(contentsRect().width()).join(QString()); }
    [[nodiscard]] bool fits(int wide) const { return lines(wide).join(QString()) == text(); }
    void setLines(int most) {
        most_ = most;
        update();
    }

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        const QStringList all = lines(contentsRect().width());
        const int high = fontMetrics().height();
        QRect place = contentsRect();
        place.setTop(place.center().y() - static_cast<int>(all.size()) * high / 2);
        for (const QString& line : all) {
            painter.drawText(QRect(place.left(), place.top(), place.width(), high), Qt::AlignVCenter | Qt::AlignLeft | Qt::TextSingleLine,
                             line);
            place.setTop(place.top() + high);
        }
    }

private:
    [[nodiscard]] QStringList lines(int wide) const {
        QStringList all;
        QString rest = text();
        while (static_cast<int>(all.size()) + 1 < most_ && fontMetrics().horizontalAdvance(rest) > wide) {
            QTextLayout layout(rest, font());
            QTextOption breaks;
            breaks.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere); // a path is one word
            layout.setTextOption(breaks);
            layout.beginLayout();
            QTextLine line = layout.createLine();
            line.setLineWidth(wide);
            layout.endLayout();
            all << rest.left(line.textLength());
            rest.remove(0, line.textLength());
        }
        return all << shortened(rest, wide);
    }
    [[nodiscard]] QString shortened(const QString& rest, int wide) const {
        const QString cut = fontMetrics().elidedText(rest, Qt::ElideRight, wide);
        const auto word = cut.lastIndexOf(' ');
        if (cut == rest || word <= 0) return cut;
        const bool whole = rest.startsWith(cut.chopped(1) + ' '); // cut between two words
        return whole ? cut : cut.left(word) + QStringLiteral("…");
    }

    int most_;
};

} // namespace edgescan::ui
