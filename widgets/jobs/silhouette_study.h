// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QUndoStack>

#include "core/io/dataset/dataset.h"
#include "core/segmentation/silhouette.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// One camera's silhouette at the current frame.
struct ShownSilhouette {
    core::Silhouette silhouette;
    bool isKept = false; ///< as it lies in the folder, made by a run or touched up; else found just now
};

/// Which silhouettes are to be made and kept.
struct SilhouetteRun {
    std::vector<int> frames;
    bool attach = true; ///< the sequence gets them
};

/// Silhouettes of the open sequence: looked at in all views as they would be found, touched up, and made for a range of
/// frames, all in the background. They are kept in masks/<sequence>-<method> in the dataset's folder; a file there is
/// never made again, so that what was touched up stays.
class SilhouetteStudy : public QObject {
    Q_OBJECT

public:
    SilhouetteStudy(const Selection& selection, JobPool& pool, QObject* parent = nullptr);
    ~SilhouetteStudy() override;

    void setSequence(std::shared_ptr<const core::Dataset> dataset, const std::string& sequence);
    bool isOpen() const { return m_source != nullptr; }
    void setOptions(const core::SilhouetteOptions& options);
    const core::SilhouetteOptions& options() const { return m_options; }
    /// Whether the current frame's silhouettes are looked for.
    void setOn(bool on);
    bool isOn() const { return m_on; }

    /// Those of the current frame that have been found, by camera.
    const std::map<int, ShownSilhouette>& shown() const { return m_shown; }
    /// Where masks of these options are kept.
    QString folder() const;
    /// The masks that the sequence has besides; empty if there are none.
    QString otherMasks() const;

    /// A person's touch: the mask of a camera at the current frame becomes this one; a step of undoStack(), on disk at
    /// once.
    void touchUp(int camera, const cv::Mat& mask);
    QUndoStack* undoStack() { return &m_undo; }

    /// Makes the silhouettes of these frames; made() or failed() follows.
    void run(const SilhouetteRun& run);
    void stop();
    bool isRunning() const { return m_run.isRunning(); }

signals:
    /// The silhouette of a camera is another, or gone.
    void changed(int camera);
    /// Another frame or method: all are gone.
    void cleared();
    void progressed(double fraction);
    void runningChanged();
    void made(int masks, int kept, bool attached);
    void failed(const QString& message);

private:
    struct Source;
    class Touch;
    void forgetJoints();
    void look();
    void lookAt(Job& job, std::vector<int> cameras, int priority);
    void place(int frame, int camera, const ShownSilhouette& silhouette);
    void writePending();

    const Selection& m_selection;
    Job m_first, m_rest, m_run, m_save;
    QUndoStack m_undo;
    std::shared_ptr<Source> m_source;
    core::SilhouetteOptions m_options;
    std::map<int, ShownSilhouette> m_shown;
    std::map<std::pair<int, int>, std::optional<cv::Mat>> m_pending; ///< by frame and camera; none: the file goes
    bool m_on = false;
};

} // namespace widgets
