// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect_columns.h"

#include <algorithm>

#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr const char* kStartId = "start";
constexpr const char* kTruthId = "truth";

const MethodOutcome* fittedMethod(const FitOutcome& outcome, const std::string& name) {
    for (const MethodOutcome& method : outcome.methods)
        if (method.method == name)
            return &method;
    return nullptr;
}

/// What the silhouettes of the pair are, for columns that no method made: outlines and masks, no matches.
std::shared_ptr<const core::FitTrace> bareTrace(const FitOutcome& outcome) {
    for (const MethodOutcome& method : outcome.methods) {
        if (!method.result.trace)
            continue;
        auto bare = std::make_shared<core::FitTrace>();
        for (const core::CameraTarget& target : method.result.trace->targets) {
            bare->targets.push_back({target.camera, target.mask, target.maskBounds, target.contour, target.rayDirection,
                                     target.centre, target.index, std::nullopt});
            bare->finalMatches.push_back({target.camera, {}});
        }
        return bare;
    }
    return nullptr;
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
    return {InspectColumn::Kind::Method, id};
}

QString columnTitle(const InspectColumn& column) {
    switch (column.kind) {
    case InspectColumn::Kind::Start:
        return InspectColumns::tr("Start");
    case InspectColumn::Kind::Truth:
        return InspectColumns::tr("Truth");
    case InspectColumn::Kind::Method:
        break;
    }
    return QString::fromStdString(column.name);
}

InspectColumns::InspectColumns(FitRunner& fits, QObject* parent)
    : QObject(parent)
    , m_fits(fits) {
    connect(&fits, &FitRunner::finished, this, &InspectColumns::takeFits);
    connect(&fits, &FitRunner::cleared, this, &InspectColumns::takeFits);
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
    }
    return false;
}

/// Columns of the pair before stay where they can; what was fitted anew comes behind them.
void InspectColumns::takeFits() {
    const std::shared_ptr<const FitOutcome> before = m_fitted;
    m_fitted = m_fits.outcome();
    if (m_fitted) {
        std::vector<InspectColumn> columns;
        for (const InspectColumn& column : m_columns)
            if (isAvailable(column))
                columns.push_back(column);
        const bool isExtended = before && isSamePair(*before, *m_fitted);
        for (const MethodOutcome& method : m_fitted->methods) {
            const InspectColumn column{InspectColumn::Kind::Method, method.method};
            const bool wasRemoved = isExtended && fittedMethod(*before, method.method);
            if (!wasRemoved && std::find(columns.begin(), columns.end(), column) == columns.end())
                columns.push_back(column);
        }
        m_columns = std::move(columns);
    }
    arrange();
}

void InspectColumns::arrange() {
    m_outcome.reset();
    if (m_fitted) {
        auto arranged = std::make_shared<FitOutcome>();
        static_cast<FitPair&>(*arranged) = *m_fitted;
        arranged->sequence = m_fitted->sequence;
        arranged->request = m_fitted->request;
        const auto trace = bareTrace(*m_fitted);
        for (const InspectColumn& column : m_columns)
            if (column.kind == InspectColumn::Kind::Method)
                arranged->methods.push_back(*fittedMethod(*m_fitted, column.name));
            else if (column.kind == InspectColumn::Kind::Start)
                arranged->methods.push_back(
                    fixedColumn(kStartId, m_fitted->startPoses, m_fitted->initialErrorMm, trace));
            else
                arranged->methods.push_back(fixedColumn(kTruthId, m_fitted->truePoses, m_fitted->trueErrorMm, trace));
        m_outcome = arranged;
    }
    m_current = std::min(m_current, m_columns.empty() ? 0 : m_columns.size() - 1);
    emit changed();
}

void InspectColumns::setColumns(const std::vector<InspectColumn>& columns) {
    if (!m_fitted)
        return;
    m_columns.clear();
    std::vector<std::string> missing;
    for (const InspectColumn& column : columns) {
        if (std::find(m_columns.begin(), m_columns.end(), column) != m_columns.end())
            continue;
        if (isAvailable(column))
            m_columns.push_back(column);
        else if (column.kind == InspectColumn::Kind::Method)
            missing.push_back(column.name);
    }
    arrange();
    if (!missing.empty())
        m_fits.extend(missing);
}

void InspectColumns::add(const InspectColumn& column) {
    std::vector<InspectColumn> columns = m_columns;
    columns.push_back(column);
    setColumns(columns);
}

void InspectColumns::remove(std::size_t column) {
    if (column >= m_columns.size() || m_columns.size() < 2)
        return;
    m_columns.erase(m_columns.begin() + static_cast<std::ptrdiff_t>(column));
    arrange();
}

void InspectColumns::move(std::size_t from, std::size_t to) {
    if (from >= m_columns.size() || to >= m_columns.size() || from == to)
        return;
    const InspectColumn column = m_columns[from];
    m_columns.erase(m_columns.begin() + static_cast<std::ptrdiff_t>(from));
    m_columns.insert(m_columns.begin() + static_cast<std::ptrdiff_t>(to), column);
    m_current = to;
    arrange();
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
