// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves junctions to the middle of the body.

#ifndef CSCD_SKELETON_CENTER_JUNCTIONS_H
#define CSCD_SKELETON_CENTER_JUNCTIONS_H

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>

namespace CSCD::internal {

/// A ball in the body.
struct Ball
{
  Vector_3 center = Vector_3::Zero();
  double radius = 0;
};

/// Grows an inscribed ball from `start`: steps away from the nearest point of the surface as long as the ball gets
/// larger, for at most `most_shift` in all. \tparam Traits a model of `TriangulatedSolidSkeletonizationTraits`
template <class Traits>
Ball inscribed_ball(const Traits& traits, const Vector_3& start, double most_shift)
{
  // More steps move a junction by less than a hundredth of its radius.
  constexpr int number_of_steps = 10;
  constexpr double first_step = 0.5;
  Vector_3 nearest = traits.closest_point(start).point;
  Ball ball{start, (start - nearest).norm()};
  double step = first_step;
  for (int i = 0; i < number_of_steps && ball.radius > 0; ++i) {
    const Vector_3 candidate = ball.center + step * (ball.center - nearest);
    const Vector_3 candidate_nearest = traits.closest_point(candidate).point;
    const double radius = (candidate - candidate_nearest).norm();
    if (radius <= ball.radius || (candidate - start).norm() > most_shift) {
      step /= 2;
      continue;
    }
    ball = {candidate, radius};
    nearest = candidate_nearest;
  }
  return ball;
}

/// Moves every junction of `draft` to the center of an inscribed ball nearby, at most by the largest radius around it.
/// \tparam Traits a model of `TriangulatedSolidSkeletonizationTraits`
template <class Traits>
void center_junctions(const Traits& traits, Skeleton_draft& draft)
{
  for (Index node = 0; node < draft.size(); ++node) {
    if (!draft.is_junction(node)) {
      continue;
    }
    double radius = 0;
    for (Index neighbor : draft[node].neighbors) {
      radius = std::max(radius, draft[neighbor].radius);
    }
    if (!traits.is_inside(draft[node].position)) {
      continue;
    }
    const Ball ball = inscribed_ball(traits, draft[node].position, radius);
    if (traits.is_inside(ball.center)) {
      draft[node].position = ball.center;
      draft[node].radius = ball.radius;
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_CENTER_JUNCTIONS_H
