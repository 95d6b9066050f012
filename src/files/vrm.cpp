#include "files/vrm.h"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "files/glb_parts.h"
#include "files/gltf.h"
#include "files/json.h"
#include "model/rig/body_plan.h"
#include "model/rig/rig_profile.h"
#include "model/rig/t_pose.h"

namespace artisketch {
namespace {

// What the "unity" rig calls joints is what VRM calls bones, & standing for the side.
constexpr const char* kBones[] = {"hips",      "spine",     "chest",     "neck",  "head",
                                  "&Shoulder", "&UpperArm", "&LowerArm", "&Hand", "&UpperLeg",
                                  "&LowerLeg", "&Foot",     "&Toes"};

Json humanoid_json(const Skeleton& skeleton) {
  Json bones = Json::object();
  const auto add = [&](const std::string& name) {
    if (const int joint = skeleton.find(name); joint >= 0) bones[name] = {{"node", joint}};
  };
  for (const std::string name : kBones) {
    if (name[0] != '&') {
      add(name);
      continue;
    }
    for (const char* side : {"left", "right"}) add(side + name.substr(1));
  }
  return {{"humanBones", bones}};
}

bool swings(const Joint& joint) {
  const std::string word = joint_name(joint.name).word;
  return word == "ear" || word == "ears" || word.starts_with("hair") || word.starts_with("skirt") ||
         word.starts_with("tail");
}

// From its first joint down to a tip. Where a chain parts, what parts from it is one of its own: no
// joint may be in two.
void add_springs(const Skeleton& skeleton, int joint, std::vector<std::vector<int>>& springs) {
  std::vector<int> chain;
  for (int at = joint; at >= 0;) {
    chain.push_back(at);
    const std::vector<int> children = skeleton.children(at);
    for (std::size_t i = 1; i < children.size(); ++i) add_springs(skeleton, children[i], springs);
    at = children.empty() ? -1 : children[0];
  }
  if (chain.size() > 1) springs.push_back(chain);
}

Json spring_json(const Skeleton& skeleton, double tall) {
  std::vector<std::vector<int>> springs;
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    if (parent < 0 || !swings(skeleton.joints[j])) continue;
    bool below = false;  // one that swings carries it: it is in that one's chain
    for (int up = parent; up >= 0; up = skeleton.joints[up].parent)
      below |= swings(skeleton.joints[up]);
    if (!below) add_springs(skeleton, j, springs);
  }
  Json all = Json::array();
  for (const std::vector<int>& spring : springs) {
    Json joints = Json::array();
    for (const int joint : spring)
      joints.push_back({{"node", joint},
                        {"hitRadius", json_number(0.01 * tall)},
                        {"stiffness", 1.0},
                        {"gravityPower", 0.05},
                        {"gravityDir", {0, -1, 0}},
                        {"dragForce", 0.4}});
    all.push_back({{"name", skeleton.joints[std::size_t(spring[0])].name}, {"joints", joints}});
  }
  return all;
}

// VRM's meta besides name, authors and license: what each field may be.
struct MetaField {
  const char* name;
  std::initializer_list<const char*> words;  // one of these; none: any words
  bool flag = false;
};
const MetaField kMetaFields[] = {
    {"version", {}},
    {"copyrightInformation", {}},
    {"contactInformation", {}},
    {"thirdPartyLicenses", {}},
    {"otherLicenseUrl", {}},
    {"avatarPermission", {"onlyAuthor", "onlySeparatelyLicensedPerson", "everyone"}},
    {"commercialUsage", {"personalNonProfit", "personalProfit", "corporation"}},
    {"creditNotation", {"required", "unnecessary"}},
    {"modification", {"prohibited", "allowModification", "allowModificationRedistribution"}},
    {"allowExcessivelyViolentUsage", {}, true},
    {"allowExcessivelySexualUsage", {}, true},
    {"allowPoliticalOrReligiousUsage", {}, true},
    {"allowAntisocialOrHateUsage", {}, true},
    {"allowRedistribution", {}, true}};

// Why the field can't stand in VRM's meta, or nothing.
std::string meta_fault(const std::string& key, const Json& value) {
  for (const MetaField& field : kMetaFields) {
    if (key != field.name) continue;
    if (field.flag) return value.is_boolean() ? "" : "wanted true or false";
    if (!value.is_string()) return "wanted words";
    std::string choices;
    for (const char* word : field.words) {
      if (value == word) return "";
      choices += (choices.empty() ? "" : ", ") + std::string(word);
    }
    return choices.empty() ? "" : "wanted one of " + choices;
  }
  return "is no field that a .vrm has";
}

bool are_words(const Json& value) {
  return value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& one) {
           return one.is_string() && !one.get<std::string>().empty();
         });
}

}  // namespace

Result<VrmMeta> vrm_meta(const Document& document, const std::string& file) {
  const std::string at = file + ": /about";
  Faults faults(file);
  Json about;
  if (!document.unknown.empty())
    if (const std::optional<Json> fields = parse_json(document.unknown, faults);
        fields && fields->contains("about"))
      about = (*fields)["about"];
  if (!about.is_object())
    return bad_input(at +
                     ": is missing: a .vrm says who made it, and what others may do with it; write "
                     "\"about\": { \"authors\": [\"Your name\"] } into the document");
  VrmMeta meta;
  meta.name = document.name.empty() ? "untitled" : document.name;
  Json more = Json::object();
  for (const auto& [key, value] : about.items()) {
    if (key == "authors") {
      if (!are_words(value)) return bad_input(at + "/authors: wanted a list of names");
      for (const Json& one : value) meta.authors.push_back(one.get<std::string>());
    } else if (key == "name" || key == "licenseUrl") {
      if (!value.is_string()) return bad_input(at + "/" + key + ": wanted words");
      (key == "name" ? meta.name : meta.license) = value.get<std::string>();
    } else if (const std::string fault = meta_fault(key, value); !fault.empty()) {
      return bad_input(at + "/" + key + ": " + fault);
    } else {
      more[key] = value;
    }
  }
  if (meta.authors.empty()) return bad_input(at + "/authors: names nobody");
  if (!more.empty()) meta.more = more.dump();
  return meta;
}

Document with_author(Document document, const std::string& author) {
  Faults none("");
  std::optional<Json> fields;
  if (!document.unknown.empty()) fields = parse_json(document.unknown, none);
  Json all = fields && fields->is_object() ? *fields : Json::object();
  if (!all.contains("about") || !all["about"].is_object()) all["about"] = Json::object();
  all["about"]["authors"] = Json::array({author});
  document.unknown = all.dump();
  return document;
}

Result<std::string> vrm_bytes(const Model& model, const VrmMeta& meta) {
  const Result<Model> rigged = with_rig(model, "unity");
  if (!rigged) return rigged.error();
  const Model posed = t_posed(*rigged);
  const Result<std::string> glb = glb_bytes(posed);
  if (!glb) return glb;
  const Skeleton& skeleton = posed.skeleton;
  const double tall = bounds(posed.mesh.V).sizes().y();
  GlbParts parts = glb_parts(*glb);
  Json about = {{"name", meta.name}, {"authors", meta.authors}, {"licenseUrl", meta.license}};
  Faults none("");
  if (!meta.more.empty()) about.update(*parse_json(meta.more, none));
  // The mesh's node comes after the joints'.
  const Json first = {
      {"meshAnnotations", Json::array({{{"node", skeleton.size()}, {"type", "auto"}}})}};
  Json& json = parts.json;
  json["extensionsUsed"] = Json::array({"VRMC_vrm"});
  json["extensions"]["VRMC_vrm"] = {{"specVersion", "1.0"},
                                    {"meta", about},
                                    {"humanoid", humanoid_json(skeleton)},
                                    {"firstPerson", first}};
  if (const Json springs = spring_json(skeleton, tall); !springs.empty()) {
    json["extensionsUsed"].push_back("VRMC_springBone");
    json["extensions"]["VRMC_springBone"] = {{"specVersion", "1.0"}, {"springs", springs}};
  }
  return glb_of(parts);
}

}  // namespace artisketch
