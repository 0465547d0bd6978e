// SPDX-License-Identifier: Apache-2.0
#include "rival_methods.h"

#include <algorithm>

#include "named.h"
#include "support/handles.h"

namespace bench::rival {
namespace {

using awdtest::must;

/// A field of all defaults.
class FieldGuide : public host::Guide {
 public:
  FieldGuide(AWDDevice device, const host::Scene& scene) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    std::copy(scene.info().lower, scene.info().lower + 3, desc.lower);
    std::copy(scene.info().upper, scene.info().upper + 3, desc.upper);
    must(awdNewField(device, &desc, field_.out()));
    if (scene.hasLights()) must(awdSetFieldScale(field_, scene.brightest()));
  }

  void choose(const host::Place& place, const double uniforms[3], AWDPathVertex& vertex) override {
    float position[3], normal[3];
    host::store(place.position, position);
    host::store(place.normal, normal);
    must(awdFindPatch(field_, position, normal, &vertex.patch));
    must(awdSampleField(field_, vertex.patch, normal, uniforms, &vertex.sample));
  }
  void learn(const host::Path& path) override {
    must(awdRecordFieldPath(field_, path.vertices.size(), path.vertices.data(), nullptr, nullptr));
  }
  void adapt() override { must(awdAdaptField(field_, nullptr)); }

 private:
  awdtest::Field field_;
};

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> list = {
        {"cosine", "unguided", [](AWDDevice, const host::Scene&) { return nullptr; }},
        {"awd", "a field of this library, all defaults",
         [](AWDDevice device, const host::Scene& scene) {
           return std::make_unique<FieldGuide>(device, scene);
         }},
    };
#ifdef AWD_BENCH_OPENPGL
    for (Method& method : openPglMethods()) list.push_back(std::move(method));
#endif
    return list;
  }();
  return all;
}

const Method& methodNamed(const std::string& name) { return named(methods(), name); }

}  // namespace bench::rival
