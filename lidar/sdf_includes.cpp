// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sdf_includes.hpp"

#include <expat.h>
#include <sdf/sdf_config.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <set>
#include <vector>

#include "core/file.hpp"
#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{256} << 20;
constexpr std::size_t kDeepest = 128;

// N of version 1.N.
std::optional<int> minor_of(std::string_view version) {
  if (!version.starts_with("1.")) return std::nullopt;
  version.remove_prefix(2);
  int minor = 0;
  const auto [end, error] = std::from_chars(version.data(), version.data() + version.size(), minor);
  return error == std::errc{} && end == version.data() + version.size() && minor >= 0 ? std::optional(minor) : std::nullopt;
}

struct Include {
  std::string uri;
  int line = 0;
};

// Collects the texts of `<include><uri>` and watches the nesting.
class Listener {
 public:
  Listener(fs::path file, std::string_view bytes) : file_(std::move(file)), parser_(XML_ParserCreate(nullptr), &XML_ParserFree) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const XML_Char* name, const XML_Char** attributes) { static_cast<Listener*>(self)->start(name, attributes); },
        [](void* self, const XML_Char*) { static_cast<Listener*>(self)->end(); });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const XML_Char* text, int length) {
      static_cast<Listener*>(self)->text({text, static_cast<std::size_t>(length)});
    });
    if (XML_Parse(parser_.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE) == XML_STATUS_ERROR && fault_.empty()) {
      stop(std::string("not valid XML: ") + XML_ErrorString(XML_GetErrorCode(parser_.get())));
    }
    if (!fault_.empty()) throw InputError(file_, fault_position_, fault_);
  }

  std::vector<Include> includes() && { return std::move(includes_); }

 private:
  int line() const { return static_cast<int>(XML_GetCurrentLineNumber(parser_.get())); }

  // Exceptions must not pass through the parser.
  void stop(std::string fault) {
    fault_ = std::move(fault);
    fault_position_ = {line(), static_cast<int>(XML_GetCurrentColumnNumber(parser_.get())) + 1};
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void start(const std::string& name, const XML_Char** attributes) {
    // Even once stopped, the parser still ends an element that it has started.
    open_.push_back(name);
    if (open_.size() == 1 && name != "sdf") return stop("expected <sdf>, not <" + name + ">");
    if (open_.size() == 1) check_version(attributes);
    if (open_.size() > kDeepest) return stop("elements are nested deeper than " + std::to_string(kDeepest));
    if (is_uri_of_include()) includes_.push_back({.uri = "", .line = line()});
  }

  // sdformat reads a newer or misspelt version as an empty world.
  void check_version(const XML_Char** attributes) {
    while (attributes[0] != nullptr && std::string_view(attributes[0]) != "version") attributes += 2;
    if (attributes[0] == nullptr) return stop("<sdf> has no 'version'");
    const std::optional<int> minor = minor_of(attributes[1]);
    if (!minor || *minor > *minor_of(SDF_PROTOCOL_VERSION)) {
      stop("'version' is '" + std::string(attributes[1]) + "'; 1.0 to " + SDF_PROTOCOL_VERSION + " are read");
    }
  }

  void end() { open_.pop_back(); }

  void text(std::string_view piece) {
    if (is_uri_of_include()) includes_.back().uri.append(piece);
  }

  bool is_uri_of_include() const { return open_.size() >= 2 && open_.back() == "uri" && open_[open_.size() - 2] == "include"; }

  fs::path file_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::vector<std::string> open_;
  std::vector<Include> includes_;
  std::string fault_;
  TextPosition fault_position_;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

class Checker {
 public:
  explicit Checker(const FindModel& find_model) : find_model_(find_model) {}

  void check(const fs::path& file) {
    const std::string bytes = read_file(file, kLargestFile);
    open_.push_back(file);
    for (const Include& include : Listener(file, bytes).includes()) {
      const std::string uri = trimmed(include.uri);
      const std::optional<fs::path> included = find_model_(uri);
      if (!included) throw InputError(file, {include.line, 0}, "no model '" + uri + "' in any folder of models");
      if (std::ranges::find(open_, *included) != open_.end()) throw InputError(file, {include.line, 0}, "'" + uri + "' includes itself");
      if (checked_.insert(*included).second) check(*included);
    }
    open_.pop_back();
  }

 private:
  const FindModel& find_model_;
  std::vector<fs::path> open_;
  std::set<fs::path> checked_;
};

}  // namespace

void check_includes(const fs::path& file, const FindModel& find_model) { Checker(find_model).check(file); }

}  // namespace alignability::detail
