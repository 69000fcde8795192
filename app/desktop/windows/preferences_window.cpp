// SPDX-License-Identifier: MIT
#include "app/desktop/windows/preferences_window.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

#include "app/desktop/actions/own_name.h"
#include "app/desktop/language.h"
#include "app/desktop/main_window.h"
#include "app/desktop/palettes.h"
#include "app/desktop/windows/shortcut_page.h"
#include "widgets/panels/state_colours.h"

namespace app {

namespace {

const QString kLanguage = QStringLiteral("language");
const QString kLook = QStringLiteral("look");
const QString kMemory = QStringLiteral("pictureMemoryMb");
const QString kHintsSeen = QStringLiteral("hintsSeen");
constexpr int kDefaultMemoryMb = 1024, kLeastMemoryMb = 64, kMostMemoryMb = 65536, kMemoryStepMb = 64;

std::int64_t bytes(int megabytes) {
    return std::int64_t(megabytes) << 20;
}

/// The language in its own words.
QString languageName(const QString& code) {
    const QString name = code == QLatin1String("en") ? QStringLiteral("English") : QLocale(code).nativeLanguageName();
    return name.isEmpty() ? code : name;
}

} // namespace

PreferencesWindow::PreferencesWindow(MainWindow& window)
    : QDialog(&window)
    , m_window(window)
    , m_pages(new QTabWidget(this)) {
    setWindowTitle(tr("Preferences"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(720, 480);
    m_pages->addTab(makeGeneralPage(), tr("General"));
    auto* keys = new QWidget(this);
    auto* column = new QVBoxLayout(keys);
    column->addWidget(new ShortcutPage(window.actions(), keys));
    m_pages->addTab(keys, tr("Keys"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* whole = new QVBoxLayout(this);
    whole->addWidget(m_pages, 1);
    whole->addWidget(buttons);
}

void PreferencesWindow::showKeys() {
    m_pages->setCurrentIndex(1);
}

QWidget* PreferencesWindow::makeGeneralPage() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->setVerticalSpacing(2 * widgets::kSpacing);
    form->addRow(tr("Your name"), makeName());
    form->addRow(tr("Language"), makeLanguages());
    form->addRow(QString(), new QLabel(tr("Another language is used from the next start on."), page));
    form->addRow(tr("Colours"), makeLooks());
    form->addRow(tr("Memory for pictures"), makeMemory());
    form->addRow(tr("Hints"), makeHints());
    return page;
}

QWidget* PreferencesWindow::makeName() {
    auto* name = new QLineEdit(ownName(m_window), this);
    name->setObjectName(QStringLiteral("name"));
    name->setToolTip(tr("Your marks are kept under this name."));
    connect(name, &QLineEdit::editingFinished, this, [this, name] {
        keepOwnName(m_window, name->text());
        name->setText(ownName(m_window));
    });
    return name;
}

QComboBox* PreferencesWindow::makeLanguages() {
    auto* languages = new QComboBox(this);
    languages->setObjectName(QStringLiteral("language"));
    languages->addItem(tr("As the system"), QString());
    for (const QString& code : availableLanguages())
        languages->addItem(languageName(code), code);
    languages->setCurrentIndex(std::max(0, languages->findData(m_window.settings().value(kLanguage).toString())));
    connect(languages, qOverload<int>(&QComboBox::activated), this,
            [this, languages] { m_window.settings().setValue(kLanguage, languages->currentData().toString()); });
    return languages;
}

QComboBox* PreferencesWindow::makeLooks() {
    auto* looks = new QComboBox(this);
    looks->setObjectName(QStringLiteral("colours"));
    looks->addItem(tr("Dark"), lookName(Look::Dark));
    looks->addItem(tr("Light"), lookName(Look::Light));
    looks->addItem(tr("As the system"), lookName(Look::System));
    looks->setCurrentIndex(looks->findData(lookName(lookFromName(m_window.settings().value(kLook).toString()))));
    connect(looks, qOverload<int>(&QComboBox::activated), this, [this, looks] {
        const QString name = looks->currentData().toString();
        m_window.actions().action(QStringLiteral("view.light"))->setChecked(lookFromName(name) == Look::Light);
        m_window.settings().setValue(kLook, name); // after the action, which knows dark and light only
        applyLook(*qApp, lookFromName(name));
    });
    return looks;
}

QWidget* PreferencesWindow::makeMemory() {
    auto* memory = new QSpinBox(this);
    memory->setObjectName(QStringLiteral("memory"));
    memory->setRange(kLeastMemoryMb, kMostMemoryMb);
    memory->setSingleStep(kMemoryStepMb);
    memory->setSuffix(tr(" MB"));
    memory->setValue(m_window.settings().value(kMemory, kDefaultMemoryMb).toInt());
    memory->setToolTip(
        tr("Pictures of recent frames are kept in so much memory: stepping back then needs no reading."));
    connect(memory, qOverload<int>(&QSpinBox::valueChanged), this, [this](int megabytes) {
        m_window.settings().setValue(kMemory, megabytes);
        m_window.session().frames.setBudget(bytes(megabytes));
    });
    return memory;
}

QWidget* PreferencesWindow::makeHints() {
    auto* hints = new QCheckBox(tr("Show the four hints at the next start"), this);
    hints->setObjectName(QStringLiteral("hints"));
    hints->setChecked(!m_window.settings().value(kHintsSeen).toBool());
    connect(hints, &QCheckBox::toggled, this, [this](bool on) { m_window.settings().setValue(kHintsSeen, !on); });
    return hints;
}

PreferencesWindow& showPreferences(MainWindow& window) {
    auto* page = window.findChild<PreferencesWindow*>();
    if (!page)
        page = new PreferencesWindow(window);
    page->show();
    page->raise();
    page->activateWindow();
    return *page;
}

void applyPreferences(MainWindow& window) {
    const int megabytes = window.settings().value(kMemory, kDefaultMemoryMb).toInt();
    window.session().frames.setBudget(bytes(std::clamp(megabytes, kLeastMemoryMb, kMostMemoryMb)));
}

} // namespace app
