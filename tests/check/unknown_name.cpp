#include "unknown_name.hpp"

#include <algorithm>
#include <map>

#include "fos/text.hpp"
#include "matches.hpp"

namespace fos {
namespace {

// The slides' names, and others that one may bring along, with those of fos/stage.hpp.
const std::map<std::string, const char*>& names_here() {
  static const std::map<std::string, const char*> names{
      {"I_A", "scene.ambient_intensity"},
      {"IA", "scene.ambient_intensity"},
      {"ambient_intensity", "scene.ambient_intensity"},
      {"BACKGROUND_COLOR", "scene.background_color"},
      {"background_color", "scene.background_color"},
      {"ComputeLighting", "compute_lighting"},
      {"TraceRay", "trace_ray"},
      {"IntersectRaySphere", "intersect_ray_sphere"},
      {"Dot", "dot"},
      {"dot_product", "dot"},
      {"Length", "length"},
      {"norm", "length"},
      {"Normalize", "normalize"},
      {"vec3", "Vec3"},
      {"Vec", "Vec3"},
      {"Vector", "Vec3"},
      {"Vector3", "Vec3"},
      {"Vec3f", "Vec3"},
      {"Vec3d", "Vec3"},
      {"vector3", "Vec3"},
      {"Point", "Vec3"},
      {"Point3", "Vec3"},
      {"inf", "infinity"},
      {"INF", "infinity"},
      {"Infinity", "infinity"},
      {"null", "nullptr"},
      {"None", "nullptr"},
      {"real", "Real"},
      {"Lights", "scene.point_lights, scene.directional_lights"},
      {"lights", "scene.point_lights, scene.directional_lights"},
      {"point_lights", "scene.point_lights"},
      {"directional_lights", "scene.directional_lights"},
      {"spheres", "scene.spheres"},
      {"Light", "PointLight, DirectionalLight"},
  };
  return names;
}

// What comes from the standard library, and with which header.
const std::map<std::string, const char*>& standard_names() {
  static const std::map<std::string, const char*> names{
      {"cout", "iostream"}, {"cerr", "iostream"},   {"endl", "iostream"},
      {"vector", "vector"}, {"string", "string"},   {"max", "algorithm"},
      {"min", "algorithm"}, {"clamp", "algorithm"}, {"numeric_limits", "limits"},
      {"swap", "utility"},  {"pair", "utility"},    {"optional", "optional"},
  };
  return names;
}

constexpr std::string_view letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789";

/// The first line before the error's that gives the name a value or a place; 0 where there is none.
int declared_in(const CompileContext& context, const std::string& name) {
  for (int i = 1; i < context.line && i <= std::ssize(context.lines); ++i) {
    const std::string& line = context.lines[static_cast<std::size_t>(i - 1)];
    const std::string code = line.substr(0, line.find("//"));
    for (std::size_t at = code.find(name); at != std::string::npos; at = code.find(name, at + 1)) {
      const bool begins = at >= 2 && letters.find(code[at - 1]) == std::string_view::npos;
      const std::size_t before = at == 0 ? at : code.find_last_not_of(' ', at - 1);
      const std::size_t after = code.find_first_not_of(' ', at + name.size());
      if (!begins || before == std::string::npos || after == std::string::npos) continue;
      const bool has_type = letters.find(code[before]) != std::string_view::npos ||
                            code[before] == '&' || code[before] == '*' || code[before] == '>';
      if (has_type && std::string_view("=;:{").find(code[after]) != std::string_view::npos)
        return i;
    }
  }
  return 0;
}

bool has_line_with(const CompileContext& context, std::string_view words) {
  return std::any_of(context.lines.begin(), context.lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

std::string is_here(const std::string& slides, std::string_view here) {
  return say(text::compile_is_here, {slides, here});
}

std::string name_word(const CompileContext& context, const std::string& name) {
  if (name.find("\xCD\xBE") != std::string::npos) return say(text::compile_greek_question_mark);
  if (name.find_first_not_of(letters) != std::string::npos) {
    const bool ascii = std::all_of(name.begin(), name.end(), [](char c) { return c >= 0; });
    if (!ascii) return say(text::compile_greek_letter, {name});
  }
  if (has_line_with(context, "closest_hit(")) {
    if (name == "closest_sphere") return is_here(name, "hit->sphere");
    if (name == "closest_t") return is_here(name, "hit->t");
    if (name == "sphere") return is_here("closest_sphere", "hit->sphere");
  }
  if (const int line = declared_in(context, name); line != 0) {
    return say(text::compile_other_block, {name, std::to_string(line)});
  }
  if (const auto here = names_here().find(name); here != names_here().end()) {
    return is_here(name, here->second);
  }
  if (const auto there = standard_names().find(name); there != standard_names().end()) {
    return say(text::compile_std, {name, there->second});
  }
  if (const auto other = matches(context.message, "did you mean '*'")) {
    return say(text::compile_did_you_mean, {name, other->front()});
  }
  return say(text::compile_unknown_name, {name});
}

std::string member_word(const CompileContext& context, const std::string& type,
                        const std::string& member) {
  const auto is = [&](std::string_view name) { return type.find(name) != std::string::npos; };
  if (is("optional<Hit>")) return say(text::compile_optional);
  if (is("Scene") && (member == "Lights" || member == "lights")) return say(text::compile_lights);
  if (is("Light") && (member == "type" || member == "Type")) return say(text::compile_light_type);
  if (const auto other = matches(context.message, "did you mean '*'")) {
    return say(text::compile_did_you_mean, {member, other->front()});
  }
  if (is("PointLight")) return say(text::compile_point_light_has);
  if (is("DirectionalLight")) return say(text::compile_directional_light_has);
  if (is("Sphere")) return say(text::compile_sphere_has);
  if (is("Scene")) return say(text::compile_scene_has);
  if (is("Hit")) return say(text::compile_hit_has);
  if (is("Vec3") || is("Color")) return say(text::compile_vec3_has);
  return "";
}

}  // namespace

std::optional<std::string> unknown_name_word(const CompileContext& context) {
  for (const std::string_view pattern :
       {"'*' was not declared in this scope", "use of undeclared identifier '*'",
        "unknown type name '*'", "'*' does not name a type"}) {
    if (const auto name = matches(context.message, pattern)) {
      return name_word(context, name->front());
    }
  }
  if (const auto gcc = matches(context.message, "'*' has no member named '*'")) {
    return member_word(context, (*gcc)[0], (*gcc)[1]);
  }
  if (const auto clang = matches(context.message, "no member named '*' in '*'")) {
    return member_word(context, (*clang)[1], (*clang)[0]);
  }
  return std::nullopt;
}

}  // namespace fos
