// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor that cannot be asked whether to continue is refused.
// expected error: CSCD: SkeletonizationVisitor requires v.go_further(), convertible to bool

#include <CSCD/concepts.h>

struct Visitor
{
  void on_stage_begin(CSCD::Skeletonization_stage stage);
  void on_stage_end(CSCD::Skeletonization_stage stage);
  void progress(double fraction);
};

int main()
{
  CSCD::check_skeletonization_visitor<Visitor>();
}
