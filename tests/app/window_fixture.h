// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <sstream>

#include <QFile>
#include <QSettings>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/script_player.h"
#include "app/desktop/window_assembly.h"
#include "tests/support/clicks.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"

namespace test {

/// The real window on a private display, with the tiny dataset open at frame 12 of sequence "a".
class WindowTest : public testing::Test {
protected:
    WindowTest() {
        writeTinyDataset(dataset());
        start();
    }

    std::filesystem::path dataset() const { return folder / "dataset"; }
    QString path(const char* name) const { return QString::fromStdString((folder / name).string()); }

    void start() {
        settings = std::make_unique<QSettings>(path("settings.ini"), QSettings::IniFormat);
        window = app::makeMainWindow(*settings, app::WindowOptions{"ann", false});
        window->setGeometry(0, 0, 1366, 768);
        window->show();
        window->activateWindow();
        window->openDataset(QString::fromStdString(dataset().string()), QStringLiteral("a"), 12);
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
    void restart() {
        window.reset();
        start();
    }

    /// Plays lines of a script; returns the exit status.
    int play(const std::string& lines) {
        QFile file(path("script.jsonl"));
        if (!file.open(QIODevice::WriteOnly))
            std::abort();
        file.write(lines.c_str());
        file.close();
        answers.str({});
        errors.str({});
        return app::playScript(*window, file.fileName(), path("out"), answers, errors);
    }

    /// The answers to the steps that were played last.
    std::vector<nlohmann::json> said() const {
        std::vector<nlohmann::json> lines;
        std::istringstream stream(answers.str());
        for (std::string line; std::getline(stream, line);)
            lines.push_back(nlohmann::json::parse(line));
        return lines;
    }
    /// Plays lines of a script that has to end well; returns the answers.
    std::vector<nlohmann::json> run(const std::string& steps) {
        EXPECT_EQ(play(steps), 0) << errors.str();
        return said();
    }

    widgets::WindowSession& session() { return window->session(); }
    core::Camera camera(int index) const { return tinyDataset().cameras[static_cast<std::size_t>(index)]; }
    /// The true place of a joint in a frame, mm.
    static Eigen::Vector3d truth(core::Side hand, int bone, int frame) {
        const auto poses = tinyMotion(frame + 1).back();
        const std::size_t index = hand == core::Side::Left ? 0 : 1;
        return core::jointPositions(tinyHands()[index].skeleton, poses[index])[static_cast<std::size_t>(bone)];
    }

    TemporaryFolder folder;
    std::unique_ptr<QSettings> settings;
    std::unique_ptr<app::MainWindow> window;
    std::ostringstream answers, errors;
};

} // namespace test
