// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include <QApplication>
#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>

#include "app/desktop/command_line.h"
#include "app/desktop/language.h"
#include "app/desktop/palettes.h"
#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/script_player.h"
#include "app/desktop/script/workspace_player.h"
#include "app/desktop/window_assembly.h"
#include "core/error.h"
#include "widgets/text/error_text.h"
#include "widgets/views/private_display.h"

namespace {

constexpr int kScreenWidth = 3840; // of the private display: room for any window that a script asks for
constexpr int kScreenHeight = 2160;
constexpr int kScriptWidth = 1920;
constexpr int kScriptHeight = 1080;

/// Opens the dataset and plays the script; returns the exit status.
int runScript(app::MainWindow& window, const app::CommandLine& line) {
    window.setGeometry(0, 0, kScriptWidth, kScriptHeight);
    window.show();
    window.activateWindow();
    if (!line.dataset.empty()) {
        QString error;
        QObject::connect(&window.session().opened, &widgets::DatasetSession::openFailed, &window,
                         [&error](const QString& message) { error = message; });
        window.openDataset(QString::fromStdString(line.dataset), QString::fromStdString(line.sequence), line.frame);
        app::waitUntilIdle(window);
        if (!error.isEmpty()) {
            std::cerr << "handlens: " << widgets::withDetailBehind(error).toStdString() << std::endl;
            return 1;
        }
        const core::Sequence& sequence = *window.session().opened.sequence();
        if (line.frame >= sequence.frameCount) {
            std::cerr << "handlens: --frame: sequence \"" << sequence.name << "\" has frames 0-"
                      << sequence.frameCount - 1 << ", not " << line.frame << std::endl;
            return 2;
        }
    }
    if (!line.workspace.empty())
        return app::renderWorkspace(window, line.workspace, line.out);
    return app::playScript(window, QString::fromStdString(line.script), QString::fromStdString(line.out), std::cout,
                           std::cerr);
}

int run(int argc, char** argv, const app::CommandLine& line) {
    if (!line.language.empty() && !app::knownLanguage(QString::fromStdString(line.language))) {
        std::cerr << "handlens: --language: unknown language \"" << line.language << "\"; known are "
                  << app::availableLanguages().join(QStringLiteral(", ")).toStdString() << std::endl;
        return 2;
    }
    std::unique_ptr<widgets::PrivateDisplay> display;
    if (line.offscreen)
        display = std::make_unique<widgets::PrivateDisplay>(kScreenWidth, kScreenHeight);
    else if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
             qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        throw core::Error(
            core::ErrorCode::Unsupported, "", "",
            "no display found; --offscreen --script FILE --out FOLDER needs none, nor does handlens-batch");
    widgets::SceneView::prepareApplication();
    QCoreApplication::setOrganizationName(QStringLiteral("handlens"));
    QCoreApplication::setApplicationName(QStringLiteral("handlens"));
    QApplication application(argc, argv);
    const QTemporaryDir freshSettings;
    QSettings settings = line.offscreen
                             ? QSettings(freshSettings.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat)
                             : QSettings();
    const QString language = line.language.empty() ? settings.value(QStringLiteral("language")).toString()
                                                   : QString::fromStdString(line.language);
    app::applyLanguage(application, language.isEmpty() && line.offscreen ? QStringLiteral("en") : language);
    app::applyLook(application, app::lookFromName(settings.value(QStringLiteral("look")).toString()));
    const auto made = app::makeMainWindow(settings, {line.rater, !line.offscreen});
    app::MainWindow& window = *made;
    if (line.offscreen) {
        QTimer::singleShot(
            0, &window, [&] { QCoreApplication::exit(runScript(window, line)); });
    } else {
        window.show();
        if (!line.dataset.empty())
            window.openDataset(QString::fromStdString(line.dataset), QString::fromStdString(line.sequence), line.frame);
        if (!line.workspace.empty())
            QTimer::singleShot(0, &window, [&] { app::openWorkspace(window, line.workspace); });
    }
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
    const app::ParsedCommandLine parsed = app::parseCommandLine(argc, argv);
    if (!parsed.arguments)
        return parsed.exitStatus;
    try {
        return run(argc, argv, *parsed.arguments);
    } catch (const std::exception& error) {
        std::cerr << "handlens: " << error.what() << std::endl;
        return 1;
    }
}
