// SPDX-License-Identifier: MIT
#include "app/desktop/windows/ask_for_file.h"

#include <algorithm>

#include <QFileDialog>

#include "app/desktop/main_window.h"

namespace app {

void askForFile(MainWindow& window, const QString& title, const std::vector<FileKind>& kinds,
                const QString& proposedName, const std::function<void(const QString& path, std::size_t kind)>& chosen) {
    auto* dialog = new QFileDialog(&window, title);
    QStringList filters;
    for (const FileKind& kind : kinds)
        filters << kind.filter;
    dialog->setNameFilters(filters);
    const bool toSave = !proposedName.isEmpty();
    dialog->setAcceptMode(toSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(toSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const auto kindOf = [filters](const QString& filter) {
        return static_cast<std::size_t>(std::max(0, filters.indexOf(filter)));
    };
    const auto setSuffix = [dialog, kinds,
                            kindOf](const QString& filter) { // before the dialog asks whether to overwrite
        dialog->setDefaultSuffix(kinds[kindOf(filter)].suffix);
    };
    setSuffix(filters.front());
    if (toSave)
        dialog->selectFile(proposedName);
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, setSuffix);
    QObject::connect(dialog, &QFileDialog::fileSelected, &window, [dialog, chosen, kindOf](const QString& path) {
        chosen(path, kindOf(dialog->selectedNameFilter()));
    });
    dialog->open();
}

} // namespace app
