// SPDX-License-Identifier: MIT
#include "core/simulation/simulated_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/contour/shaded_image.h"
#include "core/error.h"
#include "core/numeric/normal.h"
#include "core/simulation/forearm_surface.h"

namespace core {

namespace {

constexpr double kSleeveMm = 450; ///< long enough to leave most pictures

/// Grey clouds of one size, with deviation 1: white noise in coarse cells, drawn smooth.
cv::Mat clouds(const cv::Size& size, int cellPx, RandomGenerator& random) {
    cv::Mat coarse(size.height / cellPx + 2, size.width / cellPx + 2, CV_32F), fine;
    for (int y = 0; y < coarse.rows; ++y)
        for (int x = 0; x < coarse.cols; ++x)
            coarse.at<float>(y, x) = static_cast<float>(standardNormal(random));
    cv::resize(coarse, fine, size, 0, 0, cv::INTER_CUBIC);
    return fine;
}

cv::Scalar roomColour(RandomGenerator& random) {
    const double grey = 50 + 120 * random.uniform();
    const double warm = 30 * (random.uniform() - 0.5);
    return {grey - warm, grey + 8 * (random.uniform() - 0.5), grey + 0.6 * warm};
}

/// Shelves, boxes and papers: rectangles of any direction.
void addThings(cv::Mat& room, RandomGenerator& random) {
    constexpr int kThings = 26;
    for (int i = 0; i < kThings; ++i) {
        const cv::Point2f centre(static_cast<float>(room.cols * random.uniform()),
                                 static_cast<float>(room.rows * random.uniform()));
        const cv::Size2f size(static_cast<float>(room.cols * (0.05 + 0.35 * random.uniform())),
                              static_cast<float>(room.rows * (0.02 + 0.15 * random.uniform())));
        const auto angle = static_cast<float>(180 * random.uniform());
        std::array<cv::Point2f, 4> corners;
        cv::RotatedRect(centre, size, angle).points(corners.data());
        std::array<cv::Point, 4> polygon;
        std::copy(corners.begin(), corners.end(), polygon.begin());
        cv::fillConvexPoly(room, polygon.data(), 4, roomColour(random), cv::LINE_AA);
    }
}

/// A pose between two of a motion; `time` in frames, within the motion.
HandPoses posesAt(const Motion& motion, double time) {
    const double last = static_cast<double>(motion.size()) - 1;
    const double within = std::clamp(time, 0.0, last);
    const auto before = static_cast<std::size_t>(std::floor(within));
    const std::size_t after = std::min(before + 1, motion.size() - 1);
    const double share = within - static_cast<double>(before);
    HandPoses poses;
    for (std::size_t h = 0; h < motion[before].size(); ++h) {
        const Pose& a = motion[before][h];
        Eigen::VectorXd step = share * (motion[after][h] - a);
        step.segment<3>(3) =
            share * rotationLog(rotationExp(motion[after][h].segment<3>(3)) * rotationExp(a.segment<3>(3)).transpose());
        poses.push_back(retract(a, step));
    }
    return poses;
}

/// Hands and arms alone, premultiplied BGRA.
cv::Mat handsPicture(const SimulatedWorld& world, const Camera& camera, const HandPoses& poses) {
    const std::size_t count = world.hands.size();
    std::vector<std::vector<Eigen::Vector3d>> vertices(count), normals(count);
    std::vector<ForearmSurface> arms(count);
    std::vector<ShadedSurface> surfaces;
    const Eigen::Vector3f sleeve(0.33F, 0.39F, 0.50F);
    for (std::size_t h = 0; h < count; ++h) {
        const HandModel& hand = world.hands[h];
        vertices[h] = posedVertices(hand, poses[h]);
        normals[h] = vertexNormals(vertices[h], hand.mesh.triangles);
        const Eigen::Vector3f colour = skinColour(hand.side);
        surfaces.push_back({{&vertices[h], &hand.mesh.triangles}, &normals[h], colour});
        if (!world.forearm)
            continue;
        arms[h] = forearmSurface(hand, poses[h], kSleeveMm);
        surfaces.push_back({{&arms[h].verticesInWorld, &arms[h].triangles}, &arms[h].normalsInWorld, sleeve});
    }
    OverlayOptions options;
    options.opacity = 1;
    options.silhouetteEdge = false;
    return renderOverlay(camera, surfaces, options, Lighting{});
}

/// Normal numbers to be drawn by index: a table is as good for pictures, and a tenth of the time.
class NoiseTable {
public:
    explicit NoiseTable(RandomGenerator& random) {
        for (float& value : m_values)
            value = static_cast<float>(standardNormal(random));
    }
    float at(std::uint64_t bits) const { return m_values[bits & (kSize - 1)]; }

private:
    static constexpr std::size_t kSize = 1 << 14;
    std::array<float, kSize> m_values{};
};

} // namespace

cv::Mat backgroundPicture(const Camera& camera, std::uint64_t seed) {
    RandomGenerator random(drawSeed(seed, "background/" + camera.name));
    const cv::Size size(camera.size.width, camera.size.height);
    cv::Mat room(size, CV_8UC3, roomColour(random));
    addThings(room, random);
    cv::GaussianBlur(room, room, {}, 3);
    room.convertTo(room, CV_32FC3);
    for (const auto& [cellPx, strength] : {std::pair(180, 14.0), std::pair(40, 6.0), std::pair(9, 4.0)}) {
        const cv::Mat grey = clouds(size, cellPx, random) * strength;
        cv::Mat colour;
        cv::merge(std::array{grey, grey, grey}, colour);
        room += colour;
    }
    room.convertTo(room, CV_8UC3);
    return room;
}

cv::Mat withSensorNoise(const cv::Mat& picture, const PictureOptions& options, std::uint64_t seed) {
    RandomGenerator random(seed);
    const NoiseTable table(random);
    std::array<float, 256> deviation{};
    for (std::size_t level = 0; level < deviation.size(); ++level) {
        deviation[level] =
            static_cast<float>(std::sqrt(options.readNoise * options.readNoise +
                                         options.shotNoise * options.shotNoise * static_cast<double>(level)));
    }
    cv::Mat noisy = picture.clone();
    for (int y = 0; y < noisy.rows; ++y) {
        auto* row = noisy.ptr<uchar>(y);
        std::uint64_t bits = 0;
        for (int i = 0; i < noisy.cols * noisy.channels(); ++i, bits >>= 16) {
            if (i % 4 == 0)
                bits = random.next();
            row[i] = cv::saturate_cast<uchar>(static_cast<float>(row[i]) + deviation[row[i]] * table.at(bits));
        }
    }
    return noisy;
}

cv::Mat simulatedPicture(const SimulatedWorld& world, std::size_t index, const Motion& motion, int frame,
                         const cv::Mat& background, const PictureOptions& options, const std::string& name) {
    if (frame < 0 || frame >= static_cast<int>(motion.size()))
        throw Error(ErrorCode::Usage, "", "frame", "the motion has no frame " + std::to_string(frame));
    const Camera& camera = world.cameras[index];
    const int count = std::max(options.exposures, 1);
    cv::Mat sum = cv::Mat::zeros(background.size(), CV_32FC4);
    for (int i = 0; i < count; ++i) {
        const double time = frame + options.exposureFrames * ((i + 0.5) / count - 0.5);
        cv::accumulate(handsPicture(world, camera, posesAt(motion, time)), sum);
    }
    cv::Mat picture = background.clone();
    for (int y = 0; y < picture.rows; ++y) {
        const auto* hands = sum.ptr<cv::Vec4f>(y);
        auto* row = picture.ptr<cv::Vec3b>(y);
        for (int x = 0; x < picture.cols; ++x) {
            const float through = 1 - hands[x][3] / (255.0F * static_cast<float>(count));
            for (int k = 0; k < 3; ++k) {
                row[x][k] = cv::saturate_cast<uchar>(hands[x][k] / static_cast<float>(count) +
                                                     through * static_cast<float>(row[x][k]));
            }
        }
    }
    if (options.defocusPx > 0)
        cv::GaussianBlur(picture, picture, {}, options.defocusPx);
    return withSensorNoise(picture, options, drawSeed(world.seed, "picture/" + name + "/" + camera.name));
}

} // namespace core
