// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The visitor through which the program hears of progress.

#ifndef CSCD_PROGRAM_PROGRESS_VISITOR_H
#define CSCD_PROGRAM_PROGRESS_VISITOR_H

#include "Progress_bar.h"
#include <CSCD/Skeletonization_visitor.h>

namespace cscd {

/// Passes progress on to a bar, if there is one.
class Progress_visitor : public CSCD::Default_skeletonization_visitor
{
public:
  /// \param bar outlives the visitor, or is null
  explicit Progress_visitor(Progress_bar* bar) : m_bar(bar) {}

  void on_stage_begin(CSCD::Skeletonization_stage stage)
  {
    m_stage = stage;
    progress(0);
  }

  void progress(double fraction)
  {
    if (m_bar != nullptr) {
      m_bar->show(m_stage, fraction);
    }
  }

private:
  Progress_bar* m_bar;
  CSCD::Skeletonization_stage m_stage = CSCD::Skeletonization_stage::compile_surface;
};

} // namespace cscd

#endif // CSCD_PROGRAM_PROGRESS_VISITOR_H
