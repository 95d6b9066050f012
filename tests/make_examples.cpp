#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>

#include "figures/ink.h"

using namespace artisketch;
using namespace artisketch::figures;

int main(int, char** argv) {
  const Figure figure = hero();
  Camera camera;
  camera.type = Camera::Type::perspective;
  camera.distance = 6;
  camera.focal_length = 6 * 420;
  const double ground = 0.58 - 0.87;
  const std::vector<View> views = {
      view(figure, "front", about_y(0) ,
           {{"head", about_z(6)}, {"upper_arm.L", about_z(22)}, {"forearm.L", about_z(48)}, {"hand.L", about_z(-8)},
            {"upper_arm.R", about_z(58)}, {"forearm.R", about_y(45)}, {"thigh.L", about_z(9)}, {"thigh.R", about_z(-7)}, {"foot.L", about_z(-9) * about_y(18)}, {"foot.R", about_z(7) * about_y(-14)}},
           {0, ground, 0}),
      view(figure, "side", about_y(72),
           {{"chest", about_x(5)}, {"head", about_x(-6)*about_y(-14)},
            {"upper_arm.L", about_x(38) * about_z(-72)}, {"forearm.L", about_y(-50)},
            {"upper_arm.R", about_x(-42) * about_z(72)}, {"forearm.R", about_y(50)},
            {"thigh.L", about_x(-38)}, {"shin.L", about_x(22)}, {"foot.L", about_x(0)},
            {"thigh.R", about_x(26)}, {"shin.R", about_x(28)}, {"foot.R", about_x(6)}},
           {0, ground, 0}),
      view(figure, "three-quarter", about_y(-38),
           {{"chest", about_y(-8)}, {"head", about_y(14) * about_z(-5)},
            {"upper_arm.L", about_z(-48)}, {"forearm.L", about_y(-28)* about_z(-10)},
            {"upper_arm.R", about_y(50) * about_z(-22)}, {"forearm.R", about_z(-25)}, 
            {"thigh.L", about_z(13) * about_x(-6)}, {"shin.L", about_x(6)}, {"foot.L", about_z(-12)},
            {"thigh.R", about_z(-10) * about_x(4)}, {"foot.R", about_z(9)}},
           {0, ground, 0}),
  };
  for (const View& v : views) {
    const FrameCamera seen{camera, Vec2(320, 400), 1};
    const Image image = ink_drawing(figure, v.pose, seen, 640, 800);
    stbi_write_png((std::string(argv[1]) + "/hero_" + v.name + ".png").c_str(), 640, 800, 4, image.rgba.data(), 640 * 4);
  }
}
