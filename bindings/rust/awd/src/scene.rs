// SPDX-License-Identifier: Apache-2.0
//! The scene: being built, and committed.

use std::sync::Arc;

use awd_sys::*;

use crate::error::check;
use crate::handle::Handle;
use crate::{Device, Hit, Material, Mesh, Ray, Result, Returned, Vector, INVALID_ID};

/// A scene that is being uploaded.
///
/// ```
/// # fn main() -> awd::Result<()> {
/// let device = awd::Device::new(Default::default())?;
/// let mut builder = awd::SceneBuilder::new(&device)?;
/// let lamp = awd::Material { albedo: [0.0; 3], emission: [4.0; 3] };
/// let material = builder.add_material(&lamp)?;
/// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let indices = [[0, 1, 2]];
/// builder.add_mesh(&awd::Mesh {
///     vertices: (&vertices).into(),
///     indices: (&indices).into(),
///     material,
///     ..Default::default()
/// })?;
/// let scene = builder.commit()?;
/// assert_eq!(scene.info()?.lights, 1);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct SceneBuilder {
    handle: Handle<AWDSceneImpl>,
}

impl SceneBuilder {
    /// Makes an empty scene.
    pub fn new(device: &Device) -> Result<Self> {
        // Safety: the pointers are good.
        let handle = Handle::make(device, |raw| unsafe { awdNewScene(device.raw(), raw) })?;
        Ok(SceneBuilder { handle })
    }

    /// Adds a material; its number counts from 0.
    pub fn add_material(&mut self, material: &Material) -> Result<u32> {
        let Material { albedo, emission } = *material;
        let desc = AWDMaterialDesc { albedo, emission, ..Default::default() };
        let mut number = 0;
        // Safety: the pointers are good.
        check(unsafe { awdAddMaterial(self.handle.raw(), &desc, &mut number) })?;
        Ok(number)
    }

    /// Adds a mesh, which is copied; its number counts from 0. Contents are checked by
    /// [`commit`](SceneBuilder::commit).
    pub fn add_mesh(&mut self, mesh: &Mesh) -> Result<u32> {
        let desc = mesh.desc();
        let mut number = 0;
        // Safety: the buffers are borrowed, and copied by the call.
        check(unsafe { awdAddMesh(self.handle.raw(), &desc, &mut number) })?;
        Ok(number)
    }

    /// Checks everything, finds planar pieces and lights, and builds the ray tracing structure.
    ///
    /// # Errors
    /// A bad vertex, index, material or patch is named; `Cancelled` by the progress closure. The
    /// scene comes back as it was.
    pub fn commit(self) -> Result<Scene, Returned<SceneBuilder>> {
        // Safety: no pointers.
        match self.handle.finish(unsafe { awdCommitScene(self.handle.raw()) }) {
            Ok(()) => Ok(Scene { handle: Arc::new(self.handle) }),
            Err(error) => Err(Returned { error, value: self }),
        }
    }
}

/// Figures of a committed scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneInfo {
    /// Uploaded.
    pub triangles: u64,
    /// Of these, without area.
    pub skipped: u64,
    /// Coplanar connected emissive triangles of one material are one.
    pub lights: u64,
    /// Host's ids in use and planar pieces; each has two sides.
    pub patches: u64,
    /// How many were added.
    pub meshes: u32,
    /// How many were added.
    pub materials: u32,
    /// Of the bounding box; 0 if there is no triangle.
    pub lower: Vector,
    /// Of the bounding box.
    pub upper: Vector,
}

/// A committed scene, to be queried from any thread and rendered. Clones are the same scene.
#[derive(Clone, Debug)]
pub struct Scene {
    handle: Arc<Handle<AWDSceneImpl>>,
}

impl Scene {
    pub(crate) fn raw(&self) -> AWDScene {
        self.handle.raw()
    }

    pub(crate) fn device(&self) -> &Device {
        self.handle.device()
    }

    /// The scene to be changed and committed again; handed back if a clone or a render still uses
    /// it.
    pub fn edit(self) -> Result<SceneBuilder, Scene> {
        match Arc::try_unwrap(self.handle) {
            Ok(handle) => Ok(SceneBuilder { handle }),
            Err(handle) => Err(Scene { handle }),
        }
    }

    /// Figures of the scene.
    pub fn info(&self) -> Result<SceneInfo> {
        let mut info = AWDSceneInfo::default();
        // Safety: the pointer is good.
        check(unsafe { awdGetSceneInfo(self.raw(), &mut info) })?;
        Ok(SceneInfo {
            triangles: info.triangles,
            skipped: info.skipped,
            lights: info.lights,
            patches: info.patches,
            meshes: info.meshes,
            materials: info.materials,
            lower: info.lower,
            upper: info.upper,
        })
    }

    /// What each ray meets first.
    pub fn intersect(&self, rays: &[Ray]) -> Result<Vec<Hit>> {
        let mut hits = vec![Hit::default(); rays.len()];
        // Safety: as many as are told, of the same layout.
        check(unsafe {
            let (from, to) = (rays.as_ptr().cast(), hits.as_mut_ptr().cast());
            awdIntersect(self.raw(), from, rays.len(), to)
        })?;
        Ok(hits)
    }

    /// Whether anything lies on each ray.
    pub fn occluded(&self, rays: &[Ray]) -> Result<Vec<bool>> {
        let mut occluded = vec![0u8; rays.len()];
        // Safety: as many as are told, of the same layout.
        check(unsafe {
            awdOccluded(self.raw(), rays.as_ptr().cast(), rays.len(), occluded.as_mut_ptr())
        })?;
        Ok(occluded.into_iter().map(|byte| byte != 0).collect())
    }

    /// The patch of a triangle's front or back side; None for one without area.
    pub fn triangle_patch(&self, mesh: u32, triangle: u32, back: bool) -> Result<Option<u32>> {
        let mut patch = 0;
        // Safety: the pointer is good.
        check(unsafe { awdGetTrianglePatch(self.raw(), mesh, triangle, back.into(), &mut patch) })?;
        Ok(valid(patch))
    }

    /// The patch of the triangle nearest to a point, on the side where the point is; None in an
    /// empty scene.
    pub fn point_patch(&self, point: Vector) -> Result<Option<u32>> {
        let mut patch = 0;
        // Safety: three floats.
        check(unsafe { awdGetPointPatch(self.raw(), point.as_ptr(), &mut patch) })?;
        Ok(valid(patch))
    }
}

pub(crate) fn valid(id: u32) -> Option<u32> {
    (id != INVALID_ID).then(|| id)
}
