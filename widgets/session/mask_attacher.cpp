// SPDX-License-Identifier: MIT
#include "widgets/session/mask_attacher.h"

#include <QStringList>

#include "core/io/dataset/attach_masks.h"
#include "widgets/text/footage_text.h"

namespace widgets {

MaskAttacher::MaskAttacher(DatasetSession& session, const Selection& selection, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_selection(selection)
    , m_job(pool) {
    connect(&m_job, &Job::failed, this, &MaskAttacher::failed);
}

void MaskAttacher::attach(const QString& folder) {
    if (!m_session.dataset() || !m_session.sequence()) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    m_job.start([this, folder, open = m_session.dataset(),
                 sequence = m_session.sequence()->name](const JobContext&) -> Job::Delivery {
        core::Dataset dataset = *open;
        QStringList notes;
        for (const core::MaskNote& note : core::attachMasks(dataset, sequence, folder.toStdString()))
            notes << maskNoteInWords(note);
        core::rewriteDatasetFile(dataset);
        return [this, open, notes, sequence] {
            emit attached(notes.join(QLatin1Char('\n')));
            if (m_session.dataset() == open) // else another one was opened meanwhile
                m_session.openDataset(QString::fromStdString(open->folder.string()), QString::fromStdString(sequence),
                                      m_selection.frame());
        };
    });
}

} // namespace widgets
