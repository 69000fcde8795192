// SPDX-License-Identifier: MIT
#include "app/desktop/windows/model_pages.h"

#include <QFileInfo>
#include <QLabel>
#include <QVBoxLayout>

#include "app/desktop/windows/path_field.h"
#include "widgets/panels/state_colours.h"

namespace app {

namespace {

/// A choice with a sentence below it.
QRadioButton* addChoice(QWidget* page, QVBoxLayout& column, const QString& text, const QString& explanation) {
    auto* choice = new QRadioButton(text, page);
    auto* words = new QLabel(explanation, page);
    words->setWordWrap(true);
    words->setIndent(4 * widgets::kSpacing);
    words->setForegroundRole(QPalette::WindowText);
    column.addWidget(choice);
    column.addWidget(words);
    column.addSpacing(widgets::kSpacing);
    return choice;
}

} // namespace

HandsPage::HandsPage(QWidget* parent)
    : QWidget(parent)
    , m_folder(new QLineEdit(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_demo = addChoice(this, *column, tr("The demo's hands"),
                       tr("A left and a right hand of usual size. They can be measured to a person's own later, from "
                          "clicked joints."));
    m_other = addChoice(this, *column, tr("The hands of another dataset"),
                        tr("Such as this person's, measured before, or imported ones."));
    QWidget* field = withChooser(m_folder, tr("The folder of a dataset"), PathKind::Folder, this);
    column->addWidget(field);
    column->addSpacing(widgets::kSpacing);
    m_none = addChoice(this, *column, tr("No hand model"),
                       tr("Joints can be clicked, of hands or of anything else. Nothing is fitted to silhouettes."));
    column->addStretch(1);
    m_demo->setChecked(true);
    field->setEnabled(false);
    connect(m_other, &QRadioButton::toggled, field, &QWidget::setEnabled);
    for (const QRadioButton* choice : {m_demo, m_other, m_none})
        connect(choice, &QRadioButton::toggled, this, &HandsPage::changed);
    connect(m_folder, &QLineEdit::textChanged, this, &HandsPage::changed);
}

void HandsPage::setDataset(const QString& folder) {
    m_other->setChecked(true);
    m_folder->setText(folder);
}

void HandsPage::fill(widgets::NewDatasetRequest& request) const {
    request.demoHands = m_demo->isChecked();
    request.handsFrom = m_other->isChecked() ? m_folder->text().trimmed().toStdString() : std::string();
}

QString HandsPage::problem() const {
    if (!m_other->isChecked() || QFileInfo::exists(m_folder->text().trimmed() + QStringLiteral("/dataset.json")))
        return {};
    return m_folder->text().trimmed().isEmpty() ? tr("Choose the dataset whose hands are taken.")
                                                : tr("That folder is not a dataset: it has no dataset.json.");
}

MasksPage::MasksPage(QWidget* parent)
    : QWidget(parent)
    , m_path(new QLineEdit(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_none = addChoice(this, *column, tr("None yet"),
                       tr("They can be made from the pictures once the dataset is open, or attached later."));
    m_given = addChoice(this, *column, tr("They are there"),
                        tr("A folder with a folder of numbered masks per camera, or a pattern with {camera} and "
                           "{frame}. White is hand, black is not."));
    QWidget* field = withChooser(m_path, tr("The folder of the silhouettes"), PathKind::Folder, this);
    column->addWidget(field);
    column->addStretch(1);
    m_none->setChecked(true);
    field->setEnabled(false);
    connect(m_given, &QRadioButton::toggled, field, &QWidget::setEnabled);
    connect(m_given, &QRadioButton::toggled, this, &MasksPage::changed);
    connect(m_path, &QLineEdit::textChanged, this, &MasksPage::changed);
}

void MasksPage::setMasks(const QString& folderOrPattern) {
    m_given->setChecked(true);
    m_path->setText(folderOrPattern);
}

void MasksPage::fill(widgets::NewDatasetRequest& request) const {
    request.masks = m_given->isChecked() ? m_path->text().trimmed().toStdString() : std::string();
}

QString MasksPage::problem() const {
    const QString path = m_path->text().trimmed();
    if (!m_given->isChecked() || QFileInfo(path).isDir() || path.contains(QLatin1String("{frame")))
        return {};
    return path.isEmpty() ? tr("Choose the folder of the silhouettes.")
                          : tr("This must be a folder, or a pattern with {frame}.");
}

} // namespace app
