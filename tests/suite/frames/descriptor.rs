//! A valid frame descriptor of 64x32 pixels, and the data that it points to.

use crate::prelude::*;
use cellray::work;
use cellray::work::{Addresses, EyeSpheres, Order, Projection, Units};
use protocol::layout::BOX_CODE;

/// Width and height in pixels: two tiles.
pub const SIZE: (u32, u32) = (64, 32);

/// A frame without its addresses in main memory, which are 0.
pub struct Descriptor {
    pub frame: Frame,
    pub spheres: Vec<u8>,
    /// The block of Whitted's model, or zeros without such a scene.
    pub block: Vec<u8>,
    /// The blocks of the scene's mesh, or none.
    pub mesh: Vec<u8>,
    /// The program's code for depth shading, or with Whitted's model for meshes.
    pub code: Vec<u8>,
    /// Its materials in main memory, or none.
    pub materials: Vec<u8>,
    /// The tiles of its textures, or none.
    pub textures: Vec<u8>,
    /// The program's code that looks up textures.
    pub texture_code: Vec<u8>,
    /// The program's code that interpolates colours.
    pub colour_code: Vec<u8>,
    pub cuts_code: Vec<u8>,
    /// The work units. Each SPU's share is a slice of them.
    pub units: Vec<u8>,
    /// The scene, whose memory the frame points to if it has a height field.
    pub scene: Scene,
    /// The memory for the picture. The frame contains its address.
    pub framebuffer: Memory,
}

impl Descriptor {
    pub fn of(scene: &scenes::Scene, spus: u32) -> Self {
        let scene = Scene::from_nff(scene).unwrap();
        let (width, height) = SIZE;
        let mut framebuffer = Memory::new(Geometry { width, height }).unwrap();
        let target = framebuffer.target();
        let camera = scene.camera(width, height).unwrap();
        let mut records = EyeSpheres::default();
        let projection = Projection::new(&camera, target.geometry);
        let program = Settings::default().program;
        let (depth_code, mesh_code) = (program.depth_code(), program.mesh_code());
        let texture_code = program.texture_code();
        let box_code = program.box_code();
        let cuts_code = program.cuts_code();
        let [colour_code, height_code] = [program.colour_code(), program.height_code()];
        let program = program.formulations().unwrap();
        records.cull(scene.spheres(), &projection, Skip::Misses, program.eye.record);
        let mut units = Units::default();
        units.split(&[0, 1], spus, Split::Slices, None);
        let frame = work::describe(&Order {
            scene: &scene,
            camera: &camera,
            target: &target,
            addresses: Addresses {
                spheres: 0,
                scene: 0,
                depth_code: 0,
                depth_code_bytes: depth_code.len() as u32,
                mesh: 0,
                mesh_code: 0,
                mesh_code_bytes: mesh_code.len() as u32,
                texture_code: 0,
                texture_code_bytes: texture_code.len() as u32,
                cuts_code: 0,
                cuts_code_bytes: cuts_code.len() as u32,
                colour_code: 0,
                height_code: 0,
                unit_counter: 0,
                statistics: 0,
                waiting: 0,
                units: 0,
                costs: 0,
                paths: 0,
                changes: 0,
            },
            sphere_count: records.records().len() as u32,
            units: &units,
            cuts: None,
            change_count: 0,
            number: 1,
            spus,
            split: Split::Slices,
            skip: Skip::Misses,
            check_shaders: false,
        });
        let colour_code = if frame.heights.get() == 0 { colour_code } else { height_code };
        let block = scene.block();
        let code = if block.is_some() { mesh_code } else { depth_code };
        let mesh = block.and_then(|block| block.mesh());
        let textures = mesh.and_then(|mesh| mesh.textures);
        let textures = textures.map_or(Vec::new(), |textures| textures.bytes().to_vec());
        let materials = mesh.and_then(|mesh| mesh.table);
        let materials = materials.map_or(Vec::new(), |table| table.bytes().to_vec());
        let mesh = mesh.map_or(Vec::new(), |mesh| mesh.blocks.bytes().to_vec());
        let mut block = block.map_or(vec![0; 128], |block| block.bytes().to_vec());
        if frame.box_trees.get() != 0 {
            let start = (BOX_CODE - SCENE_ADDRESS) as usize;
            block[start..start + box_code.len()].copy_from_slice(&box_code);
        }
        Self {
            frame,
            spheres: records.bytes().to_vec(),
            block,
            mesh,
            code,
            materials,
            textures,
            texture_code,
            colour_code,
            cuts_code,
            units: units.bytes().to_vec(),
            scene,
            framebuffer,
        }
    }
}
