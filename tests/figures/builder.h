// Puts a figure together joint by joint.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include "figures.h"

namespace artisketch::figures {

// Positions are in rest space.
class Builder {
 public:
  explicit Builder(std::string name) { figure_.name = std::move(name); }

  // Adds a joint at `place`; `bend` is how many degrees random poses turn it.
  int joint(const std::string& name, const std::string& parent, const Vec3& place, double bend,
            Solid part = {}) {
    Joint joint;
    joint.name = name;
    joint.parent = parent.empty() ? -1 : figure_.skeleton.find(parent);
    assert(parent.empty() || joint.parent >= 0);
    // Four decimals are plenty, and read well in a document.
    const Vec3 at = (1e4 * place).array().round() / 1e4;
    joint.offset = joint.parent < 0 ? at : Vec3(at - places_[joint.parent]);
    joint.offset = (1e4 * joint.offset).array().round() / 1e4;
    figure_.skeleton.joints.push_back(joint);
    places_.push_back(at);
    figure_.parts.push_back(std::move(part));
    figure_.freedom.push_back(radians(bend));
    return figure_.skeleton.size() - 1;
  }
  void tip(const std::string& name, const std::string& parent, const Vec3& place) {
    joint(name, parent, place, 0);
  }
  // Joints whose names differ in .L and .R mirror one another, all others themselves.
  void pair_mirrors() {
    for (int j = 0; j < figure_.skeleton.size(); ++j) {
      std::string other = figure_.skeleton.joints[j].name;
      if (const std::size_t dot = other.find_last_of('.');
          dot != std::string::npos && dot + 2 == other.size() &&
          (other[dot + 1] == 'L' || other[dot + 1] == 'R'))
        other[dot + 1] = other[dot + 1] == 'L' ? 'R' : 'L';
      figure_.skeleton.joints[j].mirror = figure_.skeleton.find(other);
    }
  }
  Figure take() { return std::move(figure_); }

 private:
  Figure figure_;
  std::vector<Vec3> places_;
};

}  // namespace artisketch::figures
