// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QActionGroup>
#include <QMainWindow>
#include <QSettings>
#include <QStackedWidget>
#include <QTabBar>

#include "app/desktop/actions/actions.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/frames_bar.h"
#include "widgets/panels/hints.h"
#include "widgets/panels/status_line.h"
#include "widgets/presenters/playback.h"
#include "widgets/session/window_session.h"
#include "widgets/views/message_bar.h"
#include "widgets/workspaces/workspaces.h"

namespace app {

/// What the window is told when it is made.
struct WindowOptions {
    std::string rater; ///< empty: the one of the settings, else the login name
    bool hints = true; ///< whether hints may be shown, the person asked for the name, and questions asked before
                       ///< something surprising is done
};

/// The window: it builds the parts and wires them; all that it shows and does is theirs. makeMainWindow() gives it its
/// actions and menus.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(QSettings& settings, const WindowOptions& options, QWidget* parent = nullptr);
    ~MainWindow() override;

    void openDataset(const QString& folder, const QString& sequence = {}, int frame = 0);
    void askForDataset();
    void openDemo();
    /// Says at the top of the window what went wrong; an empty text takes it away.
    void showMessage(const QString& text);
    /// Asks or offers something at the top of the window; a button for each answer.
    void ask(const QString& question, const std::vector<widgets::MessageAction>& answers);
    /// False where there is no person to answer: what is asked for is then done at once.
    bool mayAsk() const { return m_mayAsk; }
    /// What is said or asked there now; empty if nothing.
    QString message() const { return m_message->message(); }
    QString question() const { return m_question->message(); }
    /// A bar of its own for what lasts, such as a repeat round.
    widgets::MessageBar& banner() { return *m_banner; }
    /// Whether the tabs of the workspaces can be chosen.
    void setWorkspacesEnabled(bool enabled) { m_workspaceBar->setEnabled(enabled); }
    void showHints();
    /// False if they were not shown.
    bool closeHints();

    widgets::WindowSession& session() { return m_session; }
    widgets::Workspaces& workspaces() { return *m_workspaces; }
    widgets::FramesBar& framesBar() { return *m_framesBar; }
    widgets::StatusLine& statusLine() { return *m_statusLine; }
    widgets::ViewOptions& viewOptions() { return *m_workspaces->options(); }
    widgets::Playback& playback() { return m_playback; }
    Actions& actions() { return m_actions; }
    QSettings& settings() { return m_settings; }
    /// A part of the window by the name that scripts use; null if there is none.
    QWidget* part(const QString& name);

signals:
    /// Videos or folders of images, but no dataset, were dropped on the window.
    void footageDropped(const QStringList& paths);

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void build();
    QWidget* makeWorkspaceBar();
    void connectSession();
    void connectDocument();
    void connectWork();
    void sayIfFrameIsMissing();
    void offerReport(const QString& path);
    void remember(const QString& folder);
    void restoreLayout();
    void refreshTitle();
    void refreshTestFrames();

    QSettings& m_settings;
    widgets::WindowSession m_session;
    Actions m_actions;
    widgets::Playback m_playback;
    widgets::MessageBar* m_message = nullptr;
    widgets::MessageBar* m_question = nullptr;
    widgets::MessageBar* m_banner = nullptr;
    widgets::FramesBar* m_framesBar = nullptr;
    QStackedWidget* m_pages = nullptr;
    widgets::EmptyState* m_empty = nullptr;
    widgets::Workspaces* m_workspaces = nullptr;
    widgets::StatusLine* m_statusLine = nullptr;
    QTabBar* m_workspaceBar = nullptr;
    widgets::Hints* m_hints = nullptr;
    bool m_mayHint = true;
    bool m_mayAsk = true;
    bool m_saveFailed = false;   ///< the message says so
    int m_wantedFrame = 0;       ///< that openDataset was asked for
    bool m_mayLoseEdits = false; ///< closing was asked for once while edits could not be saved
};

} // namespace app
