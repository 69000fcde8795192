// SPDX-License-Identifier: MIT
#include "widgets/jobs/rater_study.h"

#include <algorithm>
#include <sstream>

namespace widgets {

namespace {

constexpr int kViewsOfATask = 2; ///< marked by hand in so many views, a joint has a point

/// The tasks of a round are kept with the annotations, one a line: the round goes on after a restart.
std::string settingOf(const std::string& rater) {
    return "repeat/" + rater;
}

std::string textOf(const std::vector<core::RepeatTask>& tasks) {
    std::ostringstream text;
    for (const core::RepeatTask& task : tasks)
        text << task.frame << ' ' << core::sideName(task.joint.hand) << ' ' << task.joint.joint << '\n';
    return text.str();
}

std::vector<core::RepeatTask> tasksFrom(const std::string& text) {
    std::vector<core::RepeatTask> tasks;
    std::istringstream stream(text);
    core::RepeatTask task;
    for (std::string side; stream >> task.frame >> side >> task.joint.joint;) {
        if (const auto hand = core::sideFromName(side)) {
            task.joint.hand = *hand;
            tasks.push_back(task);
        }
    }
    return tasks;
}

} // namespace

std::string ownName(const std::string& rater) {
    return core::ownRaterName(rater);
}

RaterStudy::RaterStudy(AnnotationDocument& document, Selection& selection, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_selection(selection)
    , m_job(pool)
    , m_drawJob(pool) {
    connect(&document, &AnnotationDocument::opened, this, &RaterStudy::takeSequence);
    connect(&document, &AnnotationDocument::raterChanged, this, &RaterStudy::takeRater);
    connect(&document, &AnnotationDocument::changed, this, [this] {
        if (isRepeating())
            emit roundChanged();
    });
    for (const Job* job : {&m_job, &m_drawJob})
        connect(job, &Job::failed, this, &RaterStudy::failed);
}

void RaterStudy::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_dataset = std::move(dataset);
    m_job.stop();
    m_comparisons.clear(); // of other cameras
    m_sigmas = {};
    emit compared();
}

void RaterStudy::setClickSigmas(const core::ClickSigmas& sigmas) {
    m_sigmas = sigmas;
    if (m_job.isRunning() || !m_comparisons.empty())
        compare();
    else
        emit compared();
}

/// What was found belongs to the sequence before; a round goes on only where it was begun.
void RaterStudy::takeSequence() {
    m_job.stop();
    m_comparisons.clear();
    takeRater();
    if (isRepeating() && openTasks() == 0)
        m_document.setRater(ownName(m_document.rater()));
    emit compared();
}

void RaterStudy::takeRater() {
    m_drawJob.stop();
    m_tasks = tasksFrom(m_document.setting(settingOf(ownName(m_document.rater()))).value_or(std::string()));
    emit roundChanged();
}

void RaterStudy::compare() {
    if (!m_dataset || isRepeating()) // whoever repeats must not see the first marks
        return;
    m_job.start([this, dataset = m_dataset, sigmas = m_sigmas,
                 set = m_document.annotations()](const JobContext&) -> Job::Delivery {
        return [this, comparisons = core::compareAllRaters(set, dataset->cameras, sigmas)] {
            m_comparisons = comparisons;
            emit compared();
        };
    });
}

core::Consensus RaterStudy::consensus() const {
    if (!m_dataset || isRepeating())
        return {};
    return core::consensus(m_document.annotations(), m_dataset->cameras, m_selection.frame(), m_selection.joint(),
                           m_sigmas);
}

bool RaterStudy::isRepeating() const {
    return core::isRepeatRater(m_document.rater());
}

void RaterStudy::beginRepeating(double share, unsigned seed) {
    if (!m_dataset || !m_document.isOpen() || isRepeating())
        return;
    const std::string rater = m_document.rater();
    if (openTasks() > 0) {
        begin(rater, m_tasks);
        return;
    }
    m_drawJob.start([this, rater, share, seed, dataset = m_dataset, options = m_sigmas.optionsFor(rater),
                     set = m_document.annotations()](const JobContext&) mutable -> Job::Delivery {
        std::erase_if(set.marks, [&](const auto& item) { // what was repeated once is not drawn again
            core::MarkKey repeated = item.first;
            repeated.rater = core::repeatRaterName(rater);
            return item.first.rater == rater &&
                   !core::marksOfJoint(set, repeated.frame, repeated.rater, repeated.joint).empty();
        });
        auto tasks = core::drawRepeatTasks(set, dataset->cameras, rater, share, seed, options);
        return [this, rater, tasks = std::move(tasks)] { begin(rater, tasks); };
    });
}

void RaterStudy::begin(const std::string& rater, std::vector<core::RepeatTask> tasks) {
    if (tasks.empty()) {
        emit nothingToRepeat();
        return;
    }
    m_document.setSetting(settingOf(rater), textOf(tasks));
    m_document.setRater(core::repeatRaterName(rater));
    goToNextTask();
}

bool RaterStudy::isOpen(const core::RepeatTask& task) const {
    const std::string rater = core::repeatRaterName(ownName(m_document.rater()));
    const auto marks = core::marksOfJoint(m_document.annotations(), task.frame, rater, task.joint);
    return std::count_if(marks.begin(), marks.end(), [](const auto& mark) { return mark.second.isEvidence(); }) <
           kViewsOfATask;
}

int RaterStudy::openTasks() const {
    return static_cast<int>(std::count_if(
        m_tasks.begin(), m_tasks.end(), [this](const auto& task) { return isOpen(task); }));
}

bool RaterStudy::goToNextTask() {
    if (!isRepeating())
        return false;
    const core::RepeatTask here{m_selection.frame(), m_selection.joint()};
    const auto current = std::find(m_tasks.begin(), m_tasks.end(), here);
    std::vector<core::RepeatTask> order = m_tasks;
    if (current != m_tasks.end())
        std::rotate(order.begin(), order.begin() + (current - m_tasks.begin()) + 1, order.end());
    const auto next = std::find_if(order.begin(), order.end(), [this](const auto& task) { return isOpen(task); });
    if (next == order.end())
        return false;
    m_selection.setFrame(next->frame);
    m_selection.setJoint(next->joint);
    return true;
}

void RaterStudy::endRepeating() {
    m_document.setRater(ownName(m_document.rater()));
    compare();
}

} // namespace widgets
