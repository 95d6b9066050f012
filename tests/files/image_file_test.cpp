#include "files/image_file.h"

#include <cstdio>

#include <gtest/gtest.h>

#include "files/bytes.h"

namespace artisketch {
namespace {

Image checks(int width, int height, std::uint8_t alpha) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* p = image.at(x, y);
      p[0] = std::uint8_t(x * 7);
      p[1] = std::uint8_t(y * 13);
      p[2] = std::uint8_t(x ^ y);
      p[3] = x == y ? alpha : 255;
    }
  return image;
}

// A baseline JPEG of 8 × 8 pixels, all of one dull red.
std::string red_jpeg() {
  return *from_base64(
      "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZG"
      "NywtQFdBRkxOUlNSMj5aYVpQYEpRUk//2wBDAQ4ODhMREyYVFSZPNS01T09PT09PT09PT09PT09PT09PT09PT09P"
      "T09PT09PT09PT09PT09PT09PT09PT09PT0//wAARCAAIAAgDASIAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAA"
      "AAX/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFQEBAQAAAAAAAAAAAAAAAAAABQb/xAAUEQEAAAAAAAAAAAAAAAAA"
      "AAAA/9oADAMBAAIRAxEAPwCEAOVL/9k=");
}

std::string with_bytes_at(std::string bytes, std::size_t at, std::string_view put) {
  return bytes.replace(at, put.size(), put);
}

TEST(ImageFile, PngComesBackPixelForPixel) {
  for (const std::uint8_t alpha : {255, 40}) {
    const Image image = checks(37, 21, alpha);
    const std::string png = png_bytes(image);
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(png[25], alpha == 255 ? 2 : 6);  // colour type: with alpha only where needed
    const Result<Image> read = decode_image(png, "x");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->width, 37);
    EXPECT_EQ(read->height, 21);
    EXPECT_EQ(read->rgba, image.rgba);
  }
}

TEST(ImageFile, AllPicturesOfAGifAreRead) {
  // 4 × 3 pixels, red, then blue.
  const std::string gif = *from_base64(
      "R0lGODlhBAADAPAAAP8AAAAAACH5BAAAAAAAIf8LTkVUU0NBUEUyLjADAQAAACwAAAAABAADAAACA4SPVgAh+QQAAAAA"
      "ACwAAAAABAADAIAAAP8AAAACA4SPVgA7");
  const Result<std::vector<Image>> read = decode_images(gif, "x");
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[0].width, 4);
  EXPECT_EQ((*read)[0].at(3, 2)[0], 255);
  EXPECT_EQ((*read)[1].at(0, 0)[2], 255);
  EXPECT_EQ((*read)[1].at(0, 0)[0], 0);
  for (std::size_t size = 0; size < gif.size(); ++size) {
    const auto part = decode_images(std::string_view(gif).substr(0, size), "x");
    EXPECT_LE(part ? part->size() : 0, 2u) << size;
  }
  const Result<std::vector<Image>> one = decode_images(png_bytes(checks(5, 4, 255)), "x");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->size(), 1u);
}

TEST(ImageFile, JpegIsRead) {
  const Result<Image> read = decode_image(red_jpeg(), "x");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->width, 8);
  const std::uint8_t* p = read->at(4, 4);
  EXPECT_NEAR(p[0], 180, 6);
  EXPECT_NEAR(p[1], 40, 6);
  EXPECT_NEAR(p[2], 30, 6);
  EXPECT_EQ(p[3], 255);
}

TEST(ImageFile, WhatIsNoImageIsRefusedByName) {
  const std::string png = png_bytes(checks(16, 16, 255));
  EXPECT_EQ(decode_image("hello", "a.png").error().text(),
            "a.png: is no PNG or JPEG image; save it again as PNG or JPEG");
  EXPECT_FALSE(decode_image("", "x"));
  EXPECT_FALSE(decode_image("GIF89a", "x"));
  // Cut off in its data; and 20000 pixels wide by its header.
  EXPECT_NE(decode_image(png.substr(0, 60), "x").error().text().find("damaged"), std::string::npos);
  const Result<Image> wide =
      decode_image(with_bytes_at(png, 16, std::string_view("\0\0\x4e\x20", 4)), "x");
  EXPECT_NE(wide.error().text().find("20000 × 16"), std::string::npos) << wide.error().text();
}

TEST(ImageFile, AFramesImageIsFoundBesideItsDocument) {
  const std::string folder = ::testing::TempDir();
  const Image image = checks(12, 9, 255);
  ASSERT_TRUE(write_file(folder + "/artisketch_frame.png", png_bytes(image)));
  Frame frame;
  frame.name = "side";
  frame.width = 12;
  frame.height = 9;
  EXPECT_EQ(load_frame_image(frame, folder + "/d.artisketch")->rgba.size(), 0u);
  frame.image = "artisketch_frame.png";
  const Result<Image> read = load_frame_image(frame, folder + "/d.artisketch");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->rgba, image.rgba);

  frame.width = 13;
  EXPECT_NE(load_frame_image(frame, folder + "/d.artisketch")
                .error()
                .text()
                .find("frame 'side': has 12 × 9 pixels, but the frame's size is 13 × 9"),
            std::string::npos);
  std::remove((folder + "/artisketch_frame.png").c_str());
  const Result<Image> gone = load_frame_image(frame, folder + "/d.artisketch");
  EXPECT_EQ(gone.error().kind, Error::Kind::bad_input);
  EXPECT_NE(gone.error().text().find("the image of frame 'side': "), std::string::npos);
}

TEST(ImageFile, AFramesImageMayStandInTheDocument) {
  const Image image = checks(5, 4, 255);
  Frame frame;
  frame.width = 5;
  frame.height = 4;
  frame.image = "data:image/png;base64," + base64(png_bytes(image));
  EXPECT_EQ(load_frame_image(frame, "d.artisketch")->rgba, image.rgba);
  frame.image = "data:image/png;base64,!!!!";
  EXPECT_FALSE(load_frame_image(frame, "d.artisketch"));
}

}  // namespace
}  // namespace artisketch
