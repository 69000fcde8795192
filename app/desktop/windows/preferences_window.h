// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

class QComboBox;
class QTabWidget;

namespace app {

class MainWindow;

/// What a person sets once: language, name, colours, memory, hints, and the keys. Everything is kept when it is
/// changed.
class PreferencesWindow : public QDialog {
    Q_OBJECT

public:
    explicit PreferencesWindow(MainWindow& window);

    void showKeys();

private:
    QWidget* makeGeneralPage();
    QComboBox* makeLanguages();
    QComboBox* makeLooks();
    QWidget* makeName();
    QWidget* makeMemory();
    QWidget* makeHints();

    MainWindow& m_window;
    QTabWidget* m_pages;
};

/// Brings the window to the front, made if there is none.
PreferencesWindow& showPreferences(MainWindow& window);

/// Gives the settings that belong to no action to a new window: the memory for pictures.
void applyPreferences(MainWindow& window);

} // namespace app
