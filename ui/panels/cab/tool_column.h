// The tools of cab mode: signs with words, one below the other, in a second column where the window is low; Undo always at the foot.
#pragma once

#include <QWidget>

#include <vector>

class QGridLayout;
class QToolButton;

namespace edgescan::ui {

/// As large as a glove needs, with a sign and a word under it. `lit`: always looks as if it were on.
void makeGloveButton(QToolButton& button, const char* name, const char* sign, const QString& word, bool lit = false);
[[nodiscard]] QToolButton* gloveButton(const char* name, const char* sign, const QString& word);

/// GUI thread only.
class ToolColumn : public QWidget {
    Q_OBJECT
public:
    explicit ToolColumn(QWidget* parent = nullptr);

    QToolButton* add(const char* name, const char* sign, const QString& word);
    /// The last one, at the foot.
    void setFoot(QToolButton* button);

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();

    std::vector<QToolButton*> buttons_;
    QToolButton* foot_ = nullptr;
    QGridLayout* grid_;
    int rows_ = 100; // one below the other, until it is known how much room there is
};

} // namespace edgescan::ui
