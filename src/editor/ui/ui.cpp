#include "editor/ui/ui.h"

#include <cmath>
#include <utility>

#include <imgui_internal.h>

#include "editor/ui/keys.h"

namespace artisketch {
namespace {

std::vector<Widget>* recorded = nullptr;
std::vector<std::string> cut_short;

constexpr float kInterLine = 2478.0f / 2048;  // Inter's line, in ems

ImU32 ground_of(const Look& look, const Press& press) {
  const Theme& t = theme();
  if (!look.enabled) return look.quiet ? 0 : faded(t.control, 0.6f);
  if (look.primary) {
    if (press.held) return mixed(t.accent, t.panel, 0.2f);
    return press.hovered ? mixed(t.accent, rgb(0xFFFFFF), 0.12f) : t.accent;
  }
  if (look.on) return press.hovered ? mixed(t.selection, t.hover, 0.4f) : t.selection;
  if (press.hovered) return press.held ? mixed(t.hover, t.line, 0.5f) : t.hover;
  return look.quiet ? 0 : t.control;
}

ImU32 ink_of(const Look& look) {
  const Theme& t = theme();
  if (!look.enabled) return t.disabled;
  if (look.primary) return t.on_accent;
  return look.on ? t.accent : t.text;
}

std::string id_of(const std::string& label, const Look& look) {
  return look.id.empty() ? label : look.id;
}

// As it is shown.
std::string shown_words(const std::string& label, const Look& look) {
  return look.names ? label : tr(label);
}

void explain(const std::string& label, const Look& look, const Press& press, bool always) {
  if (!press.hovered) return;
  if (!always && look.hint.empty() && look.key.empty()) return;
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_DelayNormal | ImGuiHoveredFlags_NoSharedDelay |
                           ImGuiHoveredFlags_AllowWhenDisabled))
    tooltip(look.hint.empty() ? label : look.hint, look.key);
}

}  // namespace

void begin_controls(std::vector<Widget>& widgets) {
  recorded = &widgets;
  cut_short.clear();
  const Theme& t = theme();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = {0, 0};
  style.WindowBorderSize = 0;
  style.WindowMinSize = {1, 1};
  style.PopupBorderSize = 1;
  style.PopupRounding = kRadiusCard;
  style.ScrollbarSize = 8;
  style.ScrollbarRounding = 4;
  style.FrameRounding = kRadius;
  style.HoverDelayNormal = 0.45f;
  const auto set = [&](ImGuiCol which, ImU32 colour) {
    style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  set(ImGuiCol_Text, t.text);
  set(ImGuiCol_PopupBg, t.raised);
  set(ImGuiCol_Border, t.line);
  set(ImGuiCol_FrameBg, t.control);
  set(ImGuiCol_ScrollbarBg, 0);
  set(ImGuiCol_ScrollbarGrab, t.hover);
  set(ImGuiCol_ScrollbarGrabHovered, t.disabled);
  set(ImGuiCol_ScrollbarGrabActive, t.muted);
  set(ImGuiCol_TextSelectedBg, faded(t.accent, 0.35f));
  set(ImGuiCol_ModalWindowDimBg, rgb(0x000000, 0.45f));
  set(ImGuiCol_NavHighlight, t.accent);
}

Panel::Panel(const char* name, const Rect& place, ImU32 ground, Layer layer, float radius) {
  ImGui::SetNextWindowPos(place.min());
  ImGui::SetNextWindowSize({place.w, place.h});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, radius);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ground);
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                           ImGuiWindowFlags_NoScrollWithMouse;
  // A panel that appears while a button is held elsewhere would take the press away.
  flags |= ImGuiWindowFlags_NoFocusOnAppearing;
  if (layer == Layer::base) flags |= ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::Begin(name, nullptr, flags);
  // An open menu stays over all of them.
  const bool menu =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (layer == Layer::floating && !menu)
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
}

Panel::~Panel() {
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

namespace {

// Gives the card's name back, its shadow painted in a panel that is wider.
const char* in_shadow(const char* name, const Rect& place) {
  const Panel under((std::string(name) + " shade").c_str(), place.inset(-8), 0,
                    Panel::Layer::floating);
  shadow(place, kRadiusPanel);
  return name;
}

}  // namespace

FloatingCard::FloatingCard(const char* name, const Rect& place)
    : panel_(in_shadow(name, place), place, theme().raised, Panel::Layer::floating, kRadiusPanel) {
  draw().AddRect(place.min(), place.max(), theme().line, kRadiusPanel);
}

// ---------------------------------------------------------------- drawing

ImDrawList& draw() {
  return *ImGui::GetWindowDrawList();
}

std::string in_thousands(int number) {
  std::string text = std::to_string(number);
  if (text.size() > 3) text.insert(text.size() - 3, "\u00A0");
  return text;
}

float name_width(Font which, const std::string& text) {
  return font(which)
      ->CalcTextSizeA(em(which) * kInterLine, FLT_MAX, 0, text.data(), text.data() + text.size())
      .x;
}

float text_width(Font which, const std::string& text) {
  return name_width(which, tr(text));
}

namespace {
// On whole pixels, so that letters stay crisp.
ImVec2 snapped(ImVec2 p) {
  const float ratio = 1 / ImGui::GetIO().FontGlobalScale;
  return {std::round(p.x * ratio) / ratio, std::round(p.y * ratio) / ratio};
}

// The largest face, from this one down, in which words have room: those of other languages are
// longer.
Font fitting(Font which, const std::string& words, float width) {
  constexpr Font kPlain[] = {Font::body, Font::caption, Font::small};
  constexpr Font kBold[] = {Font::headline, Font::title, Font::body_bold, Font::caption_bold,
                            Font::small};
  bool reached = false;
  Font least = which;
  const auto first_in = [&](const auto& faces) {
    for (const Font face : faces) {
      reached |= face == which;
      if (!reached) continue;
      least = face;
      if (name_width(face, words) <= width + 0.5f) break;
    }
    return reached;
  };
  (void)(first_in(kPlain) || first_in(kBold));
  return least;
}

std::string shortened(Font which, const std::string& text, float width) {
  if (name_width(which, text) <= width) return text;
  std::string cut = text;
  while (!cut.empty()) {
    do cut.pop_back();
    while (!cut.empty() && (cut.back() & 0xC0) == 0x80);
    if (!cut.empty() && (cut.back() & 0xC0) == 0xC0) cut.pop_back();
    if (name_width(which, cut + "…") <= width) break;
  }
  return cut + "…";
}
}  // namespace

void write_name(const Rect& place, Font which, ImU32 colour, const std::string& text, Align align) {
  const std::string line = shortened(which, text, place.w + 0.5f);
  if (line != text) cut_short.push_back(text);
  const float height = em(which) * kInterLine, width = name_width(which, line);
  const float slack = place.w - width;
  const float x = place.x + (align == Align::left ? 0 : align == Align::right ? slack : slack / 2);
  draw().AddText(font(which), height, snapped({x, place.y + (place.h - height) / 2}), colour,
                 line.data(), line.data() + line.size());
}

void write(const Rect& place, Font which, ImU32 colour, const std::string& text, Align align) {
  const std::string words = tr(text);
  write_name(place, fitting(which, words, place.w), colour, words, align);
}

namespace {
// Broken at spaces, and where the text itself is.
std::vector<std::string> broken(Font which, const std::string& text, float width) {
  std::vector<std::string> lines;
  std::string line;
  const auto flush = [&] { lines.push_back(std::exchange(line, {})); };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && name_width(which, longer) > width) {
      flush();
      line = word;
    } else {
      line = longer;
    }
    if (end < text.size() && text[end] == '\n') flush();
    at = end + 1;
  }
  if (!line.empty()) flush();
  return lines;
}
}  // namespace

float write_lines(const Rect& place, Font which, ImU32 colour, const std::string& text,
                  float line_height, Align align) {
  float y = place.y;
  for (const std::string& line : broken(which, tr(text), place.w)) {
    write_name({place.x, y, place.w, line_height}, which, colour, line, align);
    y += line_height;
  }
  // A line that leans out of its place by less than half has the place's margin.
  if (y > place.bottom() + line_height / 2) cut_short.push_back(text);
  return y - place.y;
}

float lines_height(Font which, const std::string& text, float width, float line_height) {
  return line_height * float(broken(which, tr(text), width).size());
}

void write_icon(ImVec2 centre, IconSize size, ImU32 colour, const char* icon) {
  ImFont* face = icon_font(size);
  const float height = face->FontSize * ImGui::GetIO().FontGlobalScale;
  draw().AddText(face, height, snapped({centre.x - height / 2, centre.y - height / 2}), colour,
                 icon);
}

void shadow(const Rect& place, float radius) {
  // Stacked rectangles, each wider and fainter, a little below.
  for (int i = 5; i >= 1; --i)
    draw().AddRectFilled({place.x - float(i), place.y - float(i) + 2},
                         {place.right() + float(i), place.bottom() + float(i) + 2},
                         rgb(0x000000, 0.055f), radius + float(i));
}

void hairline(ImVec2 from, ImVec2 to) {
  draw().AddRectFilled(from, {std::max(to.x, from.x + 1), std::max(to.y, from.y + 1)},
                       theme().line);
}

void dashed_frame(const Rect& place, float radius, ImU32 colour) {
  ImDrawList& list = draw();
  list.PathRect({place.x + 0.5f, place.y + 0.5f}, {place.right() - 0.5f, place.bottom() - 0.5f},
                radius);
  std::vector<ImVec2> path(list._Path.begin(), list._Path.end());
  list.PathClear();
  path.push_back(path.front());
  constexpr float kDash = 5, kGap = 4;
  float phase = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const ImVec2 d = {path[i + 1].x - path[i].x, path[i + 1].y - path[i].y};
    const float length = std::sqrt(d.x * d.x + d.y * d.y);
    for (float at = 0; at < length;) {
      const bool on = phase < kDash;
      const float step = std::min(length - at, (on ? kDash : kDash + kGap) - phase);
      const auto point = [&](float s) {
        return ImVec2{path[i].x + d.x * s / length, path[i].y + d.y * s / length};
      };
      if (on) list.AddLine(point(at), point(at + step), colour, 1.25f);
      at += step;
      phase = std::fmod(phase + step + 1e-4f, kDash + kGap);
    }
  }
}

void key_cap(const Rect& place, const std::string& key) {
  draw().AddRectFilled(place.min(), place.max(), theme().control, kRadiusSmall);
  draw().AddRect(place.min(), place.max(), theme().line, kRadiusSmall);
  write(place, Font::small, theme().text, key, Align::centre);
}

// ---------------------------------------------------------------- controls

void record(const std::string& label, const Rect& place, bool enabled, bool active) {
  if (!recorded) return;
  // What has been scrolled away can't be clicked.
  ImRect seen = ImGui::GetCurrentWindow()->ClipRect;
  seen.ClipWith({place.min(), place.max()});
  if (seen.IsInverted()) seen = {place.min(), place.min()};
  recorded->push_back(
      {label, seen.Min.x, seen.Min.y, seen.GetWidth(), seen.GetHeight(), enabled, active});
}

const std::vector<std::string>& words_cut_short() {
  return cut_short;
}

Press press_area(const std::string& label, const Rect& place, bool enabled, bool active) {
  record(label, place, enabled, active);
  Press press;
  const ImRect box(place.min(), place.max());
  const ImGuiID id = ImGui::GetID(label.c_str());
  ImGui::BeginDisabled(!enabled);
  if (ImGui::ItemAdd(box, id)) {
    press.clicked = ImGui::ButtonBehavior(box, id, &press.hovered, &press.held);
    press.double_clicked =
        press.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && enabled;
  }
  ImGui::EndDisabled();
  if (!enabled) press.hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
  return press;
}

bool button(const std::string& label, const Rect& place, const Look& look) {
  const Press press = press_area(id_of(label, look), place, look.enabled, look.on);
  draw().AddRectFilled(place.min(), place.max(), ground_of(look, press), kRadius);
  const ImU32 ink = ink_of(look);
  constexpr float kIcon = 16, kGap = 8, kLeastPad = 4;
  const std::string words = shown_words(label, look);
  const Font face = fitting(look.primary || look.on ? Font::body_bold : Font::body, words,
                            place.w - 2 * kLeastPad - (look.icon ? kIcon + kGap : 0));
  const float text = name_width(face, words);
  float x = place.x + (place.w - text - (look.icon ? kIcon + kGap : 0)) / 2;
  if (look.icon) {
    write_icon({x + kIcon / 2, place.centre().y}, IconSize::small, ink, look.icon);
    x += kIcon + kGap;
  }
  write_name({x, place.y, place.right() - x, place.h}, face, ink, words);
  explain(label, look, press, false);
  return press.clicked;
}

bool icon_button(const std::string& label, const Rect& place, const Look& look) {
  const Press press = press_area(id_of(label, look), place, look.enabled, look.on);
  draw().AddRectFilled(place.min(), place.max(), ground_of(look, press), kRadius);
  const bool small = place.h < 30;
  write_icon(place.centre(), small ? IconSize::small : IconSize::normal, ink_of(look), look.icon);
  explain(label, look, press, true);
  return press.clicked;
}

bool tool_button(const std::string& label, const Rect& place, const Look& look, bool with_label) {
  const Press press = press_area(id_of(label, look), place, look.enabled, look.on);
  draw().AddRectFilled(place.min(), place.max(), ground_of(look, press), kRadius);
  const ImU32 ink = ink_of(look);
  if (with_label) {
    write_icon({place.centre().x, place.y + place.h * 0.38f}, IconSize::large, ink, look.icon);
    write({place.x, place.bottom() - place.h * 0.38f, place.w, 16},
          look.on ? Font::caption_bold : Font::small, look.on ? ink : theme().muted, label,
          Align::centre);
  } else {
    write_icon(place.centre(), IconSize::large, ink, look.icon);
  }
  explain(label, look, press, true);
  return press.clicked;
}

bool sheet_head(Rect head, const std::string& title, const std::string& id) {
  Look close;
  close.icon = icon::kClose;
  close.quiet = true;
  close.key = "Esc";
  close.id = id;
  const bool pressed = icon_button("Close", head.cut_right(28).middle(28, 28), close);
  write(head, Font::title, theme().text, title);
  return pressed;
}

bool checkbox(const std::string& label, const Rect& place, bool& on, bool show_label) {
  const Press press = press_area(label, place, true, on);
  if (press.clicked) on = !on;
  constexpr float kBox = 16;
  const Rect box{place.x, std::round(place.centre().y - kBox / 2), kBox, kBox};
  const Theme& t = theme();
  draw().AddRectFilled(box.min(), box.max(), on ? t.accent : (press.hovered ? t.hover : t.control),
                       kRadiusSmall);
  if (!on) draw().AddRect(box.min(), box.max(), t.line, kRadiusSmall);
  if (on) write_icon(box.centre(), IconSize::small, t.on_accent, icon::kCheck);
  if (show_label)
    write({box.right() + 8, place.y, place.w - kBox - 8, place.h}, Font::body, t.text, label);
  return press.clicked;
}

bool slider(const std::string& label, const Rect& place, float& value, float low, float high) {
  const Press press = press_area(label, place.inset(-6, 0));
  const Theme& t = theme();
  bool changed = false;
  if (press.held) {
    const float along = (ImGui::GetIO().MousePos.x - place.x) / place.w;
    const float wanted = low + (high - low) * std::clamp(along, 0.0f, 1.0f);
    changed = wanted != value;
    value = wanted;
  }
  const float y = std::round(place.centre().y);
  const float x = place.x + place.w * (value - low) / (high - low);
  draw().AddRectFilled({place.x, y - 1.5f}, {place.right(), y + 1.5f}, t.hover, 1.5f);
  draw().AddRectFilled({place.x, y - 1.5f}, {x, y + 1.5f}, t.accent, 1.5f);
  const ImU32 knob = t.dark ? t.text : t.accent;
  draw().AddCircleFilled({x, y}, press.hovered || press.held ? 7.0f : 6.0f, knob);
  return changed;
}

int segments(const std::vector<std::pair<std::string, Look>>& choices, const Rect& place,
             Font face) {
  const Theme& t = theme();
  draw().AddRectFilled(place.min(), place.max(), t.control, kRadiusCard);
  int clicked = -1;
  const float width = place.w / float(choices.size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto& [label, look] = choices[i];
    const Rect cell = Rect{place.x + width * float(i), place.y, width, place.h}.inset(2);
    const Press press = press_area(id_of(label, look), cell, look.enabled, look.on);
    if (press.clicked) clicked = int(i);
    Look shown = look;
    shown.primary = look.on && face == Font::body;
    const ImU32 ground = shown.primary                   ? t.accent
                         : look.on                       ? t.hover
                         : press.hovered && look.enabled ? t.hover
                                                         : 0;
    draw().AddRectFilled(cell.min(), cell.max(), ground, kRadius);
    const ImU32 ink = !look.enabled   ? t.disabled
                      : shown.primary ? t.on_accent
                      : look.on       ? t.text
                                      : t.muted;
    const std::string words = shown_words(label, look);
    const Font used =
        fitting(look.on ? (face == Font::caption ? Font::caption_bold : Font::body_bold) : face,
                words, cell.w - 4 - (look.icon ? 24 : 0));
    const float text = name_width(used, words);
    float x = cell.x + (cell.w - text - (look.icon ? 24 : 0)) / 2;
    if (look.icon) {
      write_icon({x + 8, cell.centre().y}, IconSize::small, ink, look.icon);
      x += 24;
    }
    write_name({x, cell.y, cell.right() - x, cell.h}, used, ink, words);
    explain(label, look, press, false);
  }
  return clicked;
}

bool text_field(const std::string& label, const Rect& place, std::string& text, bool takes_keys) {
  record(label, place);
  const std::string name = "##" + label;
  // SetKeyboardFocusHere() does nothing in windows without ImGui's own navigation.
  if (takes_keys) {
    ImGui::ActivateItemByID(ImGui::GetID(name.c_str()));
    await_text_field();
  }
  ImGui::SetCursorScreenPos(place.min());
  ImGui::PushFont(font(Font::body));
  const float padding = (place.h - ImGui::GetFontSize()) / 2;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {10, padding});
  ImGui::SetNextItemWidth(place.w);
  const auto grow = [](ImGuiInputTextCallbackData* data) {
    auto& string = *static_cast<std::string*>(data->UserData);
    string.resize(std::size_t(data->BufTextLen));
    data->Buf = string.data();
    return 0;
  };
  const bool entered = ImGui::InputText(
      name.c_str(), text.data(), text.capacity() + 1,
      ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_EnterReturnsTrue, grow, &text);
  ImGui::PopStyleVar();
  ImGui::PopFont();
  return entered;
}

void tooltip(const std::string& words, const std::string& key) {
  const float key_width = key.empty() ? 0 : text_width(Font::small, key) + 12;
  const float width = text_width(Font::caption, words) + (key.empty() ? 0 : key_width + 10) + 20;
  constexpr float kHeight = 28;
  const ImVec2 mouse = ImGui::GetIO().MousePos, display = ImGui::GetIO().DisplaySize;
  const float x = std::clamp(mouse.x + 14, 4.0f, std::max(4.0f, display.x - width - 4));
  const float y = mouse.y + 22 + kHeight < display.y ? mouse.y + 22 : mouse.y - kHeight - 8;
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({width, kHeight});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, kRadius);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  if (ImGui::BeginTooltip()) {
    Rect row = Rect{x, y, width, kHeight}.inset(10, 0);
    if (!key.empty()) key_cap(row.cut_right(key_width).middle(key_width, 18), key);
    write(row, Font::caption, theme().text, words);
    ImGui::EndTooltip();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace artisketch
