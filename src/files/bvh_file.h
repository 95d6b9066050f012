// Biovision hierarchies (.bvh): recorded motions as text.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "document/motion.h"

namespace artisketch {

// Reads one hierarchy and its motion. Angles in degrees, rotations in the order of their channels;
// joints other than the root may have positions, which are not used. Fails, naming the line, on
// what is no BVH, numbers that are not finite or beyond ±1e6, joints of one name, motions without
// frames, and more than a thousand joints or 10 million numbers. `name` becomes the motion's;
// `file` is used in errors only.
Result<Motion> parse_bvh(std::string_view text, const std::string& name, const std::string& file);

Result<Motion> read_bvh(const std::string& path);  // named after the file

}  // namespace artisketch
