// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/sdf_world.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <sdf/sdf.hh>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/input_error.hpp"
#include "lidar/mesh_file.hpp"
#include "lidar/primitives.hpp"
#include "lidar/sdf_includes.hpp"

namespace alignability {
namespace {

namespace fs = std::filesystem;

constexpr double kEndlessPlaneMargin = 10.0;

Eigen::Affine3d to_eigen(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  return Eigen::Translation3d(pose.X(), pose.Y(), pose.Z()) * Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized();
}

Eigen::Vector3d to_eigen(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

void append_folders_of_variable(std::vector<fs::path>& folders, const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr) return;
  std::istringstream list(value);
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
}

std::vector<fs::path> model_folders(const fs::path& file, const WorldOptions& options) {
  const fs::path here = fs::absolute(file).parent_path();
  std::vector<fs::path> folders{here, here / "models", here.parent_path() / "models", here.parent_path()};
  folders.insert(folders.end(), options.model_paths.begin(), options.model_paths.end());
  for (const char* variable : {"GAZEBO_MODEL_PATH", "SDF_PATH", "GZ_SIM_RESOURCE_PATH"}) append_folders_of_variable(folders, variable);
  return folders;
}

// The part of a URI behind the scheme, and nothing when the scheme does not lead to local files.
std::optional<std::string> local_part(const std::string& uri) {
  const std::size_t end = uri.find("://");
  if (end == std::string::npos) return uri;
  const std::string scheme = uri.substr(0, end);
  if (scheme == "model" || scheme == "package" || scheme == "file") return uri.substr(end + 3);
  return std::nullopt;
}

std::optional<fs::path> find_in(const std::vector<fs::path>& folders, const std::string& uri) {
  const std::optional<std::string> part = local_part(uri);
  if (!part || part->empty()) return std::nullopt;
  std::error_code error;
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / *part, error)) return (folder / *part).lexically_normal();
  }
  return std::nullopt;
}

// The SDF file of a model: the file itself, or the one that the model.config of a folder names.
std::optional<fs::path> find_model(const std::vector<fs::path>& folders, const std::string& uri) {
  std::optional<fs::path> found = find_in(folders, uri);
  std::error_code error;
  if (!found || !fs::is_directory(*found, error)) return found;
  const fs::path model =
      fs::exists(*found / "model.config", error) ? fs::path(sdf::getModelFilePath(found->string())) : *found / "model.sdf";
  return fs::is_regular_file(model, error) ? std::optional(model) : std::nullopt;
}

// Masses play no part here, and worlds with impossible ones are common.
void remove_inertia(const sdf::ElementPtr& element) {
  for (sdf::ElementPtr child = element->GetFirstElement(); child;) {
    const sdf::ElementPtr next = child->GetNextElement();
    if (child->GetName() == "inertial") {
      element->RemoveChild(child);
    } else {
      remove_inertia(child);
    }
    child = next;
  }
}

sdf::Errors load_without_inertia(const fs::path& file, const sdf::ParserConfig& config, sdf::Root& root) {
  const sdf::SDFPtr document(new sdf::SDF);
  sdf::Errors errors;
  sdf::init(document);
  try {
    const bool ok = sdf::readFile(file.string(), config, document, errors);
    if (!ok && errors.empty()) errors.emplace_back(sdf::ErrorCode::FILE_READ, "cannot be read as SDF");
    if (!errors.empty()) return errors;
    remove_inertia(document->Root());
    return root.Load(document, config);
  } catch (const std::exception& error) {
    return {{sdf::ErrorCode::FILE_READ, std::string("cannot be read as SDF: ") + error.what()}};
  }
}

// The messages of sdformat's console, a line each: "\033[1;33mWarning [Source.cc:12] \033[0mmessage".
std::vector<std::string> split_messages(const std::string& text) {
  constexpr std::string_view kEndOfPrefix = "\033[0m";
  std::vector<std::string> messages;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.find(kEndOfPrefix);
    const std::string message = end == std::string::npos ? line : line.substr(end + kEndOfPrefix.size());
    if (!message.empty()) messages.push_back(message.substr(message.starts_with(' ') ? 1 : 0));
  }
  return messages;
}

// Makes sdformat, whose console and whose configuration for what is included are one a process, serve one reader for a while.
class SdformatSession {
 public:
  explicit SdformatSession(const sdf::ParserConfig& config) : lock_(in_use()), before_(sdf::ParserConfig::GlobalConfig()) {
    sdf::Console::Instance()->GetMsgStream().SetStream(&record_);
    sdf::ParserConfig::GlobalConfig() = config;
  }
  ~SdformatSession() {
    sdf::ParserConfig::GlobalConfig() = before_;
    sdf::Console::Instance()->GetMsgStream().SetStream(&std::cerr);
  }
  SdformatSession(const SdformatSession&) = delete;
  SdformatSession& operator=(const SdformatSession&) = delete;

  std::vector<std::string> messages() const { return split_messages(record_.str()); }
  // ": " and the first error, "" when there is none. It says what of a value is wrong, which sdformat's own error objects do not.
  std::string first_error() const {
    const std::string text = record_.str();
    const std::vector<std::string> errors = split_messages(text.substr(std::min(text.find("Error ["), text.size())));
    return errors.empty() ? "" : ": " + errors.front();
  }

 private:
  static std::mutex& in_use() {
    static std::mutex mutex;
    return mutex;
  }

  std::lock_guard<std::mutex> lock_;
  sdf::ParserConfig before_;
  std::ostringstream record_;
};

// Turns the parts of a parsed SDF document into triangles in the frame of its root.
class WorldBuilder {
 public:
  WorldBuilder(fs::path file, const WorldOptions& options)
      : file_(std::move(file)), options_(options), folders_(model_folders(file_, options)) {}

  World build() && {
    const sdf::Root root = load();
    for (std::uint64_t i = 0; i < root.WorldCount(); ++i) add_world(*root.WorldByIndex(i));
    if (const sdf::Model* model = root.Model()) add_model(*model, to_eigen(model->RawPose()), model->Name());
    if (root.WorldCount() == 0 && root.Model() == nullptr) throw InputError(file_, "holds neither a world nor a model");
    cut_endless_planes();
    return std::move(world_);
  }

 private:
  struct EndlessPlane {
    std::string name;
    Eigen::Affine3d T_map_plane;
  };

  sdf::Root load() {
    const detail::FindModel find = [this](const std::string& uri) { return find_model(folders_, uri); };
    sdf::ParserConfig config;
    config.SetFindCallback([&](const std::string& uri) { return find(uri).value_or(fs::path()).string(); });
    config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::WARN);
    const SdformatSession session(config);
    detail::check_includes(file_, find);
    sdf::Root root;
    // Absolute, for a relative name such as world.sdf is first looked for among sdformat's own schemas.
    const sdf::Errors errors = load_without_inertia(fs::absolute(file_), config, root);
    if (!errors.empty()) {
      const sdf::Error& error = errors.front();
      throw InputError(path_of(error), {error.LineNumber().value_or(0), 0}, error.Message() + session.first_error());
    }
    world_.warnings = session.messages();
    return root;
  }

  void add_world(const sdf::World& world) {
    for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
      const sdf::Model& model = *world.ModelByIndex(i);
      add_model(model, resolved(model, model.Element()), model.Name());
    }
    for (const char* tag : {"actor", "population", "road"}) warn_of_elements(*world.Element(), tag);
  }

  void add_model(const sdf::Model& model, const Eigen::Affine3d& T_map_model, const std::string& name) {
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& nested = *model.ModelByIndex(i);
      add_model(nested, T_map_model * resolved(nested, nested.Element()), name + "::" + nested.Name());
    }
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      const sdf::Link& link = *model.LinkByIndex(i);
      add_link(link, T_map_model * resolved(link, link.Element()), name + "::" + link.Name());
    }
  }

  void add_link(const sdf::Link& link, const Eigen::Affine3d& T_map_link, const std::string& name) {
    if (options_.geometry == SdfGeometry::visual) {
      for (std::uint64_t i = 0; i < link.VisualCount(); ++i) add_shape(*link.VisualByIndex(i), T_map_link, name);
    } else {
      for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) add_shape(*link.CollisionByIndex(i), T_map_link, name);
    }
  }

  template <typename Shape>
  void add_shape(const Shape& shape, const Eigen::Affine3d& T_map_link, const std::string& link_name) {
    const std::string name = link_name + "::" + shape.Name();
    const sdf::ElementPtr element = shape.Element();
    const Eigen::Affine3d T_map_shape = T_map_link * resolved(shape, element);
    const sdf::Geometry* geometry = shape.Geom();
    if (geometry == nullptr) return warn(*element, "'" + name + "' has no geometry");
    switch (geometry->Type()) {
      case sdf::GeometryType::BOX: {
        const Eigen::Vector3d size = to_eigen(geometry->BoxShape()->Size());
        require_positive(*element, size.minCoeff(), "the size of a box");
        return add(make_box(size), T_map_shape, name, *element);
      }
      case sdf::GeometryType::CYLINDER: {
        const sdf::Cylinder& cylinder = *geometry->CylinderShape();
        require_positive(*element, std::min(cylinder.Radius(), cylinder.Length()), "radius and length of a cylinder");
        return add(make_cylinder(cylinder.Radius(), cylinder.Length()), T_map_shape, name, *element);
      }
      case sdf::GeometryType::CAPSULE: {
        const sdf::Capsule& capsule = *geometry->CapsuleShape();
        require_positive(*element, std::min(capsule.Radius(), capsule.Length()), "radius and length of a capsule");
        return add(make_capsule(capsule.Radius(), capsule.Length()), T_map_shape, name, *element);
      }
      case sdf::GeometryType::SPHERE:
        require_positive(*element, geometry->SphereShape()->Radius(), "the radius of a sphere");
        return add(make_sphere(geometry->SphereShape()->Radius()), T_map_shape, name, *element);
      case sdf::GeometryType::ELLIPSOID: {
        const Eigen::Vector3d radii = to_eigen(geometry->EllipsoidShape()->Radii());
        require_positive(*element, radii.minCoeff(), "the radii of an ellipsoid");
        return add(make_ellipsoid(radii), T_map_shape, name, *element);
      }
      case sdf::GeometryType::PLANE:
        return add_plane(*geometry->PlaneShape(), T_map_shape, name, *element);
      case sdf::GeometryType::MESH:
        return add_mesh(*geometry->MeshShape(), T_map_shape, name);
      default: {
        const sdf::ElementPtr kind = geometry->Element() ? geometry->Element()->GetFirstElement() : nullptr;
        return warn(*element, "'" + name + "' is left out: geometry '" + (kind ? kind->GetName() : "empty") + "' is not supported");
      }
    }
  }

  void add_plane(const sdf::Plane& plane, const Eigen::Affine3d& T_map_shape, const std::string& name, const sdf::Element& element) {
    const Eigen::Vector3d normal = to_eigen(plane.Normal());
    require_positive(element, normal.norm(), "the length of a plane's normal");
    const Eigen::Affine3d T_map_plane = T_map_shape * Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
    if (options_.geometry == SdfGeometry::collision) {
      endless_planes_.push_back({name, T_map_plane});
      return;
    }
    require_positive(element, std::min(plane.Size().X(), plane.Size().Y()), "the size of a plane");
    add(make_rectangle(plane.Size().X(), plane.Size().Y()), T_map_plane, name, element);
  }

  void add_mesh(const sdf::Mesh& mesh, const Eigen::Affine3d& T_map_shape, const std::string& name) {
    const sdf::Element& element = *mesh.Element();
    const fs::path mesh_file = locate(mesh);
    const Eigen::Vector3d scale = to_eigen(mesh.Scale());
    if (!scale.allFinite() || scale.cwiseAbs().minCoeff() == 0.0) fail(element, "the scale of a mesh must have no zero");

    const std::vector<TriangleMesh>& parts = read_once(mesh_file, mesh.Submesh());
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    if (!mesh.Submesh().empty() && mesh.CenterSubmesh()) {
      Eigen::AlignedBox3f box;
      for (const TriangleMesh& part : parts) box.extend(bounds(part));
      centre = box.center().cast<double>();
    }
    const Eigen::Affine3d T_map_mesh = T_map_shape * Eigen::Scaling(scale) * Eigen::Translation3d(-centre);
    add(merged(parts, name), T_map_mesh, name, element);
  }

  fs::path locate(const sdf::Mesh& mesh) const {
    std::vector<fs::path> folders{fs::path(mesh.FilePath()).parent_path()};
    folders.insert(folders.end(), folders_.begin(), folders_.end());
    const std::optional<fs::path> found = find_in(folders, mesh.Uri());
    if (mesh.Uri() == "__default__") fail(*mesh.Element(), "a mesh without <uri>");  // what sdformat fills in
    if (!found) fail(*mesh.Element(), "no mesh '" + mesh.Uri() + "' in any folder of models");
    return *found;
  }

  const std::vector<TriangleMesh>& read_once(const fs::path& mesh_file, const std::string& submesh) {
    const auto [entry, fresh] = meshes_read_.try_emplace({mesh_file, submesh});
    if (!fresh) return entry->second;
    MeshOptions mesh_options;
    if (!submesh.empty()) mesh_options.submesh = submesh;
    if (mesh_file.extension() != ".glb" && mesh_file.extension() != ".gltf") mesh_options.up_axis = UpAxis::z;
    return entry->second = read_mesh_file(mesh_file, mesh_options);
  }

  void add(const TriangleMesh& shape, const Eigen::Affine3d& T_map_shape, const std::string& name, const sdf::Element& element) {
    TriangleMesh mesh = transformed(shape, T_map_shape);
    mesh.name = name;
    const auto finite = [](const Eigen::Vector3f& vertex) { return vertex.allFinite(); };
    if (!std::ranges::all_of(mesh.vertices, finite)) fail(element, "'" + name + "' does not lie at finite coordinates");
    world_.meshes.push_back(std::move(mesh));
  }

  void cut_endless_planes() {
    Eigen::AlignedBox3f box;
    for (const TriangleMesh& mesh : world_.meshes) box.extend(bounds(mesh));
    for (const EndlessPlane& plane : endless_planes_) {
      const Eigen::Vector3f origin = plane.T_map_plane.translation().cast<float>();
      Eigen::AlignedBox3f around = box;
      around.extend(origin);
      const float farthest = std::max((around.max() - origin).maxCoeff(), (origin - around.min()).maxCoeff());
      const double side = 2.0 * (farthest + kEndlessPlaneMargin);
      world_.meshes.push_back(transformed(make_rectangle(side, side), plane.T_map_plane));
      world_.meshes.back().name = plane.name;
    }
  }

  template <typename Posed>
  Eigen::Affine3d resolved(const Posed& posed, const sdf::ElementPtr& element) const {
    ignition::math::Pose3d pose;
    const sdf::Errors errors = posed.SemanticPose().Resolve(pose);
    if (!errors.empty()) fail(*element, errors.front().Message());
    return to_eigen(pose);
  }

  void require_positive(const sdf::Element& element, double value, const std::string& what) const {
    if (!(value > 0.0)) fail(element, what + " must be greater than 0");
  }

  void warn_of_elements(const sdf::Element& parent, const char* tag) {
    if (!parent.HasElement(tag)) return;
    for (sdf::ElementPtr child = parent.GetElementImpl(tag); child; child = child->GetNextElement(tag)) {
      warn(*child, "'" + std::string(tag) + "' is left out: not supported");
    }
  }

  // A path as the user knows it.
  fs::path shown(const std::string& path) const { return path.empty() || path == fs::absolute(file_) ? file_ : fs::path(path); }

  fs::path path_of(const sdf::Error& error) const {
    return error.FilePath() && fs::exists(*error.FilePath()) ? shown(*error.FilePath()) : file_;
  }

  InputError at(const sdf::Element& element, const std::string& message) const {
    return InputError(shown(element.FilePath()), {element.LineNumber().value_or(0), 0}, message);
  }

  [[noreturn]] void fail(const sdf::Element& element, const std::string& message) const { throw at(element, message); }
  void warn(const sdf::Element& element, const std::string& message) { world_.warnings.push_back(at(element, message).what()); }

  fs::path file_;
  const WorldOptions& options_;
  std::vector<fs::path> folders_;
  std::map<std::pair<fs::path, std::string>, std::vector<TriangleMesh>> meshes_read_;
  std::vector<EndlessPlane> endless_planes_;
  World world_;
};

}  // namespace

World read_world(const fs::path& file, const WorldOptions& options) { return WorldBuilder(file, options).build(); }

}  // namespace alignability
