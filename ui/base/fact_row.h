// Facts about a target, a rock or a measurement, and their rows on a card: at the desk and, in large letters, in cab mode.
#pragma once

#include <QLabel>
#include <QStringList>

#include <vector>

class QVBoxLayout;

namespace edgescan::ui {

/// With the largest letters, from `mostPx` down to `leastPx`, in which the text fits into the room.
[[nodiscard]] QFont fittedFont(QFont letters, const QString& text, int room, int mostPx, int leastPx);

/// One line. It never requests more width than it is given. The font shrinks down to `leastPx`; text that still does not fit is in the tool
/// tip.
class FittedLabel : public QLabel {
public:
    FittedLabel(int mostPx, int leastPx, QWidget* parent = nullptr);

    void showText(const QString& text);
    void setMost(int px);
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    int mostPx_, leastPx_;
};

/// It is made once; card, cab mode and files read it by its key.
struct Fact {
    const char* key;         ///< "distance"; the same in every language
    QString name{}, value{}; ///< "Distance", "4.911 m"
    QString tolerance{};     ///< "± 0.009 m"
    QString tip{};
    const char* unit = "";   ///< shown after the name; not stored
    bool measured = true;    ///< a slider can change it: then the card also shows the earlier value
    bool known = true;       ///< false: not computed yet, not to be stored
    bool links = false;      ///< its value is rich text with links
    QStringList numbers{};   ///< of a place
    QString was{};           ///< the value when the target was set, if it was another one
    bool underlined = false; ///< it can be tapped

    [[nodiscard]] QString text() const { return tolerance.isEmpty() ? value : value + " " + tolerance; }
};
using Facts = std::vector<Fact>;

/// Null: no fact has the key.
[[nodiscard]] const Fact* factOf(const Facts& facts, const char* key);

/// GUI thread only.
class FactRow : public QWidget {
public:
    enum class Look {
        Line,    ///< the name at the left, the value at the right
        Number,  ///< name and tolerance, and below them the value in the largest letters that fit
        Short,   ///< a short name, and next to it the value in large letters
        Words,   ///< the value alone
        Warning, ///< the same in the colour of warnings
    };
    /// `name`: the object name of the label with the value; those of the others are made of it.
    FactRow(Look look, const QString& name, QWidget* parent);

    void show(const Fact& fact);
    void setLetters(int namePx, int valuePx);
    [[nodiscard]] Look look() const { return look_; }
    [[nodiscard]] const Fact& fact() const { return fact_; }
    [[nodiscard]] QLabel& value() const { return *value_; }
    /// "Cell: line 3 · beam 7".
    [[nodiscard]] QString text() const;

private:
    Look look_;
    Fact fact_{""};
    QLabel *name_, *value_, *tolerance_;
};

/// The rows of a card. GUI thread only.
class FactList : public QWidget {
    Q_OBJECT
public:
    struct Shown {
        FactRow::Look look;
        Fact fact;
    };
    /// `name`: the object names of the values begin with it.
    explicit FactList(const QString& name = {}, QWidget* parent = nullptr);

    void show(const std::vector<Shown>& rows);
    /// All as lines.
    void show(const Facts& facts);
    /// In the order on the screen.
    [[nodiscard]] const std::vector<FactRow*>& rows() const { return rows_; }
    [[nodiscard]] QStringList texts() const;

signals:
    void linked(const QString& target);

private:
    QString name_;
    QVBoxLayout* column_;
    std::vector<FactRow*> rows_, hidden_;
};

} // namespace edgescan::ui
