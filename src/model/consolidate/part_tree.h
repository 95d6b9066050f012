// How the drawn parts hang together: which hangs on which, and the lines that they lie along.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "model/stages.h"

namespace artisketch {

struct Segment {
  Vec3 a, b;
  // The parameter 0 … 1 of the point of the segment nearest to p.
  double nearest(const Vec3& p) const {
    const Vec3 d = b - a;
    const double l2 = d.squaredNorm();
    return l2 > 0 ? std::clamp((p - a).dot(d) / l2, 0.0, 1.0) : 0;
  }
  Vec3 at(double t) const { return a + t * (b - a); }
  double distance(const Vec3& p) const { return (p - at(nearest(p))).norm(); }
};

// Parts are counted as in the span that part_tree was given; parts without a sampled inside are
// left out of everything.
struct PartTree {
  struct Node {
    bool solid = false;    // has an inside
    int parent = -1;       // the part it hangs on: of its nearest drawn ancestor, else the first
                           // part it meets at joints without contours; −1 for one alone
    Vec3 joint;            // rest position of its joint
    Vec3 deepest;          // where its distance is least
    double thickness = 0;  // twice its greatest depth, units, as far as its samples are true
    double width = 0;      // of the largest ball inside it, units, roughly
    double area = 0;       // of its surface, units², roughly
    std::vector<Segment> axes;  // its bones; without any, from the joint to the far end
  };
  std::vector<Node> nodes;
  // Whether two parts meet at a joint: one hangs on the other.
  bool adjacent(int i, int j) const { return adjacent_pairs[i * int(nodes.size()) + j]; }
  std::vector<char> adjacent_pairs;
  // The part next to i on the way to j.
  int step(int i, int j) const { return steps[i * int(nodes.size()) + j]; }
  std::vector<int> steps;
};

PartTree part_tree(const Document& document, std::span<const PartSurface> parts);

// As joint_spheres of stages.h, where the tree is at hand.
std::vector<JointSphere> joint_spheres(const Document& document, std::span<const PartSurface> parts,
                                       const PartTree& tree);

}  // namespace artisketch
