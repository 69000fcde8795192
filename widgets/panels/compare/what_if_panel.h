// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QWidget>

#include "widgets/panels/compare/method_form.h"
#include "widgets/panels/compare/what_if.h"
#include "widgets/presenters/inspect_columns.h"
#include "widgets/views/curve_plot.h"

namespace widgets {

/// The settings of a method's column, to be changed and dragged: the methods run again meanwhile, the column shows what
/// comes of it, and a curve of the error over what is dragged grows. So do cameras that are left out, and noisier
/// silhouettes.
class WhatIfPanel : public QWidget {
    Q_OBJECT

public:
    WhatIfPanel(const FitRunner& fits, InspectColumns& columns, const DatasetSession& datasets, JobPool& pool,
                QWidget* parent = nullptr);

    /// Shows the settings of that column. Columns that no method made are passed over.
    void showColumn(std::size_t column);
    MethodForm* form() const { return m_form; }
    CurvePlot* plot() const { return m_plot; }
    QLineEdit* line() const { return m_line; }
    /// Why the written method cannot be; empty if it can.
    QString problem() const { return m_problem->text(); }
    /// What is the same at all points of the curves, besides the settings that their names say, and which cameras a
    /// number of them means; empty for nothing.
    QString heldText() const;
    const std::vector<QCheckBox*>& cameras() const { return m_cameras; }
    void setOutlineNoisePx(double px) { m_noise->setValue(px); }
    void setNoiseDraw(int draw) { m_draw->setValue(draw); }
    /// The circumstances that are set now, and the settings that are tried, by column id: columns not here have their
    /// own.
    WhatIfCase currentCase() const;
    const std::map<std::string, std::string>& triedSettings() const { return m_tried; }
    /// Sets both, and fits all columns so.
    void tryAgain(const WhatIfCase& what, std::map<std::string, std::string> settings);
    /// Error (mm) by value of what is dragged, of methods that differ in nothing else: "ch:robust=2" while its gate is
    /// dragged.
    const std::map<std::string, std::map<double, double>>& points() const { return m_points; }
    bool isRunning() const { return m_runner.isRunning(); }
    /// Whether the first answer comes as soon as later ones.
    bool isPrepared() const { return m_runner.isPrepared(); }

    void apply();
    void addColumn();
    /// All as it was fitted.
    void goBack();
    /// Fits without each camera in turn and says beside it how much the error grows.
    void measureCameras();
    /// Fits at a row of values of a parameter, in the background, for every column that has it: the curve fills. None:
    /// the parameter that was changed last, or the method's first.
    void sweep(const std::string& key = {});
    void sweepOrStop();
    bool isSweeping() const { return m_isSweeping; }
    /// Which parameter the button goes over.
    std::string sweptKey() const;

signals:
    /// What was changed has an answer, of the real-time variant or of the method itself; the columns show it from now
    /// on.
    void answered(bool isLive);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    static int noiseStep(double px);
    void connectParts();
    QLayout* makeSilhouettes();
    QLayout* makeDrawRow();
    QLayout* makeButtons();
    QLayout* makeSweepRow();
    void takeColumns();
    void makeCameraBoxes();
    void showSettings();
    void takeLine();
    void edit(const std::string& key);
    void explore(const std::string& key);
    void takeSettings(const std::string& key);
    std::vector<WhatIfTrial> trialsOf(const std::string& key) const;
    WhatIfTrial trialOf(const std::string& column) const;
    std::vector<std::string> staleColumns() const;
    std::vector<std::string> methodColumns() const; ///< whose names are methods
    bool isAsFitted(const std::string& column) const;
    bool isUpToDate(const std::string& column) const;
    void catchUp();
    void showTrial();
    void setCase(const WhatIfCase& what);
    double shownErrorMm(const std::string& column) const;
    std::string withOption(const std::string& method, const std::string& key) const;
    void take(const WhatIfTrial& trial, const MethodOutcome& outcome);
    std::vector<WhatIfTrial> sweepTrials(const std::string& key) const;
    void takeSwept(const WhatIfTrial& trial, const MethodOutcome& outcome);
    void endSweep();
    void showSweep();
    void startCurve(const std::string& key);
    void addPoint(const WhatIfTrial& trial, double errorMm);
    void showCurves();
    void showCameraTexts();
    const std::string& tried(const std::string& column) const;
    double place(const std::string& key, const std::string& method) const;
    const MethodOutcome* fitted(const std::string& method) const;

    const FitRunner& m_fits;
    InspectColumns& m_columns;
    const DatasetSession& m_datasets;
    WhatIf m_runner;
    QLabel* m_hint;
    QWidget* m_content;
    QComboBox* m_column;
    QLineEdit* m_line;
    QLabel* m_problem;
    MethodForm* m_form;
    QSlider* m_noiseSlider;
    QDoubleSpinBox* m_noise;
    QSpinBox* m_draw;
    QGridLayout* m_cameraGrid;
    std::vector<QCheckBox*> m_cameras;
    QPushButton* m_measure;
    QPushButton* m_sweep;
    QProgressBar* m_progress;
    QPushButton* m_apply;
    QPushButton* m_add;
    QPushButton* m_back;
    QLabel* m_answer;
    QLabel* m_held; ///< what is the same at all points of the curves
    CurvePlot* m_plot;
    std::shared_ptr<const FitOutcome> m_pair; ///< that all of this is about
    bool m_isSweeping = false;
    int m_swept = 0;    ///< fits of the sweep that are done
    std::string m_base; ///< method of the column that is changed
    std::string m_next; ///< that is to be the base once its column is there
    std::string m_key;  ///< what was dragged last
    std::map<std::string, std::map<double, double>> m_points;
    std::map<double, std::vector<bool>> m_cameraSets; ///< which cameras a number of them means on the curves
    std::map<std::string, std::string> m_tried;       ///< settings by column id
    struct Shown {
        WhatIfCase what;
        MethodOutcome outcome; ///< its method: the settings
    };
    std::map<std::string, Shown> m_shown; ///< what columns show of the trial, by id
    std::map<int, double> m_without;      ///< error without a camera, mm
};

} // namespace widgets
