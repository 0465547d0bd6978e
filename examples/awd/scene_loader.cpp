// SPDX-License-Identifier: Apache-2.0
#include "scene_loader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "console.h"
#include "failure.h"
#include "gltf_file.h"
#include "obj_text.h"
#include "regular_file.h"

namespace command {
namespace {

std::string extensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(letter));
  return extension;
}

/// Files, but no pipe or device, which may never end.
class RegularFiles : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char* path) const override {  // which else opens it
    return isRegularFile(path);
  }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (!isRegularFile(path)) return nullptr;
    return DefaultIOSystem::Open(path, mode);
  }
};

/// The same, but that one file's content is ours.
class OverlaidFiles final : public RegularFiles {
 public:
  OverlaidFiles(std::string path, std::string content)
      : path_(std::move(path)), content_(std::move(content)) {}

  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (path != path_) return RegularFiles::Open(path, mode);
    return new Assimp::MemoryIOStream(reinterpret_cast<const uint8_t*>(content_.data()),
                                      content_.size());
  }

 private:
  std::string path_, content_;
};

/// What a mesh of Assimp's is in terms of the file, where Assimp can't be trusted with that.
using Describe = std::function<GltfFile::Primitive(const aiMesh&)>;

class Collector {
 public:
  Collector(const std::string& path, const aiScene& scene, Describe describe)
      : path_(path), scene_(scene), describe_(std::move(describe)) {}

  void collect(SceneData& data) {
    visit(*scene_.mRootNode, aiMatrix4x4(), data);
    if (lines_) {
      warn(path_ + ": " + std::to_string(lines_) + " points and lines are ignored");
    }
    if (triangles_ == 0) throw Failure(path_ + ": has no triangles");
  }

 private:
  void visit(const aiNode& node, const aiMatrix4x4& parent, SceneData& data) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      data.meshes.push_back(convert(*scene_.mMeshes[node.mMeshes[i]], transform));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], transform, data);
  }

  Mesh convert(const aiMesh& mesh, const aiMatrix4x4& transform) {
    const GltfFile::Primitive description = describe_(mesh);
    Mesh result;
    result.name = description.name;
    result.material = description.material;
    result.vertices.reserve(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D point = transform * mesh.mVertices[i];
      result.vertices.push_back({point.x, point.y, point.z});
    }
    result.triangles.reserve(mesh.mNumFaces);
    // A mirrored mesh keeps its front side only if its corners change their order.
    const bool mirrored = transform.Determinant() < 0.0f;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) {
        ++lines_;
        continue;
      }
      const unsigned* corner = face.mIndices;
      if (std::max({corner[0], corner[1], corner[2]}) >= mesh.mNumVertices) {
        throw Failure(path_ + ": mesh " + inQuotes(result.name) + ": triangle " +
                      std::to_string(i) + " has an index out of range");
      }
      result.triangles.push_back(mirrored
                                     ? std::array<uint32_t, 3>{corner[0], corner[2], corner[1]}
                                     : std::array<uint32_t, 3>{corner[0], corner[1], corner[2]});
    }
    triangles_ += result.triangles.size();
    if (result.triangles.size() < description.triangles) {
      throw Failure(path_ + ": mesh " + inQuotes(result.name) + ": " +
                    std::to_string(description.triangles - result.triangles.size()) + " of " +
                    std::to_string(description.triangles) +
                    " triangles have an index out of range");
    }
    return result;
  }

  const std::string& path_;
  const aiScene& scene_;
  Describe describe_;
  std::size_t lines_ = 0, triangles_ = 0;
};

const aiScene& read(Assimp::Importer& importer, const std::string& path) {
  // Nothing but triangles: every other step may merge, reorder or drop something.
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) throw Failure(path + ": " + importer.GetErrorString());
  return *scene;
}

SceneData loadObj(const std::string& path) {
  const std::map<std::string, Material> defined = readObjText(path);
  Assimp::Importer importer;
  std::optional<std::string> text = plainObjText(path);
  std::unique_ptr<RegularFiles> files;
  if (text) {
    files = std::make_unique<OverlaidFiles>(path, std::move(*text));
  } else {
    files = std::make_unique<RegularFiles>();
  }
  importer.SetIOHandler(files.release());  // which then belongs to it
  const aiScene& scene = read(importer, path);
  SceneData data;
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const std::string name = scene.mMaterials[i]->GetName().C_Str();
    const auto found = defined.find(name);
    data.materials.push_back(found != defined.end() ? found->second : undefinedMaterial(name));
  }
  Collector(path, scene, [](const aiMesh& mesh) {
    return GltfFile::Primitive{mesh.mName.C_Str(), mesh.mMaterialIndex, 0};
  }).collect(data);
  std::set<std::string> missing;
  for (const Mesh& mesh : data.meshes) {
    const std::string& name = data.materials[mesh.material].name;
    if (!mesh.triangles.empty() && !defined.count(name)) missing.insert(name);
  }
  for (const std::string& name : missing) {
    const bool none = name == AI_DEFAULT_MATERIAL_NAME;
    warn(
        path + ": " +
        (none ? "faces before any usemtl are" : "material " + inQuotes(name) + " is not defined:") +
        " taken as grey of albedo 0.6 that does not emit");
  }
  return data;
}

/// The first camera whose node is part of the scene.
std::optional<AWDCamera> findCamera(const std::string& path, const aiScene& scene,
                                    const std::vector<GltfFile::Camera>& cameras) {
  for (const GltfFile::Camera& candidate : cameras) {
    const aiNode* node = scene.mRootNode->FindNode(candidate.nodeLabel.c_str());
    if (!node) continue;
    if (cameras.size() > 1) {
      note(path + ": of " + std::to_string(cameras.size()) + " cameras " +
           inQuotes(candidate.name) + " is used");
    }
    aiMatrix4x4 transform;
    for (; node; node = node->mParent) transform = node->mTransformation * transform;
    const aiMatrix3x3 linear(transform);
    const aiVector3D eye = transform * aiVector3D(0.0f, 0.0f, 0.0f);
    const aiVector3D look = linear * aiVector3D(0.0f, 0.0f, -1.0f);
    const aiVector3D up = linear * aiVector3D(0.0f, 1.0f, 0.0f);
    const double aspect = candidate.aspectRatio.value_or(1.0);
    AWDCamera camera = AWD_CAMERA_INIT;
    for (unsigned i = 0; i < 3; ++i) {
      camera.eye[i] = eye[i];
      camera.lookDir[i] = look[i];
      camera.up[i] = up[i];
    }
    camera.tanHalfFovX = static_cast<float>(std::tan(candidate.yfov / 2.0) * aspect);
    camera.height =
        static_cast<uint32_t>(std::clamp(std::round(camera.width / aspect), 1.0, 65536.0));
    return camera;
  }
  return std::nullopt;
}

SceneData loadGltf(const std::string& path) {
  const GltfFile file(path);
  Assimp::Importer importer;
  importer.SetIOHandler(new OverlaidFiles(path, file.relabelled()));  // which then belongs to it
  const aiScene& scene = read(importer, path);
  SceneData data;
  data.materials = file.materials();
  Collector(path, scene, [&](const aiMesh& mesh) {
    return file.primitive(mesh.mName.C_Str());
  }).collect(data);
  data.camera = findCamera(path, scene, file.cameras());
  return data;
}

}  // namespace

SceneData loadScene(const std::string& path) {
  if (!isRegularFile(path)) {
    throw Failure("can't read " + inQuotes(path) + ": no such file");
  }
  const std::string extension = extensionOf(path);
  if (extension == ".obj") return loadObj(path);
  if (extension == ".gltf" || extension == ".glb") return loadGltf(path);
  throw Failure(path + ": scenes are read from .obj, .gltf and .glb files");
}

}  // namespace command
