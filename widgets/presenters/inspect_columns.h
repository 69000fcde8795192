// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QColor>
#include <QObject>

#include "core/benchmark/external_rows.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/presenters/what_if_case.h"
#include "widgets/session/dataset_session.h"

namespace widgets {

/// What one column of the Inspect workspace shows.
struct InspectColumn {
    enum class Kind {
        Method, ///< a method with its settings
        Start,  ///< the pose that every method began with
        Truth,  ///< the recorded pose of the test frame
        Tracker ///< another tracker's estimate
    };
    Kind kind = Kind::Method;
    std::string name; ///< of a method, as on the command line; of a tracker; empty for the others
    bool operator==(const InspectColumn&) const = default;
};

/// As scripts and workspace files call a column: "dch-thres:tau=45", "start", "truth", "external:NAME".
std::string columnId(const InspectColumn& column);
InspectColumn columnOf(const std::string& id);
/// What the window calls it.
QString columnTitle(const InspectColumn& column);

/// Another tracker's estimates, as read from a file.
struct Tracker {
    std::string name;
    QString file;
    std::shared_ptr<const core::ExternalEstimates> estimates;
};

/// The columns of the Inspect workspace: which there are, in which order, which of them are switched off in which
/// camera. What they show is one outcome, whose `methods` are the columns from left to right.
class InspectColumns : public QObject {
    Q_OBJECT

public:
    InspectColumns(FitRunner& fits, const DatasetSession& datasets, JobPool& pool, QObject* parent = nullptr);

    /// The fitted pair as the columns show it; null while nothing is fitted.
    const std::shared_ptr<const FitOutcome>& outcome() const { return m_outcome; }
    /// Parallel to outcome()->methods.
    const std::vector<InspectColumn>& columns() const { return m_columns; }
    std::size_t count() const { return m_columns.size(); }

    /// What can be a column of this pair, apart from methods.
    bool isAvailable(const InspectColumn& column) const;
    /// Exactly these, as far as the pair has them; a method that is not fitted yet is fitted and then takes its place.
    void setColumns(const std::vector<InspectColumn>& columns);
    /// Another method, or other settings, in the place of a column.
    void replace(std::size_t column, const std::string& method);
    /// A column on the right; one that is there already stays where it is.
    void add(const InspectColumn& column);
    /// The last column stays.
    void remove(std::size_t column);
    /// Takes a column out and puts it where `to` is.
    void move(std::size_t from, std::size_t to);

    /// Reads the estimates of a tracker (CSV or JSON, as handlens-batch benchmark takes them) and adds them as a
    /// column. failed() says why that was not possible.
    void addTracker(const std::string& name, const QString& file);
    const std::vector<Tracker>& trackers() const { return m_trackers; }

    /// Shows what is tried in the places of columns, until it is set anew or the pair changes. Start, truth and
    /// trackers are compared with the silhouettes of the same case. Says previewed(), not changed().
    void setTrial(ColumnTrial trial);
    const ColumnTrial& trial() const { return m_trial; }
    /// Columns are being fitted for it, or all have been. Says trialChanged().
    void setTrialComplete(bool complete);
    /// Whether a column shows what is tried.
    bool isPreview(std::size_t column) const;

    /// The column that keys are about.
    std::size_t current() const { return m_current; }
    void setCurrent(std::size_t column);

    /// Whether a column's hands are drawn in the view of that camera (an index into the dataset's).
    bool isShown(std::size_t column, int camera) const;
    void setShown(std::size_t column, int camera, bool shown);

    /// What stands above a column: its name, or the settings that are tried in its place.
    QString title(std::size_t column) const;
    /// Of the column's meshes and curves: its method's, darker where a method is there with several settings.
    QColor colour(std::size_t column) const;

signals:
    /// Other columns, another order, or another pair.
    void changed();
    /// The same columns of the same pair, with something else in some of them.
    void previewed();
    /// The same is shown, and more is being fitted, or nothing any more.
    void trialChanged();
    void currentChanged();
    /// A column was switched on or off in a view.
    void shownChanged();
    void failed(const QString& message);

private:
    void takeFits();
    void arrange();
    std::shared_ptr<const FitOutcome> arranged() const;
    void poseTrackers();
    void takeTrialTrace();
    MethodOutcome outcomeOf(const InspectColumn& column, const std::shared_ptr<const core::FitTrace>& trace) const;
    bool isFitted(const std::string& method) const;

    FitRunner& m_fits;
    const DatasetSession& m_datasets;
    Job m_reading;
    Job m_posing;
    std::shared_ptr<const FitOutcome> m_fitted;        ///< that m_columns are of
    std::shared_ptr<const core::FitTrace> m_bareTrace; ///< of m_fitted, for columns that no method made
    std::shared_ptr<const FitOutcome> m_outcome;
    std::vector<InspectColumn> m_wanted; ///< with those that are being fitted or read
    std::vector<InspectColumn> m_columns;
    std::vector<Tracker> m_trackers;
    std::map<std::string, MethodOutcome> m_posed; ///< trackers on this pair, by column id
    ColumnTrial m_trial;
    std::shared_ptr<const core::FitTrace> m_trialTrace; ///< as m_bareTrace, in the case of m_trial; null: that one
    WhatIfCase m_traceCase;                             ///< of m_trialTrace
    bool m_isTraceWhole = false;                        ///< all of the case was fitted when it was made
    std::size_t m_current = 0;
    std::set<std::pair<std::string, int>> m_hidden; ///< column and camera
};

/// Whether both are of one run, with more methods or with other columns.
bool isSamePair(const FitOutcome& a, const FitOutcome& b);
/// A column's colour in an arranged outcome.
QColor columnColour(const FitOutcome& outcome, std::size_t column);

} // namespace widgets
