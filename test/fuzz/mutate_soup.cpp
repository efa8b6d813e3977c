// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mutations of polygon soups for libFuzzer: bytes that change at random are hardly ever a body any more; limbs that
// grow, handles and holes leave them surfaces.

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
  std::uint8_t small_step() { return std::uint8_t(below(31) - 15); }
  Triple& random_triangle() { return m_soup.triangles[below(m_soup.triangles.size())]; }
  bool has_room(std::size_t points, std::size_t triangles) const
  {
    return m_soup.points.size() + points <= Coded_soup::max_number_of_points &&
           m_soup.triangles.size() + triangles <= Coded_soup::max_number_of_triangles;
  }

  void change()
  {
    const std::size_t which = m_soup.triangles.empty() ? 0 : below(4);
    if (which == 0) {
      for (std::uint8_t& coordinate : m_soup.points[below(m_soup.points.size())]) {
        coordinate = std::uint8_t(coordinate + small_step());
      }
    } else if (which == 1) {
      std::swap(random_triangle(), m_soup.triangles.back());
      m_soup.triangles.pop_back(); // a hole
    } else if (which == 2) {
      join();
    } else {
      extrude();
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

  Coded_soup& m_soup;
  std::mt19937 m_generator;
};

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed)
{
  constexpr unsigned share_of_bytes = 2; // of so many mutations, one knows nothing of soups
  if (seed % share_of_bytes == 0) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  Coded_soup soup({data, size});
  Soup_mutation(soup, seed)();
  const std::vector<std::uint8_t> bytes = soup.bytes();
  const std::size_t result = std::min(bytes.size(), max_size);
  std::copy_n(bytes.begin(), result, data);
  return result;
}
