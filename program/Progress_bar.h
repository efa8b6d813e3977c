// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A progress bar on a terminal.

#ifndef CSCD_PROGRAM_PROGRESS_BAR_H
#define CSCD_PROGRAM_PROGRESS_BAR_H

#include "types.h"
#include <CSCD/Skeletonization_visitor.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>

namespace cscd {

/// Draws a bar that fills while a skeletonization runs, and removes it when it is destroyed.
class Progress_bar
{
public:
  explicit Progress_bar(std::ostream& out) : m_out(out) {}
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;
  ~Progress_bar() { m_out << '\r' << std::string(width + 40, ' ') << '\r' << std::flush; }

  void show(CSCD::Skeletonization_stage stage, double fraction)
  {
    const auto index = static_cast<std::size_t>(stage);
    double done = share[index] * fraction;
    for (std::size_t i = 0; i < index; ++i) {
      done += share[i];
    }
    const auto percent = static_cast<int>(100 * done);
    if (percent == m_percent && stage == m_stage) {
      return;
    }
    m_percent = percent;
    m_stage = stage;
    draw();
  }

private:
  static constexpr std::size_t width = 30; ///< characters
  /// The parts of the running time that the stages take on a mesh of 50,000 vertices, roughly.
  static constexpr std::array<double, CSCD::number_of_skeletonization_stages> share{0.2, 0.6, 0.1, 0.1};

  void draw()
  {
    const std::size_t filled = width * static_cast<std::size_t>(m_percent) / 100;
    m_out << "\r[" << std::string(filled, '#') << std::string(width - filled, '.') << "] " << m_percent << " % "
          << CSCD::name(m_stage) << "   " << std::flush;
  }

  std::ostream& m_out;
  int m_percent = -1;
  CSCD::Skeletonization_stage m_stage = CSCD::Skeletonization_stage::compile_surface;
};

/// Passes progress on to a function, if given.
class Progress_visitor : public CSCD::Default_skeletonization_visitor
{
public:
  /// \param progress is referred to
  explicit Progress_visitor(const Stage_progress& progress) : m_progress(progress) {}

  void on_stage_begin(CSCD::Skeletonization_stage stage)
  {
    m_stage = stage;
    progress(0);
  }

  void progress(double fraction)
  {
    if (m_progress) {
      m_progress(m_stage, fraction);
    }
  }

private:
  const Stage_progress& m_progress;
  CSCD::Skeletonization_stage m_stage = CSCD::Skeletonization_stage::compile_surface;
};

} // namespace cscd

#endif // CSCD_PROGRAM_PROGRESS_BAR_H
