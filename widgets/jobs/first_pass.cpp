// SPDX-License-Identifier: MIT
#include "widgets/jobs/first_pass.h"

#include <algorithm>

#include "core/io/dataset/dataset_annotations.h"
#include "core/io/detector/auto_label_file.h"

namespace widgets {

namespace {

constexpr int kSettleMs = 300; ///< after a click: the next one may correct the same joint

/// The frame of a joint that the edit places by hand for the second time or more, if it has proposals beside it.
std::optional<int> correctedFrameOf(const core::Edit& edit, const core::AnnotationSet& set, const std::string& rater) {
    for (const core::MarkChange& change : edit.marks) {
        if (change.key.rater != rater || !change.after || !change.after->isEvidence())
            continue;
        const auto ofJoint = core::marksOfJoint(set, change.key.frame, rater, change.key.joint);
        const auto ofFrame = core::marksOfFrame(set, change.key.frame, rater);
        if (std::count_if(ofJoint.begin(), ofJoint.end(), [](const auto& item) { return item.second.isEvidence(); }) >=
                2 &&
            std::any_of(ofFrame.begin(), ofFrame.end(), [&](const auto& item) {
                return item.second.isProposal() && item.first.joint != change.key.joint;
            }))
            return change.key.frame;
    }
    return std::nullopt;
}

void keepHands(core::AutoLabels& labels, const std::set<core::Side>& hands) {
    for (auto& [frame, list] : labels)
        std::erase_if(
            list, [&hands](const core::AutoHand& label) { return !hands.contains(label.side); });
    std::erase_if(labels, [](const auto& item) { return item.second.empty(); });
}

void keepJoints(core::Edit& edit, const std::set<core::JointId>& joints) {
    std::erase_if(
        edit.marks, [&joints](const core::MarkChange& change) { return !joints.contains(change.key.joint); });
}

/// Those that the rater has marks of, proposed or not.
std::set<core::JointId> jointsOf(const core::AnnotationSet& set, const std::string& rater) {
    std::set<core::JointId> joints;
    for (const auto& [key, mark] : set.marks)
        if (key.rater == rater)
            joints.insert(key.joint);
    return joints;
}

/// Without the marks that were changed since the work began: a person has worked there.
void leaveOut(core::Edit& edit, const std::set<core::MarkKey>& touched) {
    if (!touched.empty())
        std::erase_if(
            edit.marks, [&touched](const core::MarkChange& change) { return touched.contains(change.key); });
}

} // namespace

FirstPass::FirstPass(AnnotationDocument& document, JobPool& pool, FirstPassProgram program, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_program(std::move(program))
    , m_job(pool, Job::Kind::Background)
    , m_installing(pool)
    , m_following(pool, Job::Kind::Background)
    , m_refitting(pool, Job::Kind::Background) {
    m_settling.setSingleShot(true);
    m_settling.setInterval(kSettleMs);
    connect(&m_settling, &QTimer::timeout, this, &FirstPass::refit);
    connect(&document, &AnnotationDocument::changed, this, &FirstPass::noteTouched);
    connect(&document, &AnnotationDocument::changed, this, &FirstPass::noteCorrection);
    connect(&document, &AnnotationDocument::saved, this, &FirstPass::removeJournal);
    for (const auto end : {&Job::finished, &Job::stopped})
        connect(&m_following, end, this, &FirstPass::followNext);
    for (const Job* job : {&m_job, &m_installing, &m_following, &m_refitting}) {
        connect(job, &Job::failed, this, &FirstPass::failed);
        for (const auto end : {&Job::started, &Job::finished, &Job::stopped})
            connect(job, end, this, &FirstPass::runningChanged);
        connect(job, &Job::failed, this, &FirstPass::runningChanged);
    }
    connect(&m_job, &Job::progressed, this, [this](double, const QString& steps) {
        const QStringList parts = steps.split(QLatin1Char(' '));
        emit progressed(static_cast<core::PassStage>(parts[0].toInt()), parts[1].toInt(), parts[2].toInt());
    });
    connect(&document, &AnnotationDocument::aboutToClose, this, [this] {
        m_job.stop(); // what is done is in the journal
        forgetFollowing();
        forgetRefit();
        m_dataset.reset();
        m_sequence.reset();
    });
}

void FirstPass::setProgram(FirstPassProgram program) {
    m_program = std::move(program);
    emit runningChanged();
}

void FirstPass::setSequence(std::shared_ptr<const core::Dataset> dataset, const core::Sequence* sequence) {
    m_job.stop();
    forgetFollowing();
    forgetRefit();
    m_dataset = std::move(dataset);
    m_sequence = sequence ? std::optional(*sequence) : std::nullopt;
}

void FirstPass::install(const QString& package) {
    if (isInstalling())
        return;
    m_installing.start(
        [this, path = package.toStdString(), install = m_program.install](const JobContext&) -> Job::Delivery {
            return [this, title = QString::fromStdString(install(path))] { emit installed(title); };
        });
}

void FirstPass::run(const FirstPassRequest& request) {
    if (isRunning())
        return;
    if (!m_dataset || !m_sequence) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    if (m_document.isReadOnly()) {
        emit failed(tr("These annotations are read-only: nothing can be proposed."));
        return;
    }
    if (core::countViews(*m_sequence) < 2) {
        emit failed(tr("The first pass needs two cameras with pictures."));
        return;
    }
    m_touched[&m_job].clear();
    m_job.start([this, work = workOn(request.frames), wanted = request, label = m_program.label,
                 set = m_document.annotations(),
                 rater = m_document.rater()](const JobContext& context) -> Job::Delivery {
        FirstPassResult result;
        result.wanted = static_cast<int>(work.frames.size());
        auto [labels, isFinished, camerasOffPx] =
            label(work, context.stop, [&context](core::PassStage stage, int done, int total) {
                context.report(static_cast<double>(done) / std::max(1, total),
                               QStringLiteral("%1 %2 %3").arg(static_cast<int>(stage)).arg(done).arg(total));
            });
        keepHands(labels, wanted.hands);
        result.frames = static_cast<int>(labels.size());
        result.isFinished = isFinished;
        result.camerasOffPx = camerasOffPx;
        const auto edit = std::make_shared<core::Edit>(core::autoLabelEdit(set, *work.dataset, labels, rater));
        if (!wanted.joints.empty())
            keepJoints(*edit, wanted.joints);
        edit->description = {
            .kind = core::EditKind::FirstPass, .firstFrame = work.frames.front(), .lastFrame = work.frames.back()};
        for (const core::MarkChange& change : edit->marks)
            result.joints.insert(change.key.joint);
        return [this, edit, result, journal = work.journal] { deliver(std::move(*edit), result, journal); };
    });
}

FirstPassWork FirstPass::workOn(std::vector<int> frames) const {
    std::filesystem::path journal = core::annotationFile(*m_dataset, *m_sequence);
    journal += ".first-pass";
    return {m_dataset, *m_sequence, std::move(frames), std::move(journal)};
}

void FirstPass::followFrom(int frame) {
    if (!m_program.follow || !m_dataset || !m_sequence)
        return;
    if (m_toRefit == frame) // it is accepted as it stands
        forgetRefit();
    m_toFollow.push_back(frame);
    if (!isFollowing())
        followNext();
}

void FirstPass::forgetFollowing() {
    m_toFollow.clear();
    m_following.stop();
}

void FirstPass::followNext() {
    if (m_toFollow.empty())
        return;
    const int frame = m_toFollow.front();
    m_toFollow.pop_front();
    m_touched[&m_following].clear();
    m_following.start([this, work = workOn({}), follow = m_program.follow, set = m_document.annotations(),
                       rater = m_document.rater(), frame](const JobContext& context) -> Job::Delivery {
        const core::AutoLabels labels = follow(work, set, rater, frame, context.stop);
        if (labels.empty() || context.stop.stop_requested())
            return {};
        core::Edit edit = core::autoLabelEdit(set, *work.dataset, labels, rater);
        keepJoints(edit, jointsOf(set, rater));
        edit.description = {.kind = core::EditKind::FirstPass,
                            .firstFrame = labels.begin()->first,
                            .lastFrame = labels.rbegin()->first};
        return [this, edit = std::move(edit), frame]() mutable {
            leaveOut(edit, m_touched[&m_following]);
            m_document.push(edit);
            emit followed(frame, static_cast<int>(edit.marks.size()));
        };
    });
}

void FirstPass::noteCorrection(const core::Edit& edit) {
    if (!m_program.refit || !m_dataset || m_document.isReadOnly())
        return;
    const auto frame = correctedFrameOf(edit, m_document.annotations(), m_document.rater());
    if (!frame)
        return;
    m_refitting.stop(); // it knew less
    m_toRefit = frame;
    m_settling.start();
}

void FirstPass::forgetRefit() {
    m_settling.stop();
    m_toRefit.reset();
    m_refitting.stop();
}

void FirstPass::refit() {
    if (!m_toRefit || m_document.undoStack()->canRedo())
        return;
    if (m_document.hasPreview()) { // a mark is being dragged
        m_settling.start();
        return;
    }
    m_touched[&m_refitting].clear();
    m_refitting.start([this, work = workOn({*m_toRefit}), run = m_program.refit, set = m_document.annotations(),
                       rater = m_document.rater(), frame = *m_toRefit](const JobContext& context) -> Job::Delivery {
        const core::AutoLabels labels = run(work, set, rater, frame, context.stop);
        if (labels.empty() || context.stop.stop_requested())
            return {};
        core::Edit edit = core::autoLabelEdit(set, *work.dataset, labels, rater);
        keepJoints(edit, jointsOf(set, rater));
        edit.description = {.kind = core::EditKind::FirstPass, .firstFrame = frame, .lastFrame = frame};
        return [this, edit = std::move(edit), frame]() mutable {
            if (m_document.hasPreview() || m_document.undoStack()->canRedo())
                return; // the drag's end asks again; what was undone must stay within reach
            leaveOut(edit, m_touched[&m_refitting]);
            m_toRefit.reset();
            m_document.push(edit);
            emit refitted(frame, static_cast<int>(edit.marks.size()));
        };
    });
}

void FirstPass::deliver(core::Edit edit, FirstPassResult result, const std::filesystem::path& journal) {
    leaveOut(edit, m_touched[&m_job]);
    result.proposed = static_cast<int>(edit.marks.size());
    if (result.isFinished)
        m_doneJournal = journal;
    m_document.push(std::move(edit));
    removeJournal();
    emit finished(result);
}

/// What was labelled is in the annotations' file: nothing is left to go on with.
void FirstPass::removeJournal() {
    if (!m_doneJournal || m_document.hasUnsaved())
        return;
    std::error_code ignored;
    std::filesystem::remove(*m_doneJournal, ignored);
    m_doneJournal.reset();
}

void FirstPass::noteTouched(const core::Edit& edit) {
    for (const Job* job : {&m_job, &m_following, &m_refitting})
        if (job->isRunning())
            for (const core::MarkChange& change : edit.marks)
                m_touched[job].insert(change.key);
}

void FirstPass::stop() {
    m_job.requestEnd();
    forgetFollowing();
    forgetRefit();
}

} // namespace widgets
