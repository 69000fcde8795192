// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>

#include "widgets/jobs/dataset_maker.h"
#include "widgets/views/message_bar.h"

class QFormLayout;

namespace app {

class MainWindow;

/// Asks for a calibration, videos or folders of images, and a folder, and makes a dataset of them, which is then
/// opened. Footage is given to the cameras by name.
class NewDatasetWindow : public QDialog {
    Q_OBJECT

public:
    explicit NewDatasetWindow(MainWindow& window);

    /// Shows the window's one such dialog, with more footage.
    static NewDatasetWindow* open(MainWindow& window, const QStringList& footage);

    void addFootage(const QStringList& paths);
    void setCalibration(const QString& path);
    void setFolder(const QString& path);
    /// What is said above the fields: what is missing or wrong.
    QString message() const { return m_message->message(); }
    QTableWidget* table() const { return m_table; }
    QPushButton* makeButton() const { return m_make; }

private:
    void build();
    void addButtons(QFormLayout& form);
    QWidget* withChooser(QLineEdit* field, const QString& title, bool isFolder);
    void askForFootage(bool isFolder);
    void readCameras();
    void showCameras(const QStringList& names);
    void refresh();
    void make();
    widgets::NewDatasetRequest request() const;
    QComboBox* choiceIn(int row) const;
    QStringList paths() const;

    MainWindow& m_window;
    widgets::DatasetMaker m_maker;
    widgets::MessageBar* m_message;
    QLineEdit* m_calibration;
    QComboBox* m_unit;
    QTableWidget* m_table;
    QLineEdit* m_sequence;
    QLineEdit* m_folder;
    QPushButton* m_make;
    QTimer m_wait; ///< until the calibration's name is typed
    QStringList m_cameras;
};

} // namespace app
