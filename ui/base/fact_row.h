// Facts about a target or a rock, and their rows on a card.
#pragma once

#include <QLabel>
#include <QStringList>

#include <vector>

class QVBoxLayout;

namespace edgescan::ui {

/// Bold, and larger than the letters of the window by this factor, also after these change.
class LargeLabel : public QLabel {
public:
    explicit LargeLabel(double factor, QWidget* parent = nullptr);

protected:
    bool event(QEvent* event) override;

private:
    void fit();

    double factor_;
};

/// It is made once; card and files read it by its key.
struct Fact {
    const char* key;         ///< "distance"; the same in every language
    QString name{}, value{}; ///< "Distance", "4.911 m"
    QString tolerance{};     ///< "± 0.009 m"
    QString tip{};
    const char* unit = ""; ///< shown after the name; not stored
    bool measured = true;  ///< a slider can change it: then the card also shows the earlier value
    bool known = true;     ///< false: not computed yet, not to be stored
    bool links = false;    ///< its value is rich text with links
    QStringList numbers{}; ///< of a place
    QString was{};         ///< the value when the target was set, if it was another one

    [[nodiscard]] QString text() const { return tolerance.isEmpty() ? value : value + " " + tolerance; }
};
using Facts = std::vector<Fact>;

/// The name at the left, the value at the right. GUI thread only.
class FactRow : public QWidget {
public:
    explicit FactRow(QWidget* parent);

    void show(const Fact& fact);
    [[nodiscard]] const Fact& fact() const { return fact_; }
    [[nodiscard]] QLabel& value() const { return *value_; }
    /// "Cell: line 3 · beam 7".
    [[nodiscard]] QString text() const;

private:
    Fact fact_{""};
    QLabel *name_, *value_;
};

/// The rows of a card. GUI thread only.
class FactList : public QWidget {
    Q_OBJECT
public:
    explicit FactList(QWidget* parent = nullptr);

    void show(const Facts& facts);
    [[nodiscard]] QStringList texts() const;

signals:
    void linked(const QString& target);

private:
    QVBoxLayout* column_;
    std::vector<FactRow*> rows_, hidden_; // in the order on the screen
};

} // namespace edgescan::ui
