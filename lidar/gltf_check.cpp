// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/gltf_check.hpp"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

using Json = nlohmann::json;

constexpr int kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;  // componentType, unsigned where whole
constexpr std::size_t kMostNested = 64;

std::uint32_t number_at(std::string_view bytes, std::size_t position) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + position, sizeof number);
  return number;
}

// Of a binary file the first chunk, after magic, version and length: its length, its kind and the text.
std::string_view json_of(std::string_view bytes, const std::filesystem::path& file) {
  constexpr std::size_t kVersion = 4, kLength = 8, kChunk = 12, kText = 20;
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < kText) throw InputError(file, "ends within the header");
  if (number_at(bytes, kVersion) != 2)
    throw InputError(file, "is glTF of version " + std::to_string(number_at(bytes, kVersion)) + ", not 2");
  if (number_at(bytes, kLength) != bytes.size()) {
    throw InputError(
        file, "is " + std::to_string(bytes.size()) + " bytes long, where its header says " + std::to_string(number_at(bytes, kLength)));
  }
  if (number_at(bytes, kChunk) > bytes.size() - kText) throw InputError(file, "ends within its first chunk");
  return bytes.substr(kText, number_at(bytes, kChunk));
}

Json parsed(std::string_view text, const std::filesystem::path& file) {
  const auto shallow = [](int depth, Json::parse_event_t, Json&) {
    if (static_cast<std::size_t>(depth) > kMostNested) throw std::length_error("nested more than 64 deep");
    return true;
  };
  try {
    return Json::parse(text, shallow);
  } catch (const Json::parse_error& error) {
    throw InputError(file, "is no JSON from byte " + std::to_string(error.byte) + " on");
  } catch (const Json::out_of_range&) {
    throw InputError(file, "has a number beyond what a double holds");
  } catch (const std::length_error& error) {
    throw InputError(file, error.what());
  }
}

const Json& member(const Json& object, const char* name) {
  static const Json kNone;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? *found : kNone;
}

class Checker {
 public:
  Checker(const Json& root, const std::filesystem::path& file) : root_(root), file_(file) {}

  void check() const {
    for (const Json& extension : member(root_, "extensionsRequired")) {
      for (const char* packed : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"}) {
        if (extension == packed) throw InputError(file_, std::string("needs ") + packed + ", which is not read: export it without");
      }
    }
    for (const Json& mesh : member(root_, "meshes")) {
      for (const Json& primitive : member(mesh, "primitives")) check_primitive(primitive);
    }
  }

 private:
  void check_primitive(const Json& primitive) const {
    const Json& positions = accessor(member(member(primitive, "attributes"), "POSITION"));
    if (!positions.is_null() && (member(positions, "type") != "VEC3" || member(positions, "componentType") != kFloat)) {
      throw InputError(file_, "has positions that are not VEC3 of floats");
    }
    const Json& corners = accessor(member(primitive, "indices"));
    if (corners.is_null()) return;
    const Json& type = member(corners, "componentType");
    if (member(corners, "type") != "SCALAR" || (type != kByte && type != kShort && type != kInt)) {
      throw InputError(file_, "has indices that are not SCALAR of unsigned numbers");
    }
  }

  // Null where there is none: the importer tells of those that are missing.
  const Json& accessor(const Json& index) const {
    static const Json kNone;
    const Json& accessors = member(root_, "accessors");
    if (!index.is_number_unsigned() || !accessors.is_array() || index.get<std::size_t>() >= accessors.size()) return kNone;
    return accessors[index.get<std::size_t>()];
  }

  const Json& root_;
  const std::filesystem::path& file_;
};

}  // namespace

void check_gltf(std::string_view bytes, const std::filesystem::path& file) {
  const Json root = parsed(json_of(bytes, file), file);
  Checker(root, file).check();
}

}  // namespace alignability::detail
