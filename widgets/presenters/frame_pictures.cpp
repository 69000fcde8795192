// SPDX-License-Identifier: MIT
#include "widgets/presenters/frame_pictures.h"

#include <algorithm>

#include "widgets/jobs/footage_finder.h"
#include "widgets/views/message_bar.h"

namespace widgets {

namespace {

/// What a view shows where there is no picture.
QImage plainPicture(const core::ImageSize& size) {
    QImage image(size.width, size.height, QImage::Format_RGB32);
    image.fill(QColor(0x20, 0x22, 0x25));
    return image;
}

} // namespace

FramePictures::FramePictures(FrameLoader& frames, DatasetSession& opened, CameraGrid& grid, QObject* parent)
    : QObject(parent)
    , m_frames(frames)
    , m_opened(opened)
    , m_grid(grid) {
    connect(&frames, &FrameLoader::pictureLoaded, this, &FramePictures::show);
    connect(&frames, &FrameLoader::standInLoaded, this, &FramePictures::showStandIn);
    connect(&frames, &FrameLoader::pictureFailed, this, &FramePictures::showFailure);
}

void FramePictures::show(int camera, const ImagePyramid& picture) {
    if (camera >= m_grid.count() || picture.isNull())
        return;
    CameraView* view = m_grid.view(camera);
    view->setMessage(m_frames.lacksPicture(camera) ? tr("No picture at this instant.") : QString());
    view->setAwaiting(false);
    view->setImage(picture);
    emit shown(camera, picture);
}

/// A picture of another instant: to look at until the right one comes.
void FramePictures::showStandIn(int camera, const ImagePyramid& picture) {
    if (camera >= m_grid.count())
        return;
    CameraView* view = m_grid.view(camera);
    view->setMessage({});
    view->setAwaiting(true);
    view->setImage(picture);
}

/// Says why there is no picture, instead of another frame's; footage that is not there any more can be looked for.
void FramePictures::showFailure(int camera, const QString& message) {
    const auto& dataset = m_opened.dataset();
    if (!dataset || camera >= m_grid.count())
        return;
    CameraView* view = m_grid.view(camera);
    view->setAwaiting(false);
    view->setImage(plainPicture(view->camera().size));
    std::vector<MessageAction> actions;
    if (isFootageGone(*dataset, *m_opened.sequence(), view->camera().name))
        actions.push_back({tr("Find..."), [this] { emit footageWanted(); }});
    view->setMessage(message, actions);
}

void FramePictures::chooseDrafts() {
    constexpr int kMostShrink = 4;
    double largest = 0;
    for (const CameraView* view : m_grid.views())
        if (view->isVisible())
            largest = std::max(largest, view->scale() * view->devicePixelRatioF());
    int shrink = 1;
    while (shrink < kMostShrink && largest * 2 * shrink <= 1)
        shrink *= 2;
    m_frames.setDraftShrink(shrink);
}

} // namespace widgets
