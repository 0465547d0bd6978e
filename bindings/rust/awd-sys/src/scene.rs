// SPDX-License-Identifier: Apache-2.0
//! awd/scene.h: triangles, materials, queries.

use crate::types::*;

constants! {
    AWD_MESH_SHARED: u32 = 1;
}

structs! {
    pub struct AWDMaterialDesc {
        structSize: usize,
        albedo: [f32; 3],
        emission: [f32; 3],
    }

    pub struct AWDMeshDesc {
        structSize: usize,
        vertices: AWDBuffer,
        indices: AWDBuffer,
        materials: AWDBuffer,
        patches: AWDBuffer,
        material: u32,
        flags: u32,
    }

    pub struct AWDSceneInfo {
        structSize: usize,
        triangles: u64,
        skipped: u64,
        lights: u64,
        patches: u64,
        meshes: u32,
        materials: u32,
        lower: [f32; 3],
        upper: [f32; 3],
    }

    pub struct AWDRay {
        origin: [f32; 3],
        tnear: f32,
        direction: [f32; 3],
        tfar: f32,
    }

    pub struct AWDHit {
        t: f32,
        normal: [f32; 3],
        u: f32,
        v: f32,
        mesh: u32,
        triangle: u32,
        material: u32,
        patch: u32,
    }
}

inits! {
    AWDMaterialDesc;
    AWDMeshDesc;
    AWDSceneInfo;
}

functions! {
    fn awdNewScene(device: AWDDevice, scene: *mut AWDScene) -> AWDResult;
    fn awdRetainScene(scene: AWDScene);
    fn awdReleaseScene(scene: AWDScene);
    fn awdAddMaterial(
        scene: AWDScene,
        desc: *const AWDMaterialDesc,
        material: *mut u32,
    ) -> AWDResult;
    fn awdAddMesh(scene: AWDScene, desc: *const AWDMeshDesc, mesh: *mut u32) -> AWDResult;
    fn awdCommitScene(scene: AWDScene) -> AWDResult;
    fn awdGetSceneInfo(scene: AWDScene, info: *mut AWDSceneInfo) -> AWDResult;
    fn awdIntersect(
        scene: AWDScene,
        rays: *const AWDRay,
        count: usize,
        hits: *mut AWDHit,
    ) -> AWDResult;
    fn awdOccluded(
        scene: AWDScene,
        rays: *const AWDRay,
        count: usize,
        occluded: *mut u8,
    ) -> AWDResult;
    fn awdGetTrianglePatch(
        scene: AWDScene,
        mesh: u32,
        triangle: u32,
        back: i32,
        patch: *mut u32,
    ) -> AWDResult;
    fn awdGetPointPatch(scene: AWDScene, point: *const f32, patch: *mut u32) -> AWDResult;
}
