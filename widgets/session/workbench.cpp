// SPDX-License-Identifier: MIT
#include "widgets/session/workbench.h"

#include <algorithm>
#include <sstream>

#include "core/io/dataset/sequence_pictures.h"

namespace widgets {

namespace {

constexpr const char* kJointsSetting = "joints";
constexpr const char* kCamerasSetting = "cameras";

std::vector<std::string> cameraNames(const core::Dataset& dataset) {
    std::vector<std::string> names;
    for (const core::Camera& camera : dataset.cameras)
        names.push_back(camera.name);
    return names;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

std::vector<std::string> knownLines(const std::string& text, const core::Dataset& dataset) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (dataset.cameraIndex(line) >= 0)
            lines.push_back(line);
    return lines;
}

} // namespace

Workbench::Workbench(QObject* parent)
    : QObject(parent)
    , reconstructions(document, selection)
    , annotator(document, selection, reconstructions, joints)
    , coverage(document, pool)
    , session(document, pool)
    , frames(pool)
    , fits(document, pool)
    , files(document, session, pool)
    , benchmarks(pool)
    , checks(document, pool)
    , model(document, selection, reconstructions, pool)
    , raters(document, selection, pool) {
    connect(&session, &DatasetSession::datasetOpened, this, &Workbench::takeDataset);
    connect(&session, &DatasetSession::sequenceOpened, this, &Workbench::takeSequence);
    connect(&selection, &Selection::frameChanged, &frames, &FrameLoader::request);
    connect(&joints, &JointList::changed, this, [this] {
        if (!m_restoring)
            document.setSetting(kJointsSetting, joints.toText());
    });
}

Workbench::~Workbench() = default;

void Workbench::setShownCameras(const std::vector<std::string>& cameras) {
    annotator.setCameraOrder(cameras);
    document.setSetting(kCamerasSetting, joined(cameras));
    emit shownCamerasChanged();
}

void Workbench::takeDataset() {
    reconstructions.setDataset(session.dataset());
    annotator.setDataset(session.dataset());
    coverage.setDataset(session.dataset());
    benchmarks.setDataset(session.dataset());
    checks.setDataset(session.dataset());
    model.setDataset(session.dataset());
    raters.setDataset(session.dataset());
}

void Workbench::takeSequence(int frame) {
    const core::Sequence& sequence = *session.sequence();
    frames.setSequence(session.dataset(), &sequence, session.motion());
    fits.setSequence(session.dataset(), &sequence, session.motion());
    const core::PictureGaps gaps = core::pictureGaps(*session.dataset(), sequence);
    reconstructions.setPictureGaps(gaps);
    coverage.setPictureGaps(gaps);
    restoreChoices();
    selection.setFrameCount(sequence.frameCount);
    selection.setFrame(frame);
    frames.request(selection.frame());
    if (!joints.contains(selection.joint()) && !joints.joints().empty())
        selection.setJoint(joints.joints().front());
    const auto& shown = shownCameras();
    if (std::find(shown.begin(), shown.end(), selection.camera()) == shown.end())
        selection.setCamera(shown.empty() ? std::string() : shown.front());
    emit ready();
}

void Workbench::restoreChoices() {
    const core::Dataset& dataset = *session.dataset();
    m_restoring = true;
    if (const auto text = document.setting(kJointsSetting); !text || !joints.setFromText(*text, dataset))
        joints.setChoice(joints.choice() == JointChoice::Custom ? JointChoice::Fourteen : joints.choice(), dataset);
    m_restoring = false;
    std::vector<std::string> cameras;
    if (const auto text = document.setting(kCamerasSetting))
        cameras = knownLines(*text, dataset);
    annotator.setCameraOrder(cameras.empty() ? cameraNames(dataset) : cameras);
    emit shownCamerasChanged();
}

} // namespace widgets
