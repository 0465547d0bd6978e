// SPDX-License-Identifier: Apache-2.0
#include "faults/life.h"

#include "support/random.h"

namespace awdtest {

namespace {

/// A peak in the middle of the cube.
double peak(const double* point, uint32_t dimensions) {
  double squares = 0.0;
  for (uint32_t a = 0; a < dimensions; ++a) squares += (point[a] - 0.5) * (point[a] - 0.5);
  return 1.0 / (0.01 + squares);
}

SceneBuilder roomOf(uint32_t panels) {
  SceneBuilder room = sevenLampRoom();
  if (panels > 0) room.box({0.5, 0, 0.5}, {1.5, 1, 1.5}, false, {0}, panels);
  return room;
}

}  // namespace

Life::Life(const AWDDeviceDesc& desc, std::string folder, bool refits, const Size& size)
    : desc_(desc),
      fieldPath_(folder + "/field"),
      renderPath_(folder + "/render"),
      exrPath_(folder + "/image.exr"),
      pngPath_(folder + "/image.png"),
      is_(size),
      room_(roomOf(size.panels)) {
  for (const float light : {0.0f, 0.0f, 0.0f, 0.0f, 12.0f, 2.0f, 4.0f, 6.0f, 3.0f, 5.0f, 8.0f}) {
    AWDMaterialDesc material = {sizeof material, {0.5f, 0.5f, 0.5f}, {light, light, light}};
    materials_.push_back(material);
  }
  pixels_.resize(size_t{3} * is_.pixels * is_.pixels);
  renderDesc_.camera = &camera_;
  renderDesc_.seed = 7;
  schedule_.samplesPerPass = passes_.data();
  schedule_.passCount = 2;
  schedule_.resume = 1;  // so that the call can be repeated
  fieldDesc_.patchSamples = 30;
  hostDesc_.patches = AWD_PATCHES_HOST;
  hostDesc_.lightCount = 3;
  addScene();
  addRender();
  addParts();
  addField();
  addCheckpoint();
  addDensity("grid", grid_, AWD_STRUCTURE_GRID, AWD_ESTIMATOR_DEFAULT);
  addDensity("tree", tree_, AWD_STRUCTURE_TREE, AWD_ESTIMATOR_DEFAULT);
  if (refits) addDensity("refit", refit_, AWD_STRUCTURE_TREE, AWD_ESTIMATOR_REFIT);
  addImages();
}

Life::~Life() {
  awdReleaseDevice(device_);  // parents first: children keep them alive
  awdReleaseScene(scene_);
  for (AWDRender render : {render_, loadedRender_}) awdReleaseRender(render);
  for (AWDField field : {field_, host_, loaded_, read_}) awdReleaseField(field);
  for (AWDDensity density : {grid_, tree_, refit_, fork_, copy_}) awdReleaseDensity(density);
  for (AWDImage image : {image_, patchImage_, readImage_}) awdReleaseImage(image);
}

void Life::step(const char* name, std::function<AWDResult()> call, std::function<void()> after) {
  steps_.push_back({name, std::move(call), std::move(after)});
}

void Life::addScene() {
  step("awdNewDevice", [this] { return awdNewDevice(&desc_, &device_); });
  step("awdNewScene", [this] { return awdNewScene(device_, &scene_); });
  for (const AWDMaterialDesc& material : materials_) {
    step("awdAddMaterial", [&] { return awdAddMaterial(scene_, &material, nullptr); });
  }
  step("awdAddMesh", [this] { return awdAddMesh(scene_, &mesh_, nullptr); });
  step("awdCommitScene", [this] { return awdCommitScene(scene_); });
  step("awdCommitScene again", [this] { return awdCommitScene(scene_); });
}

void Life::addFilm(const char* name, AWDRender& render) {
  step(
      "awdReadFilm",
      [this, &render] { return awdReadFilm(render, AWD_FILM_RADIANCE, pixels_.data(), 0, 0); },
      [this, name] { keep(name, pixels_); });
}

void Life::addSavedField(const char* name, AWDField& field) {
  step(
      "awdSaveField, its size", [this, &field] { return awdSaveField(field, nullptr, 0, &size_); },
      [this] { bytes_.assign(size_, 0); });
  step(
      "awdSaveField",
      [this, &field] { return awdSaveField(field, bytes_.data(), bytes_.size(), &size_); },
      [this, name] { keep(name, bytes_); });
}

void Life::addRender() {
  step("awdNewSceneField", [this] { return awdNewSceneField(scene_, &fieldDesc_, &field_); });
  step("awdNewRender", [this] { return awdNewRender(scene_, field_, &renderDesc_, &render_); });
  step("awdRenderPasses", [this] { return awdRenderPasses(render_, &schedule_); });
  addFilm("film", render_);
}

void Life::addParts() {
  step(
      "awdRenderPassPart",
      [this] {
        schedule_.passCount = 3;
        return awdRenderPassPart(render_, &schedule_, 0, 1, &samplesPerPixel_);
      },
      [this] { numbers_.clear(); });
  step(
      "awdExportPass, its size",
      [this] { return awdExportPass(render_, nullptr, 0, &sums_, &maxima_); },
      [this] { numbers_.assign(sums_ + maxima_, 0); });
  step("awdExportPass", [this] {
    return awdExportPass(render_, numbers_.data(), numbers_.size(), &sums_, &maxima_);
  });
  step("awdImportPass",
       [this] { return awdImportPass(render_, numbers_.data(), numbers_.size(), nullptr); });
  addFilm("film of the part", render_);
  addSavedField("field after the part", field_);
}

void Life::addField() {
  step("awdAdaptField", [this] { return awdAdaptField(field_, nullptr); });
  addSavedField("field", field_);
  step("awdLoadField",
       [this] { return awdLoadField(device_, bytes_.data(), bytes_.size(), &loaded_); });
  step("awdNewField", [this] { return awdNewField(device_, &hostDesc_, &host_); });
  // Patches that lie far apart: each takes memory where it is found in the table.
  for (uint32_t i = 0; i < 6; ++i) patches_.push_back(i * 0x01234567u);
  Random random(3);
  for (size_t i = 0; i < 3 * patches_.size(); ++i) uniforms_.push_back(random.uniform());
  for (size_t i = 0; i < patches_.size(); ++i) values_.push_back(0.25 * double(i));
  samples_.resize(patches_.size());
  static const std::vector<float> kUp = [] {
    std::vector<float> up;
    for (int i = 0; i < 6; ++i) up.insert(up.end(), {0.0f, 0.0f, 1.0f});
    return up;
  }();
  step(
      "awdSampleFieldBatch",
      [this] {
        return awdSampleFieldBatch(host_, patches_.size(), patches_.data(), kUp.data(),
                                   uniforms_.data(), samples_.data());
      },
      [this] {
        for (uint32_t i = 0; i < 5; ++i) {
          path_.push_back({0x76543210u >> i,
                           i < 4 ? 0.5f : 0.0f,
                           samples_[i],
                           {0.1f, 0.2f, 0.3f},
                           {1.0f, 1.0f, 0.5f},
                           {0.3f, 0.3f, 0.3f}});
        }
      });
  step("awdRecordField", [this] { return awdRecordField(host_, 77, &samples_[0], 2.0); });
  step("awdRecordLight", [this] { return awdRecordLight(host_, 0x4321u, 1, 2.0); });
  step("awdRecordFieldBatch", [this] {
    return awdRecordFieldBatch(host_, patches_.size(), patches_.data(), samples_.data(),
                               values_.data());
  });
  step("awdRecordFieldPath",
       [this] { return awdRecordFieldPath(host_, path_.size(), path_.data(), nullptr, nullptr); });
  addSavedField("field of the host's patches", host_);
  step("awdMarkField", [this] { return awdMarkField(host_); });
  step("awdRecordField after the mark",
       [this] { return awdRecordField(host_, 0x11111111u, &samples_[1], 3.0); });
  step("awdRevertField", [this] { return awdRevertField(host_); });
  step("awdAdaptField of the host's patches", [this] { return awdAdaptField(host_, nullptr); });
  step("awdGetFieldPatches", [this] { return awdGetFieldPatches(host_, nullptr, 0, &size_); });
  addSavedField("adapted field of the host's patches", host_);
  step(
      "awdExportField",
      [this] { return awdExportField(loaded_, nullptr, 0, nullptr, 0, &sums_, &maxima_); },
      [this] { numbers_.assign(sums_ + maxima_, 0); });
  step("awdExportField", [this] {
    return awdExportField(loaded_, nullptr, 0, numbers_.data(), numbers_.size(), &sums_, &maxima_);
  });
  step("awdImportField",
       [this] { return awdImportField(loaded_, nullptr, 0, numbers_.data(), numbers_.size()); });
  step("awdMergeField", [this] { return awdMergeField(loaded_, field_); });
  addSavedField("merged field", loaded_);
}

void Life::addCheckpoint() {
  step("awdWriteField", [this] { return awdWriteField(field_, fieldPath_.c_str()); });
  step("awdReadField", [this] { return awdReadField(device_, fieldPath_.c_str(), &read_); });
  addSavedField("read field", read_);
  step("awdSaveRender", [this] { return awdSaveRender(render_, renderPath_.c_str()); });
  step("awdLoadRender", [this] {
    return awdLoadRender(scene_, renderPath_.c_str(), nullptr, nullptr, &loadedRender_);
  });
  step("awdRenderPass", [this] { return awdRenderPass(loadedRender_, 2, nullptr); });
  addFilm("film that went on", loadedRender_);
}

void Life::addDensity(const std::string& name, AWDDensity& density, AWDDensityStructure structure,
                      AWDEstimator estimator) {
  AWDDensityDesc& desc = densityDescs_[name];
  desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 2;
  desc.structure = structure;
  desc.estimator = estimator;
  desc.combination = AWD_COMBINE_CROSS_VARIANCE;
  static const AWDDensityAxis kHaar[] = {{"haar", 0, 0}, {"haar", 0, 0}};
  desc.axes = kHaar;  // nested
  step(
      "awdNewDensity", [this, &desc, &density] { return awdNewDensity(device_, &desc, &density); },
      [this] {
        Random random(5);
        uniforms_.resize(2 * is_.points);
        for (double& u : uniforms_) u = random.uniform();
        points_.resize(2 * is_.points);
        pdfs_.resize(is_.points);
        values_.resize(is_.points);
      });
  for (int pass = 0; pass < 2; ++pass) {
    step(
        "awdSampleDensity",
        [this, &density] {
          return awdSampleDensity(density, is_.points, uniforms_.data(), points_.data(),
                                  pdfs_.data(), nullptr);
        },
        [this] {
          for (size_t i = 0; i < is_.points; ++i) values_[i] = peak(&points_[2 * i], 2);
        });
    step("awdForkDensity", [this, &density] { return awdForkDensity(density, &fork_); });
    step("awdRecordDensity", [this] {
      return awdRecordDensity(fork_, is_.points, points_.data(), pdfs_.data(), nullptr,
                              values_.data());
    });
    step(
        "awdJoinDensity", [this, &density] { return awdJoinDensity(density, fork_); },
        [this] {
          awdReleaseDensity(fork_);
          fork_ = nullptr;
        });
    step(
        "awdExportDensityStatistics",
        [this, &density] { return awdExportDensityStatistics(density, nullptr, 0, &size_); },
        [this] { bytes_.assign(size_, 0); });
    step("awdExportDensityStatistics", [this, &density] {
      return awdExportDensityStatistics(density, bytes_.data(), bytes_.size(), &size_);
    });
    step("awdAddDensityStatistics", [this, &density] {
      return awdAddDensityStatistics(density, bytes_.data(), bytes_.size());
    });
    step("awdAdaptDensity", [&density] { return awdAdaptDensity(density, nullptr); });
  }
  step("awdRefineDensity", [&density] { return awdRefineDensity(density, AWD_ALL_AXES); });
  step(
      "awdGetDensityDetailEnergy",
      [this, &density] { return awdGetDensityDetailEnergy(density, nullptr, 0, &size_); },
      [this, &density] {
        AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
        must(awdGetDensityInfo(density, &info));
        values_.assign(std::max<size_t>(info.coefficients, is_.points), 0.0);
        size_ = info.coefficients;
      });
  for (const AWDCoefficientForm form : {AWD_COEFFICIENTS_ORTHONORMAL, AWD_COEFFICIENTS_SCALING}) {
    step("awdGetDensityCoefficients", [this, form, &density] {
      return awdGetDensityCoefficients(density, form, values_.data(), values_.size());
    });
  }
  step("awdSetDensityCoefficients",
       [this, &density] { return awdSetDensityCoefficients(density, values_.data(), size_); });
  step("awdGetDensityIntegral", [&density] {
    const double lower[] = {0.1, 0.2}, upper[] = {0.7, 0.6};
    double integral = 0.0;
    return awdGetDensityIntegral(density, lower, upper, &integral);
  });
  step("awdGetDensityEstimate", [&density] {
    AWDDensityEstimate estimate = AWD_DENSITY_ESTIMATE_INIT;
    return awdGetDensityEstimate(density, &estimate);
  });
  step(
      "awdSaveDensity", [this, &density] { return awdSaveDensity(density, nullptr, 0, &size_); },
      [this] { bytes_.assign(size_, 0); });
  step(
      "awdSaveDensity",
      [this, &density] { return awdSaveDensity(density, bytes_.data(), bytes_.size(), &size_); },
      [this, name] { keep(name, bytes_); });
  step("awdLoadDensity",
       [this] { return awdLoadDensity(device_, bytes_.data(), bytes_.size(), &copy_); });
  step(
      "awdSaveDensity of the copy",
      [this] { return awdSaveDensity(copy_, bytes_.data(), bytes_.size(), &size_); },
      [this, name] {
        keep(name + " loaded", bytes_);
        awdReleaseDensity(copy_);
        copy_ = nullptr;
      });
}

void Life::addImages() {
  step("awdNewFilmImage", [this] { return awdNewFilmImage(render_, &image_); });
  step("awdNewPatchImage", [this] { return awdNewPatchImage(host_, 77, 8, &patchImage_); });
  step("awdSetImageChannel",
       [this] { return awdSetImageChannel(image_, "layer.of.mine", pixels_.data(), 0, 0); });
  step("awdSetImageMetadata",
       [this] { return awdSetImageMetadata(image_, "a.key.of.my.own", "with a value"); });
  step("awdWriteImageEXR", [this] { return awdWriteImageEXR(image_, exrPath_.c_str()); });
  step("awdWriteImagePNG", [this] { return awdWriteImagePNG(image_, pngPath_.c_str(), nullptr); });
  step("awdReadImage", [this] { return awdReadImage(device_, exrPath_.c_str(), &readImage_); });
  step(
      "awdGetImageChannel",
      [this] { return awdGetImageChannel(readImage_, "variance.G", pixels_.data(), 0, 0); },
      [this] { keep("image", pixels_); });
}

}  // namespace awdtest
