// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the triangles of glTF.

#include "IO/decompress.h"
#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <Eigen/Geometry>
#include <boost/unordered_map.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// The map of a matrix of 4 x 4 numbers, column by column.
Eigen::Affine3d map_of_matrix(const std::array<double, 16>& columns)
{
  return Eigen::Affine3d(Eigen::Map<const Eigen::Matrix4d>(columns.data()));
}

/// Where `map` moves a point.
Vector3 moved(const Eigen::Affine3d& map, const Vector3& point)
{
  const Eigen::Vector3d place = map * Eigen::Vector3d(point.x(), point.y(), point.z());
  return {place.x(), place.y(), place.z()};
}

/// Reads glTF 2.0: the triangles of all meshes of the scene at their places, skins as their joints stand. The data are
/// in the binary chunk, in the JSON in Base64, or in files next to it. The values in the JSON are checked before they
/// are used.
class Gltf_parser
{
public:
  Gltf_parser(std::string_view content, const std::string& filename) : m_content(content), m_filename(filename) {}

  Shape_file parse()
  {
    constexpr bool has_exceptions = false;
    const std::string_view text = split();
    m_json = Json::parse(text.begin(), text.end(), nullptr, has_exceptions);
    if (!m_json.is_object()) {
      fail("its JSON is malformed");
    }
    if (list("extensionsRequired").size() > 0) {
      fail("it needs the extension " +
           list("extensionsRequired")[0].dump(-1, ' ', true, Json::error_handler_t::replace) +
           ", such as compression, which is not read");
    }
    for (const Json& buffer : list("buffers")) {
      m_buffers.push_back(buffer_bytes(buffer));
    }
    add_scene();
    return std::move(m_shape);
  }

private:
  using Json = nlohmann::json;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  /// Instances could multiply a small file without end.
  static constexpr std::size_t max_number_of_elements = std::size_t(1) << 26U;

  struct Skin
  {
    std::vector<Eigen::Affine3d> joints;                           ///< where they move vertices
    boost::unordered_map<std::array<double, 3>, Vector3> places{}; ///< of vertices, by where they are at rest
  };

  [[noreturn]] static void fail(const std::string& fault)
  {
    internal::fail(fault, "write the file again as .glb, or as another format");
  }

  /// \return the JSON; the rest of a binary file becomes the first buffer
  std::string_view split()
  {
    constexpr std::uint32_t version = 2;
    if (m_content.substr(0, 4) != "glTF") {
      return m_content;
    }
    Byte_scanner bytes(m_content.substr(4), Byte_order::little);
    if (bytes.number<std::uint32_t>() != version) {
      fail("only version 2 of glTF is read");
    }
    const auto next_chunk = [&bytes]() -> std::string_view {
      const std::size_t size = bytes.number<std::uint32_t>();
      bytes.skip(sizeof(std::uint32_t)); // the kind of the chunk
      return {bytes.skip(size), size};
    };
    bytes.skip(sizeof(std::uint32_t)); // the size of the file
    const std::string_view json = next_chunk();
    m_binary_chunk = bytes.remaining() == 0 ? std::string_view() : next_chunk();
    return json;
  }

  const Json& list(const char* name) const { return list(m_json, name); }

  /// A member that is an array; an empty one if there is none.
  const Json& list(const Json& object, const char* name) const
  {
    static const Json empty = Json::array();
    const auto place = object.find(name);
    if (place == object.end()) {
      return empty;
    }
    if (!place->is_array()) {
      fail(std::string(name) + " is not an array");
    }
    return *place;
  }

  /// A member that is a number, or `by_default`.
  std::size_t number(const Json& object, const char* name, std::size_t by_default) const
  {
    if (!object.is_object()) {
      fail("an element is not an object");
    }
    const auto place = object.find(name);
    return place == object.end() ? by_default : to_index(*place, name);
  }

  std::size_t to_index(const Json& json, const std::string& name) const
  {
    if (!json.is_number_unsigned()) {
      fail(name + " is not an integer from 0 on");
    }
    return json.get<std::size_t>();
  }

  const Json& element(const char* name, std::size_t i) const
  {
    if (i >= list(name).size() || !list(name)[i].is_object()) {
      fail("the list " + std::string(name) + " does not have an element " + std::to_string(i));
    }
    return list(name)[i];
  }

  std::string_view buffer_bytes(const Json& buffer)
  {
    number(buffer, "byteLength", 0);
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
      return m_binary_chunk;
    }
    if (!uri->is_string()) {
      fail("a URI is not a string");
    }
    const std::string& text = uri->get_ref<const std::string&>();
    const auto [place, is_new] = m_content_of_uri.try_emplace(text);
    if (is_new) {
      constexpr std::string_view base64 = ";base64,";
      const std::size_t begin = text.find(base64);
      const bool is_here = text.substr(0, 5) == "data:" && begin != std::string::npos;
      place->second = is_here ? Encoded_bytes(std::string_view(text).substr(begin + base64.size()), true).take_all()
                              : content_beside(text);
    }
    return place->second;
  }

  /// The content of a file in the folder of this one, or below: a file from elsewhere must not reach others.
  std::string content_beside(const std::string& uri) const
  {
    const std::filesystem::path path = decode_percents(uri);
    const bool is_below = path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
    const std::filesystem::path place = std::filesystem::path(m_filename).parent_path() / path;
    std::error_code error;
    if (!is_below || !std::filesystem::is_regular_file(place, error)) {
      fail("its data are in a file of their own, which is not in its folder");
    }
    std::ifstream in = open_file(place.string());
    return naming(place.string(), [&] { return read_content(in, place.string()); });
  }

  /// Replaces `%20` and the like.
  static std::string decode_percents(std::string uri)
  {
    for (std::size_t i = uri.find('%'); i != std::string::npos; i = uri.find('%', i + 1)) {
      unsigned char byte = 0;
      const char* const digits = uri.data() + i + 1;
      if (i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
        uri.replace(i, 3, 1, char(byte));
      }
    }
    return uri;
  }

  Number_type component_type(const Json& accessor) const
  {
    static const std::map<std::size_t, Number_type> types{{5120, {'i', 1}}, {5121, {'u', 1}}, {5122, {'i', 2}},
                                                          {5123, {'u', 2}}, {5125, {'u', 4}}, {5126, {'f', 4}}};
    const auto type = types.find(number(accessor, "componentType", 0));
    if (type == types.end()) {
      fail("an accessor has an unknown type of components");
    }
    return type->second;
  }

  /// The numbers of an accessor.
  /// \param number_of_components that each of its elements must have, or else are refused with `fault`
  /// \param kinds of numbers that they may be
  Number_view accessor(std::size_t i, std::size_t number_of_components, std::string_view kinds, const char* fault) const
  {
    static const std::map<std::string, std::size_t> sizes{{"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const Json& its = element("accessors", i);
    const auto type = its.find("type");
    if (its.find("sparse") != its.end() || its.find("bufferView") == its.end()) {
      fail("sparse accessors are not read");
    }
    Number_view result;
    result.type = component_type(its);
    result.count = number(its, "count", 0);
    const auto its_size = sizes.find(type != its.end() && type->is_string() ? type->get<std::string>() : "SCALAR");
    const std::size_t size = (its_size != sizes.end() ? its_size->second : 1) * result.type.size;
    const Json& view = element("bufferViews", number(its, "bufferView", 0));
    const std::size_t buffer = number(view, "buffer", 0);
    const std::size_t offset_in_view = number(its, "byteOffset", 0);
    const std::size_t offset = number(view, "byteOffset", 0);
    result.stride = number(view, "byteStride", size);
    if (buffer >= m_buffers.size() || offset > m_buffers[buffer].size() ||
        offset_in_view > m_buffers[buffer].size() - offset) {
      fail("a view begins behind the end of its buffer");
    }
    const std::string_view bytes = m_buffers[buffer].substr(offset + offset_in_view);
    const std::size_t room = bytes.size() < size ? 0 : bytes.size() - size;
    if (result.count > 0 && (bytes.size() < size || result.stride == 0 || result.count - 1 > room / result.stride)) {
      fail("an accessor has more elements than there is room for");
    }
    if (kinds.find(result.type.kind) == std::string_view::npos || size != number_of_components * result.type.size) {
      fail(fault);
    }
    result.bytes = bytes.data();
    return result;
  }

  /// The first elements of an accessor, at most `max_number`, each an array of numbers. Many objects may refer to one
  /// large accessor: none reads more of it than it needs.
  template <class Element>
  std::vector<Element> elements(std::size_t i, std::size_t max_number, std::string_view kinds, const char* fault) const
  {
    constexpr std::size_t size = sizeof(Element) / sizeof(double);
    Number_view numbers = accessor(i, size, kinds, fault);
    numbers.count = std::min(numbers.count, max_number);
    std::vector<Element> result(numbers.count);
    for (std::size_t k = 0; k < size; ++k, numbers.bytes += numbers.type.size) {
      numbers.for_each([&result, k](std::size_t e, auto number) { result[e][k] = double(number); });
    }
    return result;
  }

  std::vector<Index> indices(const Json& primitive, std::size_t number_of_points) const
  {
    std::vector<Index> result;
    const std::size_t i = number(primitive, "indices", none);
    if (i == none) {
      result.resize(number_of_points);
      std::iota(result.begin(), result.end(), Index(0));
      return result;
    }
    const Number_view numbers = accessor(i, 1, "u", "indices are not integers from 0 on");
    result.resize(numbers.count);
    numbers.for_each([&](std::size_t k, auto index) {
      if (std::size_t(index) >= number_of_points) {
        fail("a triangle names a vertex that is not there");
      }
      result[k] = Index(index);
    });
    return result;
  }

  /// Finds where the joints of all skins move vertices; those that are not in the scene count as if they were at rest.
  void place_joints()
  {
    using Matrix = std::array<double, 16>;
    for (const Json& skin : list("skins")) {
      std::vector<Eigen::Affine3d>& maps = m_skins.emplace_back().joints;
      const Json& joints = list(skin, "joints");
      const std::size_t i = number(skin, "inverseBindMatrices", none);
      std::vector<Matrix> matrices;
      if (i != none) {
        matrices = elements<Matrix>(i, joints.size(), "f", "the matrices of a skin are not made of floats");
      }
      for (const Json& joint : joints) {
        const std::size_t node = to_index(joint, "a node index");
        Eigen::Affine3d& map = maps.emplace_back(Eigen::Affine3d::Identity());
        if (node < m_place.size() && m_place[node]) {
          map = maps.size() <= matrices.size() ? *m_place[node] * map_of_matrix(matrices[maps.size() - 1])
                                               : *m_place[node];
        }
      }
    }
  }

  /// Moves points by the joints of a skin: to the mean of the places where these move them, by their weights. Points at
  /// one place stay together, as along seams.
  void pose(const Json& attributes, std::size_t skin, std::vector<Vector3>& points)
  {
    constexpr const char* fault = "a skin, its joints or its weights are not complete";
    using Four = std::array<double, 4>;
    const auto joints = elements<Four>(number(attributes, "JOINTS_0", none), points.size(), "u", fault);
    const auto weights = elements<Four>(number(attributes, "WEIGHTS_0", none), points.size(), "fu", fault);
    if (skin >= m_skins.size() || joints.size() < points.size() || weights.size() < points.size()) {
      fail(fault);
    }
    const std::vector<Eigen::Affine3d>& maps = m_skins[skin].joints;
    for (std::size_t v = 0; v < points.size(); ++v) {
      Vector3& point = points[v];
      const auto [place, is_new] = m_skins[skin].places.try_emplace({point.x(), point.y(), point.z()}, point);
      Vector3 moment = Vector3::Zero();
      double sum = 0;
      for (std::size_t k = 0; k < 4 && is_new; ++k) {
        if (joints[v][k] < double(maps.size())) {
          moment += weights[v][k] * moved(maps[std::size_t(joints[v][k])], point);
          sum += weights[v][k];
        }
      }
      place->second = sum > 0 ? moment / sum : place->second;
      point = place->second;
    }
  }

  /// \param skin of the node, or none
  void add_primitive(const Json& primitive, const Eigen::Affine3d& map, std::size_t skin)
  {
    constexpr std::size_t triangle_list = 4;
    constexpr std::size_t triangle_strip = 5;
    constexpr std::size_t triangle_fan = 6;
    const std::size_t mode = number(primitive, "mode", triangle_list);
    const auto attributes = primitive.find("attributes");
    if (mode < triangle_list || mode > triangle_fan || attributes == primitive.end()) {
      return; // points or lines
    }
    const std::size_t position = number(*attributes, "POSITION", none);
    if (position == none) {
      return;
    }
    std::vector<Vector3> its_points =
        elements<Vector3>(position, none, "f", "positions are not vectors of floating-point numbers");
    const std::vector<Index> corners = indices(primitive, its_points.size());
    const std::size_t step = mode == triangle_list ? 3 : 1;
    const std::size_t number_of_triangles = corners.size() < 3 ? 0 : (corners.size() - 3) / step + 1;
    if (m_shape.points.size() + its_points.size() + m_shape.corners.size() / 3 + number_of_triangles >
        max_number_of_elements) {
      fail("its meshes have more than 2^26 vertices and triangles in all");
    }
    if (skin != none && attributes->contains("JOINTS_0")) {
      pose(*attributes, skin, its_points);
    }
    const Index first = Index(m_shape.points.size());
    std::transform(its_points.begin(), its_points.end(), std::back_inserter(m_shape.points),
                   [&map](const Vector3& point) { return moved(map, point); });
    // Where the mesh would be mirrored, its triangles are turned, and of a strip every other one.
    const bool is_mirrored = map.linear().determinant() < 0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      const std::size_t turn = (mode == triangle_strip && i % 2 == 1) != is_mirrored ? 1 : 0;
      for (const std::size_t corner : {mode == triangle_fan ? 0 : i, i + 1 + turn, i + 2 - turn}) {
        m_shape.corners.push_back(first + corners[corner]);
      }
      m_shape.end_polygon();
    }
  }

  /// Reads up to `size` numbers of an array.
  template <std::size_t size>
  bool numbers(const Json& node, const char* name, std::array<double, size>& result) const
  {
    const Json& values = list(node, name);
    for (std::size_t i = 0; i < size && i < values.size(); ++i) {
      if (!values[i].is_number()) {
        fail(std::string(name) + " of a node is not made of numbers");
      }
      result[i] = values[i].get<double>();
    }
    return values.size() == size;
  }

  Eigen::Affine3d map_of(const Json& node) const
  {
    std::array<double, 16> m{};
    if (numbers(node, "matrix", m)) {
      return map_of_matrix(m);
    }
    std::array<double, 3> t{};
    std::array<double, 4> q{0, 0, 0, 1};
    std::array<double, 3> s{1, 1, 1};
    numbers(node, "translation", t);
    numbers(node, "rotation", q);
    numbers(node, "scale", s);
    return Eigen::Translation3d(t[0], t[1], t[2]) * Eigen::Quaterniond(q[3], q[0], q[1], q[2]) *
           Eigen::Scaling(s[0], s[1], s[2]);
  }

  /// Places all nodes of the scene, then their meshes; a hierarchy of nodes is a forest, so that each comes once.
  void add_scene()
  {
    std::vector<std::pair<std::size_t, Eigen::Affine3d>> open;
    const std::size_t scene = number(m_json, "scene", 0);
    for (const Json& node : scene < list("scenes").size() ? list(list("scenes")[scene], "nodes") : Json::array()) {
      open.emplace_back(to_index(node, "a node index"), Eigen::Affine3d::Identity());
    }
    m_place.resize(list("nodes").size());
    std::vector<std::size_t> nodes;
    while (!open.empty()) {
      const auto [i, above] = open.back();
      open.pop_back();
      const Json& node = element("nodes", i);
      if (m_place[i]) {
        fail("a node has two parents");
      }
      m_place[i] = above * map_of(node);
      nodes.push_back(i);
      for (const Json& child : list(node, "children")) {
        open.emplace_back(to_index(child, "a node index"), *m_place[i]);
      }
    }
    place_joints();
    for (const std::size_t i : nodes) {
      const std::size_t mesh = number(element("nodes", i), "mesh", none);
      const std::size_t skin = number(element("nodes", i), "skin", none);
      if (mesh != none) {
        for (const Json& primitive : list(element("meshes", mesh), "primitives")) {
          // A skin moves its vertices by its joints alone.
          add_primitive(primitive, skin != none ? Eigen::Affine3d::Identity() : *m_place[i], skin);
        }
      }
    }
  }

  std::string_view m_content;
  std::string m_filename;
  Json m_json;
  std::string_view m_binary_chunk;
  std::map<std::string_view, std::string> m_content_of_uri; ///< by the URIs in `m_json`
  std::vector<std::string_view> m_buffers;                  ///< in the binary chunk or in `m_content_of_uri`
  std::vector<std::optional<Eigen::Affine3d>> m_place;      ///< of the nodes of the scene
  std::vector<Skin> m_skins;
  Shape_file m_shape;
};

} // namespace

Shape_file parse_gltf(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  return Gltf_parser(content, filename).parse();
}

} // namespace CSCD::internal
