// SPDX-License-Identifier: BSD-3-Clause
#include "core/yaml_outline.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <optional>
#include <sstream>

#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

class Outline : public YAML::EventHandler {
 public:
  explicit Outline(const std::filesystem::path& file) : file_(file) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    // Where the parser does not know what to do with a word, it begins one document after the other there.
    if (start_ && start_->pos == mark.pos) fail(mark, "not valid YAML: what stands here belongs to nothing");
    if (start_) fail(mark, "a second document begins, where only one is read");
    start_ = mark;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override { enter(mark); }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override { enter(mark); }
  void OnMapEnd() override { --depth_; }

 private:
  void enter(const YAML::Mark& mark) {
    if (++depth_ > kDeepestYaml) fail(mark, "nests more than " + std::to_string(kDeepestYaml) + " deep");
  }
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    throw InputError(file_, TextPosition{mark.line + 1, mark.column + 1}, what);
  }

  const std::filesystem::path& file_;
  std::optional<YAML::Mark> start_;
  int depth_ = 0;
};

}  // namespace

void check_yaml_outline(const std::string& text, const std::filesystem::path& file) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Outline outline(file);
  while (parser.HandleNextDocument(outline)) {
  }
}

}  // namespace alignability::detail
