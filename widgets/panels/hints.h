// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>

namespace widgets {

/// Four short hints for the first minutes, over the views. It stays in the middle of its parent's lower edge.
class Hints : public QFrame {
    Q_OBJECT

public:
    explicit Hints(QWidget* parent);

    /// Away with them: a button or Esc.
    void dismiss();

signals:
    void closed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void place();
};

} // namespace widgets
