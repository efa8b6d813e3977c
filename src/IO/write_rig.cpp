// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes rigs as binary glTF.

#include "IO/scanners.h"
#include <CSCD/Application/make_rig.h>
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/write_rig.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/version.h>

#include <boost/range/adaptor/transformed.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CSCD::internal {

namespace {

/// Writes a mesh and its rig as binary glTF 2.0. Layout and constants: the specification of Khronos, 3.6, 3.7 and 4.
class Glb_writer
{
public:
  Glb_writer(const Assigned_surface& surface, const Rig& rig) : m_surface(surface), m_rig(rig) {}

  void write(std::ostream& out, const std::string& name)
  {
    constexpr std::uint32_t version = 2;
    constexpr std::uint32_t json_chunk = 0x4E4F534A;   // "JSON"
    constexpr std::uint32_t binary_chunk = 0x004E4942; // "BIN" and a zero
    constexpr std::uint64_t size_of_headers = 12 + 2 * 8;
    check();
    const nlohmann::json document = describe(name);
    std::string text = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    text.resize(padded(text.size()), ' ');
    const std::string binary = m_binary.str();
    const std::uint64_t size = size_of_headers + text.size() + binary.size();
    if (size > std::numeric_limits<std::uint32_t>::max()) {
      throw Input_error("the mesh is too large for a file of glTF; simplify it first");
    }
    Exact_format format(out);
    out << "glTF";
    for (const std::uint64_t number :
         {std::uint64_t(version), size, std::uint64_t(text.size()), std::uint64_t(json_chunk)}) {
      write_little_endian(out, std::uint32_t(number));
    }
    out << text;
    write_little_endian(out, std::uint32_t(binary.size()));
    write_little_endian(out, binary_chunk);
    out << binary;
    format.finish();
  }

private:
  using Json = nlohmann::json;
  static constexpr int float_type = 5126;
  static constexpr int unsigned_short_type = 5123;
  static constexpr int unsigned_int_type = 5125;
  static constexpr int vertex_target = 34962; ///< ARRAY_BUFFER
  static constexpr int index_target = 34963;  ///< ELEMENT_ARRAY_BUFFER
  static constexpr int no_target = 0;

  void check() const
  {
    if (m_surface.triangles.empty()) {
      throw Input_error("a rig in glTF needs a surface, but there are no faces; name another format");
    }
    if (m_rig.joints.size() > std::numeric_limits<std::uint16_t>::max()) {
      throw Input_error("glTF holds 65,535 joints, but the rig has more; simplify the skeleton");
    }
    for (const Vector3& point : m_surface.points) {
      if (!(point.cwiseAbs().maxCoeff() <= double(std::numeric_limits<float>::max()))) {
        throw Input_error("a coordinate is too large for glTF, which is of single precision; scale the mesh");
      }
    }
  }

  /// Offsets in the file are multiples of this many bytes.
  static std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

  Json describe(const std::string& name)
  {
    const std::size_t triangles =
        add_view<Index>(index_target, unsigned_int_type, "SCALAR", 3 * m_surface.triangles.size(), m_surface.triangles);
    const std::size_t matrices = add_inverse_bind_matrices();
    const Json attributes = {{"POSITION", add_positions()},
                             {"NORMAL", add_normals()},
                             {"JOINTS_0", add_influences<std::uint16_t>(unsigned_short_type, &Rig_influence::joint)},
                             {"WEIGHTS_0", add_influences<float>(float_type, &Rig_influence::weight)}};
    Json joints = Json::array();
    for (std::size_t j = 0; j < m_rig.joints.size(); ++j) {
      joints.push_back(node_of_joint(j));
    }
    const Json primitive = {{"attributes", attributes}, {"indices", triangles}};
    m_document["asset"] = {{"version", "2.0"}, {"generator", "CSCD " CSCD_VERSION}};
    m_document["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
    m_document["skins"].push_back({{"inverseBindMatrices", matrices}, {"joints", joints}});
    m_document["buffers"].push_back({{"byteLength", std::size_t(m_binary.tellp())}});
    add_nodes(name);
    return m_document;
  }

  static std::size_t node_of_joint(std::size_t joint) { return joint + 1; } // the first one is the mesh

  static Json to_json(const Vector3& vector) { return {float(vector.x()), float(vector.y()), float(vector.z())}; }

  void add_nodes(const std::string& name)
  {
    Json nodes = Json::array();
    nodes.push_back({{"name", name}, {"mesh", 0}, {"skin", 0}});
    Json roots = Json::array();
    for (std::size_t j = 0; j < m_rig.joints.size(); ++j) {
      const Rig_joint& joint = m_rig.joints[j];
      const Vector3 offset = joint.parent ? joint.point - m_rig.joints[*joint.parent].point : joint.point;
      nodes.push_back({{"name", CSCD::name(joint)}, {"translation", to_json(offset)}});
      (joint.parent ? nodes[node_of_joint(*joint.parent)]["children"] : roots).push_back(node_of_joint(j));
    }
    if (roots.size() > 1) { // joints need a node above all of them
      nodes.push_back({{"name", "rig"}, {"children", roots}});
      roots = Json::array({nodes.size() - 1});
    }
    m_document["nodes"] = nodes;
    m_document["scene"] = 0;
    m_document["scenes"].push_back({{"nodes", Json::array({0, roots[0]})}});
  }

  /// Appends the rows of numbers of `count` elements to the binary chunk, each number converted to `Number`.
  /// \return the number of their accessor
  template <class Number, class Rows>
  std::size_t add_view(int target, int component_type, const char* type, std::size_t count, const Rows& rows)
  {
    const std::size_t begin = std::size_t(m_binary.tellp());
    for (const auto& row : rows) {
      for (const auto number : row) {
        write_little_endian(m_binary, Number(number));
      }
    }
    const std::size_t end = std::size_t(m_binary.tellp());
    Json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", end - begin}};
    if (target != no_target) {
      view["target"] = target;
    }
    m_document["bufferViews"].push_back(view);
    m_document["accessors"].push_back({{"bufferView", m_document["bufferViews"].size() - 1},
                                       {"componentType", component_type},
                                       {"count", count},
                                       {"type", type}});
    m_binary << std::string(padded(end) - end, '\0');
    return m_document["accessors"].size() - 1;
  }

  std::size_t add_vectors(const std::vector<Vector3>& vectors)
  {
    return add_view<float>(vertex_target, float_type, "VEC3", vectors.size(), vectors);
  }

  std::size_t add_positions()
  {
    const std::size_t accessor = add_vectors(m_surface.points);
    const Bounding_box box(m_surface.points);
    m_document["accessors"][accessor]["min"] = to_json(box.min());
    m_document["accessors"][accessor]["max"] = to_json(box.max());
    return accessor;
  }

  /// Means of the normals of the faces at the vertices, by their areas.
  std::size_t add_normals()
  {
    std::vector<Vector3> normals(m_surface.points.size());
    for (const auto& [a, b, c] : m_surface.triangles) {
      const Vector3 normal = triangle_vector(m_surface.points[a], m_surface.points[b], m_surface.points[c]);
      for (const Index corner : {a, b, c}) {
        normals[corner] += normal;
      }
    }
    for (Vector3& normal : normals) {
      normal.normalize();
      // Without area, or too small or large to tell: any direction will do.
      normal = normal.allFinite() && std::abs(normal.squaredNorm() - 1) < 1e-6 ? normal : Vector3::UnitZ();
    }
    return add_vectors(normals);
  }

  /// Joints are not turned: the matrices, column by column, move them to the origin.
  std::size_t add_inverse_bind_matrices()
  {
    std::vector<std::array<double, 16>> matrices;
    for (const Rig_joint& joint : m_rig.joints) {
      const Vector3& p = joint.point;
      matrices.push_back({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -p.x(), -p.y(), -p.z(), 1});
    }
    return add_view<float>(no_target, float_type, "MAT4", matrices.size(), matrices);
  }

  /// \param member of the influences of all vertices
  template <class Number, class Value>
  std::size_t add_influences(int component_type, Value Rig_influence::*member)
  {
    const auto row = [member](const Rig::Influences& influences) {
      return influences | boost::adaptors::transformed(std::mem_fn(member));
    };
    return add_view<Number>(vertex_target, component_type, "VEC4", m_rig.influences.size(),
                            m_rig.influences | boost::adaptors::transformed(row));
  }

  const Assigned_surface& m_surface;
  const Rig& m_rig;
  Json m_document;
  std::ostringstream m_binary;
};

} // namespace

void write_glb(std::ostream& out, const Assigned_surface& surface, const Rig& rig, const std::string& name)
{
  Glb_writer(surface, rig).write(out, name);
}

} // namespace CSCD::internal
