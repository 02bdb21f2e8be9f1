// Small pictures of one scan at many values of one setting: a click adopts the value. Not modal.
#pragma once

#include <QDialog>
#include <QImage>
#include <QString>

#include <vector>

class QGridLayout;
class QLabel;
class QProgressBar;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class ContactCard : public QDialog {
    Q_OBJECT
public:
    explicit ContactCard(QWidget* parent);

    /// An empty sheet for this many pictures.
    void begin(const QString& name, int pictures);
    /// Adds the next picture. `words`: value and count, shown under it.
    void add(const QImage& picture, const QString& words);
    /// All pictures are there. `steady`: pictures in a range where the edge count changes little; `inUse`: index of the current value (-1:
    /// none).
    void end(const std::vector<bool>& steady, int inUse);
    [[nodiscard]] const std::vector<QToolButton*>& pictures() const { return buttons_; }
    [[nodiscard]] bool working() const;

signals:
    void chosen(int place);
    /// Closed before all pictures were there.
    void givenUp();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    QLabel* help_;
    QLabel* state_;
    QProgressBar* progress_;
    QGridLayout* grid_;
    std::vector<QToolButton*> buttons_;
    std::vector<QString> words_;
};

} // namespace edgescan::ui
