#include "files/image_file.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>
#include <zlib.h>

#include "files/bytes.h"
#include "model/working_scale.h"

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

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift & 255);
  return bytes;
}

// A chunk of a PNG, its check sum right.
std::string chunk(const std::string& kind, const std::string& body) {
  const std::string summed = kind + body;
  const auto* data = reinterpret_cast<const unsigned char*>(summed.data());
  return big_endian(body.size()) + summed + big_endian(crc32(0, data, unsigned(summed.size())));
}

// Exif of one entry, in either order of bytes.
std::string exif(int orientation, bool little) {
  using namespace std::string_literals;
  const char value = char(orientation);
  return little ? "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0"s + value + "\0\0\0\0\0\0\0"s
                : "MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0"s + value + "\0\0\0\0\0\0"s;
}

// Where the pixel that is stored at (u, v) is to be seen, by the words of the standard: what the
// 0th row and the 0th column are.
std::array<int, 2> seen_at(int orientation, int u, int v, int w, int h) {
  switch (orientation) {
    case 1:
      return {u, v};  // top, left
    case 2:
      return {w - 1 - u, v};  // top, right
    case 3:
      return {w - 1 - u, h - 1 - v};  // bottom, right
    case 4:
      return {u, h - 1 - v};  // bottom, left
    case 5:
      return {v, u};  // left, top
    case 6:
      return {h - 1 - v, u};  // right, top
    case 7:
      return {h - 1 - v, w - 1 - u};  // right, bottom
    default:
      return {v, w - 1 - u};  // left, bottom
  }
}

TEST(ImageFile, PicturesStandAsTheirExifSays) {
  const Image image = checks(7, 4, 255);
  const std::string png = png_bytes(image);
  for (const bool little : {false, true})
    for (int orientation = 1; orientation <= 8; ++orientation) {
      const std::size_t end = png.rfind("IEND") - 4;
      const Result<Image> read = decode_image(
          png.substr(0, end) + chunk("eXIf", exif(orientation, little)) + png.substr(end), "x");
      ASSERT_TRUE(read) << read.error().text();
      ASSERT_EQ(read->width, orientation < 5 ? 7 : 4);
      ASSERT_EQ(read->height, orientation < 5 ? 4 : 7);
      for (int v = 0; v < 4; ++v)
        for (int u = 0; u < 7; ++u) {
          const auto [x, y] = seen_at(orientation, u, v, 7, 4);
          for (int c = 0; c < 4; ++c)
            ASSERT_EQ(read->at(x, y)[c], image.at(u, v)[c]) << orientation;
        }
    }
  // What an Exif says that is no orientation, or is cut off, turns nothing.
  for (const std::string& odd : {exif(9, true), exif(6, true).substr(0, 15), std::string("II*")}) {
    const Result<Image> read =
        decode_image(png.substr(0, png.rfind("IEND") - 4) + chunk("eXIf", odd) +
                         png.substr(png.rfind("IEND") - 4),
                     "x");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->rgba, image.rgba);
  }
}

// 16 × 8 pixels, the left half red and the right half blue (or dark and light grey), as programs,
// phones and scanners write them.
TEST(ImageFile, PicturesOfEveryKindAreRead) {
  const std::pair<const char*, const char*> kinds[] = {
      {"jpeg turned",
       "/9j/4AAQSkZJRgABAQAAAQABAAD/4QAiRXhpZgAATU0AKgAAAAgAAQESAAMAAAABAAYAAAAAAAD/"
       "2wBDAA0JCgsKCA0L"
       "CgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywtQFdBRkxOUlNSMj5aYVpQYEpRUk//"
       "2wBDAQ4ODhMREyYV"
       "FSZPNS01T09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT0//"
       "wAARCAAIABADASIA"
       "AhEBAxEB/8QAHwAAAQUBAQEBAQEAAAAAAAAAAAECAwQFBgcICQoL/"
       "8QAtRAAAgEDAwIEAwUFBAQAAAF9AQIDAAQRBRIh"
       "MUEGE1FhByJxFDKBkaEII0KxwRVS0fAkM2JyggkKFhcYGRolJicoKSo0NTY3ODk6Q0RFRkdISUpTVFVWV1hZWmNkZWZ"
       "n"
       "aGlqc3R1dnd4eXqDhIWGh4iJipKTlJWWl5iZmqKjpKWmp6ipqrKztLW2t7i5usLDxMXGx8jJytLT1NXW19jZ2uHi4+"
       "Tl"
       "5ufo6erx8vP09fb3+Pn6/8QAHwEAAwEBAQEBAQEBAQAAAAAAAAECAwQFBgcICQoL/"
       "8QAtREAAgECBAQDBAcFBAQAAQJ3"
       "AAECAxEEBSExBhJBUQdhcRMiMoEIFEKRobHBCSMzUvAVYnLRChYkNOEl8RcYGRomJygpKjU2Nzg5OkNERUZHSElKU1R"
       "V"
       "VldYWVpjZGVmZ2hpanN0dXZ3eHl6goOEhYaHiImKkpOUlZaXmJmaoqOkpaanqKmqsrO0tba3uLm6wsPExcbHyMnK0tP"
       "U"
       "1dbX2Nna4uPk5ebn6Onq8vP09fb3+Pn6/9oADAMBAAIRAxEAPwDGrJoor0uHv+Xny/U9fPP+Xfz/AEP/2Q=="},
      {"progressive jpeg",
       "/9j/4AAQSkZJRgABAQAAAQABAAD/"
       "2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywt"
       "QFdBRkxOUlNSMj5aYVpQYEpRUk//"
       "2wBDAQ4ODhMREyYVFSZPNS01T09PT09PT09PT09PT09PT09PT09PT09PT09PT09P"
       "T09PT09PT09PT09PT09PT09PT0//wgARCAAIABADASIAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAAAAT/"
       "xAAUAQEA"
       "AAAAAAAAAAAAAAAAAAAE/9oADAMBAAIQAxAAAAGKQSv/xAAUEAEAAAAAAAAAAAAAAAAAAAAQ/9oACAEBAAEFAj//"
       "xAAW"
       "EQADAAAAAAAAAAAAAAAAAAAABEL/2gAIAQMBAT8Bek//xAAWEQADAAAAAAAAAAAAAAAAAAAABUL/"
       "2gAIAQIBAT8BX0f/"
       "xAAUEAEAAAAAAAAAAAAAAAAAAAAQ/9oACAEBAAY/Aj//xAAUEAEAAAAAAAAAAAAAAAAAAAAQ/9oACAEBAAE/IT//"
       "2gAM"
       "AwEAAgADAAAAEPf/xAAVEQEBAAAAAAAAAAAAAAAAAADBAP/aAAgBAwEBPxBC/"
       "8QAFREBAQAAAAAAAAAAAAAAAAAAwQD/"
       "2gAIAQIBAT8QJv/EABQQAQAAAAAAAAAAAAAAAAAAABD/2gAIAQEAAT8QP//Z"},
      {"cmyk jpeg",
       "/9j/7gAOQWRvYmUAZAAAAAAA/"
       "9sAQwANCQoLCggNCwoLDg4NDxMgFRMSEhMnHB4XIC4pMTAuKS0sMzpKPjM2RjcsLUBX"
       "QUZMTlJTUjI+WmFaUGBKUVJP/8AAFAgACAAQBEMRAE0RAFkRAEsRAP/"
       "EAB8AAAEFAQEBAQEBAAAAAAAAAAABAgMEBQYH"
       "CAkKC//"
       "EALUQAAIBAwMCBAMFBQQEAAABfQECAwAEEQUSITFBBhNRYQcicRQygZGhCCNCscEVUtHwJDNicoIJChYXGBka"
       "JSYnKCkqNDU2Nzg5OkNERUZHSElKU1RVVldYWVpjZGVmZ2hpanN0dXZ3eHl6g4SFhoeIiYqSk5SVlpeYmZqio6Slpqe"
       "o"
       "qaqys7S1tre4ubrCw8TFxsfIycrS09TV1tfY2drh4uPk5ebn6Onq8fLz9PX29/j5+v/"
       "aAA4EQwBNAFkASwAAPwDua4Ou"
       "Dr06vCqK91or/9k="},
      {"palette png",
       "iVBORw0KGgoAAAANSUhEUgAAABAAAAAICAMAAADHqI+"
       "lAAADAFBMVEXcHh4eHtwAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
       "A"
       "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACpHTzAAAAEUlEQVR4nGNggAJ"
       "G"
       "KGAYGAEAEIgAQc3kErgAAAAASUVORK5CYII="},
      {"grey with alpha png",
       "iVBORw0KGgoAAAANSUhEUgAAABAAAAAICAQAAABaf7ccAAAAGElEQVR4nGPU+M+"
       "AAhagchmYGAiA4aEAANHJAde6mCtk"
       "AAAAAElFTkSuQmCC"},
      {"interlaced png",
       "iVBORw0KGgoAAAANSUhEUgAAABAAAAAICAIAAAEIE9hWAAAAP0lEQVQY02O4IycnJ3eHAUIx3pGTY2BgcGLYx8DAgMJ"
       "h"
       "YkACUBkIgMhDAIoqynSQLoFiBzJAto8ok0i2mmoaAIUpDu40X+dqAAAAAElFTkSuQmCC"},
      {"16 bit png",
       "iVBORw0KGgoAAAANSUhEUgAAABAAAAAIEAIAAAAvhDSDAAAAJklEQVQoz2O8c0dOTk6OgWjg5MTAsG8f8eqZiFdKHhi"
       "1"
       "YNQCygEAX9wEQBQYdTgAAAAASUVORK5CYII="},
      {"animated png",
       "iVBORw0KGgoAAAANSUhEUgAAABAAAAAICAIAAAB/"
       "FOjAAAAACGFjVEwAAAACAAAAAPONk3AAAAAaZmNUTAAAAAAAAAAQ"
       "AAAACAAAAAAAAAAAAAAD6AAAbR4efQAAAB1JREFUeJxjvCMnx4ANODHswyrOhFUUDxjVQAwAACbHAigxTTPVAAAAGmZ"
       "j"
       "VEwAAAABAAAAEAAAAAgAAAAAAAAAAAAAA+"
       "gAAPZt9KkAAAASZmRBVAAAAAJ4nGNgGAWDAQAAAYgAAduraWcAAAAASUVO"
       "RK5CYII="},
  };
  for (const auto& [kind, bytes] : kinds) {
    SCOPED_TRACE(kind);
    const Result<Image> read = decode_image(*from_base64(bytes), "x");
    ASSERT_TRUE(read) << read.error().text();
    const bool turned = std::string(kind) == "jpeg turned", grey = kind[0] == 'g';
    ASSERT_EQ(read->width, turned ? 8 : 16);
    ASSERT_EQ(read->height, turned ? 16 : 8);
    const std::uint8_t* first = turned ? read->at(4, 2) : read->at(2, 4);
    const std::uint8_t* last = turned ? read->at(4, 13) : read->at(13, 4);
    EXPECT_NEAR(first[0], grey ? 40 : 220, 12);
    EXPECT_NEAR(first[2], grey ? 40 : 30, 12);
    EXPECT_NEAR(last[0], grey ? 200 : 30, 12);
    EXPECT_NEAR(last[2], grey ? 200 : 220, 12);
    EXPECT_EQ(first[3], 255);
  }
}

// A few kilobytes that hold 40 MB of rows, where 256 × 256 pixels have a quarter of one.
TEST(ImageFile, APictureThatInflatesBeyondItsSizeIsRefused) {
  using namespace std::string_literals;
  const std::string rows(40 << 20, '\0');
  std::string packed(compressBound(rows.size()), '\0');
  uLongf size = packed.size();
  ASSERT_EQ(compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                      reinterpret_cast<const Bytef*>(rows.data()), rows.size(), 1),
            Z_OK);
  packed.resize(size);
  const std::string png = "\x89PNG\r\n\x1a\n" + chunk("IHDR", "\0\0\1\0\0\0\1\0\x08\x02\0\0\0"s) +
                          chunk("IDAT", packed) + chunk("IEND", "");
  const Result<Image> read = decode_image(png, "x");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("memory"), std::string::npos) << read.error().text();
}

// stb has room for 256 codes, and writes on.
TEST(ImageFile, AJpegWithATableOfTooManyCodesIsRefused) {
  std::string jpeg = red_jpeg();
  const std::size_t table = jpeg.find("\xff\xc4");
  ASSERT_NE(table, jpeg.npos);
  std::string segment("\xff\xc4", 2);
  const std::size_t codes = 16 * 255;
  segment += char((19 + codes) >> 8);
  segment += char((19 + codes) & 255);
  segment += '\0';
  segment += std::string(16, '\xff') + std::string(codes, '\0');
  EXPECT_FALSE(decode_image(jpeg.substr(0, table) + segment + jpeg.substr(table), "x"));
  // Nor where what begins it isn't quite what begins a JPEG, which stb takes for one all the same.
  EXPECT_FALSE(decode_image("\xff" + jpeg.substr(0, table) + segment + jpeg.substr(table), "x"));
}

TEST(ImageFile, APictureCutOffAnywhereIsReadOrRefused) {
  const std::string png = png_bytes(checks(5, 4, 40)), jpeg = red_jpeg();
  for (const std::string& whole : {png, jpeg})
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Result<std::vector<Image>> read = decode_images(whole.substr(0, size), "x");
      EXPECT_TRUE(!read || read->size() == 1) << size;
      (void)colour_profile(whole.substr(0, size));
    }
}

TEST(ImageFile, ASizeThatNobodyDrawsIsNamedNotDecoded) {
  const std::string png = png_bytes(checks(16, 16, 255));
  for (const char* side : {"\0\0\xea\x60", "\x7f\xff\xff\xff", "\xff\xff\xff\xff"}) {
    const std::string_view bytes(side, 4);
    const Result<Image> read =
        decode_image(with_bytes_at(with_bytes_at(png, 16, bytes), 20, bytes), "x");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().text().find("too many"), std::string::npos) << read.error().text();
  }
}

TEST(ImageFile, DrawingsBeyondWhatMemoryShouldHoldAreNotRead) {
  Document document;
  document.frames.resize(3);
  for (Frame& frame : document.frames) {
    frame.name = "wall";
    frame.width = frame.height = 10000;
    frame.image = "none.png";
  }
  std::vector<std::string> warnings;
  EXPECT_EQ(load_drawings(document, "d.artisketch", warnings).size(), 3u);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(warnings[1].find("250 million"), std::string::npos);
  EXPECT_NE(warnings[2].find("250 million pixels in all"), std::string::npos);
}

// Read at a half, a drawing is what it would be if it were read whole and then shrunk: counted from
// the corner that is seen at the top left.
TEST(ImageFile, ADrawingIsReadAtTheSizeThatIsNeeded) {
  for (const std::uint8_t alpha : {255, 40})
    for (const int orientation : {1, 3, 6}) {
      const std::string png = png_bytes(checks(7, 5, alpha));
      const std::size_t end = png.rfind("IEND") - 4;
      const std::string turned =
          png.substr(0, end) + chunk("eXIf", exif(orientation, true)) + png.substr(end);
      Frame frame;
      frame.name = "side";
      frame.image = "data:image/png;base64," + base64(turned);
      frame.width = orientation == 6 ? 5 : 7;
      frame.height = orientation == 6 ? 7 : 5;
      const Result<Image> whole = load_frame_image(frame, ""),
                          half = load_frame_image(frame, "", 2);
      ASSERT_TRUE(whole && half) << half.error().text();
      EXPECT_EQ(half->width, (frame.width + 1) / 2);
      EXPECT_EQ(half->rgba, scaled(*whole, 0.5).rgba);
      std::swap(frame.width, frame.height);
      EXPECT_NE(load_frame_image(frame, "", 2).error().text().find("frame's size"),
                std::string::npos);
    }
}

TEST(ImageFile, APathThatLeavesTheDocumentsFolderIsSeen) {
  for (const char* path : {"../a.png", "x/../../a.png", "./../a.png", "/a.png", ".."})
    EXPECT_TRUE(leaves_folder(path)) << path;
  for (const char* path : {"a.png", "x/../a.png", "..a.png", "x//y/.././a.png", "data:../x", ""})
    EXPECT_FALSE(leaves_folder(path)) << path;
}

TEST(ImageFile, NoPathLeadsOutOfTheDocumentsFolder) {
  const std::string folder = ::testing::TempDir() + "/artisketch_inner";
  std::filesystem::create_directory(folder);
  const std::string outside = ::testing::TempDir() + "/artisketch_outside.png";
  ASSERT_TRUE(write_file(outside, png_bytes(checks(12, 9, 255))));
  Frame frame;
  frame.name = "side";
  frame.width = 12;
  frame.height = 9;
  for (const std::string& path : {std::string("../artisketch_outside.png"), outside}) {
    frame.image = path;
    const Result<Image> read = load_frame_image(frame, folder + "/d.artisketch");
    ASSERT_FALSE(read) << path;
    EXPECT_NE(read.error().text().find("'side' lies outside the document's folder: " + path),
              std::string::npos)
        << read.error().text();
  }
  std::filesystem::create_symlink("../artisketch_outside.png", folder + "/link.png");
  frame.image = "link.png";  // which its owner put there
  EXPECT_TRUE(load_frame_image(frame, folder + "/d.artisketch"));
  std::filesystem::remove_all(folder);
  std::filesystem::remove(outside);
}

TEST(ImageFile, AColourProfileThatIsNotUsedIsNamed) {
  const std::string png = png_bytes(checks(4, 4, 255));
  const std::size_t at = png.find("IDAT") - 4;
  const auto with = [&](const std::string& name) {
    return png.substr(0, at) + chunk("iCCP", name + std::string("\0\0x", 3)) + png.substr(at);
  };
  EXPECT_EQ(colour_profile(png), "");
  EXPECT_EQ(colour_profile(with("Display P3")), "Display P3");
  EXPECT_EQ(colour_profile(with("sRGB IEC61966-2.1")), "");
}

}  // namespace
}  // namespace artisketch
