// SPDX-License-Identifier: MIT
#include "widgets/jobs/silhouette_study.h"

#include <filesystem>
#include <mutex>
#include <utility>

#include <QCoreApplication>
#include <QUndoCommand>
#include <opencv2/core.hpp>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/footage/image_file.h"
#include "core/io/segmentation/mask_record.h"
#include "core/io/segmentation/room_pictures.h"
#include "core/io/segmentation/segment_frames.h"

namespace widgets {

namespace fs = std::filesystem;

namespace {

constexpr int kMedianSamples = 15;

std::string programName() {
    return "Handlens " + QCoreApplication::applicationVersion().toStdString();
}

} // namespace

/// What the workers read: made once per sequence, then only added to.
struct SilhouetteStudy::Source {
    std::shared_ptr<const core::Dataset> dataset;
    const core::Sequence* sequence = nullptr;
    std::optional<core::FrameSource> frames;
    std::mutex mutex; ///< guards what follows
    std::shared_ptr<const core::SequenceEvidence> evidence;
    std::vector<cv::Mat> rooms;

    fs::path folder(const core::SilhouetteOptions& options) const {
        return dataset->folder / "masks" / (sequence->name + "-" + std::string(methodName(options.method)));
    }
    const core::FrameSource& pictures() {
        const std::scoped_lock lock(mutex);
        if (!frames)
            frames.emplace(*dataset, *sequence, core::readMotion(*dataset, *sequence));
        return *frames;
    }
    /// Recorded poses for the model; annotated joints, or those of recorded poses, for the others.
    std::shared_ptr<const core::SequenceEvidence> known(core::SegmentationMethod method) {
        const std::scoped_lock lock(mutex);
        if (!evidence) {
            core::SequenceEvidence found;
            const bool hasMotion = !sequence->motion.empty();
            if (method != core::SegmentationMethod::Model || !hasMotion)
                if (core::SequencePoints points = core::readAnnotationPoints(*dataset, *sequence); !points.empty())
                    found = {dataset->hands, std::move(points), core::EvidenceOrigin::Annotations};
            if (hasMotion && found.origin() == core::EvidenceOrigin::None)
                found = {dataset->hands, core::readMotion(*dataset, *sequence)};
            evidence = std::make_shared<const core::SequenceEvidence>(std::move(found));
        }
        return evidence;
    }
    std::vector<cv::Mat> roomPictures(const std::stop_token& stop) {
        const core::FrameSource& source = pictures();
        const std::scoped_lock lock(mutex);
        if (rooms.empty()) {
            std::vector<cv::Mat> found =
                core::medianRoomPictures(source, dataset->cameras.size(), kMedianSamples, stop);
            if (stop.stop_requested())
                return {};
            rooms = std::move(found);
        }
        return rooms;
    }
    core::MaskRecord record(const core::SilhouetteOptions& options) {
        const core::EvidenceOrigin joints = known(options.method)->origin();
        std::string origin = "none";
        if (options.method == core::SegmentationMethod::Background)
            origin = "median";
        else if (options.method == core::SegmentationMethod::Model ||
                 options.method == core::SegmentationMethod::Landmarks)
            origin = originName(joints);
        return core::maskRecord(programName(), *sequence, options, origin, joints);
    }
    /// The silhouette that is kept, or the one that is found now; none if nothing is known of the hands or there is no
    /// picture.
    std::optional<ShownSilhouette> silhouette(const core::SilhouetteOptions& options, int frame, int camera,
                                              const std::stop_token& stop) {
        const core::Camera& one = dataset->cameras[static_cast<std::size_t>(camera)];
        const fs::path file = core::madeMaskFile(folder(options), one.name, frame);
        std::error_code ignored;
        if (fs::exists(file, ignored))
            return ShownSilhouette{{core::readMask(file), {}}, true};
        if (!pictures().hasPicture(camera, frame))
            return std::nullopt;
        cv::Mat room;
        if (options.method == core::SegmentationMethod::Background)
            if (const auto all = roomPictures(stop); static_cast<std::size_t>(camera) < all.size())
                room = all[static_cast<std::size_t>(camera)];
        const core::HandEvidence hands = known(options.method)->at(frame, options.method);
        const cv::Mat picture = pictures().read(camera, frame, stop);
        if (picture.empty())
            return std::nullopt;
        const auto found = core::findSilhouette(picture, one, dataset->hands, hands, room, options);
        return found ? std::optional(ShownSilhouette{*found, false}) : std::nullopt;
    }
};

/// One touch of a person: swaps the mask with the one before.
class SilhouetteStudy::Touch : public QUndoCommand {
public:
    Touch(SilhouetteStudy& study, int frame, int camera, ShownSilhouette before, ShownSilhouette after)
        : QUndoCommand(
              SilhouetteStudy::tr("touch up %1")
                  .arg(QString::fromStdString(study.m_source->dataset->cameras[static_cast<std::size_t>(camera)].name)))
        , m_study(study)
        , m_frame(frame)
        , m_camera(camera)
        , m_before(std::move(before))
        , m_after(std::move(after)) {}
    void undo() override { m_study.place(m_frame, m_camera, m_before); }
    void redo() override { m_study.place(m_frame, m_camera, m_after); }

private:
    SilhouetteStudy& m_study;
    int m_frame, m_camera;
    ShownSilhouette m_before, m_after;
};

SilhouetteStudy::SilhouetteStudy(const Selection& selection, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_selection(selection)
    , m_first(pool)
    , m_rest(pool)
    , m_run(pool)
    , m_save(pool) {
    for (const Job* job : {&m_first, &m_rest, &m_run, &m_save})
        connect(job, &Job::failed, this, &SilhouetteStudy::failed);
    for (const auto end : {&Job::started, &Job::finished, &Job::stopped})
        connect(&m_run, end, this, &SilhouetteStudy::runningChanged);
    connect(&m_run, &Job::failed, this, &SilhouetteStudy::runningChanged);
    connect(&m_run, &Job::progressed, this, [this](double fraction, const QString&) { emit progressed(fraction); });
    connect(&m_save, &Job::finished, this, &SilhouetteStudy::writePending);
    connect(&selection, &Selection::frameChanged, this, &SilhouetteStudy::look);
}

SilhouetteStudy::~SilhouetteStudy() = default;

void SilhouetteStudy::setSequence(std::shared_ptr<const core::Dataset> dataset, const std::string& sequence) {
    m_run.stop();
    m_undo.clear();
    m_source = std::make_shared<Source>();
    m_source->dataset = std::move(dataset);
    m_source->sequence = &m_source->dataset->sequence(sequence);
    look();
}

void SilhouetteStudy::setOptions(const core::SilhouetteOptions& options) {
    m_options = options;
    m_undo.clear(); // its steps are of masks in another folder
    forgetJoints();
    look();
}

/// Annotations may have been made meanwhile.
void SilhouetteStudy::forgetJoints() {
    if (!m_source)
        return;
    const std::scoped_lock lock(m_source->mutex);
    m_source->evidence.reset();
}

void SilhouetteStudy::setOn(bool on) {
    m_on = on;
    forgetJoints();
    look();
}

QString SilhouetteStudy::folder() const {
    return m_source ? QString::fromStdString(m_source->folder(m_options).string()) : QString();
}

QString SilhouetteStudy::otherMasks() const {
    return m_source ? QString::fromStdString(
                          core::otherMasks(*m_source->dataset, *m_source->sequence, m_source->folder(m_options)))
                    : QString();
}

/// The current view first, the others as they come.
void SilhouetteStudy::look() {
    m_first.stop();
    m_rest.stop();
    m_shown.clear();
    emit cleared();
    if (!m_on || !m_source)
        return;
    const int current = m_source->dataset->cameraIndex(m_selection.camera());
    std::vector<int> others;
    for (int c = 0; c < static_cast<int>(m_source->dataset->cameras.size()); ++c)
        if (c != current)
            others.push_back(c);
    if (current >= 0)
        lookAt(m_first, {current}, 1);
    lookAt(m_rest, others, 0);
}

void SilhouetteStudy::lookAt(Job& job, std::vector<int> cameras, int priority) {
    const int frame = m_selection.frame();
    job.start(
        [this, source = m_source, options = m_options, frame,
         cameras = std::move(cameras)](const JobContext& context) -> Job::Delivery {
            std::map<int, ShownSilhouette> found;
            for (const int camera : cameras) {
                if (context.stop.stop_requested())
                    return {};
                if (auto one = source->silhouette(options, frame, camera, context.stop))
                    found.emplace(camera, std::move(*one));
            }
            return [this, found, cameras] {
                for (const int camera : cameras) {
                    if (const auto one = found.find(camera); one != found.end())
                        m_shown[camera] = one->second;
                    emit changed(camera);
                }
            };
        },
        priority);
}

void SilhouetteStudy::touchUp(int camera, const cv::Mat& mask) {
    const auto shown = m_shown.find(camera);
    if (!m_source || shown == m_shown.end() || cv::norm(shown->second.silhouette.mask, mask, cv::NORM_INF) == 0)
        return;
    ShownSilhouette after = shown->second;
    after.silhouette.mask = mask.clone();
    after.isKept = true;
    m_undo.push(new Touch(*this, m_selection.frame(), camera, shown->second, after));
}

void SilhouetteStudy::place(int frame, int camera, const ShownSilhouette& silhouette) {
    m_pending[{frame, camera}] =
        silhouette.isKept ? std::optional(silhouette.silhouette.mask) : std::optional<cv::Mat>();
    if (m_selection.frame() == frame) {
        m_shown[camera] = silhouette;
        emit changed(camera);
    }
    writePending();
}

/// One worker writes at a time, so that the last touch is the one that stays.
void SilhouetteStudy::writePending() {
    if (m_save.isRunning() || m_pending.empty())
        return;
    m_save.start([source = m_source, options = m_options,
                  touches = std::exchange(m_pending, {})](const JobContext&) -> Job::Delivery {
        const fs::path folder = source->folder(options);
        core::claimMaskFolder(folder, source->record(options));
        for (const auto& [where, mask] : touches) {
            const core::Camera& camera = source->dataset->cameras[static_cast<std::size_t>(where.second)];
            const fs::path file = core::madeMaskFile(folder, camera.name, where.first);
            core::ensureFolder(file.parent_path());
            if (mask)
                core::writePng(file, *mask);
            else
                fs::remove(file);
        }
        return {};
    });
}

void SilhouetteStudy::run(const SilhouetteRun& run) {
    if (!m_source || isRunning())
        return;
    m_run.start([this, source = m_source, options = m_options, run](const JobContext& context) -> Job::Delivery {
        const auto evidence = source->known(options.method);
        core::SegmentationWork work{source->dataset.get(),  source->sequence, run.frames, options, evidence.get(), {},
                                    source->folder(options)};
        if (options.method == core::SegmentationMethod::Background)
            work.roomPictures = source->roomPictures(context.stop);
        core::claimMaskFolder(work.folder, source->record(options));
        const auto summary = core::segmentFrames(work, source->pictures(), context.stop, [&](int done, int total) {
            context.report(static_cast<double>(done) / total, {});
        });
        if (summary.stopped)
            return {};
        const bool isAttached = run.attach && summary.made + summary.kept > 0;
        if (isAttached)
            core::attachMadeMasks(source->dataset->folder, source->sequence->name, work.folder);
        return [this, summary, isAttached] {
            emit made(summary.made, summary.kept, isAttached);
            look();
        };
    });
}

void SilhouetteStudy::stop() {
    m_run.stop();
}

} // namespace widgets
