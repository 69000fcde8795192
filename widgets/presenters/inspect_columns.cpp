// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect_columns.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/io/benchmark/external_estimates.h"
#include "widgets/presenters/tracker_column.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr const char* kStartId = "start";
constexpr const char* kTruthId = "truth";
constexpr std::string_view kTrackerId = "external:";

bool contains(const std::vector<InspectColumn>& columns, const InspectColumn& column) {
    return std::find(columns.begin(), columns.end(), column) != columns.end();
}

const MethodOutcome* fittedMethod(const FitOutcome& outcome, const std::string& name) {
    for (const MethodOutcome& method : outcome.methods)
        if (method.method == name)
            return &method;
    return nullptr;
}

bool hasForearm(const core::FitTrace& trace) {
    return std::any_of(
        trace.forearms.begin(), trace.forearms.end(), [](const auto& cut) { return cut.has_value(); });
}

/// What the silhouettes of the pair are, for columns that no method made: outlines, masks and where forearms are cut
/// off, no matches.
std::shared_ptr<const core::FitTrace> bareTrace(const std::vector<MethodOutcome>& methods) {
    std::shared_ptr<core::FitTrace> bare;
    for (const MethodOutcome& method : methods) {
        const auto& trace = method.result.trace;
        if (trace && !bare) {
            bare = std::make_shared<core::FitTrace>();
            for (const core::CameraTarget& target : trace->targets) {
                bare->targets.push_back({target.camera, target.mask, target.maskBounds, target.contour,
                                         target.rayDirection, target.centre, target.index, std::nullopt});
                bare->finalMatches.push_back({target.camera, {}, {}});
            }
        }
        if (trace && !hasForearm(*bare))
            bare->forearms = trace->forearms;
    }
    return bare;
}

MethodOutcome fixedColumn(std::string id, core::HandPoses poses, double errorMm,
                          std::shared_ptr<const core::FitTrace> trace) {
    MethodOutcome column;
    column.method = std::move(id);
    column.result.poses = std::move(poses);
    column.result.trace = std::move(trace);
    column.errorMm = errorMm;
    column.isFixed = true;
    return column;
}

} // namespace

bool isSamePair(const FitOutcome& a, const FitOutcome& b) {
    return a.sequence == b.sequence && a.request.start == b.request.start &&
           std::equal(
               a.masks.begin(), a.masks.end(), b.masks.begin(), b.masks.end(),
               [](const cv::Mat& one, const cv::Mat& other) { return one.data == other.data; });
}

std::string columnId(const InspectColumn& column) {
    switch (column.kind) {
    case InspectColumn::Kind::Start:
        return kStartId;
    case InspectColumn::Kind::Truth:
        return kTruthId;
    case InspectColumn::Kind::Tracker:
        return std::string(kTrackerId) + column.name;
    case InspectColumn::Kind::Method:
        break;
    }
    return column.name;
}

InspectColumn columnOf(const std::string& id) {
    if (id == kStartId)
        return {InspectColumn::Kind::Start, {}};
    if (id == kTruthId)
        return {InspectColumn::Kind::Truth, {}};
    if (id.rfind(kTrackerId, 0) == 0)
        return {InspectColumn::Kind::Tracker, id.substr(kTrackerId.size())};
    return {InspectColumn::Kind::Method, id};
}

QString columnTitle(const InspectColumn& column) {
    switch (column.kind) {
    case InspectColumn::Kind::Start:
        return InspectColumns::tr("Start");
    case InspectColumn::Kind::Truth:
        return InspectColumns::tr("Truth");
    case InspectColumn::Kind::Tracker:
    case InspectColumn::Kind::Method:
        break;
    }
    return QString::fromStdString(column.name);
}

InspectColumns::InspectColumns(FitRunner& fits, const DatasetSession& datasets, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_fits(fits)
    , m_datasets(datasets)
    , m_reading(pool)
    , m_posing(pool) {
    connect(&fits, &FitRunner::finished, this, &InspectColumns::takeFits);
    connect(&fits, &FitRunner::cleared, this, &InspectColumns::takeFits);
    connect(&m_reading, &Job::failed, this, &InspectColumns::failed);
    connect(&m_posing, &Job::failed, this, &InspectColumns::failed);
    takeFits();
}

bool InspectColumns::isFitted(const std::string& method) const {
    return m_fitted && fittedMethod(*m_fitted, method);
}

bool InspectColumns::isAvailable(const InspectColumn& column) const {
    switch (column.kind) {
    case InspectColumn::Kind::Method:
        return isFitted(column.name);
    case InspectColumn::Kind::Start:
        return m_fitted != nullptr;
    case InspectColumn::Kind::Truth:
        return m_fitted && !m_fitted->truePoses.empty();
    case InspectColumn::Kind::Tracker:
        return m_fitted && std::any_of(m_trackers.begin(), m_trackers.end(),
                                       [&](const Tracker& tracker) { return tracker.name == column.name; });
    }
    return false;
}

/// Columns that the new pair has, too, keep their places; what is fitted anew comes behind them. Nothing of the pair
/// before stays: methods that were not fitted on this one go, and so do settings that were tried.
void InspectColumns::takeFits() {
    const std::shared_ptr<const FitOutcome> before = m_fitted;
    m_fitted = m_fits.outcome();
    m_bareTrace = m_fitted ? bareTrace(m_fitted->methods) : nullptr;
    const bool isExtended = before && m_fitted && isSamePair(*before, *m_fitted);
    if (!isExtended) { // it was of the pair before
        m_trial = ColumnTrial();
        m_trialTrace.reset();
    }
    if (m_fitted && !isExtended) {
        std::erase_if(m_wanted, [this](const InspectColumn& column) { return !isAvailable(column); });
        m_posed.clear();
    }
    if (m_fitted) {
        for (const MethodOutcome& method : m_fitted->methods) {
            const InspectColumn column{InspectColumn::Kind::Method, method.method};
            const bool wasRemoved = isExtended && fittedMethod(*before, method.method);
            if (!wasRemoved && !contains(m_wanted, column))
                m_wanted.push_back(column);
        }
        if (!isExtended)
            poseTrackers();
    }
    arrange();
}

MethodOutcome InspectColumns::outcomeOf(const InspectColumn& column,
                                        const std::shared_ptr<const core::FitTrace>& trace) const {
    const std::string id = columnId(column);
    switch (column.kind) {
    case InspectColumn::Kind::Start:
        return fixedColumn(id, m_fitted->startPoses, m_fitted->initialErrorMm, trace);
    case InspectColumn::Kind::Truth:
        return fixedColumn(id, m_fitted->truePoses, m_fitted->trueErrorMm, trace);
    case InspectColumn::Kind::Tracker: {
        const auto posed = m_posed.find(id);
        MethodOutcome outcome = posed == m_posed.end() ? fixedColumn(id, {}, std::nan(""), trace) : posed->second;
        outcome.result.trace = trace;
        return outcome;
    }
    case InspectColumn::Kind::Method:
        break;
    }
    const auto tried = m_trial.methods.find(id);
    return tried == m_trial.methods.end() ? *fittedMethod(*m_fitted, column.name) : tried->second;
}

/// The pair with what its columns show, from left to right.
std::shared_ptr<const FitOutcome> InspectColumns::arranged() const {
    auto outcome = std::make_shared<FitOutcome>();
    static_cast<FitPair&>(*outcome) = *m_fitted;
    outcome->sequence = m_fitted->sequence;
    outcome->request = m_fitted->request;
    for (const InspectColumn& column : m_columns)
        outcome->methods.push_back(outcomeOf(column, m_trialTrace ? m_trialTrace : m_bareTrace));
    if (m_trial.outlinesPx)
        outcome->outlinesPx = *m_trial.outlinesPx;
    return outcome;
}

void InspectColumns::arrange() {
    m_columns.clear();
    for (const InspectColumn& column : m_wanted)
        if (isAvailable(column))
            m_columns.push_back(column);
    m_outcome = m_fitted ? arranged() : nullptr;
    m_current = std::min(m_current, m_columns.empty() ? 0 : m_columns.size() - 1);
    emit changed();
}

void InspectColumns::setColumns(const std::vector<InspectColumn>& columns) {
    if (!m_fitted)
        return;
    m_wanted.clear();
    std::vector<std::string> missing;
    for (const InspectColumn& column : columns) {
        if (contains(m_wanted, column))
            continue;
        m_wanted.push_back(column);
        if (column.kind == InspectColumn::Kind::Method && !isFitted(column.name))
            missing.push_back(column.name);
    }
    arrange();
    if (!missing.empty())
        m_fits.extend(missing);
}

void InspectColumns::replace(std::size_t column, const std::string& method) {
    if (column >= m_columns.size())
        return;
    std::vector<InspectColumn> columns = m_wanted;
    *std::find(columns.begin(), columns.end(), m_columns[column]) = {InspectColumn::Kind::Method, method};
    setColumns(columns);
}

void InspectColumns::addTracker(const std::string& name, const QString& file) {
    const auto& dataset = m_datasets.dataset();
    if (!dataset)
        return;
    m_reading.start([this, name, file, dataset](const JobContext&) -> Job::Delivery {
        auto estimates = std::make_shared<const core::ExternalEstimates>(
            core::readExternalEstimates(name, file.toStdString(), dataset->hands));
        return [this, name, file, estimates] {
            std::erase_if(m_trackers, [&](const Tracker& tracker) { return tracker.name == name; });
            m_trackers.push_back({name, file, estimates});
            if (const InspectColumn column{InspectColumn::Kind::Tracker, name}; !contains(m_wanted, column))
                m_wanted.push_back(column);
            arrange();
            poseTrackers();
        };
    });
}

/// In the background: what the trackers say of this pair.
void InspectColumns::poseTrackers() {
    const auto& dataset = m_datasets.dataset();
    if (m_trackers.empty() || !m_fitted || !dataset)
        return;
    m_posing.start([this, dataset, fitted = m_fitted, trackers = m_trackers](const JobContext& context) {
        auto posed = std::make_shared<std::map<std::string, MethodOutcome>>();
        for (const Tracker& tracker : trackers) {
            const std::string id = std::string(kTrackerId) + tracker.name;
            if (!context.stop.stop_requested())
                posed->emplace(id, trackerColumn(*dataset, *fitted, *tracker.estimates, id));
        }
        return [this, posed, fitted] {
            if (!m_fitted || !isSamePair(*m_fitted, *fitted))
                return;
            m_posed = std::move(*posed);
            arrange();
        };
    });
}

/// The silhouettes of a case are in what was fitted to them.
void InspectColumns::takeTrialTrace() {
    if (m_trial.what == WhatIfCase()) {
        m_trialTrace.reset();
        return;
    }
    const bool isOfCase = m_trialTrace && m_traceCase == m_trial.what;
    if (isOfCase && (m_isTraceWhole || !m_trial.isComplete))
        return; // the same stays the same: views draw nothing anew
    std::vector<MethodOutcome> methods;
    for (const auto& [column, outcome] : m_trial.methods)
        if (m_trial.stale.count(column) == 0)
            methods.push_back(outcome);
    if (auto trace = bareTrace(methods)) {
        m_trialTrace = std::move(trace);
        m_traceCase = m_trial.what;
        m_isTraceWhole = m_trial.isComplete;
    }
}

void InspectColumns::setTrial(ColumnTrial trial) {
    if (!trial.isOn() && !m_trial.isOn())
        return;
    m_trial = std::move(trial);
    takeTrialTrace();
    if (!m_fitted)
        return;
    m_outcome = arranged();
    emit previewed();
}

void InspectColumns::setTrialComplete(bool complete) {
    if (complete == m_trial.isComplete)
        return;
    m_trial.isComplete = complete;
    emit trialChanged();
}

bool InspectColumns::isPreview(std::size_t column) const {
    return column < m_columns.size() && m_trial.methods.count(columnId(m_columns[column])) > 0;
}

void InspectColumns::add(const InspectColumn& column) {
    std::vector<InspectColumn> columns = m_wanted;
    columns.push_back(column);
    setColumns(columns);
}

void InspectColumns::remove(std::size_t column) {
    if (column >= m_columns.size() || m_columns.size() < 2)
        return;
    std::vector<InspectColumn> columns = m_wanted;
    std::erase(columns, m_columns[column]);
    setColumns(columns);
}

void InspectColumns::move(std::size_t from, std::size_t to) {
    if (from >= m_columns.size() || to >= m_columns.size() || from == to)
        return;
    const InspectColumn moved = m_columns[from], place = m_columns[to];
    std::vector<InspectColumn> columns = m_wanted;
    std::erase(columns, moved);
    const auto at = std::find(columns.begin(), columns.end(), place);
    columns.insert(to > from ? at + 1 : at, moved);
    m_current = to;
    setColumns(columns);
}

void InspectColumns::setCurrent(std::size_t column) {
    if (column >= m_columns.size() || column == m_current)
        return;
    m_current = column;
    emit currentChanged();
}

bool InspectColumns::isShown(std::size_t column, int camera) const {
    return column >= m_columns.size() || m_hidden.count({columnId(m_columns[column]), camera}) == 0;
}

void InspectColumns::setShown(std::size_t column, int camera, bool shown) {
    if (column >= m_columns.size() || shown == isShown(column, camera))
        return;
    if (shown)
        m_hidden.erase({columnId(m_columns[column]), camera});
    else
        m_hidden.insert({columnId(m_columns[column]), camera});
    emit shownChanged();
}

QString InspectColumns::title(std::size_t column) const {
    if (!isPreview(column))
        return columnTitle(m_columns[column]);
    return tr("%1?", "a method with settings that are tried")
        .arg(QString::fromStdString(m_outcome->methods[column].method));
}

QColor InspectColumns::colour(std::size_t column) const {
    return m_outcome ? columnColour(*m_outcome, column) : QColor();
}

QColor columnColour(const FitOutcome& outcome, std::size_t column) {
    constexpr int kDarker = 140; // per cent, for every column before it of the same method
    QColor colour = methodColour(outcome.methods[column].method);
    const QColor plain = colour;
    for (std::size_t before = 0; before < column; ++before)
        if (methodColour(outcome.methods[before].method) == plain)
            colour = colour.darker(kDarker);
    return colour;
}

} // namespace widgets
