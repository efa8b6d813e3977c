// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The compiled part of the Python module: between NumPy's arrays and the commands of the program. The public interface
// is in cscd/__init__.py.

#include "options.h"
#include "types.h"
#include "write_report.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/find_surface_loops.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/version.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace py = pybind11;
using namespace pybind11::literals;
using CSCD::Index;

using Coordinates = py::array_t<double, py::array::c_style>;
using Corners = py::array_t<std::int64_t, py::array::c_style>;

/// The number of a node or vertex as NumPy gets it, signed, so that differences are right; -1 for none.
using Signed_index = std::int32_t;
static_assert(sizeof(Signed_index) == sizeof(Index) && Signed_index(CSCD::no_index) == -1,
              "NumPy sees the library's indices as signed ones");
static_assert(sizeof(CSCD::Vector3) == 3 * sizeof(double) && sizeof(std::array<Index, 2>) == 2 * sizeof(Index),
              "NumPy sees points and edges as rows");

/// The name of an input in messages.
const char* name_of(const cscd::Input& input)
{
  return input.graph ? "graph" : input.is_point_set ? "points" : "mesh";
}

std::vector<CSCD::Vector3> to_points(const Coordinates& rows, const std::string& name)
{
  std::vector<CSCD::Vector3> result;
  result.reserve(std::size_t(rows.shape(0)));
  const auto value = rows.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const CSCD::Vector3 point(value(i, 0), value(i, 1), value(i, 2));
    if (!point.allFinite()) {
      throw CSCD::Input_error(name + ": row " + std::to_string(i) +
                              ": a coordinate is not finite; correct or remove this row");
    }
    result.push_back(point);
  }
  return result;
}

/// Adds the rows of an array, which has this name, as polygons to `soup`. -1 after the third value of a row does not
/// stand for a vertex.
void add_polygons(const Corners& rows, const std::string& name, py::ssize_t number_of_vertices, CSCD::Shape_file& soup)
{
  const auto value = rows.unchecked<2>();
  soup.corners.reserve(std::size_t(rows.size()));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    for (py::ssize_t j = 0; j < rows.shape(1) && (j < 3 || value(i, j) != -1); ++j) {
      if (value(i, j) < 0 || value(i, j) >= number_of_vertices) {
        throw CSCD::Input_error(name + ": row " + std::to_string(i) + " names vertex " + std::to_string(value(i, j)) +
                                ", and V has rows 0 to " + std::to_string(number_of_vertices - 1));
      }
      soup.corners.push_back(static_cast<Index>(value(i, j)));
    }
    soup.end_polygon();
  }
}

CSCD::Shape_file to_soup(const Coordinates& points, const std::optional<Corners>& corners)
{
  CSCD::Shape_file result;
  result.points = to_points(points, "V");
  if (corners) {
    add_polygons(*corners, "F", points.shape(0), result);
  }
  return result;
}

/// The graph of `edges`, of the sides of faces, or of each point and its neighbors.
cscd::Input make_graph(const Coordinates& points, const std::optional<Corners>& corners,
                       const std::optional<Corners>& edges, unsigned int number_of_neighbors)
{
  CSCD::Shape_file soup = to_soup(points, corners);
  if (edges) {
    CSCD::Shape_file ends;
    add_polygons(*edges, "edges", points.shape(0), ends);
    for (std::size_t i = 0; i < ends.corners.size(); i += 2) {
      soup.lines.push_back({ends.corners[i], ends.corners[i + 1]});
    }
  }
  return cscd::make_input(cscd::make_graph(soup, number_of_neighbors));
}

/// The mesh of polygons, repaired as the program repairs them, which has kept the points of the arrays; or the points.
cscd::Input make_input(CSCD::Shape_file&& soup, unsigned number_of_threads)
{
  constexpr bool is_quiet = true;
  constexpr bool keeps_file = false; // only its points are needed
  std::vector<CSCD::Vector3> points = soup.points;
  cscd::Input result = cscd::to_input(std::move(soup), "mesh", is_quiet, keeps_file, number_of_threads);
  if (result.as_read.points.empty()) { // else they were moved
    result.as_read.points = std::move(points);
  }
  return result;
}

/// The options that `arguments` of Python set; None leaves the default.
/// \throw Usage_error naming the argument and its range
template <class Options>
Options to_options(const py::dict& arguments)
{
  Options result;
  for (const cscd::Option& option : cscd::options_of(result)) {
    const std::string name = cscd::python_name(option);
    const py::object value = arguments.contains(name) ? py::object(arguments[name.c_str()]) : py::none();
    if (value.is_none()) {
      continue;
    }
    const bool is_flag = std::holds_alternative<bool*>(option.value);
    const std::string text = is_flag ? (py::bool_(value) ? "true" : "false") : std::string(py::str(value));
    if (text != cscd::text_of(option)) {
      cscd::assign(option, text);
    }
  }
  return result;
}

/// Name, default, values and help of the arguments of Python that the options of `command` are.
template <class Options>
py::list describe_options()
{
  Options options;
  py::list result;
  for (const cscd::Option& option : cscd::options_of(options)) {
    if (cscd::is_of_method(option)) {
      result.append(py::make_tuple(cscd::python_name(option), cscd::text_of(option),
                                   option.choices.empty() ? "" : option.argument, option.help));
    }
  }
  return result;
}

/// Passes progress on to `callback(stage, fraction)`, which is referred to and may be None, and raises the exceptions
/// of the user's signals, such as KeyboardInterrupt.
cscd::Stage_progress to_progress(const py::object& callback)
{
  return [&callback](CSCD::Skeletonization_stage stage, double fraction) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) {
      throw py::error_already_set();
    }
    if (!callback.is_none()) {
      callback(CSCD::name(stage), fraction);
    }
  };
}

/// A skeleton, and its input, as NumPy shows them.
struct Python_skeleton
{
  std::shared_ptr<const cscd::Input> input;
  cscd::Skeletonize_options options;
  cscd::Skeletonization_result result;
  std::string report;                            ///< of the skeletonization, as JSON
  std::vector<Signed_index> nodes_of_vertices{}; ///< of the arrays that were skeletonized

  const CSCD::Skeleton& skeleton() const { return result.skeleton; }
};

void find_nodes_of_vertices(Python_skeleton& skeleton)
{
  skeleton.nodes_of_vertices.clear();
  for (const CSCD::Vertex_label& label : cscd::labels_of_file(*skeleton.input, skeleton.result)) {
    skeleton.nodes_of_vertices.push_back(Signed_index(label.node));
  }
}

Python_skeleton simplify(const Python_skeleton& skeleton, const py::dict& arguments, bool stays_inside)
{
  auto options = to_options<cscd::Simplify_options>(arguments);
  options.skeleton = "skeleton"; // in messages
  const py::gil_scoped_release release;
  Python_skeleton simplified = skeleton;
  const bool has_mesh = stays_inside && !skeleton.input->is_point_set;
  cscd::simplify_skeleton(options, has_mesh ? skeleton.input.get() : nullptr, simplified.result.skeleton);
  cscd::Skeletonize_options settings = skeleton.options;
  settings.root = options.root.empty() ? settings.root : options.root;
  // The limbs of a tree name nodes that may be gone, and a tree has no surface.
  std::optional<CSCD::Tree_report> tree = std::exchange(simplified.result.tree, std::nullopt);
  if (tree) {
    settings.report.clear();
  }
  cscd::measure_branches(*skeleton.input, settings, simplified.result);
  simplified.result.tree = std::move(tree);
  find_nodes_of_vertices(simplified);
  return simplified;
}

Python_skeleton skeletonize(const Coordinates& points, const std::optional<Corners>& corners,
                            const std::optional<Coordinates>& normals, const std::optional<Corners>& edges,
                            const py::dict& arguments, const py::object& callback)
{
  auto options = to_options<cscd::Skeletonize_options>(arguments);
  const cscd::Stage_progress progress = to_progress(callback);
  const auto input = std::make_shared<cscd::Input>();
  std::optional<CSCD::Shape_file> soup;
  if (options.domain == cscd::graph_domain) {
    *input = make_graph(points, corners, edges, options.number_of_neighbors);
  } else {
    soup = to_soup(points, corners);
    if (normals) {
      soup->normals = to_points(*normals, "normals");
    }
  }
  const py::gil_scoped_release release;
  if (soup) {
    *input = make_input(std::move(*soup), options.number_of_threads);
  }
  options.input = name_of(*input);
  options.is_quiet = true;
  options.report = cscd::standard_stream; // with all that a report has
  cscd::Skeletonization_result result = cscd::skeletonize_input(*input, options, progress);
  std::ostringstream report;
  cscd::write_report(report, options, input->repairs.sentences(), result);
  Python_skeleton skeleton{input, std::move(options), std::move(result), report.str()};
  find_nodes_of_vertices(skeleton);
  return skeleton;
}

std::string evaluate(const Python_skeleton& skeleton, const py::dict& arguments)
{
  auto options = to_options<cscd::Evaluate_options>(arguments);
  const py::gil_scoped_release release;
  options.input = name_of(*skeleton.input);
  options.skeleton = "skeleton";
  std::ostringstream out;
  cscd::write_measures_as_json(out, options, cscd::measure_skeleton(*skeleton.input, skeleton.skeleton(), options));
  return out.str();
}

std::string page(const Python_skeleton& skeleton, const std::string& title)
{
  std::ostringstream out;
  cscd::write_page(out, *skeleton.input, skeleton.result, title);
  return out.str();
}

/// Writes a file as `cscd skeletonize --output` does.
void save(const Python_skeleton& skeleton, const std::string& filename)
{
  cscd::Skeletonize_options options = skeleton.options;
  options.input = std::filesystem::path(filename).stem().string(); // the title of a page, the name of a rig
  options.outputs = {filename};
  options.report.clear();
  CSCD::File_group files;
  cscd::write_results(files, *skeleton.input, skeleton.result, options);
  files.publish();
}

/// The mesh that was skeletonized, with its skeleton. \throw Usage_error if rows of the arrays have no counterparts in
/// it
CSCD::internal::Skeletonized_surface skeletonized_surface(const Python_skeleton& skeleton)
{
  const cscd::Input& input = *skeleton.input;
  if (input.is_point_set || input.is_wrapped || !input.repairs.sentences().empty() || input.faces.empty()) {
    throw cscd::Usage_error(
        "only a mesh that was neither repaired nor wrapped has values of its own vertices and faces");
  }
  return CSCD::internal::make_skeletonized_surface(cscd::assigned_surface(input, skeleton.skeleton()),
                                                   skeleton.skeleton());
}

std::vector<double> shape_diameters(const Python_skeleton& skeleton)
{
  return CSCD::internal::shape_diameters(skeletonized_surface(skeleton), skeleton.input->points.size(),
                                         CSCD::default_number_of_diameter_smoothing_steps);
}

std::vector<Index> segment(const Python_skeleton& skeleton, std::size_t number_of_parts)
{
  return CSCD::internal::segment_surface(skeletonized_surface(skeleton), number_of_parts);
}

/// A new array of rows of three or two numbers; None if `rows` is empty.
template <class Value, class Row>
py::object rows_or_none(const std::vector<Row>& rows)
{
  constexpr std::size_t width = sizeof(Row) / sizeof(Value);
  return rows.empty() ? py::object(py::none())
                      : py::array_t<Value>({rows.size(), width}, reinterpret_cast<const Value*>(rows.data()));
}

/// Kind, length, depth and points of each loop.
py::list find_loops(const Coordinates& points, const Corners& corners, unsigned seed, double min_depth)
{
  CSCD::Shape_file soup = to_soup(points, corners);
  std::vector<CSCD::Surface_loop<CSCD::Vector3>> loops;
  {
    const py::gil_scoped_release release;
    cscd::Input mesh = make_input(std::move(soup), 0);
    loops = CSCD::internal::find_surface_loops(std::move(mesh.points), std::move(mesh.faces), seed, min_depth);
  }
  py::list result;
  for (const CSCD::Surface_loop<CSCD::Vector3>& loop : loops) {
    result.append(py::make_tuple(name(loop.kind), loop.length, loop.depth, rows_or_none<double>(loop.points)));
  }
  return result;
}

/// An array that refers to the memory of `rows`, which `owner` has, for reading.
template <class Value, class Row>
py::array view(const py::object& owner, const std::vector<Row>& rows)
{
  std::vector<py::ssize_t> shape{py::ssize_t(rows.size())};
  if (sizeof(Row) > sizeof(Value)) {
    shape.push_back(sizeof(Row) / sizeof(Value));
  }
  py::array result(py::dtype::of<Value>(), std::move(shape), reinterpret_cast<const Value*>(rows.data()), owner);
  result.attr("setflags")("write"_a = false);
  return result;
}

/// The arrays of a skeleton, without a copy: each keeps the skeleton alive.
void define_arrays(py::class_<Python_skeleton>& type)
{
  const auto define = [&type](const char* name, auto value, auto member) {
    type.def_property_readonly(name, [member](const py::object& self) {
      return view<decltype(value)>(self, self.cast<const Python_skeleton&>().skeleton().*member);
    });
  };
  define("nodes", 0., &CSCD::Skeleton::points);
  define("radius", 0., &CSCD::Skeleton::radii);
  define("edges", Signed_index(0), &CSCD::Skeleton::edges);
  define("significance", 0., &CSCD::Skeleton::significance);
  type.def_property_readonly("vertex_to_node", [](const py::object& self) {
    return view<Signed_index>(self, self.cast<const Python_skeleton&>().nodes_of_vertices);
  });
}

/// The corners of the polygons, a row each, padded with -1 to the length of the longest.
py::object polygons_of(const CSCD::Shape_file& shape)
{
  std::size_t width = 0;
  for (std::size_t polygon = 0; polygon < shape.number_of_polygons(); ++polygon) {
    width = std::max(width, shape.size_of_polygon(polygon));
  }
  py::array_t<std::int64_t> result({shape.number_of_polygons(), width});
  std::fill_n(result.mutable_data(), result.size(), -1);
  for (std::size_t polygon = 0; polygon < shape.number_of_polygons(); ++polygon) {
    std::copy_n(shape.corners.begin() + std::ptrdiff_t(shape.first_corner[polygon]), shape.size_of_polygon(polygon),
                result.mutable_data(py::ssize_t(polygon), 0));
  }
  return result;
}

/// Points, polygons, normals, edges and radii of a file; None stands for missing arrays.
py::tuple read_file(const std::string& filename)
{
  CSCD::Shape_file shape;
  {
    const py::gil_scoped_release release;
    shape = CSCD::internal::read_shape(filename, CSCD::internal::any_content);
  }
  return py::make_tuple(rows_or_none<double>(shape.points),
                        shape.number_of_polygons() > 0 ? polygons_of(shape) : py::none(),
                        rows_or_none<double>(shape.normals), rows_or_none<std::int64_t>(shape.lines),
                        shape.radii.empty() ? py::object(py::none())
                                            : py::array_t<double>(py::ssize_t(shape.radii.size()), shape.radii.data()));
}

/// The fields of `Branch`, in their order.
py::tuple to_tuple(const CSCD::Skeleton_branch& branch)
{
  return py::make_tuple(branch.nodes, py::make_tuple(name(branch.ends[0]), name(branch.ends[1])), branch.length,
                        branch.chord, branch.min_radius, branch.mean_radius, branch.max_radius, branch.significance,
                        branch.volume, branch.surface_area, branch.parent, branch.order);
}

/// `message` with options spelled as arguments of Python: `detail` for `--detail`, `domain="graph"` for `--as graph`.
std::string in_words_of_python(std::string message)
{
  cscd::Skeletonize_options skeletonize_options;
  cscd::Simplify_options simplify_options;
  cscd::Evaluate_options evaluate_options;
  for (const std::vector<cscd::Option>& table :
       {options_of(skeletonize_options), options_of(simplify_options), options_of(evaluate_options)}) {
    for (const cscd::Option& option : table) {
      const std::string argument = cscd::python_name(option);
      for (const std::string& choice : option.choices) {
        boost::algorithm::replace_all(message, "--" + option.name + " " + choice, argument + "=\"" + choice + "\"");
      }
      message = std::regex_replace(message, std::regex("--" + option.name + "(?![a-z-])"), argument);
    }
  }
  return message;
}

void register_usage_error()
{
  py::register_exception_translator([](std::exception_ptr exception) {
    try {
      if (exception) {
        std::rethrow_exception(exception);
      }
    } catch (const cscd::Usage_error& error) {
      PyErr_SetString(PyExc_ValueError, in_words_of_python(error.what()).c_str());
    }
  });
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.attr("__version__") = CSCD_VERSION;
  py::register_exception<CSCD::Input_error>(module, "InputError", PyExc_ValueError);
  py::register_exception<CSCD::File_error>(module, "FileError", PyExc_OSError);
  register_usage_error();
  const py::call_guard<py::gil_scoped_release> without_gil;
  py::class_<Python_skeleton> type(module, "Skeleton");
  define_arrays(type);
  type.def_readonly("report", &Python_skeleton::report)
      .def_property_readonly("warnings", [](const Python_skeleton& skeleton) { return skeleton.result.warnings(); })
      .def_property_readonly("repairs",
                             [](const Python_skeleton& skeleton) { return skeleton.input->repairs.sentences(); })
      .def("simplify", &simplify, "options"_a, "stays_inside"_a)
      .def("evaluate", &evaluate, "options"_a)
      .def("page", &page, "title"_a, without_gil)
      .def("shape_diameters", &shape_diameters, without_gil)
      .def("segment", &segment, "parts"_a, without_gil)
      .def("save", &save, "filename"_a, without_gil)
      .def("branches", [](const Python_skeleton& skeleton) {
        py::list result;
        for (const CSCD::Skeleton_branch& branch : skeleton.result.branches.branches) {
          result.append(to_tuple(branch));
        }
        return result;
      });
  module.def("find_loops", &find_loops, "V"_a, "F"_a, "seed"_a, "min_depth"_a);
  module.def("skeletonize", &skeletonize, "V"_a, "F"_a, "normals"_a, "edges"_a, "options"_a, "progress"_a);
  module.def("read", &read_file, "filename"_a);
  module.attr("skeletonize_options") = describe_options<cscd::Skeletonize_options>();
  module.attr("simplify_options") = describe_options<cscd::Simplify_options>();
  module.attr("evaluate_options") = describe_options<cscd::Evaluate_options>();
}
