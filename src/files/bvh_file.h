// Biovision hierarchies (.bvh): recorded motions as text.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "document/motion.h"

namespace artisketch {

// Reads one hierarchy and its motion, as programs write them: with or without a byte order mark,
// any ends of lines, words in any case, `Frames:2`, lines that begin with # or //. Angles in
// degrees, rotations in the order of their channels. Positions stand in place of a joint's offset;
// joints below the root whose positions are near zero where their offsets aren't have them beside
// it.
//
// The rows that are there count: where `Frames:` says another number, a warning does.
// Fails, naming the line, on what is no BVH, numbers that are not finite or beyond ±1e6, joints of
// one name, motions without frames, a row cut short, and more than a thousand joints or 10 million
// numbers. `name` becomes the motion's; `file` is used in errors only.
Result<Motion> parse_bvh(std::string_view text, const std::string& name, const std::string& file);

bool is_bvh(std::string_view bytes);  // by how it begins

}  // namespace artisketch
