#include "app/outputs.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string_view>

#include <unistd.h>

#include "base/words.h"
#include "files/bytes.h"
#include "files/mesh_file.h"

namespace artisketch {
namespace {

// The ending of an output says what will be in it: another kind's would lie.
std::optional<std::string> wrong_ending(const std::vector<Target>& targets) {
  constexpr struct {
    std::string_view ending;
    std::optional<Kind> kind;  // none: nothing that is written here
  } kEndings[] = {{".png", Kind::picture},
                  {".json", Kind::report},
                  {".artisketch", Kind::document},
                  {".jpg", {}},
                  {".jpeg", {}},
                  {".gif", {}},
                  {".webp", {}},
                  {".bmp", {}},
                  {".tif", {}},
                  {".tiff", {}},
                  {".svg", {}},
                  {".pdf", {}},
                  {".gltf", {}},
                  {".fbx", {}},
                  {".bvh", {}},
                  {".zip", Kind::archive}};
  const std::string right[] = {model_endings(), ".artisketch", ".png", ".json", ".zip"};
  for (const Target& target : targets) {
    const std::string ending = lower_case(std::filesystem::path(target.path).extension().string());
    const auto wanted = [&] {
      return std::string(target.option) + " " + target.path + ": wanted a file that ends in " +
             right[int(target.kind)];
    };
    if (!model_ending(target.path).empty() && target.kind != Kind::model) return wanted();
    for (const auto& known : kEndings)
      if (ending == known.ending && known.kind != target.kind) return wanted();
  }
  return std::nullopt;
}

// What a run reads stays as it is, and two of its results don't go to one place.
std::optional<std::string> overwritten(const std::vector<Target>& targets,
                                       const std::vector<std::string>& inputs) {
  std::map<std::string, std::string> read, written;  // by what the file is, whatever it is called
  for (const std::string& input : inputs)
    if (!input.empty()) read.emplace(file_identity(input), input);
  for (const Target& target : targets) {
    const std::string identity = target.path.empty() ? "" : file_identity(target.path);
    if (identity.empty()) continue;
    const std::string said = std::string(target.option) + " " + target.path;
    if (const auto input = read.find(identity); input != read.end())
      return said + ": would replace what is read from " + input->second + "; name another file";
    const auto [other, is_new] = written.emplace(identity, target.option);
    if (!is_new) return said + ": is the file of " + other->second + ", too; name another";
  }
  return std::nullopt;
}

// A result that has nowhere to go is better known before the work than after it.
std::optional<Error> unwritable(const std::vector<Target>& targets) {
  for (const Target& target : targets) {
    const std::string& path = target.path;
    if (path.empty()) continue;
    std::error_code ignored;
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!std::filesystem::is_directory(folder, ignored))
      return io_error(path + ": the folder '" + folder.string() +
                      "' does not exist; make it, or name another");
    if (std::filesystem::is_directory(path, ignored))
      return io_error(path + ": is a folder; name a file in it");
    if (access(folder.c_str(), W_OK) != 0)
      return io_error(path + ": the folder '" + folder.string() + "' can't be written to");
  }
  return std::nullopt;
}

}  // namespace

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  switch (error.kind) {
    case Error::Kind::cancelled:
      return kStopped;
    case Error::Kind::io:
      return kNotWritten;
    case Error::Kind::bad_input:
    case Error::Kind::out_of_memory:
    case Error::Kind::crashed:
      break;
  }
  return kBadInput;
}

int bad_command_line(const std::string& words) {
  std::fprintf(stderr, "%s\n", words.c_str());
  return kBadCommandLine;
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    std::fprintf(stderr, "warning: %s\n", warning.c_str());
}

int judge_endings(const std::vector<Target>& targets) {
  const auto words = wrong_ending(targets);
  return words ? bad_command_line(*words) : kDone;
}

int judge_places(const std::vector<Target>& targets) {
  const auto error = unwritable(targets);
  return error ? fail(*error) : kDone;
}

int judge_overwriting(const std::vector<Target>& targets, const std::vector<std::string>& inputs) {
  const auto words = overwritten(targets, inputs);
  return words ? bad_command_line(*words) : kDone;
}

int write_all(const std::vector<Output>& outputs) {
  std::vector<NewFile> files;
  for (const Output& output : outputs) files.push_back({output.path, output.bytes});
  const Result<Done> written = write_files(files);
  return written ? kDone : fail(io_error(written.error().text()));
}

}  // namespace artisketch
