// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>

#include "app/desktop/windows/calibration_page.h"
#include "app/desktop/windows/footage_page.h"
#include "app/desktop/windows/model_pages.h"
#include "widgets/jobs/dataset_maker.h"
#include "widgets/views/message_bar.h"

namespace app {

class MainWindow;

/// Makes a dataset in five steps and opens it: footage, calibration, hands, silhouettes, folder. A list on the left
/// says which steps are done; a sentence at the bottom says why the next one cannot be taken yet. Footage is given to
/// the cameras by name; files and folders can be dropped at any step.
class NewDatasetWindow : public QDialog {
    Q_OBJECT

public:
    enum class Step { Footage, Calibration, Hands, Silhouettes, Folder };

    explicit NewDatasetWindow(MainWindow& window);

    /// Shows the window's one such dialog, with more footage (or the calibration).
    static NewDatasetWindow* open(MainWindow& window, const QStringList& footage);

    void addFootage(const QStringList& paths) { m_maker.gather(paths); }
    void setCalibration(const QString& path) { m_calibration->setPath(path); }
    void setFolder(const QString& path);
    void goTo(Step step);
    /// Why a step is not done; empty if it is.
    QString problem(Step step) const;
    /// What is said above the fields: what went wrong.
    QString message() const { return m_message->message(); }
    /// What is said at the bottom: what is missing.
    QString reason() const { return m_reason->text(); }
    QTableWidget* table() const { return m_footage->table(); }
    CalibrationPage* calibrationPage() const { return m_calibration; }
    HandsPage* handsPage() const { return m_hands; }
    MasksPage* masksPage() const { return m_masks; }
    QPushButton* makeButton() const { return m_make; }

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void build();
    QWidget* folderPage();
    void connectMaker();
    void takeFootage(const widgets::GatheredFootage& footage);
    void look();
    void refresh();
    void refreshSteps();
    void make();
    QString summary() const;
    widgets::NewDatasetRequest request() const;

    MainWindow& m_window;
    widgets::DatasetMaker m_maker;
    widgets::MessageBar* m_message;
    QListWidget* m_steps;
    QStackedWidget* m_pages;
    FootagePage* m_footage;
    CalibrationPage* m_calibration;
    HandsPage* m_hands;
    MasksPage* m_masks;
    QLineEdit* m_folder;
    QLabel* m_summary;
    QLabel* m_reason;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_make = nullptr;
    QTimer m_wait; ///< until the footage is looked at again
    QStringList m_cameras;
};

} // namespace app
