// The command line's words: every verb and option, with what it says of itself.
#include "app/command_table.h"

#include <cmath>
#include <map>

#include "app/version.h"
#include "files/document_file.h"
#include "model/rig/rig_profile.h"

namespace artisketch {
namespace {

void add_run_flags(CLI::App& verb, Arguments& a) {
  verb.add_option("--method", a.method, "paper: every step as published; rays: ours")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(kMethodNames), std::end(kMethodNames))));
  verb.add_option("--report", a.report, "what was done and how well it fits, as JSON");
  verb.add_option("--threads", a.threads,
                  "that work at once (default: all that the machine has); the result is the same")
      ->check(CLI::Range(1, 1024));
  verb.add_flag("--quiet", a.quiet, "print nothing but warnings and errors");
  verb.add_flag("--progress", a.progress, "show progress even where standard error is no terminal");
}

void add_reconstruct(CLI::App& app, Arguments& a) {
  CLI::App& make = *app.add_subcommand("reconstruct", "Make a rigged model from a sketch document");
  make.add_option("IN", a.documents, "the sketch documents (.artisketch)")->required();
  add_run_flags(make, a);
  make.add_option("-o,--output", a.out,
                  "the model to write (.glb; .vrm, an avatar; its surface alone: .obj, .stl, "
                  ".ply), or for many documents a folder/")
      ->required();
  make.add_option("--jobs", a.jobs, "documents worked on at once (default 1)")
      ->check(CLI::Range(1, 1024));
  make.add_flag("--skip-existing", a.skip_existing, "leave out what has its model already");
  make.add_option("--grid", a.grid, "cells along a part's longest side (default 100)")
      ->check(CLI::Range(kFewestCells, kMostCells));
  make.add_option("--triangles", a.triangles,
                  "of the model (default 15000), or auto: as few as half a pixel allows")
      ->transform(CLI::Validator(
          [](std::string& text) {
            if (text == "auto") return text = "0", std::string();
            return CLI::Range(100, 10000000)(text);
          },
          "auto or INT in [100 - 10000000]", "triangles"));
  make.add_flag("--no-calibrate", a.no_calibrate, "trust the document's poses");
  make.add_option("--motion", a.motion,
                  "recorded motions to add as clips (.bvh; .glb, .vrm: its animations)");
  make.add_option("--clip", a.clips,
                  "a clip of the library, like walk or walk:stride=1.2,bounce=0.5; again for more")
      ->allow_extra_args(false);
  std::vector<std::string> rigs;
  for (const RigProfile& profile : rig_profiles()) rigs.push_back(profile.name);
  make.add_option("--rig", a.rig, "name and complete a person's joints as an engine has them")
      ->check(CLI::IsMember(rigs));
  make.add_flag("--in-place", a.retarget.in_place, "leave out the motion's way over the ground");
  make.add_flag("--raw-feet{false}", a.retarget.plant_feet,
                "feet as the motion has them: they may slide and float");
  make.add_flag("--compress", a.compress,
                "a smaller .glb or .vrm, for three.js and its like: Godot refuses it");
  make.add_flag("--no-texture", a.no_texture, "leave the model plain");
  make.add_option("--calibrated", a.calibrated, "the document at the calibrated poses");
  make.add_option("--preview", a.preview,
                  "a contact sheet: drawings, result over them, four sides (.png)");
  make.add_option("--trace", a.trace,
                  "a folder for what is found on the way: meshes (.ply), curves (.obj), "
                  "fields (.nrrd)");
  make.add_flag("--visual-hull", a.visual_hull, "stop after carving: the plain hull of each part");
}

// Not CLI::Range, which lets nan through: no comparison with it holds.
CLI::Validator degrees_of_an_angle() {
  return CLI::Validator(
      [](const std::string& text) {
        double degrees = 0;
        const bool number = CLI::detail::lexical_cast(text, degrees);
        return number && std::abs(degrees) <= 1e6 ? "" : text + ": wanted a number of degrees";
      },
      "DEGREES");
}

void add_render(CLI::App& app, Arguments& a) {
  CLI::App& draw = *app.add_subcommand("render", "Draw a model to a picture");
  draw.add_option("IN", a.in, "the model (.glb)")->required();
  draw.add_option("-o,--output", a.out, "the picture (.png)")->required();
  draw.add_option("--frame", a.frame, "the pose of drawing N (default: the rest pose)")
      ->check(CLI::Range(1, 100000));
  draw.add_option("--yaw", a.yaw, "degrees about the vertical")->check(degrees_of_an_angle());
  draw.add_option("--pitch", a.pitch, "degrees about the horizontal")->check(degrees_of_an_angle());
  draw.add_option("--size", a.size, "WIDTHxHEIGHT in pixels (default 800x800)");
  draw.add_flag("--clear", a.clear, "nothing behind the model: a picture with transparency");
  draw.add_option("--turntable", a.turntable, "N pictures round the model, side by side")
      ->check(CLI::Range(1, 64));
}

void add_sprites(CLI::App& app, Arguments& a) {
  CLI::App& cut = *app.add_subcommand("sprites", "Draw a clip of a model as a sheet of sprites");
  cut.add_option("IN", a.in, "the model (.glb)")->required();
  cut.add_option("-o,--output", a.out, "the sheet (.png), or all its files in one (.zip)")
      ->required();
  cut.add_option("--json", a.json,
                 "where each sprite is, as Aseprite and TexturePacker say it "
                 "(default: beside the sheet)");
  cut.add_option("--clip", a.sprites.clip, "the clip, by its name in the model")->required();
  cut.add_option("--directions", a.sprites.directions, "sides it is seen from (default 8)")
      ->check(CLI::IsMember({1, 4, 8, 16}));
  cut.add_option("--size", a.sprites.size, "of a sprite's longer side in pixels (default 128)")
      ->check(CLI::Range(8, 1024));
  cut.add_option("--rate", a.sprites.rate, "pictures a second (default 12)")
      ->check(CLI::Range(1, 60));
  cut.add_option("--padding", a.sprites.padding, "pixels between sprites (default 0)")
      ->check(CLI::Range(0, 64));
  cut.add_option("--pitch", a.pitch, "degrees that it is seen from above")
      ->check(degrees_of_an_angle());
  cut.add_option("--light", a.sprites.light, "soft (default), toon: two tones, or plain: none")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Light>{
          {"soft", Light::soft}, {"plain", Light::plain}, {"toon", Light::toon}}));
  cut.add_flag("--no-ink{false}", a.sprites.ink, "no outline");
  cut.add_option("--pixels", a.sprites.pixels,
                 "pixel art in the drawings' colours: each pixel N by N, hard edges")
      ->check(CLI::Range(1, 16));
  cut.add_flag("--normals", a.sprites.normals, "a sheet of normals too (NAME_n.png)");
  cut.add_flag("--depth", a.sprites.depth, "a sheet of depths too (NAME_d.png)");
  cut.add_option("--layout", a.sprites.layout, "of the JSON: array (default), or hash, by name")
      ->transform(CLI::CheckedTransformer(std::map<std::string, SheetLayout>{
          {"array", SheetLayout::array}, {"hash", SheetLayout::hash}}));
}

void add_others(CLI::App& app, Arguments& a) {
  CLI::App& pose = *app.add_subcommand("calibrate", "Refine a document's poses and write it again");
  pose.add_option("IN", a.in, "the sketch document (.artisketch)")->required();
  add_run_flags(pose, a);
  pose.add_option("-o,--output", a.out, "the calibrated document (.artisketch)")->required();
  CLI::App& check = *app.add_subcommand("check", "Check a document and name its faults");
  check.add_option("IN", a.in, "the sketch document (.artisketch)")->required();
  check.add_flag("--quiet", a.quiet, "print nothing but errors");
  CLI::App& own = *app.add_subcommand("skeleton", "Begin a document with a skeleton of one's own");
  own.add_option("IN", a.in, "a rig or a motion (.glb, .vrm, .bvh)")->required();
  own.add_option("-o,--output", a.out, "the document (.artisketch)")->required();
  own.add_flag("--quiet", a.quiet, "print nothing but errors");
}

// What a package is made with.
void add_words(CLI::App& app, Arguments& a) {
  app.add_subcommand("manual", "Print the manual page (roff)");
  CLI::App& shell =
      *app.add_subcommand("completions", "Print what completes this command line in a shell");
  shell.add_option("SHELL", a.shell, "whose")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

}  // namespace

std::unique_ptr<CLI::App> command_table(Arguments& a) {
  auto app = std::make_unique<CLI::App>(
      "ArtiSketch: from a few drawings of a character to a 3D model that moves.", "artisketch");
  app->set_version_flag("--version", version_words());
  app->require_subcommand(1);
  add_reconstruct(*app, a);
  add_others(*app, a);
  add_render(*app, a);
  add_sprites(*app, a);
  add_words(*app, a);
  return app;
}

}  // namespace artisketch
