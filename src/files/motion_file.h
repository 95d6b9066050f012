// Recorded motions of whatever kind: Biovision hierarchies, and the animations of binary glTF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "document/motion.h"

namespace artisketch {

// Every animation of a .glb or .vrm that moves joints, by name: any program's, with or without a
// mesh. Joints are those of its skins and the animated nodes above them; without a skin, animated
// nodes and all below them. Where there is a skin, its bind pose is the rest pose. Joints' own axes
// at rest are left out: every pose is given against the rest pose, in the world's axes. Poses are
// taken at even steps, as fine as the longest channel's keys, 24 to 120 a second.
// Fails on what is no sound glTF, one without animations, one with more than a thousand joints or
// 10 million numbers. `name` is for animations without one; `file` is used in errors only.
Result<std::vector<Motion>> parse_glb_motions(std::string_view bytes, const std::string& name,
                                              const std::string& file);

// Its joints alone, in one pose: as they are bound.
Result<Motion> parse_glb_skeleton(std::string_view bytes, const std::string& name,
                                  const std::string& file);

bool is_motion(std::string_view bytes);  // by how it begins

// A BVH's one motion, or a glTF's: one or more.
Result<std::vector<Motion>> parse_motions(std::string_view bytes, const std::string& name,
                                          const std::string& file);
// One motion's skeleton, whether or not it moves: of a GLB without animations the bind pose is the
// one pose there is.
Result<Motion> read_skeleton(const std::string& path);
Result<std::vector<Motion>> read_motions(const std::string& path);  // named after the file

}  // namespace artisketch
