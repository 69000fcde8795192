// SPDX-License-Identifier: MIT
#include "widgets/session/window_session.h"

#include <algorithm>
#include <sstream>

#include "core/io/dataset/sequence_pictures.h"
#include "widgets/jobs/detector_first_pass.h"

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

WindowSession::WindowSession(QObject* parent)
    : QObject(parent)
    , reconstructions(document, selection)
    , annotator(document, selection, reconstructions, joints, shownCameras)
    , coverage(document, pool)
    , opened(document, pool)
    , frames(pool)
    , fits(document, pool)
    , files(document, opened, pool)
    , benchmarks(pool)
    , checks(document, pool)
    , model(document, selection, reconstructions, pool)
    , raters(document, selection, pool)
    , rig(document, pool)
    , silhouettes(selection, pool)
    , subject(pool)
    , firstPass(document, pool, detectorFirstPass())
    , review(document, pool)
    , calibrations(opened, selection, pool) {
    connect(&opened, &DatasetSession::datasetOpened, this, &WindowSession::takeDataset);
    connect(&opened, &DatasetSession::sequenceOpened, this, &WindowSession::takeSequence);
    connect(&rig, &RigStudy::clickSigmasChanged, this, [this] {
        reconstructions.setClickSigmas(rig.clickSigmas());
        coverage.setClickSigmas(rig.clickSigmas());
        checks.setClickSigmas(rig.clickSigmas());
        raters.setClickSigmas(rig.clickSigmas());
        fits.setClickSigmas(rig.clickSigmas());
    });
    connect(&selection, &Selection::frameChanged, &frames, &FrameLoader::request);
    connect(
        &selection, &Selection::cameraChanged, this,
        [this] { frames.setFirstCamera(opened.dataset() ? opened.dataset()->cameraIndex(selection.camera()) : -1); });
    connect(
        &joints, &JointList::changed, this,
        [this] {
            if (!m_restoring)
                document.setSetting(kJointsSetting, joints.toText());
        });
    connect(&shownCameras, &ShownCameras::changed, this, [this] {
        if (!m_restoring)
            document.setSetting(kCamerasSetting, joined(shownCameras.names()));
    });
}

WindowSession::~WindowSession() = default;

void WindowSession::takeDataset() {
    reconstructions.setDataset(opened.dataset());
    annotator.setDataset(opened.dataset());
    coverage.setDataset(opened.dataset());
    benchmarks.setDataset(opened.dataset());
    checks.setDataset(opened.dataset());
    model.setDataset(opened.dataset());
    raters.setDataset(opened.dataset());
    subject.setDataset(opened.dataset());
    review.setDataset(opened.dataset());
}

void WindowSession::takeSequence(int frame) {
    const core::Sequence& sequence = *opened.sequence();
    rig.setSequence(opened.dataset(), sequence.name);
    firstPass.setSequence(opened.dataset(), &sequence);
    silhouettes.setSequence(opened.dataset(), sequence.name);
    frames.setSequence(opened.dataset(), &sequence, opened.motion());
    fits.setSequence(opened.dataset(), &sequence, opened.motion());
    const core::PictureGaps gaps = core::pictureGaps(*opened.dataset(), sequence);
    reconstructions.setPictureGaps(gaps);
    coverage.setPictureGaps(gaps);
    restoreChoices();
    selection.setFrameCount(sequence.frameCount);
    selection.setFrame(frame);
    frames.request(selection.frame());
    if (!joints.contains(selection.joint()) && !joints.joints().empty())
        selection.setJoint(joints.joints().front());
    const auto& shown = shownCameras.names();
    if (std::find(shown.begin(), shown.end(), selection.camera()) == shown.end())
        selection.setCamera(shown.empty() ? std::string() : shown.front());
    emit ready();
}

void WindowSession::restoreChoices() {
    const core::Dataset& dataset = *opened.dataset();
    m_restoring = true;
    if (const auto text = document.setting(kJointsSetting); !text || !joints.setFromText(*text, dataset))
        joints.setChoice(joints.choice() == JointChoice::Custom ? JointChoice::Fourteen : joints.choice(), dataset);
    std::vector<std::string> cameras;
    if (const auto text = document.setting(kCamerasSetting))
        cameras = knownLines(*text, dataset);
    shownCameras.setNames(cameras.empty() ? cameraNames(dataset) : cameras);
    m_restoring = false;
}

} // namespace widgets
