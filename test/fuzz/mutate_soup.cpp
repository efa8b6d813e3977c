// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mutations of polygon soups for libFuzzer: bytes that change at random are hardly ever a body any more; limbs that
// grow, handles, folds and holes leave them surfaces.

#include "Coded_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using CSCD::test::Coded_soup;
using Triple = Coded_soup::Triple;

class Soup_mutation
{
public:
  Soup_mutation(Coded_soup& soup, unsigned seed) : m_soup(soup), m_generator(seed) {}

  /// Makes some random changes.
  void operator()()
  {
    for (std::size_t left = 1 + below(4); left > 0; --left) {
      change();
    }
  }

private:
  std::size_t below(std::size_t bound) { return std::uniform_int_distribution<std::size_t>(0, bound - 1)(m_generator); }
  std::uint8_t random_byte() { return std::uint8_t(below(256)); }
  std::uint8_t small_step() { return std::uint8_t(below(31) - 15); }
  std::size_t random_point() { return below(m_soup.points.size()); }
  Triple& random_triangle() { return m_soup.triangles[below(m_soup.triangles.size())]; }
  bool has_room(std::size_t points, std::size_t triangles) const
  {
    return m_soup.points.size() + points <= Coded_soup::max_number_of_points &&
           m_soup.triangles.size() + triangles <= Coded_soup::max_number_of_triangles;
  }

  void change()
  {
    constexpr std::size_t number_of_changes = 12;
    const std::size_t which = below(number_of_changes);
    if (which == 0) {
      m_soup.points[random_point()][below(3)] = random_byte();
    } else if (which == 1) {
      shift(m_soup.points[random_point()]);
    } else if (which == 2) {
      align();
    } else if (which == 3) {
      m_soup.points[random_point()] = m_soup.points[random_point()];
    } else if (which == 4) {
      flatten();
    } else if (which == 5) {
      (below(2) == 0 ? m_soup.options : m_soup.maximum_number_of_sources) = random_byte();
    } else if (!m_soup.triangles.empty()) {
      change_triangles(which);
    }
  }

  void change_triangles(std::size_t which)
  {
    if (which == 6) {
      std::swap(random_triangle(), m_soup.triangles.back());
      m_soup.triangles.pop_back(); // a hole
    } else if (which == 7) {
      random_triangle()[below(3)] = std::uint8_t(random_point());
    } else if (which == 8) {
      flip();
    } else if (which == 9) {
      join();
    } else if (which == 10) {
      copy();
    } else {
      extrude();
    }
  }

  void shift(Triple& point)
  {
    for (std::uint8_t& coordinate : point) {
      coordinate = std::uint8_t(coordinate + small_step());
    }
  }

  /// Gives a point a coordinate of another one.
  void align()
  {
    const std::size_t axis = below(3);
    m_soup.points[random_point()][axis] = m_soup.points[random_point()][axis];
  }

  /// Halves all coordinates along an axis: bodies become thin.
  void flatten()
  {
    const std::size_t axis = below(3);
    for (Triple& point : m_soup.points) {
      point[axis] = std::uint8_t(std::int8_t(point[axis]) / 2);
    }
  }

  /// Lets a limb grow from a triangle, or divides it where the step is small.
  void extrude()
  {
    if (!has_room(3, 6)) {
      return;
    }
    Triple& base = random_triangle();
    const Triple step{small_step(), small_step(), small_step()};
    const Triple bottom = base;
    Triple top{};
    for (std::size_t i = 0; i < 3; ++i) {
      top[i] = std::uint8_t(m_soup.points.size());
      Triple point = m_soup.points[bottom[i]];
      std::transform(point.begin(), point.end(), step.begin(), point.begin(),
                     [](std::uint8_t a, std::uint8_t b) { return std::uint8_t(a + b); });
      m_soup.points.push_back(point);
    }
    base = top;
    add_tube(bottom, top);
  }

  /// Joins two triangles by a tube: a handle.
  void join()
  {
    const std::size_t a = below(m_soup.triangles.size());
    const std::size_t b = below(m_soup.triangles.size());
    if (a == b || !has_room(0, 4)) {
      return;
    }
    Triple end = m_soup.triangles[b];
    std::swap(end[0], end[1]);
    const Triple begin = m_soup.triangles[a];
    if (std::find_first_of(begin.begin(), begin.end(), end.begin(), end.end()) != begin.end()) {
      return;
    }
    m_soup.triangles.erase(m_soup.triangles.begin() + std::ptrdiff_t(std::max(a, b)));
    m_soup.triangles.erase(m_soup.triangles.begin() + std::ptrdiff_t(std::min(a, b)));
    add_tube(begin, end);
  }

  void add_tube(const Triple& bottom, const Triple& top)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      m_soup.triangles.push_back({bottom[i], bottom[next], top[next]});
      m_soup.triangles.push_back({bottom[i], top[next], top[i]});
    }
  }

  /// Flips the edge of two neighbors.
  void flip()
  {
    Triple& first = random_triangle();
    const std::size_t side = below(3);
    const std::uint8_t a = first[side];
    const std::uint8_t b = first[(side + 1) % 3];
    const std::uint8_t c = first[(side + 2) % 3];
    for (Triple& second : m_soup.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint8_t d = second[(i + 2) % 3];
        if (second[i] == b && second[(i + 1) % 3] == a && d != c) {
          first = {c, d, b};
          second = {d, c, a};
          return;
        }
      }
    }
  }

  /// Appends a copy of everything, moved: components, often through each other.
  void copy()
  {
    const std::size_t number_of_points = m_soup.points.size();
    const std::size_t number_of_triangles = m_soup.triangles.size();
    if (!has_room(number_of_points, number_of_triangles)) {
      return;
    }
    const Triple step{random_byte(), random_byte(), random_byte()};
    for (std::size_t i = 0; i < number_of_points; ++i) {
      const Triple point = m_soup.points[i];
      m_soup.points.push_back(
          {std::uint8_t(point[0] + step[0]), std::uint8_t(point[1] + step[1]), std::uint8_t(point[2] + step[2])});
    }
    for (std::size_t i = 0; i < number_of_triangles; ++i) {
      Triple triangle = m_soup.triangles[i];
      for (std::uint8_t& corner : triangle) {
        corner = std::uint8_t(corner + number_of_points);
      }
      m_soup.triangles.push_back(triangle);
    }
  }

  Coded_soup& m_soup;
  std::mt19937 m_generator;
};

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed)
{
  constexpr unsigned share_of_bytes = 8; // of so many mutations, one knows nothing of soups
  if (seed % share_of_bytes == 0) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  Coded_soup soup(data, size);
  Soup_mutation(soup, seed)();
  const std::vector<std::uint8_t> bytes = soup.bytes();
  const std::size_t result = std::min(bytes.size(), max_size);
  std::copy_n(bytes.begin(), result, data);
  return result;
}
