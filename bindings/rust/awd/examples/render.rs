// SPDX-License-Identifier: Apache-2.0
//! Renders a room whose lamp shines at the ceiling, and shows what one patch has learned.
//!
//!     render [WIDTH [SAMPLES [FOLDER]]]

use std::env;
use std::ops::ControlFlow;
use std::path::PathBuf;

use awd::{
    Camera, Device, DeviceSettings, Image, Material, Mesh, Render, RenderSettings, Result, Scene,
    SceneBuilder, Schedule, Vector,
};

/// Two triangles.
fn add_quad(builder: &mut SceneBuilder, corners: [Vector; 4], material: u32) -> Result<u32> {
    let indices = [[0, 1, 2], [0, 2, 3]];
    let (vertices, indices) = ((&corners).into(), (&indices).into());
    builder.add_mesh(&Mesh { vertices, indices, material, ..Default::default() })
}

/// A box open to the viewer, from -1 to 1, and a lamp that faces up, with a shade below it.
fn room(device: &Device) -> Result<Scene> {
    let mut builder = SceneBuilder::new(device)?;
    let mut diffuse = |albedo, emission| builder.add_material(&Material { albedo, emission });
    let white = diffuse([0.75; 3], [0.0; 3])?;
    let red = diffuse([0.63, 0.06, 0.05], [0.0; 3])?;
    let green = diffuse([0.15, 0.48, 0.09], [0.0; 3])?;
    let lamp = diffuse([0.0; 3], [25.0, 22.0, 16.0])?;
    let corner = |x: i32, y: i32, z: i32| [x as f32, y as f32, z as f32];
    let quads = [
        ([(-1, -1, 1), (1, -1, 1), (1, -1, -1), (-1, -1, -1)], white), // floor
        ([(-1, 1, -1), (1, 1, -1), (1, 1, 1), (-1, 1, 1)], white),     // ceiling
        ([(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1)], white), // back
        ([(-1, -1, 1), (-1, -1, -1), (-1, 1, -1), (-1, 1, 1)], red),   // left
        ([(1, -1, -1), (1, -1, 1), (1, 1, 1), (1, 1, -1)], green),     // right
    ];
    for (corners, material) in quads {
        add_quad(&mut builder, corners.map(|(x, y, z)| corner(x, y, z)), material)?;
    }
    let flat = |half: f32, y: f32| {
        [[-half, y, half], [half, y, half], [half, y, -half], [-half, y, -half]]
    };
    add_quad(&mut builder, flat(0.25, 0.8), lamp)?;
    add_quad(&mut builder, flat(0.3, 0.78), white)?;
    Ok(builder.commit()?)
}

fn main() -> Result<()> {
    let mut arguments = env::args().skip(1);
    let mut number = |default| {
        let argument = arguments.next();
        argument.map_or(default, |text| text.parse().expect("a number is wanted"))
    };
    let (width, samples) = (number(256), number(64));
    let folder = PathBuf::from(arguments.next().unwrap_or_else(|| ".".to_string()));
    std::fs::create_dir_all(&folder).expect("the folder can't be made");

    let device = Device::new(DeviceSettings {
        log: Some(Box::new(|level, message| eprintln!("{:?}: {}", level, message))),
        progress: Some(Box::new(|progress| {
            eprint!("\r{} {:3.0} %  ", progress.operation, 100.0 * progress.fraction);
            ControlFlow::Continue(())
        })),
        ..Default::default()
    })?;
    let camera = Camera { eye: [0.0, 0.0, 3.5], width, height: width, ..Default::default() };
    let settings = RenderSettings { camera, seed: 1, ..Default::default() };
    let mut render = Render::new(&room(&device)?, &settings)?;
    render.passes(&Schedule { total_samples: samples, ..Default::default() })?;
    eprintln!();

    let path = folder.join("render.exr");
    let image = render.film_image()?;
    image.write_exr(&path)?;
    image.write_png(folder.join("render.png"), 0.0)?;
    if let (Some(field), Some(patch)) =
        (render.field(), render.pixel_patch(width / 2, 3 * width / 4)?)
    {
        Image::of_patch(field, patch, 256)?.write_png(folder.join("pdf.png"), 0.0)?;
    }
    let film = render.film_info()?;
    println!(
        "{} x {} pixels, {} samples each, error {:.3}: {}",
        film.width,
        film.height,
        film.samples_per_pixel,
        render.error()?.error,
        path.display()
    );
    Ok(())
}
