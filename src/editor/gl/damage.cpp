#include "editor/gl/damage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace artisketch {
namespace {

Rect between(ImVec2 low, ImVec2 high) {
  return {low.x, low.y, std::max(0.0f, high.x - low.x), std::max(0.0f, high.y - low.y)};
}

bool empty(const Rect& r) {
  return r.w <= 0 || r.h <= 0;
}

Rect common(const Rect& a, const Rect& b) {
  return between({std::max(a.x, b.x), std::max(a.y, b.y)},
                 {std::min(a.right(), b.right()), std::min(a.bottom(), b.bottom())});
}

Rect both(const Rect& a, const Rect& b) {
  if (empty(a)) return b;
  if (empty(b)) return a;
  return between({std::min(a.x, b.x), std::min(a.y, b.y)},
                 {std::max(a.right(), b.right()), std::max(a.bottom(), b.bottom())});
}

Rect clip_of(const ImDrawCmd& command) {
  return between({command.ClipRect.x, command.ClipRect.y},
                 {command.ClipRect.z, command.ClipRect.w});
}

bool same_kind(const ImDrawCmd& a, const ImDrawCmd& b) {
  return std::memcmp(&a.ClipRect, &b.ClipRect, sizeof a.ClipRect) == 0 &&
         a.TextureId == b.TextureId && a.UserCallback == b.UserCallback;
}

template <class T>
std::vector<T> copied(const ImVector<T>& from) {
  return {from.begin(), from.end()};
}

// Those that overlap become one, until none do.
std::vector<Rect> disjoint(std::vector<Rect> rects) {
  std::vector<Rect> apart;
  while (!rects.empty()) {
    Rect next = rects.back();
    rects.pop_back();
    if (empty(next)) continue;
    bool alone = true;
    for (std::size_t i = 0; alone && i < apart.size(); ++i)
      if (!empty(common(apart[i], next))) {
        rects.push_back(both(apart[i], next));
        apart.erase(apart.begin() + std::ptrdiff_t(i));
        alone = false;
      }
    if (alone) apart.push_back(next);
  }
  return apart;
}

// The triangles of a command that reach into a place.
void add_within(const ImDrawList& list, const ImDrawCmd& command, const Rect& place,
                ImVector<ImDrawIdx>& indices) {
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  const ImDrawIdx* corner = list.IdxBuffer.Data + command.IdxOffset;
  for (unsigned i = 0; i < command.ElemCount; i += 3, corner += 3) {
    const ImVec2 a = vertices[corner[0]].pos, b = vertices[corner[1]].pos,
                 c = vertices[corner[2]].pos;
    if (std::max({a.x, b.x, c.x}) < place.x || std::min({a.x, b.x, c.x}) > place.right() ||
        std::max({a.y, b.y, c.y}) < place.y || std::min({a.y, b.y, c.y}) > place.bottom())
      continue;
    for (int k = 0; k < 3; ++k) indices.push_back(corner[k]);
  }
}

// What of each list lies within the places; lists without any go.
void keep_within(ImDrawData& data, const std::vector<Rect>& places) {
  ImVector<ImDrawList*> lists;
  for (ImDrawList* list : data.CmdLists) {
    ImVector<ImDrawCmd> commands;
    ImVector<ImDrawIdx> indices;
    for (const ImDrawCmd& command : list->CmdBuffer)
      for (const Rect& place : places) {
        const Rect seen = common(clip_of(command), place);
        if (empty(seen)) continue;
        ImDrawCmd part = command;
        part.ClipRect = {seen.x, seen.y, seen.right(), seen.bottom()};
        part.IdxOffset = unsigned(indices.Size);
        add_within(*list, command, seen, indices);
        part.ElemCount = unsigned(indices.Size) - part.IdxOffset;
        if (part.ElemCount > 0 || part.UserCallback) commands.push_back(part);
      }
    list->CmdBuffer.swap(commands);
    list->IdxBuffer.swap(indices);
    if (!list->CmdBuffer.empty()) lists.push_back(list);
  }
  data.CmdLists.swap(lists);
  data.CmdListsCount = data.CmdLists.Size;
}

}  // namespace

// Around some of a command's corners, as far as it shows them.
Rect Damage::around(const List& list, const ImDrawCmd& command, std::size_t from, std::size_t to) {
  if (from >= to) return {};
  ImVec2 low(1e9f, 1e9f), high(-1e9f, -1e9f);
  for (std::size_t i = from; i < to; ++i) {
    const ImVec2 p = list.vertices[command.VtxOffset + list.indices[command.IdxOffset + i]].pos;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return common(between(low, high), clip_of(command));
}

void Damage::whole(const List& list, std::vector<Rect>& changed) {
  for (const ImDrawCmd& command : list.commands)
    changed.push_back(around(list, command, 0, command.ElemCount));
}

// Each command draws a row of triangles: what differs lies between the first and the last that do.
void Damage::compare(const List& old, const List& now, std::span<const unsigned> painted,
                     std::vector<Rect>& changed) {
  const bool alike = std::equal(old.commands.begin(), old.commands.end(), now.commands.begin(),
                                now.commands.end(), same_kind);
  if (!alike) {
    whole(old, changed);
    whole(now, changed);
    return;
  }
  for (std::size_t c = 0; c < now.commands.size(); ++c) {
    const ImDrawCmd &a = old.commands[c], &b = now.commands[c];
    const auto texture = unsigned(reinterpret_cast<std::uintptr_t>(b.TextureId));
    if (std::find(painted.begin(), painted.end(), texture) != painted.end())
      changed.push_back(around(now, b, 0, b.ElemCount));
    const auto same = [&](std::size_t i, std::size_t j) {
      const ImDrawVert& p = old.vertices[a.VtxOffset + old.indices[a.IdxOffset + i]];
      const ImDrawVert& q = now.vertices[b.VtxOffset + now.indices[b.IdxOffset + j]];
      return p.pos.x == q.pos.x && p.pos.y == q.pos.y && p.uv.x == q.uv.x && p.uv.y == q.uv.y &&
             p.col == q.col;
    };
    const std::size_t shared = std::min(a.ElemCount, b.ElemCount);
    std::size_t front = 0, back = 0;
    while (front < shared && same(front, front)) ++front;
    front = front / 3 * 3;
    while (back < shared - front && same(a.ElemCount - 1 - back, b.ElemCount - 1 - back)) ++back;
    back = back / 3 * 3;
    changed.push_back(around(old, a, front, a.ElemCount - back));
    changed.push_back(around(now, b, front, b.ElemCount - back));
  }
}

std::vector<Rect> Damage::narrow(ImDrawData& data, std::span<const unsigned> painted, bool afresh) {
  std::vector<List> lists;
  for (const ImDrawList* list : data.CmdLists)
    lists.push_back({list->_OwnerName ? list->_OwnerName : "", copied(list->CmdBuffer),
                     copied(list->VtxBuffer), copied(list->IdxBuffer)});
  const std::vector<List> before = std::exchange(before_, std::move(lists));
  const Rect window{data.DisplayPos.x, data.DisplayPos.y, data.DisplaySize.x, data.DisplaySize.y};
  if (afresh) return {window};

  // Panels come and go, yet those that stay lie over each other as before.
  std::vector<Rect> changed;
  std::size_t next = 0;
  for (const List& now : before_) {
    std::size_t at = next;
    while (at < before.size() && before[at].owner != now.owner) ++at;
    if (at == before.size()) {
      whole(now, changed);
      continue;
    }
    for (; next < at; ++next) whole(before[next], changed);
    compare(before[at], now, painted, changed);
    next = at + 1;
  }
  for (; next < before.size(); ++next) whole(before[next], changed);

  // Whole pixels, whatever the scale; edges blend into the next.
  for (Rect& r : changed)
    if (!empty(r))
      r = common(between({std::floor(r.x) - 1, std::floor(r.y) - 1},
                         {std::ceil(r.right()) + 1, std::ceil(r.bottom()) + 1}),
                 window);
  changed = disjoint(std::move(changed));
  keep_within(data, changed);
  return changed;
}

}  // namespace artisketch
