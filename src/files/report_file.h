// `--report`: what a run did and how well it fits, as JSON.
//
//   stages[]       stage, seconds, sizes {name: count}
//   frames[]       frame, iou (silhouette against the union of its closed contours),
//                  parts[] {joint, contour_distance (symmetric mean, pixels)}
//   unseen_sides   hold (good, doubtful, guess: from sides that no drawing shows),
//                  parts[] {joint, hold, spread (degrees, 0 … 90, between lines of sight),
//                  disagreement (of the part's size, of views predicted from the others)}
//   calibration    energy_before, energy_after (pixels²), iterations,
//                  largest_rotation {joint, degrees}, largest_translation (units),
//                  scales[] (of orthographic frames),
//                  coverage[] {joint, frame, before, after} (share of a contour's rays that meet
//                  the part's hull), undetermined[], warnings[];
//                  null where poses were not calibrated
//   motion         clips[] {name, loops}, up (y, z), scale (units per unit of the motion),
//                  joints[] {joint, by (the motion's joint), how: given, named, guessed},
//                  still[] (joints that nothing moves), unused[] (the motion's that move nothing),
//                  warnings[]; null without --motion
//   model          vertices, triangles, joints
//   warnings[]     in words
//
// Of many documents at once:
//
//   documents[]    in, out, became (made, there already, failed, not begun), exit (its status),
//                  errors[] (in words), report (as above; null where none was made)
//
// Angles in degrees, as in documents. Frames are called by name, or by number (from 1) without one.
// Numbers that are not finite become null.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/rig/retarget.h"
#include "model/stages.h"

namespace artisketch {

// Of a whole run. `document` is what went in; with a file of motions, what became of each.
std::string report_text(const Document& document, const Reconstruction& result,
                        std::span<const MovedBy> moved = {});

// Of `artisketch calibrate`: one stage that took `seconds`.
std::string report_text(const Document& document, const Calibration& result,
                        const StageTime& stage);

// What became of one of many documents.
struct DocumentOutcome {
  enum class Became { not_begun, there_already, made, failed };
  std::string in, out;
  Became became = Became::not_begun;
  int exit = 0;
  std::vector<std::string> errors;
  std::string report;  // report_text() of it, or empty
};
std::string reports_text(const std::vector<DocumentOutcome>& outcomes);

}  // namespace artisketch
