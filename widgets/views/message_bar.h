// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QWidget>

class QBoxLayout;
class QLabel;

namespace widgets {

/// A button on a message: what it says, and what it does once the message has gone.
struct MessageAction {
    QString text;
    std::function<void()> run;
};

/// A bar at the top of a view or panel that says what is wrong and what to do about it, or asks something in place.
/// Hidden while it has nothing to say.
class MessageBar : public QWidget {
    Q_OBJECT
public:
    /// How it looks: something is wrong, or something is offered.
    enum class Tone { Warning, Notice };

    explicit MessageBar(QWidget* parent = nullptr);

    /// Shows the text, or hides the bar if it is empty. The detail behind an error's text becomes the tool tip.
    void setMessage(const QString& text);
    /// Shows the text with a button for each action. Pressing one hides the bar.
    void offer(const QString& text, const std::vector<MessageAction>& actions, Tone tone = Tone::Notice);
    /// Whether it can be dismissed without an answer; it can unless this says otherwise.
    void setDismissible(bool dismissible);
    QString message() const;

signals:
    void dismissed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void setColours(Tone tone);
    void arrange(int width);

    QBoxLayout* m_content;
    QBoxLayout* m_buttons;
    QLabel* m_label;
    QWidget* m_close;
    Tone m_tone = Tone::Warning;
};

} // namespace widgets
