// Small pictures of one scan at many values of one setting: a click takes the value. Not modal.
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

/// GUI thread only. Shows what it is told and says what the operator wants.
class ContactCard : public QDialog {
    Q_OBJECT
public:
    explicit ContactCard(QWidget* parent);

    /// An empty sheet for so many pictures.
    void begin(const QString& name, int pictures);
    /// The next one. `words`: value and count, under it.
    void add(const QImage& picture, const QString& words);
    /// All are there: which are steady, and which is the one in use (-1: none).
    void end(const std::vector<bool>& steady, int inUse);
    [[nodiscard]] const std::vector<QToolButton*>& pictures() const { return buttons_; }
    [[nodiscard]] bool working() const;

signals:
    void chosen(int place);
    /// Closed before all were there.
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
