// SPDX-License-Identifier: Apache-2.0
#include "gltf_geometry.h"

#include <cstdint>
#include <string>
#include <vector>

#include "failure.h"

namespace command {
namespace {

using nlohmann::json;

/// Assimp goes down the tree by recursion.
constexpr std::size_t kDeepestNode = 500;
/// So that no product or sum of them leaves 64 bits.
constexpr uint64_t kMostBytes = uint64_t{1} << 40;
constexpr uint64_t kMostCorners = 0xFFFFFFFEu;
constexpr uint64_t kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6;

const json& listOf(const json& file, const char* key) {
  static const json none = json::array();
  if (!file.contains(key)) return none;
  if (!file.at(key).is_array()) throw Failure(inQuotes(key) + " is no array");
  return file.at(key);
}

uint64_t natural(const json& value, uint64_t most, const std::string& what) {
  if (!value.is_number_unsigned() || value.get<uint64_t>() > most) {
    throw Failure(what + " is " + value.dump() + ": it must be a whole number up to " +
                  std::to_string(most));
  }
  return value.get<uint64_t>();
}
uint64_t natural(const json& object, const char* key, uint64_t most, const std::string& what) {
  return object.contains(key) ? natural(object.at(key), most, what + ": " + key) : 0;
}

/// An entry of a list, by the number that something gives.
const json& entry(const json& file, const char* list, const json& number, const std::string& what) {
  const json& entries = listOf(file, list);
  if (entries.empty()) throw Failure(what + " names one of " + list + ", of which there are none");
  return entries.at(natural(number, entries.size() - 1, what + ": its number among " + list));
}

void keep(json& to, const json& from, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (from.contains(key)) to[key] = from.at(key);
  }
}

class Geometry {
 public:
  Geometry(const json& file, std::size_t binaryBytes) : file_(file), binaryBytes_(binaryBytes) {}

  json run() {
    json result;
    keep(result, file_, {"asset", "scene", "scenes", "accessors", "bufferViews", "buffers"});
    for (const json& mesh : listOf(file_, "meshes")) addMesh(result, mesh);
    for (const json& node : listOf(file_, "nodes")) addNode(result, node);
    checkTree();
    return result;
  }

 private:
  static void addNode(json& result, const json& node) {
    const std::size_t number = result["nodes"].size();
    const std::string name = "node" + std::to_string(number);
    natural(node, "camera", kMostCorners, name);
    json kept = {{"name", name}};
    keep(kept, node, {"children", "mesh", "matrix", "translation", "rotation", "scale"});
    result["nodes"].push_back(std::move(kept));
  }

  void addMesh(json& result, const json& mesh) const {
    const std::size_t number = result["meshes"].size();
    json kept = {{"name", "mesh" + std::to_string(number)}, {"primitives", json::array()}};
    for (const json& primitive : mesh.at("primitives")) {
      const std::string what = "mesh " + std::to_string(number);
      if (!primitive.at("attributes").contains("POSITION")) {
        throw Failure(what + " has a primitive without POSITION");
      }
      const json& position = primitive.at("attributes").at("POSITION");
      uint64_t corners = countOf(position, false, what);
      if (primitive.contains("indices")) corners = countOf(primitive.at("indices"), true, what);
      // What is read later, too: a number that is none would be anything.
      natural(primitive, "material", kMostCorners, what);
      const uint64_t mode =
          primitive.contains("mode") ? natural(primitive, "mode", kTriangleFan, what) : kTriangles;
      if (mode >= kTriangleStrip && corners < 3) {
        throw Failure(what + " has a strip or fan of " + std::to_string(corners) + " corners");
      }
      json corner = {{"attributes", {{"POSITION", position}}}};
      keep(corner, primitive, {"indices", "mode"});
      kept["primitives"].push_back(std::move(corner));
    }
    result["meshes"].push_back(std::move(kept));
  }

  /// Items of an accessor that is one of positions or of indices, and lies within its data.
  uint64_t countOf(const json& number, bool indices, const std::string& mesh) const {
    const json& accessor = entry(file_, "accessors", number, mesh);
    const std::string what = mesh + ": accessor " + number.dump();
    const uint64_t component = natural(accessor.at("componentType"), kMostCorners, what);
    const uint64_t bytes = component == 5121 ? 1 : component == 5123 ? 2 : 4;
    const bool fits =
        indices ? component == 5121 || component == 5123 || component == 5125 : component == 5126;
    if (!fits || accessor.at("type") != (indices ? "SCALAR" : "VEC3")) {
      throw Failure(what + " is not of " +
                    (indices ? "indices: unsigned integers" : "positions: vectors of 3 floats"));
    }
    if (accessor.contains("sparse")) throw Failure(what + " is sparse, which can't be read");
    const uint64_t count = natural(accessor.at("count"), kMostCorners, what + ": count");
    if (count == 0) throw Failure(what + " is empty");
    if (!accessor.contains("bufferView")) throw Failure(what + " has no bufferView");
    const json& view = entry(file_, "bufferViews", accessor.at("bufferView"), what);
    const uint64_t item = indices ? bytes : 3 * bytes;
    uint64_t stride = natural(view, "byteStride", 252, what);
    if (stride == 0) stride = item;
    const uint64_t begin = natural(accessor, "byteOffset", kMostBytes, what);
    if (stride < item || begin + stride * (count - 1) + item > lengthOf(view, what)) {
      throw Failure(what + " goes beyond its bufferView");
    }
    return count;
  }

  /// Of a view, which lies within its buffer.
  uint64_t lengthOf(const json& view, const std::string& what) const {
    const json& buffer = entry(file_, "buffers", view.at("buffer"), what);
    const uint64_t all = natural(buffer, "byteLength", kMostBytes, what);
    const uint64_t begin = natural(view, "byteOffset", kMostBytes, what);
    const uint64_t length = natural(view, "byteLength", kMostBytes, what);
    if (begin + length > all) throw Failure(what + ": its bufferView goes beyond its buffer");
    if (!buffer.contains("uri") && all > binaryBytes_) {
      throw Failure(what + ": its buffer has " + std::to_string(all) + " bytes, but the file " +
                    std::to_string(binaryBytes_));
    }
    return length;
  }

  /// Each node has one parent at most, as glTF wants it: else a small file could make any number.
  void checkTree() const {
    const json& nodes = listOf(file_, "nodes");
    constexpr std::size_t kNone = ~std::size_t{0};
    std::vector<std::size_t> parents(nodes.size(), kNone);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const json& child : listOf(nodes[i], "children")) {
        const std::string what = "node " + std::to_string(i) + ": a child";
        std::size_t& parent = parents[natural(child, nodes.size() - 1, what)];
        if (parent != kNone) throw Failure("node " + child.dump() + " has two parents");
        parent = i;
      }
    }
    std::vector<std::size_t> depths(nodes.size(), 0);  // 0: not known yet
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::vector<std::size_t> path;
      std::size_t at = i;
      for (; at != kNone && depths[at] == 0 && path.size() <= kDeepestNode; at = parents[at]) {
        path.push_back(at);
      }
      std::size_t depth = at == kNone ? 0 : depths[at];
      if (depth + path.size() > kDeepestNode) {
        throw Failure("node " + std::to_string(i) + " is its own ancestor, or more than " +
                      std::to_string(kDeepestNode) + " levels deep");
      }
      for (; !path.empty(); path.pop_back()) depths[path.back()] = ++depth;
    }
  }

  const json& file_;
  const std::size_t binaryBytes_;
};

}  // namespace

json gltfGeometry(const json& file, std::size_t binaryBytes) {
  return Geometry(file, binaryBytes).run();
}

}  // namespace command
