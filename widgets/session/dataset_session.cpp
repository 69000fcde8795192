// SPDX-License-Identifier: MIT
#include "widgets/session/dataset_session.h"

#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/demo/demo_dataset.h"

namespace widgets {

/// What a worker has read.
struct DatasetSession::Loaded {
    std::shared_ptr<const core::Dataset> dataset;
    const core::Sequence* sequence = nullptr;
    std::shared_ptr<const core::Motion> motion;
    AnnotationDocument::Content annotations;
};

DatasetSession::DatasetSession(AnnotationDocument& document, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_job(pool) {
    connect(&m_job, &Job::failed, this, &DatasetSession::openFailed);
}

/// What is not in the file yet would go with the document.
bool DatasetSession::mayLeave() {
    if (m_document.saveNow())
        return true;
    emit openFailed(tr("Your last edits are not saved yet, so they would be lost. Make room or give permission where "
                       "they are kept, or export them first."));
    return false;
}

void DatasetSession::openDataset(const QString& folder, const QString& sequence, int frame) {
    if (!mayLeave())
        return;
    const std::filesystem::path path = folder.toStdString();
    closeBefore(path);
    emit opening(folder);
    load([path] { return std::make_shared<const core::Dataset>(core::readDataset(path)); }, sequence, frame);
}

void DatasetSession::openDemo(const QString& folder) {
    if (!mayLeave())
        return;
    const std::filesystem::path path = folder.toStdString();
    closeBefore(path);
    emit opening(folder);
    load(
        [path] {
            if (!std::filesystem::exists(path / "dataset.json")) {
                std::filesystem::create_directories(path.parent_path());
                const core::NewDataset demo = core::makeDemoDataset();
                core::writeDataset(demo.dataset, demo.motions, path);
            }
            return std::make_shared<const core::Dataset>(core::readDataset(path));
        },
        {}, 0);
}

void DatasetSession::openSequence(const QString& sequence, int frame) {
    if (!m_dataset)
        return;
    if (m_sequence && m_document.isOpen() && m_sequence->name == sequence.toStdString()) {
        m_job.stop();
        return;
    }
    if (!mayLeave())
        return;
    emit opening(sequence);
    load([dataset = m_dataset] { return dataset; }, sequence, frame);
}

/// One process holds one writer per file: the old one lets go before the file is opened again.
void DatasetSession::closeBefore(const std::filesystem::path& folder) {
    if (m_dataset && m_dataset->folder == folder)
        m_document.close();
}

void DatasetSession::load(DatasetReader reader, const QString& sequence, int frame) {
    m_job.start(
        [this, reader = std::move(reader), name = sequence.toStdString(), frame](const JobContext&) -> Job::Delivery {
            auto loaded = std::make_shared<Loaded>();
            loaded->dataset = reader();
            const core::Dataset& dataset = *loaded->dataset;
            if (dataset.sequences.empty())
                throw core::Error(core::ErrorCode::BadInput, (dataset.folder / "dataset.json").string(), "sequences",
                                  "the dataset has no sequence");
            loaded->sequence = name.empty() ? &dataset.sequences.front() : &dataset.sequence(name);
            loaded->motion = std::make_shared<const core::Motion>(core::readMotion(dataset, *loaded->sequence));
            loaded->annotations = AnnotationDocument::read(core::annotationFile(dataset, *loaded->sequence));
            return [this, loaded, frame] { take(loaded, frame); };
        });
}

void DatasetSession::take(const std::shared_ptr<Loaded>& loaded, int frame) {
    if (!mayLeave()) // people go on clicking while a sequence loads
        return;
    const bool isNew = m_dataset != loaded->dataset;
    m_dataset = loaded->dataset;
    m_sequence = loaded->sequence;
    m_motion = loaded->motion;
    if (isNew)
        emit datasetOpened();
    m_document.open(std::move(loaded->annotations));
    emit sequenceOpened(frame);
}

void DatasetSession::takeCalibration(std::shared_ptr<const core::Dataset> changed, int frame) {
    m_job.stop();
    const core::Sequence& sequence = changed->sequence(m_sequence->name);
    m_dataset = std::move(changed);
    m_sequence = &sequence;
    emit datasetOpened();
    emit sequenceOpened(frame);
}

} // namespace widgets
