// SPDX-License-Identifier: MIT
#include "widgets/jobs/footage_finder.h"

#include <algorithm>

#include <QDir>
#include <QStringList>

#include "core/io/dataset/relink.h"
#include "widgets/text/footage_text.h"

namespace widgets {

namespace {

QString nameOf(const core::RelinkFinding& finding) {
    return QStringLiteral("%1, %2: %3")
        .arg(QString::fromStdString(finding.sequence), QString::fromStdString(finding.camera),
             QString::fromStdString(finding.from));
}

QString notesOf(const core::RelinkResult& result) {
    QStringList notes;
    for (const core::RelinkFinding& finding : result.notFound)
        notes << FootageFinder::tr("not found: %1").arg(nameOf(finding)) +
                     (finding.reason == core::RelinkReason::None
                          ? QString()
                          : QStringLiteral(" (%1)").arg(relinkNoteInWords(finding)));
    for (const core::RelinkFinding& finding : result.found)
        if (const QString note = relinkNoteInWords(finding); !note.isEmpty())
            notes << QStringLiteral("%1: %2").arg(nameOf(finding), note);
    return notes.join(QLatin1Char('\n'));
}

} // namespace

FootageFinder::FootageFinder(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_job(pool) {
    connect(&m_job, &Job::started, this, &FootageFinder::started);
    connect(&m_job, &Job::failed, this, &FootageFinder::failed);
    for (const auto end : {&Job::finished, &Job::stopped})
        connect(&m_job, end, this, &FootageFinder::idle);
    connect(&m_job, &Job::failed, this, &FootageFinder::idle);
}

void FootageFinder::find(const std::shared_ptr<const core::Dataset>& dataset, const QString& root) {
    m_job.start([this, dataset, root](const JobContext& context) -> Job::Delivery {
        core::Dataset changed = *dataset;
        const core::RelinkResult result = core::relinkFootage(changed, root.toStdString(), context.stop);
        if (context.stop.stop_requested())
            return {};
        if (!result.found.empty())
            core::rewriteDatasetFile(changed);
        return [this, folder = QString::fromStdString(dataset->folder.string()),
                pieces = static_cast<int>(result.found.size()),
                notes = notesOf(result)] { emit found(folder, pieces, notes); };
    });
}

bool isFootageGone(const core::Dataset& dataset, const core::Sequence& sequence, const std::string& camera) {
    const auto view = std::find_if(sequence.views.begin(), sequence.views.end(),
                                   [&](const core::ViewSource& source) { return source.camera == camera; });
    if (view == sequence.views.end() || (view->kind != core::ViewKind::Video && view->kind != core::ViewKind::Images))
        return false;
    const std::filesystem::path path = dataset.folder / view->path;
    std::error_code ignored;
    return !std::filesystem::exists(view->kind == core::ViewKind::Video ? path : path.parent_path(), ignored);
}

} // namespace widgets
