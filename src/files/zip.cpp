#include "files/zip.h"

#include <zlib.h>

#include "base/ensure.h"

namespace artisketch {
namespace {

void put_number(std::string& out, std::size_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += char(value >> (8 * i) & 255);
}

// What the head of a file and its entry in the directory have alike.
std::string common_head(const FileInside& file) {
  constexpr int kVersion = 20, kNamesAreUtf8 = 1 << 11, kStored = 0, kFirstOfJanuary1980 = 33;
  std::string head;
  put_number(head, kVersion, 2);
  put_number(head, kNamesAreUtf8, 2);
  put_number(head, kStored, 2);
  put_number(head, 0, 2);  // midnight
  put_number(head, kFirstOfJanuary1980, 2);
  put_number(head,
             crc32(0, reinterpret_cast<const Bytef*>(file.bytes.data()), uInt(file.bytes.size())),
             4);
  put_number(head, file.bytes.size(), 4);
  put_number(head, file.bytes.size(), 4);
  put_number(head, file.name.size(), 2);
  put_number(head, 0, 2);  // no extra field
  return head;
}

}  // namespace

std::string zip_bytes(const std::vector<FileInside>& files) {
  std::string out, directory;
  for (const FileInside& file : files) {
    ensure(out.size() + file.bytes.size() < 0xfff00000u && file.name.size() < 65536,
           "files that 32 bits can count");
    const std::string head = common_head(file);
    directory += "PK\1\2";
    put_number(directory, 20, 2);  // made by: no system in particular
    directory += head;
    put_number(directory, 0, 2 + 2 + 2);  // no comment, disk 0, no attributes
    put_number(directory, 0, 4);
    put_number(directory, out.size(), 4);
    directory += file.name;
    out += "PK\3\4" + head + file.name + file.bytes;
  }
  const std::size_t at = out.size();
  out += directory + "PK\5\6";
  put_number(out, 0, 4);  // disks
  put_number(out, files.size(), 2);
  put_number(out, files.size(), 2);
  put_number(out, directory.size(), 4);
  put_number(out, at, 4);
  put_number(out, 0, 2);  // no comment
  return out;
}

}  // namespace artisketch
