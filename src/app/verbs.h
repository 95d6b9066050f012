// The command line's verbs: each takes what was said after its name, says what it did, and returns
// the exit status (outputs.h). cli.cpp reads the words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/sprites.h"
#include "model/rig/retarget.h"
#include "model/stages.h"

namespace artisketch {

struct Arguments {
  std::string in, out, calibrated, report, preview, trace, motion, method, size = "800x800";
  std::optional<int> grid, triangles;
  bool no_calibrate = false, no_texture = false, visual_hull = false, quiet = false,
       progress = false, compress = false;
  std::vector<std::string> documents;  // of reconstruct, which takes many; each is `in` in its turn
  bool skip_existing = false;
  int jobs = 1;
  std::optional<int> threads;  // of each; as many as the machine runs at once
  int frame = 0, turntable = 0;
  bool clear = false;
  double yaw = 0, pitch = 0;
  RetargetOptions retarget;
  std::vector<std::string> clips;
  SpriteOptions sprites;
  std::string json, rig, shell;
};

int reconstruct_verb(Arguments& a);
// Of one document, a.in; with its report's text, too, where that is wanted.
int reconstruct_one(Arguments& a, std::string* report = nullptr);
int calibrate_verb(const Arguments& a);
int check_verb(const Arguments& a);
int skeleton_verb(const Arguments& a);
int render_verb(const Arguments& a);
int sprites_verb(Arguments& a);

// ---------------------------------------------------------------- what several of them need

// A document that can be worked on; it and the files of its drawings.
Result<Document> sound_document(const std::string& path);
std::vector<std::string> files_of(const Document& document, const std::string& path);

// The document's settings, and the flags over them.
PipelineOptions options_of(const Arguments& a, const Document& document);
bool shows_progress(const Arguments& a);

// The document's text for a file at `to`: drawings are named relative to the file that names them,
// or go into it where that would lead out of its folder.
std::string text_beside(Document document, const std::string& from, const std::string& to);

// What a stage finds wrong says of which file: it knows none.
Error said_of(const std::string& file, Error error);

std::string seconds_text(double seconds);

}  // namespace artisketch
