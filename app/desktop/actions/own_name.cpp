// SPDX-License-Identifier: MIT
#include "app/desktop/actions/own_name.h"

#include "app/desktop/main_window.h"

namespace app {

QString ownName(MainWindow& window) {
    return QString::fromStdString(widgets::ownName(window.session().document.rater()));
}

void keepOwnName(MainWindow& window, const QString& name) {
    const QString rater = QString::fromStdString(widgets::ownName(name.trimmed().toStdString())).trimmed();
    if (rater.isEmpty() || rater == ownName(window))
        return;
    window.settings().setValue(QStringLiteral("rater"), rater);
    window.session().document.setRater(rater.toStdString());
}

} // namespace app
