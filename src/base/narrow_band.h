// A level set kept in a narrow band about its front, after Iwashita, Kurazume, Tsuji and Hasegawa
// (2004, "Fast implementation of level set method and its real-time applications"): speeds are
// worked out at the front alone, and every cell of the band moves with the front cell nearest to
// it. Distances are laid anew now and then, outward from the front and no farther than the band.
// (They stamp a sorted list of neighbours round each front cell; handing the front cell on from
// neighbour to neighbour finds nearly the same in half the time in three dimensions.)
// All lengths are in cells.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/grid.h"

namespace artisketch {

class NarrowBand {
 public:
  // φ: signed distance in cells, negative inside; what lies farther than half_width (≥ 2) from the
  // front only keeps its sign.
  NarrowBand(Grid3<float> phi, double half_width);

  // A sample beside the zero set: one of its six neighbours lies on the other side.
  struct Front {
    int index = 0;
    Index3 at;
    Vec3 normal;                // outward unit vector
    double distance = 0;        // ≥ 0, to the surface
    std::array<int, 3> across;  // by axis: the nearest front cell across the zero set, or −1
  };
  struct Cell {
    int index = 0;  // of the sample
    int front = 0;  // the front cell that it moves with
  };
  const Grid3<float>& phi() const { return phi_; }
  const std::vector<Front>& front() const { return front_; }  // ascending index
  const std::vector<Cell>& cells() const { return cells_; }   // ascending index

  // Value at the zero set beside front cell f of what is known at the front cells.
  double at_surface(int f, std::span<const float> at_front) const;

  // Mean curvature div n at a sample, at most ±1 (a grid can't tell more), positive on a ball.
  double curvature(const Front& f) const;

  // Moves the surface outward by `way` cells (one value for each front cell), nowhere beyond φ ≥
  // least(index), which may be +infinity. Lays the band anew once the front has gone half a cell in
  // all.
  template <class Least>
  void move(std::span<const float> way, const Least& least) {
    float longest = 0;
    for (const float w : way) longest = std::max(longest, std::abs(w));
    for (const Cell& cell : cells_) {
      float& value = phi_.values[cell.index];
      value = std::min(std::max(value - way[cell.front], least(cell.index)), kFar);
    }
    travelled_ += longest;
    if (travelled_ > kMostTravel) lay();
  }

  // Finds the front, and the distances and the band about it, from the signs and the zero set of φ.
  void lay();

 private:
  static constexpr double kMostTravel = 0.5;
  static constexpr float kFar = 1e6f;  // cells: φ stays a number where `least` is infinite
  void find_front();
  void carry_distances();
  float distance_to_piece(int f, const Index3& offset) const;
  Vec3 gradient(int index, const Index3& at) const;

  Grid3<float> phi_;
  double half_width_;
  double travelled_ = 0;
  std::vector<Front> front_;
  std::vector<Cell> cells_;
  std::vector<int> nearest_;  // by sample: its front cell; −1 outside the band
};

}  // namespace artisketch
