#include "files/zip.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

std::size_t little(const std::string& bytes, std::size_t at, int count) {
  std::size_t value = 0;
  for (int i = count - 1; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// As an unpacker goes: from the end to the directory, from there to each file.
std::vector<FileInside> unpacked_files(const std::string& zip) {
  const std::size_t end = zip.size() - 22;
  EXPECT_EQ(zip.substr(end, 4), "PK\5\6");
  std::size_t entry = little(zip, end + 16, 4);
  EXPECT_EQ(entry + little(zip, end + 12, 4), end);
  std::vector<FileInside> files;
  for (std::size_t k = little(zip, end + 10, 2); k > 0; --k) {
    EXPECT_EQ(zip.substr(entry, 4), "PK\1\2");
    const std::size_t size = little(zip, entry + 24, 4), name = little(zip, entry + 28, 2),
                      at = little(zip, entry + 42, 4);
    EXPECT_EQ(zip.substr(at, 4), "PK\3\4");
    EXPECT_EQ(zip.substr(at + 4, 26), zip.substr(entry + 6, 26));  // both say the same
    files.push_back({zip.substr(at + 30, name), zip.substr(at + 30 + name, size)});
    EXPECT_EQ(files.back().name, zip.substr(entry + 46, name));
    entry += 46 + name;
  }
  return files;
}

TEST(Zip, HoldsTheFilesAsTheyAre) {
  const std::vector<FileInside> files{{"walk.png", std::string("\0\1PK\5\6\2", 7)},
                                      {"wälk.json", ""}};
  const std::string zip = zip_bytes(files);
  EXPECT_EQ(zip, zip_bytes(files));
  const std::vector<FileInside> found = unpacked_files(zip);
  ASSERT_EQ(found.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(found[i].name, files[i].name);
    EXPECT_EQ(found[i].bytes, files[i].bytes);
  }
  // CRC-32 of "123456789" is what its definition gives as the check.
  EXPECT_EQ(little(zip_bytes({{"a", "123456789"}}), 14, 4), 0xcbf43926u);
}

}  // namespace
}  // namespace artisketch
