// SPDX-License-Identifier: MIT
#include "widgets/jobs/first_pass.h"

#include <algorithm>

#include "core/io/dataset/dataset_annotations.h"
#include "core/io/detector/auto_label_file.h"

namespace widgets {

namespace {

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

/// Without what the annotations do not hold any more as it was when the run began: a person has worked there.
void keepCurrent(core::Edit& edit, const core::AnnotationSet& set) {
    std::erase_if(
        edit.marks, [&set](const core::MarkChange& change) { return core::markAt(set, change.key) != change.before; });
}

} // namespace

FirstPass::FirstPass(AnnotationDocument& document, JobPool& pool, FirstPassProgram program, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_program(std::move(program))
    , m_job(pool, Job::Kind::Background)
    , m_installing(pool)
    , m_following(pool, Job::Kind::Background) {
    for (const auto end : {&Job::finished, &Job::stopped})
        connect(&m_following, end, this, &FirstPass::followNext);
    for (const Job* job : {&m_job, &m_installing, &m_following}) {
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
    m_job.start([this, work = workOn(request.frames), wanted = request, label = m_program.label,
                 set = m_document.annotations(),
                 rater = m_document.rater()](const JobContext& context) -> Job::Delivery {
        FirstPassResult result;
        result.wanted = static_cast<int>(work.frames.size());
        auto [labels, isFinished] = label(work, context.stop, [&context](core::PassStage stage, int done, int total) {
            context.report(static_cast<double>(done) / std::max(1, total),
                           QStringLiteral("%1 %2 %3").arg(static_cast<int>(stage)).arg(done).arg(total));
        });
        keepHands(labels, wanted.hands);
        result.frames = static_cast<int>(labels.size());
        result.isFinished = isFinished;
        core::Edit edit = core::autoLabelEdit(set, *work.dataset, labels, rater);
        if (!wanted.joints.empty())
            keepJoints(edit, wanted.joints);
        edit.description = {
            .kind = core::EditKind::FirstPass, .firstFrame = work.frames.front(), .lastFrame = work.frames.back()};
        return [this, edit = std::move(edit), result, journal = work.journal] { deliver(edit, result, journal); };
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
            keepCurrent(edit, m_document.annotations());
            m_document.push(edit);
            emit followed(frame, static_cast<int>(edit.marks.size()));
        };
    });
}

void FirstPass::deliver(core::Edit edit, FirstPassResult result, const std::filesystem::path& journal) {
    keepCurrent(edit, m_document.annotations());
    result.proposed = static_cast<int>(edit.marks.size());
    for (const core::MarkChange& change : edit.marks)
        result.joints.insert(change.key.joint);
    m_document.push(edit);
    if (result.isFinished && !m_document.hasUnsaved()) {
        std::error_code ignored;
        std::filesystem::remove(journal, ignored);
    }
    emit finished(result);
}

void FirstPass::stop() {
    m_job.requestEnd();
    forgetFollowing();
}

} // namespace widgets
