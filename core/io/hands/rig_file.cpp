// SPDX-License-Identifier: MIT
#include "core/io/hands/rig_file.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/io/files/embedded_resources.h"
#include "core/io/files/json_file.h"

namespace core {

using nlohmann::json;

namespace {

/// Reads one rig; remembers the file for its errors.
class RigReader {
public:
    explicit RigReader(std::string file)
        : m_file(std::move(file)) {}

    Rig read(const json& value) {
        m_rig.name = value["name"].get<std::string>();
        m_rig.forwardInJoint = jsonVector(value["jointAxes"]["forward"], m_file, "jointAxes.forward").normalized();
        m_rig.dorsalInJoint = jsonVector(value["jointAxes"]["dorsal"], m_file, "jointAxes.dorsal").normalized();
        if (!(m_rig.forwardInJoint.cross(m_rig.dorsalInJoint).norm() > 0.1))
            throw bad("jointAxes", "forward and dorsal must be two different directions");
        for (std::size_t j = 0; j < value["joints"].size(); ++j)
            addJoint(value["joints"][j], "joints[" + std::to_string(j) + "]");
        for (std::size_t d = 0; d < value["dofs"].size(); ++d)
            addDof(value["dofs"][d], "dofs[" + std::to_string(d) + "]");
        return std::move(m_rig);
    }

private:
    Error bad(const std::string& field, const std::string& detail) const {
        return {ErrorCode::BadInput, m_file, field, detail};
    }

    bool hasJoint(const std::string& name) const {
        return std::any_of(
            m_rig.joints.begin(), m_rig.joints.end(), [&](const RigJoint& j) { return j.name == name; });
    }

    void addJoint(const json& value, const std::string& field) {
        RigJoint joint{value["name"].get<std::string>(),
                       value["parent"].is_null() ? "" : value["parent"].get<std::string>(),
                       value.value("namesInFile", std::vector<std::string>{})};
        if (hasJoint(joint.name))
            throw bad(field + ".name", "'" + joint.name + "' is there twice");
        if (m_rig.joints.empty() != joint.parent.empty())
            throw bad(field + ".parent", "the first joint, and it alone, has no parent");
        if (!joint.parent.empty() && !hasJoint(joint.parent))
            throw bad(field + ".parent", "no earlier joint is named '" + joint.parent + "'");
        m_rig.joints.push_back(std::move(joint));
    }

    void addDof(const json& value, const std::string& field) {
        RigDof dof{value["joint"].get<std::string>(), value["name"].get<std::string>(),
                   jsonVector(value["axis"], m_file, field + ".axis"), value["limitsDeg"][0].get<double>(),
                   value["limitsDeg"][1].get<double>()};
        if (!hasJoint(dof.joint) || dof.joint == m_rig.joints.front().name)
            throw bad(field + ".joint", "'" + dof.joint + "' is not a joint with a parent");
        if (std::any_of(m_rig.dofs.begin(), m_rig.dofs.end(),
                        [&](const RigDof& other) { return other.joint == dof.joint && other.name == dof.name; }))
            throw bad(field + ".name", "'" + dof.joint + "." + dof.name + "' is there twice");
        if (!(dof.axis.norm() > 1e-6))
            throw bad(field + ".axis", "has no length");
        if (dof.minDeg > 0 || dof.maxDeg < 0 || dof.minDeg >= dof.maxDeg)
            throw bad(field + ".limitsDeg", "must go from a least to a most angle with the rest pose, 0, between them");
        m_rig.dofs.push_back(std::move(dof));
    }

    std::string m_file;
    Rig m_rig;
};

} // namespace

Rig rigFromJson(const json& value, const std::string& file) {
    return RigReader(file).read(value);
}

Rig readRig(const std::filesystem::path& file) {
    return rigFromJson(readOwnFile(file, "rig"), file.string());
}

Rig defaultRig(const std::string& name) {
    const std::string resource = "rigs/" + name + ".json";
    return rigFromJson(embeddedOwnFile(resource, "rig"), resource);
}

} // namespace core
