// SPDX-License-Identifier: MIT
#include "core/contour/shaded_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core {

namespace {

// Light adds up in linear intensities; a gamma of 2 is close enough to sRGB's and costs one square root.
Eigen::Array3f linearFromEncoded(const Eigen::Vector3f& encoded) {
    return encoded.array().square();
}

/// What light makes of one colour at one surface point, in the camera's frame.
class Shader {
public:
    Shader(const Camera& camera, const Lighting& lighting)
        : m_rotation(camera.cameraFromWorld.rotation.cast<float>())
        , m_translation(camera.cameraFromWorld.translation.cast<float>())
        , m_lighting(lighting)
        , m_key(lighting.keyDirection.normalized())
        , m_fill(lighting.fillDirection.normalized()) {}

    /// Encoded RGB of a point with a normal, both in the world. The normal is taken towards the camera.
    Eigen::Vector3f operator()(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                               const Eigen::Array3f& albedo) const {
        const Eigen::Vector3f toCamera = -(m_rotation * point.cast<float>() + m_translation).normalized();
        Eigen::Vector3f n = m_rotation * normal.cast<float>();
        float facing = n.dot(toCamera);
        if (facing < 0) {
            n = -n;
            facing = -facing;
        }
        const float key = wrapped(n.dot(m_key)), fill = wrapped(n.dot(m_fill));
        const float sky = 0.5f - 0.5f * n.y();
        const Eigen::Array3f ambient = m_lighting.ambient * tinted(kGround + sky * (kSky - kGround));
        const float edge = 4 * key * (1 - key); // where the light fades into shadow
        const Eigen::Array3f bleed = m_lighting.warmth * edge * kBlood;
        const Eigen::Array3f light =
            ambient + m_lighting.key * key * tinted(kKeyTint) + m_lighting.fill * fill * tinted(kFillTint) + bleed;
        const float away = 1 - facing;
        const float rim = m_lighting.rim * away * away * away * (0.35f + 0.65f * sky);
        return (albedo * light + rim * (0.5f * albedo + 0.15f) + m_lighting.specular * highlight(n, toCamera))
            .min(1)
            .sqrt();
    }

private:
    Eigen::Array3f tinted(const Eigen::Array3f& light) const { return 1 + m_lighting.tint * (light - 1); }
    static float wrapped(float cosine) {
        constexpr float kWrap = 0.22f;
        return std::max(0.0f, (cosine + kWrap) / (1 + kWrap));
    }
    float highlight(const Eigen::Vector3f& n, const Eigen::Vector3f& toCamera) const {
        const float half = std::max(0.0f, n.dot((m_key + toCamera).normalized()));
        const float p2 = half * half, p4 = p2 * p2, p8 = p4 * p4;
        return p8 * p8 * p4;
    }

    inline static const Eigen::Array3f kSky{0.95f, 1.0f, 1.08f};
    inline static const Eigen::Array3f kGround{0.75f, 0.62f, 0.56f};
    inline static const Eigen::Array3f kKeyTint{1.04f, 1.0f, 0.95f};
    inline static const Eigen::Array3f kFillTint{0.88f, 0.98f, 1.15f};
    inline static const Eigen::Array3f kBlood{0.60f, 0.12f, 0.06f};

    Eigen::Matrix3f m_rotation;
    Eigen::Vector3f m_translation;
    Lighting m_lighting;
    Eigen::Vector3f m_key, m_fill;
};

/// A vertex as it looks in the image; made when a visible triangle first needs it.
struct VertexLook {
    Eigen::Vector2f px;
    Eigen::Vector3f rgb;
    bool ready = false;
};

/// Interpolates over one triangle: weights of its second and third vertex at a pixel.
struct ScreenTriangle {
    const ShadedSurface* surface = nullptr;
    std::array<const VertexLook*, 3> vertices{};
    Eigen::Vector2f bByPx, cByPx;

    ScreenTriangle() = default;
    ScreenTriangle(const ShadedSurface& s, const std::array<const VertexLook*, 3>& v)
        : surface(&s)
        , vertices(v) {
        const Eigen::Vector2f ab = v[1]->px - v[0]->px, ac = v[2]->px - v[0]->px;
        const float area = ab.x() * ac.y() - ab.y() * ac.x();
        const float inverse = std::abs(area) > 1e-9f ? 1 / area : 0;
        bByPx = Eigen::Vector2f(ac.y(), -ac.x()) * inverse;
        cByPx = Eigen::Vector2f(-ab.y(), ab.x()) * inverse;
    }
    Eigen::Vector3f weights(int x, int y) const {
        const Eigen::Vector2f p = Eigen::Vector2f(static_cast<float>(x), static_cast<float>(y)) - vertices[0]->px;
        const float b = std::clamp(bByPx.dot(p), 0.0f, 1.0f);
        const float c = std::clamp(cByPx.dot(p), 0.0f, 1 - b);
        return {1 - b - c, b, c};
    }
    Eigen::Vector3f rgb(const Eigen::Vector3f& w) const {
        return w[0] * vertices[0]->rgb + w[1] * vertices[1]->rgb + w[2] * vertices[2]->rgb;
    }
    /// 1 on the triangle's edges, 0 from one pixel away on.
    float wireStrength(const Eigen::Vector3f& w) const {
        const float perA = (bByPx + cByPx).norm(), perB = bByPx.norm(), perC = cByPx.norm();
        const auto distance = [](float weight, float perPx) { return perPx > 0 ? weight / perPx : 0; };
        const float nearest = std::min({distance(w[0], perA), distance(w[1], perB), distance(w[2], perC)});
        return std::clamp(1 - nearest, 0.0f, 1.0f);
    }
};

/// Gives visible triangles their colours; vertices outside every view are never shaded.
class VisibleTriangles {
public:
    VisibleTriangles(const Camera& camera, const std::vector<ShadedSurface>& surfaces, const Lighting& lighting)
        : m_camera(camera)
        , m_surfaces(surfaces)
        , m_shader(camera, lighting) {
        for (const ShadedSurface& s : surfaces) {
            m_end.push_back((m_end.empty() ? 0 : m_end.back()) + static_cast<int>(s.surface.triangles->size()));
            m_looks.emplace_back(s.surface.verticesInWorld->size());
            m_albedo.push_back(linearFromEncoded(s.colour));
        }
    }

    ScreenTriangle operator()(int globalTriangle) {
        const auto s =
            static_cast<std::size_t>(std::upper_bound(m_end.begin(), m_end.end(), globalTriangle) - m_end.begin());
        const std::vector<std::array<int, 3>>& triangles = *m_surfaces[s].surface.triangles;
        const std::size_t t =
            static_cast<std::size_t>(globalTriangle) + triangles.size() - static_cast<std::size_t>(m_end[s]);
        const auto [a, b, c] = triangles[t];
        return ScreenTriangle(m_surfaces[s], {look(s, a), look(s, b), look(s, c)});
    }

private:
    const VertexLook* look(std::size_t surface, int vertex) {
        const auto v = static_cast<std::size_t>(vertex);
        VertexLook& look = m_looks[surface][v];
        if (!look.ready) {
            const ShadedSurface& s = m_surfaces[surface];
            const Eigen::Vector3d& point = (*s.surface.verticesInWorld)[v];
            look.px = project(m_camera, point).value_or(Eigen::Vector2d::Zero()).cast<float>();
            const Eigen::Array3f albedo =
                s.vertexColours ? linearFromEncoded((*s.vertexColours)[v]) : m_albedo[surface];
            look.rgb = m_shader(point, (*s.normalsInWorld)[v], albedo);
            look.ready = true;
        }
        return &look;
    }

    const Camera& m_camera;
    const std::vector<ShadedSurface>& m_surfaces;
    Shader m_shader;
    std::vector<int> m_end; ///< per surface, one past its last global triangle index
    std::vector<std::vector<VertexLook>> m_looks;
    std::vector<Eigen::Array3f> m_albedo;
};

/// Calls paint(x, y, triangle, weights) for every covered pixel of the camera's image, row by row.
template <typename Paint>
void forEachCoveredPixel(const DepthWindow& depth, VisibleTriangles& visible, Paint&& paint) {
    ScreenTriangle current;
    int currentIndex = -1;
    for (int windowY = 0; windowY < depth.window.height; ++windowY) {
        const int* row = depth.image.triangle.ptr<int>(windowY) - depth.window.x;
        const int y = windowY + depth.window.y;
        for (int x = depth.window.x; x < depth.window.br().x; ++x) {
            if (row[x] < 0)
                continue;
            if (row[x] != currentIndex) {
                currentIndex = row[x];
                current = visible(currentIndex);
            }
            paint(x, y, current, current.weights(x, y));
        }
    }
}

std::vector<PosedSurface> posedSurfaces(const std::vector<ShadedSurface>& surfaces) {
    std::vector<PosedSurface> posed;
    for (const ShadedSurface& s : surfaces)
        posed.push_back(s.surface);
    return posed;
}

unsigned char toByte(float v) {
    return static_cast<unsigned char>(std::clamp(v * 255 + 0.5f, 0.0f, 255.0f));
}

/// The backdrop's radial gradient, dithered so that its faint steps do not show.
cv::Mat drawBackdrop(const ImageSize& size, const Backdrop& backdrop) {
    constexpr int kSteps = 1024;
    std::array<cv::Vec3b, kSteps + 16> colours;
    for (int i = 0; i < static_cast<int>(colours.size()); ++i) {
        const float t = std::min(1.0f, static_cast<float>(i) / kSteps);
        const Eigen::Vector3f c = backdrop.centre + t * (backdrop.corner - backdrop.centre);
        colours[static_cast<std::size_t>(i)] = {toByte(c[2]), toByte(c[1]), toByte(c[0])};
    }
    constexpr int kDither[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    cv::Mat image(size.height, size.width, CV_8UC3);
    const float halfWidth = std::max(1.0f, 0.5f * static_cast<float>(size.width));
    const float halfHeight = std::max(1.0f, 0.5f * static_cast<float>(size.height));
    std::vector<int> fromColumn(static_cast<std::size_t>(size.width));
    for (int x = 0; x < size.width; ++x) {
        const float dx = (static_cast<float>(x) - halfWidth) / halfWidth;
        fromColumn[static_cast<std::size_t>(x)] = static_cast<int>(dx * dx * kSteps / 2);
    }
    for (int y = 0; y < size.height; ++y) {
        const float dy = (static_cast<float>(y) - halfHeight) / halfHeight;
        const int fromRow = static_cast<int>(dy * dy * kSteps / 2);
        auto* row = image.ptr<cv::Vec3b>(y);
        for (int x = 0; x < size.width; ++x) {
            const int step = fromRow + fromColumn[static_cast<std::size_t>(x)] + kDither[y & 3][x & 3];
            row[x] = colours[static_cast<std::size_t>(std::min(step, kSteps + 15))];
        }
    }
    return image;
}

/// True on covered pixels with an uncovered neighbour to the left, right, above or below, within the image.
bool isOnEdge(const DepthWindow& depth, const ImageSize& size, int x, int y) {
    const auto uncovered = [&](int nx, int ny) {
        const bool inImage = nx >= 0 && ny >= 0 && nx < size.width && ny < size.height;
        return inImage && (!depth.window.contains({nx, ny}) ||
                           depth.image.triangle.ptr<int>(ny - depth.window.y)[nx - depth.window.x] < 0);
    };
    return uncovered(x - 1, y) || uncovered(x + 1, y) || uncovered(x, y - 1) || uncovered(x, y + 1);
}

} // namespace

Lighting overlayLighting() {
    Lighting lighting;
    lighting.ambient = 0.52f;
    lighting.key = 0.55f;
    lighting.fill = 0.22f;
    lighting.rim = 0;
    lighting.specular = 0.02f;
    lighting.warmth = 0;
    lighting.tint = 0;
    return lighting;
}

Eigen::Vector3f skinColour(Side side) {
    return side == Side::Left ? Eigen::Vector3f(0.90f, 0.70f, 0.58f) : Eigen::Vector3f(0.82f, 0.61f, 0.51f);
}

cv::Mat renderShaded(const Camera& camera, const std::vector<ShadedSurface>& surfaces, const Lighting& lighting,
                     const Backdrop& backdrop) {
    const DepthWindow depth = renderDepthWindow(camera, posedSurfaces(surfaces));
    cv::Mat image = drawBackdrop(camera.size, backdrop);
    VisibleTriangles visible(camera, surfaces, lighting);
    forEachCoveredPixel(depth, visible,
                        [&](int x, int y, const ScreenTriangle& triangle, const Eigen::Vector3f& weights) {
                            const Eigen::Vector3f rgb = triangle.rgb(weights);
                            image.ptr<cv::Vec3b>(y)[x] = {toByte(rgb[2]), toByte(rgb[1]), toByte(rgb[0])};
                        });
    return image;
}

cv::Mat renderHandsShaded(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses) {
    std::vector<std::vector<Eigen::Vector3d>> vertices(hands.size()), normals(hands.size());
    std::vector<ShadedSurface> surfaces;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        vertices[h] = posedVertices(hands[h], poses[h]);
        normals[h] = vertexNormals(vertices[h], hands[h].mesh.triangles);
        surfaces.push_back({{&vertices[h], &hands[h].mesh.triangles}, &normals[h], skinColour(hands[h].side)});
    }
    return renderShaded(camera, surfaces);
}

cv::Mat renderOverlay(const Camera& camera, const std::vector<ShadedSurface>& surfaces, const OverlayOptions& options,
                      const Lighting& lighting) {
    const DepthWindow depth = renderDepthWindow(camera, posedSurfaces(surfaces));
    cv::Mat image(camera.size.height, camera.size.width, CV_8UC4, cv::Scalar(0, 0, 0, 0));
    VisibleTriangles visible(camera, surfaces, lighting);
    const auto paint = [&](int x, int y, const ScreenTriangle& triangle, const Eigen::Vector3f& weights) {
        auto& pixel = image.ptr<cv::Vec4b>(y)[x];
        if (options.silhouetteEdge && isOnEdge(depth, camera.size, x, y)) {
            const Eigen::Vector3f& plain = triangle.surface->colour;
            pixel = {toByte(plain[2]), toByte(plain[1]), toByte(plain[0]), 255};
            return;
        }
        const bool wires = options.style == OverlayStyle::Wireframe;
        const float alpha = options.opacity * (wires ? triangle.wireStrength(weights) : 1);
        const Eigen::Vector3f rgb = alpha * triangle.rgb(weights);
        pixel = {toByte(rgb[2]), toByte(rgb[1]), toByte(rgb[0]), toByte(alpha)};
    };
    forEachCoveredPixel(depth, visible, paint);
    return image;
}

} // namespace core
