// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include <opencv2/core/mat.hpp>

#include "core/io/dataset/dataset.h"

namespace core {

/// A picture that can be shown while the wanted one is being decoded.
struct Glance {
    cv::Mat picture;      ///< CV_8UC3 BGR, smaller than the camera's by a factor of kGlanceShrink
    bool isExact = false; ///< of the wanted frame; else of one near it
};

/// Where a window gets the pictures of a sequence from. All members may be called from several threads at once.
class PictureSource {
public:
    virtual ~PictureSource() = default;
    /// As FrameSource has them.
    virtual ViewKind kind(int camera) const = 0;
    virtual bool hasPicture(int camera, int frame) const = 0;
    virtual cv::Mat read(int camera, int frame, const std::stop_token& stop, int shrink) const = 0;
    virtual std::optional<Glance> glance(int camera, int frame, bool hurried, const std::stop_token& stop) const = 0;
    virtual bool hasVideos() const = 0;
    virtual void setBudget(std::int64_t bytes) = 0;
    virtual void setFirstCamera(int camera) = 0;
    virtual bool fetchAhead(int camera, int direction, const std::stop_token& stop) const = 0;
    virtual cv::Mat keptSmall(int camera, int frame) const = 0;
    virtual bool survey(int camera, const std::stop_token& stop) const = 0;
};

/// The pictures of one sequence, whatever they come from: videos, image files, or the recorded motion ("rendered").
/// Nothing is opened before it is asked for. All members may be called from several threads at once; different cameras
/// are then read side by side.
class FrameSource : public PictureSource {
public:
    /// Keeps copies of what it needs. `motion` is that of the sequence (readMotion); empty if there is none.
    FrameSource(const Dataset& dataset, const Sequence& sequence, Motion motion);
    ~FrameSource() override;
    FrameSource(FrameSource&&) noexcept;
    FrameSource& operator=(FrameSource&&) noexcept;

    int frameCount() const;
    /// Where the pictures of this camera (index into the dataset's) come from; None for cameras without a view.
    ViewKind kind(int camera) const override;

    /// False for cameras without a view, and where this camera has no picture at this instant (a lost frame, a missing
    /// image).
    bool hasPicture(int camera, int frame) const override;

    /// The picture of that camera at that frame: CV_8UC3 BGR of the camera's size, exactly the recorded pixels, turned
    /// and (of more than 8 bits) brought to 8 bits as the view says. A plain backdrop where hasPicture is false. Throws
    /// Error: NotFound if the recording has no such frame, BadInput if the file is damaged or its size is not the
    /// camera's.
    /// Empty if it was stopped.
    /// `shrink` of 2, 4, 8: may be so much smaller (sides rounded up), where that saves time; else it is whole.
    cv::Mat read(int camera, int frame, const std::stop_token& stop = {}, int shrink = 1) const override;
    /// What can be shown at once, where reading this frame of a video takes long. No value where it does not, or where
    /// the video was not read before.
    /// `hurried`: frames follow each other so quickly that decoding even one picture takes too long.
    std::optional<Glance> glance(int camera, int frame, bool hurried, const std::stop_token& stop) const override;

    bool hasVideos() const override;
    /// Its video is decoded by all cores when a jump is made, the others by their share of them; -1: none.
    void setFirstCamera(int camera) override;
    /// How much memory decoded pictures of videos may take, near the frames that were read last; a few are kept at
    /// first.
    void setBudget(std::int64_t bytes) override;
    /// Decodes the nearest picture of a video that is not kept before (direction -1) or after (+1) the frame that was
    /// read last, so that reading it takes a few milliseconds. False if there is nothing to do for this camera (all
    /// that fits is kept, it has no video, nothing of it was read yet), or it was stopped.
    bool fetchAhead(int camera, int direction, const std::stop_token& stop) const override;
    /// The picture of a video at 1 / kGlanceShrink of its size, turned, if it is kept so; else empty.
    cv::Mat keptSmall(int camera, int frame) const override;
    /// Decodes a picture of a video that is not kept small yet, near the frame that was read last, and keeps it so.
    /// False if there is nothing to do for this camera, or it was stopped.
    bool survey(int camera, const std::stop_token& stop) const override;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// The mask file of one camera at a frame, whether or not it exists; empty if the camera has no mask pattern.
std::filesystem::path maskFile(const std::filesystem::path& datasetFolder, const Sequence& sequence,
                               const std::string& camera, int frame);

/// Silhouettes of a frame, one per camera, from the sequence's mask files; empty for a camera without a file.
/// Throws Error(BadInput) if one cannot be read.
std::vector<cv::Mat> readFrameMasks(const std::filesystem::path& datasetFolder, const Sequence& sequence,
                                    const std::vector<Camera>& cameras, int frame);

} // namespace core
