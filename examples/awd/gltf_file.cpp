// SPDX-License-Identifier: Apache-2.0
#include "gltf_file.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "console.h"
#include "failure.h"
#include "gltf_geometry.h"

namespace command {
namespace {

using nlohmann::json;

// A .glb: magic, version, length of all; then chunks of length, type, bytes. Little-endian.
constexpr uint32_t kMagic = 0x46546C67;        // "glTF"
constexpr uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr uint32_t kBinaryChunk = 0x004E4942;  // "BIN"
constexpr int kDeepestJson = 100;
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

uint32_t readWord(const std::string& bytes, std::size_t offset) {
  uint32_t word = 0;
  for (int i = 3; i >= 0; --i) word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return word;
}

void appendWord(std::string& bytes, std::size_t word) {
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> 8 * i & 0xFF);
}

/// Extensions that a file may require and still be rendered as it means, or nearly so.
bool isHarmless(const std::string& extension) {
  return extension.rfind("KHR_materials_", 0) == 0 || extension == "KHR_texture_transform" ||
         extension == "KHR_lights_punctual";
}

/// Writing JSON goes down by recursion, and so does Assimp reading it. Found before it is parsed:
/// the JSON library's own way of telling depths takes quadratic time.
bool isTooDeep(const std::string& text) {
  int depth = 0;
  bool inText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inText && c == '\\') {
      ++i;
    } else if (c == '"') {
      inText = !inText;
    } else if (!inText && (c == '[' || c == '{')) {
      if (++depth > kDeepestJson) return true;
    } else if (!inText && (c == ']' || c == '}')) {
      --depth;
    }
  }
  return false;
}

std::array<float, 3> readColor(const json& object, const char* key, float missing) {
  if (!object.contains(key)) return {missing, missing, missing};
  const json& values = object.at(key);
  return {values.at(0).get<float>(), values.at(1).get<float>(), values.at(2).get<float>()};
}

}  // namespace

void GltfFile::fail(const std::string& reason) const { throw Failure(path_ + ": " + reason); }

GltfFile::GltfFile(const std::string& path) : path_(path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Failure("can't read " + inQuotes(path));
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  isBinary_ = bytes.size() >= 4 && readWord(bytes, 0) == kMagic;
  if (!isBinary_) {
    parse(bytes);
    return;
  }
  if (bytes.size() < kHeader + kChunkHeader) fail("is truncated within the header");
  const std::size_t length = readWord(bytes, kHeader);
  if (readWord(bytes, kHeader + 4) != kJsonChunk) fail("does not begin with a JSON chunk");
  if (bytes.size() < readWord(bytes, 8) || bytes.size() - kHeader - kChunkHeader < length) {
    fail(
        "is truncated: " + std::to_string(bytes.size()) + " bytes where its header tells of " +
        std::to_string(std::max<std::size_t>(readWord(bytes, 8), kHeader + kChunkHeader + length)));
  }
  takeBinary(bytes.substr(kHeader + kChunkHeader + length));
  parse(bytes.substr(kHeader + kChunkHeader, length));
}

/// The first chunk of data; what follows it says nothing.
void GltfFile::takeBinary(const std::string& chunks) {
  if (chunks.empty()) return;
  const std::size_t length = chunks.size() < kChunkHeader ? 0 : readWord(chunks, 0);
  if (chunks.size() < kChunkHeader || chunks.size() - kChunkHeader < length) {
    fail("is truncated within its data");
  }
  if (readWord(chunks, 4) == kBinaryChunk) binary_ = chunks.substr(0, kChunkHeader + length);
}

void GltfFile::parse(const std::string& text) {
  if (isTooDeep(text)) fail("is nested too deep");
  try {
    file_ = json::parse(text);
    if (!file_.is_object()) fail("is no JSON object");
    const std::string version = file_.at("asset").at("version").get<std::string>();
    if (version.rfind("2.", 0) != 0) fail("is glTF " + version + "; only glTF 2 can be read");
    checkExtensions();
  } catch (const json::exception& error) {
    fail(std::string("is no glTF file: ") + error.what());
  }
}

void GltfFile::checkExtensions() const {
  for (const json& extension : list("extensionsRequired")) {
    if (!isHarmless(extension.get<std::string>())) {
      fail("needs extension " + extension.get<std::string>() + ", which can't be read");
    }
  }
  for (const json& extension : list("extensionsUsed")) {
    if (extension == "KHR_lights_punctual") {
      warn(path_ + ": point, spot and directional lights are ignored; only surfaces emit");
    }
  }
}

const json& GltfFile::list(const char* key) const {
  static const json none = json::array();
  return file_.contains(key) ? file_.at(key) : none;
}

std::string GltfFile::relabelled() const {
  json file;
  try {
    file = gltfGeometry(file_, binary_.empty() ? 0 : binary_.size() - kChunkHeader);
  } catch (const json::exception& error) {
    fail(error.what());
  } catch (const Failure& failure) {
    fail(failure.what());
  }
  std::string text = file.dump();
  if (!isBinary_) return text;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string bytes;
  appendWord(bytes, kMagic);
  appendWord(bytes, 2);
  appendWord(bytes, kHeader + kChunkHeader + text.size() + binary_.size());
  appendWord(bytes, text.size());
  appendWord(bytes, kJsonChunk);
  return bytes + text + binary_;
}

std::vector<Material> GltfFile::materials() const {
  std::vector<Material> materials;
  std::size_t textured = 0, metallic = 0;
  for (const json& entry : list("materials")) {
    Material material;
    const std::string number = std::to_string(materials.size());
    try {
      material.name = entry.value("name", number);
      const json surface = entry.value("pbrMetallicRoughness", json::object());
      material.albedo = readColor(surface, "baseColorFactor", 1.0f);
      material.emission = readColor(entry, "emissiveFactor", 0.0f);
      const json extension = entry.value("extensions", json::object())
                                 .value("KHR_materials_emissive_strength", json::object());
      const float strength = extension.value("emissiveStrength", 1.0f);
      for (float& channel : material.emission) channel *= strength;
      textured += surface.contains("baseColorTexture") || entry.contains("emissiveTexture");
      metallic += surface.value("metallicFactor", 1.0f) > 0.0f;
    } catch (const json::exception& error) {
      fail("material " + number + ": " + error.what());
    }
    materials.push_back(std::move(material));
  }
  if (textured)
    warn(path_ + ": textures of " + std::to_string(textured) + " materials are ignored");
  if (metallic) {
    warn(path_ + ": " + std::to_string(metallic) +
         " materials are metallic (metallicFactor above 0, or absent); all are taken as diffuse");
  }
  materials.push_back({"default", {1.0f, 1.0f, 1.0f}, {}});
  return materials;
}

GltfFile::Primitive GltfFile::primitive(const std::string& label) const {
  // Assimp leaves the number of the primitive away where there is but one.
  std::size_t mesh = 0, part = 0;
  if (std::sscanf(label.c_str(), "mesh%zu-%zu", &mesh, &part) < 1) {
    fail("mesh " + inQuotes(label) + " is none of the file's");
  }
  try {
    const json& entry = list("meshes").at(mesh);
    const json& primitive = entry.at("primitives").at(part);
    Primitive result;
    result.name = entry.value("name", std::to_string(mesh));
    const std::size_t materialCount = list("materials").size();
    result.material = static_cast<uint32_t>(primitive.value("material", materialCount));
    if (result.material > materialCount) {
      fail("mesh " + inQuotes(result.name) + " has material " + std::to_string(result.material) +
           " of " + std::to_string(materialCount));
    }
    const json& corners = primitive.contains("indices") ? primitive.at("indices")
                                                        : primitive.at("attributes").at("POSITION");
    const std::size_t count = list("accessors").at(corners.get<std::size_t>()).at("count");
    const int mode = primitive.value("mode", 4);
    if (mode == 4) result.triangles = count / 3;
    if (mode > 4 && count >= 3) result.triangles = count - 2;  // strips and fans
    return result;
  } catch (const json::exception& error) {
    fail("mesh " + std::to_string(mesh) + ": " + error.what());
  }
}

std::vector<GltfFile::Camera> GltfFile::cameras() const {
  std::vector<Camera> cameras;
  std::size_t number = 0;
  try {
    for (const json& node : list("nodes")) {
      const std::string label = "node" + std::to_string(number++);
      if (!node.contains("camera")) continue;
      const json& entry = list("cameras").at(node.at("camera").get<std::size_t>());
      if (entry.at("type") != "perspective") continue;
      const json& perspective = entry.at("perspective");
      Camera camera;
      camera.name = node.value("name", entry.value("name", label));
      camera.nodeLabel = label;
      camera.yfov = perspective.at("yfov").get<double>();
      if (perspective.contains("aspectRatio")) {
        camera.aspectRatio = perspective.at("aspectRatio").get<double>();
      }
      if (!(camera.yfov > 0.0 && camera.yfov < M_PI) ||
          (camera.aspectRatio && !(*camera.aspectRatio > 1e-4 && *camera.aspectRatio < 1e4))) {
        fail("camera of node " + inQuotes(camera.name) +
             ": yfov must be within (0, pi) and aspectRatio above 0");
      }
      cameras.push_back(camera);
    }
  } catch (const json::exception& error) {
    fail("node " + std::to_string(number - 1) + ": " + error.what());
  }
  return cameras;
}

}  // namespace command
