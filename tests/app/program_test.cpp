// SPDX-License-Identifier: MIT
// The program itself, in a process of its own: killed in mid-edit, opened twice, with few and many cameras.
#include <csignal>
#include <fstream>
#include <random>
#include <sstream>

#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QProcess>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/files/atomic_file.h"
#include "core/io/store/annotation_store.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"

namespace {

using nlohmann::json;

constexpr int kPatienceMs = 60000;

class Program : public testing::Test {
protected:
    void writeDataset(int cameras = 8) { test::writeTinyDataset(dataset(), cameras); }
    std::filesystem::path dataset() const { return m_folder / "dataset"; }
    std::filesystem::path annotations() const { return dataset() / "annotations" / "a.sqlite"; }

    void start(QProcess& process, const std::vector<json>& steps, const QStringList& more = {}) {
        std::ostringstream script;
        for (const json& step : steps)
            script << step.dump() << '\n';
        core::writeFileAtomically(m_folder / "script.jsonl", script.str());
        QStringList arguments{text(dataset()),
                              QStringLiteral("--offscreen"),
                              QStringLiteral("--script"),
                              text(m_folder / "script.jsonl"),
                              QStringLiteral("--out"),
                              text(m_folder / "out")};
        process.start(QStringLiteral(HANDLENS_PROGRAM), arguments + more);
        ASSERT_TRUE(process.waitForStarted());
    }
    /// Plays the steps to their end; returns the answers.
    std::vector<json> play(const std::vector<json>& steps, const QStringList& more = {}) {
        QProcess process;
        start(process, steps, more);
        EXPECT_TRUE(process.waitForFinished(kPatienceMs));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().constData();
        std::vector<json> answers;
        for (const QByteArray& line : process.readAllStandardOutput().split('\n'))
            if (!line.isEmpty())
                answers.push_back(json::parse(line.toStdString()));
        return answers;
    }
    static QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

    test::TemporaryFolder m_folder;
};

/// A click somewhere in view `camera`, then a drag of that mark.
void addClickAndDrag(std::vector<json>& steps, int camera, double x, double y) {
    const std::string name = "cam" + std::to_string(camera);
    steps.push_back({{"do", "click"}, {"camera", name}, {"px", {x, y}}});
    steps.push_back({{"do", "drag"}, {"camera", name}, {"from", {x, y}}, {"to", {x + 20, y + 15}}, {"moves", 60}});
}

TEST_F(Program, KilledInMidDragLosesNothingThatWasDone) {
    writeDataset();
    std::mt19937 random(7);
    for (int round = 0; round < 5; ++round) {
        std::filesystem::remove_all(dataset() / "annotations");
        std::vector<json> steps{{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}}};
        for (int frame = 0; frame < 20; ++frame) {
            steps.push_back({{"do", "goto"}, {"frame", frame}});
            steps.push_back({{"do", "select"}, {"hand", "left"}, {"joint", "index_mcp"}});
            addClickAndDrag(steps, frame % 8, 100 + frame, 200);
        }
        QProcess process;
        start(process, steps);
        const int killAfter = 5 + static_cast<int>(random() % 40);
        std::vector<json> answers;
        while (static_cast<int>(answers.size()) < killAfter) {
            ASSERT_TRUE(process.canReadLine() || process.waitForReadyRead(kPatienceMs))
                << process.readAllStandardError().constData();
            while (process.canReadLine())
                answers.push_back(json::parse(process.readLine().toStdString()));
        }
        ::usleep(random() % 20000); // into the next step
        ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
        process.waitForFinished(kPatienceMs);

        std::size_t clicks = 0, drags = 0;
        for (const json& answer : answers) {
            ASSERT_TRUE(answer["ok"]) << answer;
            clicks += answer["do"] == "click";
            drags += answer["do"] == "drag";
        }
        auto store = core::AnnotationStore::open(annotations());
        EXPECT_FALSE(store.isReadOnly()) << core::readOnlyText(store.readOnlyReason());
        const auto marks = store.annotations().marks;
        EXPECT_GE(marks.size(), clicks);
        EXPECT_LE(marks.size(), clicks + 1);
        EXPECT_GE(store.history().done.size(), clicks + drags);
        std::size_t moved = 0;
        for (const auto& [key, mark] : marks)
            moved += std::abs(mark.px.y() - 215) < 0.6;
        EXPECT_GE(moved, drags);
        EXPECT_TRUE(store.undo());
        EXPECT_TRUE(store.redo());
    }
}

TEST_F(Program, RedoOfAKilledRunIsOffered) {
    writeDataset();
    QProcess process;
    std::vector<json> steps{{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}},
                            {{"do", "select"}, {"hand", "left"}, {"joint", "index_mcp"}}};
    addClickAndDrag(steps, 0, 100, 200);
    addClickAndDrag(steps, 1, 100, 200);
    steps.push_back({{"do", "key"}, {"keys", "Ctrl+Z"}});
    steps.push_back({{"do", "key"}, {"keys", "Ctrl+Z"}});
    const std::size_t answersWanted = steps.size();
    steps.push_back({{"do", "key"}, {"keys", "F12"}, {"hold", 60000}});
    start(process, steps);
    std::size_t answers = 0;
    while (answers < answersWanted) {
        ASSERT_TRUE(process.canReadLine() || process.waitForReadyRead(kPatienceMs));
        while (process.canReadLine())
            answers += !process.readLine().isEmpty();
    }
    ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
    process.waitForFinished(kPatienceMs);
    const auto after = play({{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}},
                             {{"do", "print"}, {"what", "joint"}, {"hand", "left"}, {"joint", "index_mcp"}},
                             {{"do", "action"}, {"id", "edit.redo"}},
                             {{"do", "action"}, {"id", "edit.redo"}},
                             {{"do", "print"}, {"what", "joint"}, {"hand", "left"}, {"joint", "index_mcp"}}});
    ASSERT_EQ(after.size(), 5u);
    EXPECT_EQ(after[1]["views"].size(), 1u);
    EXPECT_EQ(after[4]["views"].size(), 2u);
}

TEST_F(Program, ASecondWindowOpensReadOnlyAndSaysSo) {
    writeDataset();
    std::filesystem::create_directories(dataset() / "annotations");
    const auto first = core::AnnotationStore::open(annotations());
    const auto answers = play({{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}},
                               {{"do", "select"}, {"hand", "left"}, {"joint", "index_mcp"}},
                               {{"do", "print"}, {"what", "joint"}, {"hand", "left"}, {"joint", "index_mcp"}},
                               {{"do", "shot"}, {"of", "window"}, {"path", "window.png"}}});
    EXPECT_TRUE(answers[2]["views"].empty());
    EXPECT_TRUE(first.annotations().marks.empty());
    QProcess process;
    start(process, {{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}},
                    {{"do", "click"}, {"camera", "cam0"}, {"px", {100, 200}}}});
    ASSERT_TRUE(process.waitForFinished(kPatienceMs));
    EXPECT_EQ(process.exitCode(), 1);
    const json refused = json::parse(process.readAllStandardOutput().trimmed().split('\n').last().toStdString());
    EXPECT_FALSE(refused["ok"].get<bool>());
    EXPECT_NE(refused["error"].get<std::string>().find("reading only"), std::string::npos) << refused;
    EXPECT_TRUE(first.annotations().marks.empty());
}

TEST_F(Program, TwoAndSixteenCamerasAreShown) {
    for (const int cameras : {2, 16}) {
        std::filesystem::remove_all(dataset());
        writeDataset(cameras);
        const std::string last = "cam" + std::to_string(cameras - 1);
        const auto answers = play({{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}},
                                   {{"do", "select"}, {"hand", "left"}, {"joint", "index_mcp"}},
                                   {{"do", "click"}, {"camera", "cam0"}, {"px", {130, 240}}},
                                   {{"do", "click"}, {"camera", last}, {"px", {130, 240}}},
                                   {{"do", "print"}, {"what", "joint"}, {"hand", "left"}, {"joint", "index_mcp"}},
                                   {{"do", "shot"}, {"of", last}, {"path", "last.png"}},
                                   {{"do", "fit"}, {"start", 4}, {"test", 7}, {"methods", {"ch"}}},
                                   {{"do", "action"}, {"id", "workspace.inspect"}},
                                   {{"do", "shot"}, {"of", "window"}, {"path", "window.png"}}});
        ASSERT_EQ(answers.size(), 9u) << cameras << " cameras";
        EXPECT_EQ(answers[4]["views"].size(), 2u);
        EXPECT_FALSE(QImage(text(m_folder / "out" / "last.png")).isNull());
        EXPECT_EQ(QImage(text(m_folder / "out" / "window.png")).size(), QSize(1920, 1080));
    }
}

TEST_F(Program, ShowsGermanWithTheLanguageOption) {
    writeDataset();
    play({{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}},
          {{"do", "shot"}, {"of", "status"}, {"path", "german.png"}}},
         {QStringLiteral("--language"), QStringLiteral("de")});
    play({{{"do", "goto"}, {"sequence", "a"}, {"frame", 12}},
          {{"do", "shot"}, {"of", "status"}, {"path", "english.png"}}});
    const QImage german(text(m_folder / "out" / "german.png")), english(text(m_folder / "out" / "english.png"));
    EXPECT_FALSE(german.isNull());
    EXPECT_NE(german, english);
}

TEST_F(Program, AnUnknownFrameOrLanguageEndsInOneSentence) {
    writeDataset();
    const std::pair<QStringList, const char*> wishes[] = {
        {{QStringLiteral("--frame"), QStringLiteral("9999")}, "frames 0-29"},
        {{QStringLiteral("--language"), QStringLiteral("tlh")}, "de, el, en, zh_CN"}};
    for (const auto& [arguments, mentions] : wishes) {
        QProcess process;
        start(process, {{{"do", "timing"}}}, arguments);
        ASSERT_TRUE(process.waitForFinished(kPatienceMs));
        EXPECT_EQ(process.exitCode(), 2);
        const QByteArray said = process.readAllStandardError();
        EXPECT_EQ(said.count("handlens: "), 1) << said.constData();
        EXPECT_TRUE(said.contains("handlens: " + arguments.front().toUtf8())) << said.constData();
        EXPECT_TRUE(said.contains(mentions)) << said.constData();
        EXPECT_TRUE(process.readAllStandardOutput().isEmpty()) << "no step was played";
    }
    play({{{"do", "timing"}}}, {QStringLiteral("--language"), QStringLiteral("de_AT")});
}

TEST_F(Program, BadDatasetsEndInOneSentence) {
    QProcess process;
    start(process, {{{"do", "timing"}}});
    ASSERT_TRUE(process.waitForFinished(kPatienceMs));
    EXPECT_EQ(process.exitCode(), 1);
    const QByteArray said = process.readAllStandardError();
    EXPECT_TRUE(said.contains("handlens: ")) << said.constData();
    EXPECT_TRUE(said.contains("dataset")) << said.constData();
}

} // namespace
