#include "editor/harness.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <stdexcept>

#include <gtest/gtest.h>

#include "app/job_bytes.h"
#include "editor/ui/fonts.h"
#include "editor/ui/keys.h"
#include "files/bytes.h"
#include "files/image_file.h"
#include "files/inside_images.h"

namespace artisketch {
namespace {

constexpr int kCoarse = 20;  // cells: what is asked of the editor doesn't depend on it

bool is_of_the_gallery(const std::string& name) {
  return std::filesystem::exists(ARTISKETCH_SOURCE_DIR "/assets/gallery/" + name);
}

std::string example_path(const std::string& name) {
  return std::string(ARTISKETCH_SOURCE_DIR "/assets/") +
         (is_of_the_gallery(name) ? "gallery/" : "examples/") + name + "/" + name + ".artisketch";
}

// One check for all of them: there are tens of thousands in every frame.
bool all_below(std::span<const unsigned> numbers, std::size_t limit) {
  return std::all_of(numbers.begin(), numbers.end(), [=](unsigned n) { return n < limit; });
}

// Jobs are pure: the same request gives the same outcome.
Result<JobResult> outcome_of(JobRequest request) {
  static std::map<std::string, Result<JobResult>> known;
  request.options.grid = std::min(request.options.grid, kCoarse);
  const std::string bytes = job_bytes(request);
  const auto found = known.find(bytes);
  if (found != known.end()) return found->second;
  Run run;
  return known.emplace(bytes, run_job(request, run)).first->second;
}

}  // namespace

std::string example_document(const std::string& name) {
  const Result<std::string> text = read_file(example_path(name));
  if (!text) throw std::runtime_error(text.error().text());
  const Result<std::string> whole = with_images_inside(*text, example_path(name));
  if (!whole) throw std::runtime_error(whole.error().text());
  return *whole;
}

std::string example_model(const std::string& name) {
  JobRequest request;
  request.document = example_document(name);
  request.options.grid = kCoarse;
  request.options.triangles = 2000;
  const Result<JobResult> made = outcome_of(request);
  if (!made) throw std::runtime_error(made.error().text());
  return made->glb;
}

// ---------------------------------------------------------------- the platform

void MemoryPlatform::open_files(Kind kind, Opened then) {
  asked.push_back(kind);
  if (to_open.empty()) return;
  Result<std::vector<NamedBytes>> answer = std::move(to_open.front());
  to_open.pop_front();
  then(std::move(answer));
}

void MemoryPlatform::save_file(const std::string& name, const std::string& place, std::string bytes,
                               std::function<void(Result<Saved>)> then) {
  if (no_saving) return then(*no_saving);
  const std::string where = place.empty() ? "/kept/" + name : place;
  files[where] = std::move(bytes);
  then(Saved{where.substr(where.rfind('/') + 1), where});
}

void MemoryPlatform::open_recent(const std::string& place, Opened then) {
  const auto found = files.find(place);
  if (found == files.end()) return then(io_error("There is no " + place));
  then(std::vector<NamedBytes>{{place.substr(place.rfind('/') + 1), found->second, place}});
}

void MemoryPlatform::store(const std::string& key, std::string bytes) {
  if (bytes.empty())
    kept.erase(key);
  else
    kept[key] = std::move(bytes);
}

void MemoryPlatform::load(const std::string& key, std::function<void(std::string)> then) {
  const auto found = kept.find(key);
  then(found == kept.end() ? "" : found->second);
}

std::vector<ExampleCard> MemoryPlatform::examples() {
  using Shelf = ExampleCard::Shelf;
  std::vector<ExampleCard> cards;
  for (const std::string& name : example_names)
    cards.push_back({name, 2, is_of_the_gallery(name) ? Shelf::gallery : Shelf::first_screen});
  return cards;
}

void MemoryPlatform::load_example(const std::string& name,
                                  std::function<void(Result<Example>)> then) {
  if (no_example) return then(*no_example);
  const bool with_model = with_models && !is_of_the_gallery(name);
  then(Example{example_document(name), with_model ? example_model(name) : ""});
}

void MemoryPlatform::load_example_picture(const std::string&,
                                          std::function<void(std::string)> then) {
  then(png_bytes(Image(4, 4)));
}

void MemoryPlatform::load_words(const std::string& code, std::function<void(std::string)> then) {
  const Result<std::string> text =
      read_file(ARTISKETCH_SOURCE_DIR "/assets/languages/" + code + ".txt");
  then(text ? *text : "");
}

void MemoryPlatform::set_title(const std::string& words, bool unsaved) {
  title = words;
  unsaved_shown = unsaved;
}

// ---------------------------------------------------------------- jobs

void StepJobs::start(JobRequest request) {
  started.push_back(request.kind);
  request_ = std::move(request);
}

std::optional<Result<JobResult>> StepJobs::poll() {
  if (std::exchange(cancelled_, false)) return Error{Error::Kind::cancelled, {"cancelled"}};
  if (!request_ || held) return std::nullopt;
  const JobRequest request = *std::exchange(request_, std::nullopt);
  const bool live = request.kind == JobRequest::Kind::parts;
  if (ends && !live) return *std::exchange(ends, std::nullopt);
  return outcome_of(request);
}

void StepJobs::cancel() {
  cancelled_ = request_.has_value();
  request_.reset();
}

// ---------------------------------------------------------------- the card

class NoGraphics::Mesh : public CardMesh {
 public:
  explicit Mesh(NoGraphics& owner) : owner_(owner) { ++owner_.meshes; }
  ~Mesh() override { --owner_.meshes; }
  void set_faces(std::span<const unsigned> corners, std::span<const float> uvs) override {
    vertices_ = uvs.size() / 2;
    EXPECT_EQ(corners.size() % 3, 0u);
    EXPECT_TRUE(all_below(corners, vertices_));
  }
  void set_edges(std::span<const unsigned> ends) override {
    EXPECT_EQ(ends.size() % 2, 0u);
    EXPECT_TRUE(all_below(ends, vertices_));
    has_edges = true;
  }
  void set_ground(std::span<const float> ends) override { EXPECT_EQ(ends.size() % 6, 0u); }
  void move(std::span<const float> positions, std::span<const float> normals) override {
    EXPECT_EQ(positions.size(), 3 * vertices_);
    EXPECT_EQ(normals.size(), 3 * vertices_);
    EXPECT_TRUE(
        std::all_of(positions.begin(), positions.end(), [](float x) { return std::isfinite(x); }));
    placed = true;
  }
  void colour(std::span<const std::uint8_t> rgba) override {
    EXPECT_EQ(rgba.size(), 4 * vertices_);
    coloured = true;
  }
  bool has_edges = false, placed = false, coloured = false;

 private:
  NoGraphics& owner_;
  std::size_t vertices_ = 0;
};

class NoGraphics::Picture : public CardPicture {
 public:
  explicit Picture(NoGraphics& owner) : owner_(owner) {}
  ~Picture() override { owner_.textures.erase(texture_); }
  unsigned texture() const override { return texture_; }
  void paint(const CardMesh& mesh, const MeshLook& look, int width, int height, bool) override {
    const Mesh& painted = static_cast<const Mesh&>(mesh);
    EXPECT_TRUE(painted.placed && painted.coloured);
    EXPECT_TRUE(painted.has_edges || !look.edges_alone);
    EXPECT_TRUE(look.texture == 0 || owner_.textures.contains(look.texture));
    EXPECT_TRUE(look.clip.allFinite());
    EXPECT_GT(width, 0);
    EXPECT_GT(height, 0);
    if (!texture_) texture_ = owner_.add();
    owner_.look = look;
    ++owner_.painted;
  }

 private:
  NoGraphics& owner_;
  unsigned texture_ = 0;
};

unsigned NoGraphics::add() {
  textures.insert(++last_);
  return last_;
}

unsigned NoGraphics::add_texture(int width, int height, std::span<const std::uint8_t> rgba,
                                 Beyond) {
  EXPECT_EQ(rgba.size(), std::size_t(4) * std::size_t(width) * std::size_t(height));
  return add();
}

void NoGraphics::remove_texture(unsigned texture) {
  EXPECT_EQ(textures.erase(texture), 1u) << "a texture that isn't there";
}

std::unique_ptr<CardMesh> NoGraphics::make_mesh() {
  return std::make_unique<Mesh>(*this);
}

std::unique_ptr<CardPicture> NoGraphics::make_picture() {
  return std::make_unique<Picture>(*this);
}

// ---------------------------------------------------------------- the person

namespace {

constexpr unsigned kFonts = 1;  // the texture's name

ImFontAtlas& shared_fonts() {
  static ImFontAtlas fonts;
  return fonts;
}

// What is drawn can be drawn.
void check(const ImDrawData& data, const std::set<unsigned>& textures) {
  for (const ImDrawList* list : data.CmdLists) {
    const auto placed = [](const ImDrawVert& vertex) {
      return std::isfinite(vertex.pos.x) && std::isfinite(vertex.pos.y);
    };
    ASSERT_TRUE(std::all_of(list->VtxBuffer.begin(), list->VtxBuffer.end(), placed))
        << list->_OwnerName;
    for (const ImDrawCmd& command : list->CmdBuffer) {
      if (command.UserCallback) continue;
      const auto texture = unsigned(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
      ASSERT_TRUE(command.ElemCount == 0 || texture == kFonts || textures.contains(texture))
          << "texture " << texture << " in " << list->_OwnerName;
      ASSERT_LE(command.IdxOffset + command.ElemCount, unsigned(list->IdxBuffer.Size));
      ASSERT_LE(command.VtxOffset, unsigned(list->VtxBuffer.Size));
      ASSERT_TRUE(all_below({list->IdxBuffer.Data + command.IdxOffset, command.ElemCount},
                            unsigned(list->VtxBuffer.Size) - command.VtxOffset))
          << list->_OwnerName;
    }
  }
}

}  // namespace

Harness::Harness(std::vector<std::string> examples, std::map<std::string, std::string> kept,
                 Size size, const std::string& language)
    : size(size) {
  platform.speaks = language;
  platform.example_names = std::move(examples);
  platform.kept = std::move(kept);
  context_ = ImGui::CreateContext(&shared_fonts());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.MouseDragThreshold = 4;
  io.DisplaySize = {size.width, size.height};
  fit_fonts(1);
  io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(std::uintptr_t(kFonts)));
  editor_ = std::make_unique<Editor>(platform, jobs, graphics);
  frames(2);
}

Harness::~Harness() {
  editor_.reset();
  EXPECT_TRUE(graphics.textures.empty()) << "textures are left behind";
  EXPECT_EQ(graphics.meshes, 0) << "meshes are left behind";
  ImGui::DestroyContext(context_);
}

void Harness::frame(double seconds) {
  platform.clock += seconds;
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = float(seconds);
  io.DisplaySize = {size.width, size.height};
  if (fit_fonts(pixel_ratio))
    io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(std::uintptr_t(kFonts)));
  begin_frame();
  editor_->touch(std::exchange(fingers_, {}));
  editor_->frame(size.width, size.height, pixel_ratio);
  ImGui::Render();
  check(*ImGui::GetDrawData(), graphics.textures);
}

void Harness::wait(double seconds) {
  constexpr double kStep = 0.1;
  for (; seconds > 0; seconds -= kStep) frame(std::min(seconds, kStep));
}

void Harness::settle() {
  for (int i = 0; i < 50; ++i) {
    frame();
    if (!jobs.busy()) break;
  }
  frames(2);
}

void Harness::open(const std::string& name, std::string bytes) {
  editor_->open(std::vector<NamedBytes>{{name, std::move(bytes), ""}});
  frames(2);
}

void Harness::open_example(const std::string& name) {
  open(name + ".artisketch", example_document(name));
}

void Harness::start_over() {
  key(ImGuiKey_N, ImGuiMod_Ctrl);
}

void Harness::point_at(Vec2 place) {
  ImGui::GetIO().AddMousePosEvent(float(place.x()), float(place.y()));
  frame();
}

void Harness::press(ImGuiMouseButton button) {
  ImGui::GetIO().AddMouseButtonEvent(button, true);
  frame();
}

void Harness::release(ImGuiMouseButton button) {
  ImGui::GetIO().AddMouseButtonEvent(button, false);
  frames(2);
}

void Harness::click(Vec2 place, ImGuiMouseButton button) {
  wait(0.5);  // else it may be a double click
  point_at(place);
  frame();  // what appeared under the pointer is hovered from the second frame on
  press(button);
  release(button);
}

void Harness::click(const std::string& label) {
  ASSERT_TRUE(enabled(label)) << label << " is not enabled";
  click(middle(label));
}

void Harness::double_click(Vec2 place) {
  click(place);
  press();
  release();
}

void Harness::right_click(const std::string& label) {
  click(middle(label), ImGuiMouseButton_Right);
}

void Harness::drag(Vec2 from, Vec2 by, int steps) {
  std::vector<Vec2> places;
  for (int i = 0; i <= steps; ++i) places.push_back(from + by * i / steps);
  draw(places);
}

void Harness::draw(const std::vector<Vec2>& places) {
  wait(0.5);
  point_at(places.front());
  frame();
  press();
  for (const Vec2& place : places) point_at(place);
  release();
}

void Harness::wheel(float notches) {
  ImGui::GetIO().AddMouseWheelEvent(0, notches);
  frames(2);
}

void Harness::touch(const Fingers& fingers) {
  fingers_ = fingers;
  frames(2);
}

void Harness::key(ImGuiKey key, int modifiers) {
  ImGuiIO& io = ImGui::GetIO();
  for (const int modifier : {ImGuiMod_Ctrl, ImGuiMod_Shift, ImGuiMod_Alt, ImGuiMod_Super})
    if (modifiers & modifier) io.AddKeyEvent(ImGuiKey(modifier), true);
  frame();
  io.AddKeyEvent(key, true);
  frame();
  io.AddKeyEvent(key, false);
  for (const int modifier : {ImGuiMod_Ctrl, ImGuiMod_Shift, ImGuiMod_Alt, ImGuiMod_Super})
    if (modifiers & modifier) io.AddKeyEvent(ImGuiKey(modifier), false);
  frames(2);
}

void Harness::keys_at_once(const std::vector<ImGuiKey>& keys) {
  ImGuiIO& io = ImGui::GetIO();
  for (const ImGuiKey key : keys) {
    io.AddKeyEvent(key, true);
    if (key >= ImGuiKey_A && key <= ImGuiKey_Z)
      io.AddInputCharacter(unsigned('a' + key - ImGuiKey_A));
    io.AddKeyEvent(key, false);
  }
}

void Harness::hold(ImGuiKey key, bool down) {
  ImGui::GetIO().AddKeyEvent(key, down);
  frames(2);
}

void Harness::type(const std::string& text) {
  for (const char c : text) {
    ImGui::GetIO().AddInputCharacter(unsigned(c));
    frame();
  }
}

bool Harness::says(const std::string& words) const {
  return said().find(words) != std::string::npos;
}

std::string Harness::said() const {
  std::string all;
  for (const std::string& words : state().messages) all += words + "\n";
  return all;
}

const Widget* Harness::find(const std::string& label) const {
  for (const Widget& widget : editor_->widgets())
    if (widget.label == label) return &widget;
  return nullptr;
}

const Widget& Harness::widget(const std::string& label) const {
  if (const Widget* found = find(label)) return *found;
  std::string all;
  for (const std::string& other : labels()) all += "\n  " + other;
  ADD_FAILURE() << "there is no control '" << label << "', only" << all;
  static const Widget none;
  return none;
}

Vec2 Harness::middle(const std::string& label) const {
  const Widget& w = widget(label);
  return {w.x + w.width / 2, w.y + w.height / 2};
}

Vec2 Harness::on_screen(double x, double y) const {
  const std::optional<Vec2> place = editor_->project(state().frame, x, y);
  if (place) return *place;
  ADD_FAILURE() << "no drawing is in view";
  return Vec2::Zero();
}

std::optional<double> Harness::opacity(const std::string& panel) const {
  std::optional<double> most;
  for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists)
    for (const ImDrawCmd& command : list->CmdBuffer) {
      const auto texture = unsigned(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
      if (command.UserCallback || panel != list->_OwnerName || !graphics.textures.contains(texture))
        continue;
      for (unsigned i = 0; i < command.ElemCount; ++i) {
        const auto vertex = command.VtxOffset + list->IdxBuffer[int(command.IdxOffset + i)];
        const double alpha = double(list->VtxBuffer[int(vertex)].col >> IM_COL32_A_SHIFT & 255);
        most = std::max(most.value_or(0), alpha / 255);
      }
    }
  return most;
}

std::vector<std::string> Harness::labels() const {
  std::vector<std::string> labels;
  for (const Widget& widget : editor_->widgets()) labels.push_back(widget.label);
  return labels;
}

}  // namespace artisketch
