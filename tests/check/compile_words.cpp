#include "compile_words.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "fos/text.hpp"
#include "matches.hpp"
#include "unknown_name.hpp"

namespace fos {
namespace {

bool has(std::string_view text, std::string_view words) {
  return text.find(words) != std::string_view::npos;
}
bool has_any(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view each) { return has(text, each); });
}

bool is_vector(std::string_view type) { return has_any(type, {"Vec3", "Color"}); }
bool is_number(std::string_view type) {
  return !is_vector(type) && has_any(type, {"Real", "double", "float", "int", "bool"});
}

std::string_view without_const(std::string_view type) {
  if (type.starts_with("const ")) type.remove_prefix(6);
  return type;
}

/// The first word of a line.
std::string first_word(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t}");
  if (begin == std::string::npos) return "";
  return line.substr(begin, line.find_first_of(" \t({", begin) - begin);
}

/// `for light in scene.point_lights`, or what comes near it.
std::string loop_word(const std::string& source) {
  const bool directional = has(source, "directional");
  const bool sphere = has(source, "sphere");
  return say(text::compile_loop, {directional ? "DirectionalLight"
                                  : sphere    ? "Sphere"
                                              : "PointLight",
                                  sphere ? "sphere" : "light",
                                  directional ? "directional_lights"
                                  : sphere    ? "spheres"
                                              : "point_lights"});
}

std::string conversion_word(const CompileContext& context, std::string_view from,
                            std::string_view to) {
  if (is_vector(from) && is_number(to)) {
    return has(context.source(), "*") ? say(text::compile_product)
                                      : say(text::compile_number_needed);
  }
  if (is_number(from) && is_vector(to)) return say(text::compile_vector_needed);
  return "";
}

/// A value of one type where another is needed.
std::optional<std::string> type_word(const CompileContext& context) {
  const std::string& message = context.message;
  if (has_any(message,
              {"(did you forget the '()'", "must be called", "invalid use of non-static"}) ||
      matches(message, "cannot convert '*' from type '*)() *'")) {
    return say(text::compile_call);
  }
  for (const std::string_view pattern :
       {"could not convert '*' from '*' to '*'", "cannot convert '*' to '*'",
        "conversion from '*' to non-scalar type '*'",
        "no viable conversion from returned value of type '*' to function return type '*'",
        "no viable conversion from '*' to '*'", "assigning to '*' from incompatible type '*'"}) {
    if (auto types = matches(message, pattern)) {
      if (pattern.starts_with("assigning")) std::swap((*types)[0], (*types)[1]);
      return conversion_word(context, (*types)[types->size() - 2], types->back());
    }
  }
  for (const std::string_view pattern :
       {"(operand types are '*' and '*')", "invalid operands to binary expression ('*' and '*')"}) {
    if (const auto types = matches(message, pattern)) {
      const std::string& left = (*types)[0];
      const std::string& right = (*types)[1];
      if (has(message, "operator=' ")) return conversion_word(context, right, left);
      if (has(left, "optional") || has(right, "optional")) return say(text::compile_hit_compared);
      if (is_vector(left) || is_vector(right)) {
        return say(text::compile_operands, {without_const(left), without_const(right)});
      }
    }
  }
  if (has_any(message, {"discards qualifiers", "read-only", "const-qualified"})) {
    return say(text::compile_const);
  }
  if (has(message, "no viable overloaded '='")) {
    for (const std::string& note : context.notes) {
      if (has(note, "'this' argument has type 'const")) return say(text::compile_const);
    }
  }
  return std::nullopt;
}

/// A function called with what it does not take.
std::optional<std::string> call_word(const CompileContext& context) {
  if (has_any(context.message, {"cannot be used as a function", "is not a function"})) {
    return say(text::compile_not_a_function);
  }
  std::string function;
  for (const std::string_view pattern :
       {"no matching function for call to '*'", "arguments to function '*'",
        "static assertion failed: *", "static_assert failed *"}) {
    if (const auto name = matches(context.message, pattern)) {
      function = name->front();
      break;
    }
  }
  const auto calls = [&](std::string_view words) { return has(function, words); };
  if (function.empty()) return std::nullopt;
  if (calls("compute_lighting")) {
    return say(text::compile_arguments, {"compute_lighting", "P, N, scene"});
  }
  if (calls("closest_hit")) {
    return say(text::compile_arguments, {"closest_hit", "O, D, t_min, t_max, scene"});
  }
  if (calls("trace_ray")) {
    return say(text::compile_arguments, {"trace_ray", "O, D, t_min, t_max, scene"});
  }
  if (calls("intersect_ray_sphere")) {
    return say(text::compile_arguments, {"intersect_ray_sphere", "O, D, sphere"});
  }
  if (calls("dot")) return say(text::compile_dot);
  if (calls("length")) return say(text::compile_length, {"length"});
  if (calls("normalize")) return say(text::compile_length, {"normalize"});
  if (calls("max")) return say(text::compile_same_kind, {"max"});
  if (calls("min")) return say(text::compile_same_kind, {"min"});
  return std::nullopt;
}

/// Punctuation: what is missing or too much.
std::optional<std::string> syntax_word(const CompileContext& context) {
  const std::string& message = context.message;
  const std::string source = context.source();
  const std::string word = first_word(source);
  if (has(source, "\xCD\xBE")) return say(text::compile_greek_question_mark);
  if (has_any(message, {"stray '", "not allowed in an identifier", "not valid in an identifier",
                        "unexpected character", "non-ASCII"})) {
    return say(text::compile_stray);
  }
  if (has_any(message, {"expected"}) && word == "for" && has(source, " in ")) {
    return loop_word(source);
  }
  if (has(message, "'else' without a previous 'if'") ||
      (word == "else" && has(message, "expected expression"))) {
    return say(text::compile_else);
  }
  if (has_any(message, {"expected ',' or ';'", "expected ';'", "expected ';,'"})) {
    return say(text::compile_semicolon);
  }
  if (has(message, "expected '('")) return say(text::compile_parentheses);
  if (has(message, "expected ')'")) return say(text::compile_parenthesis);
  if (has_any(message, {"function-definition is not allowed", "function definition is not allowed",
                        "qualified-id in declaration before"})) {
    return say(text::compile_function_inside);
  }
  if (has_any(message, {"expected '}'", "expected unqualified-id at end of input"})) {
    return say(text::compile_missing_brace);
  }
  if (has_any(message,
              {"expected declaration before '}'", "extraneous closing brace",
               "expected unqualified-id before 'return'", "expected unqualified-id before 'if'",
               "expected unqualified-id before 'for'"}) ||
      (has(message, "expected unqualified-id") &&
       (word == "return" || word == "if" || word == "for"))) {
    return say(text::compile_extra_brace);
  }
  if (has_any(message, {"no return statement in function", "control reaches end of non-void",
                        "non-void function does not return"})) {
    return say(text::compile_missing_return);
  }
  return std::nullopt;
}

std::optional<std::string> other_word(const CompileContext& context) {
  const std::string& message = context.message;
  if (has_any(message, {"redeclaration of ", "redefinition of ", "conflicting declaration"})) {
    return say(text::compile_twice);
  }
  if (has(message, "which is of pointer type") || has(message, "is a pointer; did you mean")) {
    return say(text::compile_arrow);
  }
  if (has(message, "has non-pointer type") || has(message, "is not a pointer; did you mean")) {
    return say(text::compile_not_arrow);
  }
  if (const auto gcc = matches(message, "*: No such file or directory")) {
    return say(text::compile_header, {gcc->front()});
  }
  if (const auto clang = matches(message, "'*' file not found")) {
    return say(text::compile_header, {clang->front()});
  }
  if (const auto name = matches(message, "undefined reference to '*'")) {
    return say(text::compile_undefined, {name->front()});
  }
  if (const auto name = matches(message, "multiple definition of '*'")) {
    return say(text::compile_multiple, {name->front()});
  }
  return std::nullopt;
}

}  // namespace

std::string compile_word(const CompileContext& context) {
  for (auto* words : {syntax_word, unknown_name_word, type_word, call_word, other_word}) {
    if (const auto found = words(context)) return *found;
  }
  return "";
}

}  // namespace fos
