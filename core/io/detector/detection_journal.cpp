// SPDX-License-Identifier: MIT
#include "core/io/detector/detection_journal.h"

#include <cerrno>
#include <cstring>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"

namespace core {

using nlohmann::json;

namespace {

constexpr int kVersion = 2;
constexpr int kDeepest = 8; ///< lists in lists of a journal's line

json handToJson(const DetectedHand& hand) {
    json px = json::array();
    for (const Eigen::Vector2d& at : hand.px) {
        px.push_back(at.x());
        px.push_back(at.y());
    }
    return {{"px", px}, {"presence", hand.presence}, {"rightness", hand.rightness}, {"sidePx", hand.sidePx}};
}

json frameToJson(int frame, const ViewDetections& detections) {
    json views = json::array();
    for (const std::vector<DetectedHand>& hands : detections) {
        json list = json::array();
        for (const DetectedHand& hand : hands)
            list.push_back(handToJson(hand));
        views.push_back(list);
    }
    return {{"frame", frame}, {"views", views}};
}

DetectedHand handFromJson(const json& value) {
    DetectedHand hand;
    const json& px = value.at("px");
    for (std::size_t i = 0; i < kLandmarkCount; ++i)
        hand.px[i] = {px.at(2 * i).get<double>(), px.at(2 * i + 1).get<double>()};
    hand.presence = value.at("presence");
    hand.rightness = value.at("rightness");
    hand.sidePx = value.at("sidePx");
    return hand;
}

json numbers(const double* values, Eigen::Index count) {
    return json(std::vector<double>(values, values + count));
}

json fitToJson(const DetectionJournal::StepKey& step, const FrameFit& fit) {
    json hands = json::array();
    for (const FittedHand& hand : fit.hands) {
        json covariances = json::array();
        for (const Eigen::Matrix3d& covariance : hand.jointCovarianceMm2)
            covariances.push_back(numbers(covariance.data(), covariance.size()));
        hands.push_back({{"pose", numbers(hand.pose.data(), hand.pose.size())},
                         {"covariances", covariances},
                         {"doubt", hand.doubt}});
    }
    return {{"step", step.first},     {"at", step.second},    {"source", static_cast<int>(fit.source)},
            {"overlap", fit.overlap}, {"deepPx", fit.deepPx}, {"hands", hands}};
}

FittedHand fittedHandFromJson(const json& value) {
    FittedHand hand;
    const auto pose = value.at("pose").get<std::vector<double>>();
    hand.pose = Eigen::Map<const Eigen::VectorXd>(pose.data(), static_cast<Eigen::Index>(pose.size()));
    for (const json& entry : value.at("covariances")) {
        Eigen::Matrix3d covariance;
        for (Eigen::Index i = 0; i < covariance.size(); ++i)
            covariance.data()[i] = entry.at(static_cast<std::size_t>(i)).get<double>();
        hand.jointCovarianceMm2.push_back(covariance);
    }
    hand.doubt = value.at("doubt");
    return hand;
}

FrameFit fitFromJson(const json& value) {
    FrameFit fit;
    const int source = value.at("source");
    fit.source = source >= 0 && source <= static_cast<int>(FitSource::Correction) ? static_cast<FitSource>(source)
                                                                                  : FitSource::Landmarks;
    fit.overlap = value.at("overlap");
    fit.deepPx = value.at("deepPx");
    for (const json& hand : value.at("hands"))
        fit.hands.push_back(fittedHandFromJson(hand));
    return fit;
}

ViewDetections viewsFromJson(const json& value) {
    ViewDetections detections;
    for (const json& view : value) {
        auto& hands = detections.emplace_back();
        for (const json& hand : view)
            hands.push_back(handFromJson(hand));
    }
    return detections;
}

/// What a journal holds that is of the same work; `kept` becomes its text.
struct Kept {
    std::map<int, ViewDetections> frames;
    std::map<DetectionJournal::StepKey, FrameFit> fits;
    std::string lines;
};

/// False if the line is not one of this journal. Fits are left out where they are of other work.
bool readLine(const std::string& line, std::size_t cameras, bool withFits, Kept& kept) {
    try {
        const json value = json::parse(line, [](int depth, json::parse_event_t, json&) { return depth < kDeepest; });
        if (value.contains("step")) {
            if (!withFits)
                return true;
            kept.fits[{value.at("step").get<std::string>(), value.at("at").get<int>()}] = fitFromJson(value);
        } else {
            ViewDetections detections = viewsFromJson(value.at("views"));
            if (detections.size() != cameras)
                return false;
            kept.frames[value.at("frame").get<int>()] = std::move(detections);
        }
        kept.lines += line + "\n";
        return true;
    } catch (const json::exception&) {
        return false;
    }
}

Kept readJournal(const std::string& content, const JournalWork& work, std::size_t cameras) {
    Kept kept;
    std::size_t end = content.find('\n');
    const json header = json::parse(content.substr(0, end), nullptr, false);
    if (end == std::string::npos || !header.is_object() || header.value("version", json()) != json(kVersion) ||
        header.value("detections", json()) != json(work.detections))
        return kept;
    const bool withFits = header.value("fits", json()) == json(work.fits);
    for (std::size_t at = end + 1; (end = content.find('\n', at)) != std::string::npos; at = end + 1)
        if (!readLine(content.substr(at, end - at), cameras, withFits, kept))
            break;
    return kept;
}

} // namespace

DetectionJournal::DetectionJournal(std::filesystem::path file, const JournalWork& work, std::size_t cameras)
    : m_file(std::move(file)) {
    std::error_code error;
    Kept kept;
    if (std::filesystem::exists(m_file, error))
        kept = readJournal(readTextFile(m_file), work, cameras);
    m_frames = std::move(kept.frames);
    m_fits = std::move(kept.fits);
    const json header{{"version", kVersion}, {"detections", work.detections}, {"fits", work.fits}};
    writeFileAtomically(m_file, header.dump() + "\n" + kept.lines);
    m_stream = std::fopen(m_file.c_str(), "ab");
    if (!m_stream)
        throw Error(ErrorCode::Io, m_file.string(), "", std::string("cannot be written: ") + std::strerror(errno));
}

DetectionJournal::~DetectionJournal() {
    if (m_stream)
        std::fclose(m_stream);
}

void DetectionJournal::write(const std::string& line) {
    if (!m_stream || std::fwrite(line.data(), 1, line.size(), m_stream) != line.size() || std::fflush(m_stream) != 0)
        throw Error(ErrorCode::Io, m_file.string(), "", std::string("cannot be written: ") + std::strerror(errno));
}

void DetectionJournal::append(int frame, const ViewDetections& detections) {
    write(frameToJson(frame, detections).dump() + "\n");
    m_frames[frame] = detections;
}

void DetectionJournal::append(const StepKey& step, const FrameFit& fit) {
    write(fitToJson(step, fit).dump() + "\n");
    m_fits[step] = fit;
}

void DetectionJournal::remove() {
    if (m_stream)
        std::fclose(m_stream);
    m_stream = nullptr;
    std::error_code ignored;
    std::filesystem::remove(m_file, ignored);
}

} // namespace core
