//! Makes a frame's record of a scene, a camera and a framebuffer.

use glam::DVec3;
use scenes::Camera;
use zerocopy::FromZeros as _;
use zerocopy::big_endian::F32;

use super::cuts::Cuts;
use super::policy::{Skip, Split};
use super::units::Units;
use crate::framebuffer::{Geometry, Target};
use crate::scene::block::SceneBlock;
use crate::scene::single::{single, singles};
use crate::scene::{Colour, Scene};
use protocol::layout::{
    EYE_CODE_CAPACITY, FEATURE_BRANCHES, FEATURE_CHECK_SHADERS, FEATURE_COLOURS, FEATURE_CUTS,
    FEATURE_HEIGHTS, FEATURE_MATERIALS, FEATURE_MESH, FEATURE_NO_SHADOWS, FEATURE_ROLL_OFF,
    FEATURE_SPHERES, FEATURE_SRGB, FEATURE_TEXTURES, FEATURE_VISIBILITY, FEATURE_WHITTED, Frame,
    MAGIC, SKIP_MISSES, SKIP_NOTHING, SPLIT_SLICES, SPLIT_UNITS, VERSION,
};

/// The addresses of a frame's records in main memory.
#[derive(Clone, Copy, Debug)]
pub struct Addresses {
    /// The sphere records of depth shading.
    pub spheres: u64,
    /// The block of Whitted's model.
    pub scene: u64,
    /// The first block of the scene's mesh.
    pub mesh: u64,
    /// The program's code for depth shading.
    pub depth_code: u64,
    /// The number of its bytes.
    pub depth_code_bytes: u32,
    /// The program's code that traces meshes.
    pub mesh_code: u64,
    /// The number of its bytes.
    pub mesh_code_bytes: u32,
    /// The program's code that looks up textures.
    pub texture_code: u64,
    /// The number of its bytes.
    pub texture_code_bytes: u32,
    /// The program's code that finds height fields by cuts.
    pub cuts_code: u64,
    /// The number of its bytes.
    pub cuts_code_bytes: u32,
    /// The program's code that interpolates colours.
    pub colour_code: u64,
    /// The program's code for height fields, and after it that for colours.
    pub height_code: u64,
    /// The unit counter.
    pub unit_counter: u64,
    /// The statistics records.
    pub statistics: u64,
    /// The capacity of each SPU's queue of rays.
    pub waiting: u64,
    /// The work units.
    pub units: u64,
    /// The lines for the units' costs.
    pub costs: u64,
    /// The paths of the page's tiles; 0 if the frame keeps none.
    pub paths: u64,
    /// The nodes around the frame's changes.
    pub changes: u64,
}

/// Everything that a frame's record is made of.
#[derive(Clone, Copy)]
pub struct Order<'a> {
    /// The scene, with its background and depth shading.
    pub scene: &'a Scene,
    /// The camera, which defines the primary rays.
    pub camera: &'a Camera,
    /// The page of the framebuffer that the picture is written to.
    pub target: &'a Target,
    /// The addresses of the records.
    pub addresses: Addresses,
    /// The number of sphere records.
    pub sphere_count: u32,
    /// The work units.
    pub units: &'a Units,
    /// The cuts by which rays from the eye find the ground, if they do.
    pub cuts: Option<Cuts>,
    /// The number of nodes around the frame's changes.
    pub change_count: u32,
    /// The number of the frame.
    pub number: u32,
    /// The number of SPUs.
    pub spus: u32,
    /// How the frame is split among the SPUs.
    pub split: Split,
    /// Which tests the SPUs may skip.
    pub skip: Skip,
    /// Whether the SPUs check each call of a shader.
    pub check_shaders: bool,
}

/// The record of a frame.
#[must_use]
pub fn describe(order: &Order) -> Frame {
    let Order { scene, camera, target, addresses, units, .. } = *order;
    let mut frame = Frame::new_zeroed();
    frame.magic = MAGIC.into();
    frame.version = VERSION.into();
    frame.size = (size_of::<Frame>() as u32).into();
    frame.number = order.number.into();
    frame.spus = order.spus.into();
    frame.split = match order.split {
        Split::Units => SPLIT_UNITS,
        Split::Slices => SPLIT_SLICES,
    }
    .into();
    frame.skip = match order.skip {
        Skip::Misses => SKIP_MISSES,
        Skip::Nothing => SKIP_NOTHING,
    }
    .into();
    frame.width = target.geometry.width.into();
    frame.height = target.geometry.height.into();
    frame.stride = target.stride.into();
    frame.framebuffer = (target.base.as_ptr().expose_provenance() as u64).into();
    frame.spheres = addresses.spheres.into();
    frame.unit_counter = addresses.unit_counter.into();
    frame.statistics = addresses.statistics.into();
    frame.units = addresses.units.into();
    frame.costs = addresses.costs.into();
    frame.paths = addresses.paths.into();
    frame.changes = addresses.changes.into();
    frame.change_count = order.change_count.into();
    frame.unit_count = (units.lines().len() as u32).into();
    frame.slices = units.slices();
    frame.sphere_count = order.sphere_count.into();
    frame.red_shift = target.format.red_shift.into();
    frame.green_shift = target.format.green_shift.into();
    frame.blue_shift = target.format.blue_shift.into();

    let depth = scene.depth();
    let range = (depth.far - depth.near) as f32;
    // If the range has no width, the brightness is clamped to 1 everywhere.
    let (far, scale) =
        if range > 0.0 { (depth.far as f32, range.recip()) } else { (f32::MAX, 1.0) };
    frame.depth_far = far.into();
    frame.depth_scale = scale.into();

    let basis = if scene.block().is_some() {
        in_singles(camera, target.geometry)
    } else {
        [camera.corner, camera.right, camera.down].map(singles)
    };
    [frame.corner, frame.right, frame.down] = basis.map(quadword);
    let colour = scene.render_options().colour;
    frame.background = quadword(singles(colour.light(scene.background())));
    if let Some(block) = scene.block() {
        frame.scene = addresses.scene.into();
        frame.waiting = addresses.waiting.into();
        frame.scene_bytes = (block.bytes().len() as u32).into();
        frame.ray_depth = block.ray_depth().into();
        frame.least_weight = block.least_weight().into();
        frame.batch = block.batch().into();
        frame.lights = block.light_address().into();
        frame.light_count = block.light_count().into();
        frame.trees = block.bvhs();
        frame.box_trees = block.box_trees().into();
        frame.ambient = block.ambient();
        frame.fog = block.fog();
        frame.eye = quadword(singles(camera.eye));
    } else {
        frame.code = addresses.depth_code.into();
        frame.code_bytes = addresses.depth_code_bytes.into();
    }
    if let Some(mesh) = scene.block().and_then(SceneBlock::mesh) {
        frame.mesh_eye = mesh.eye;
        frame.mesh = addresses.mesh.into();
        frame.mesh_blocks = mesh.blocks.count().into();
        frame.code = addresses.mesh_code.into();
        frame.code_bytes = addresses.mesh_code_bytes.into();
        frame.mesh_materials = mesh.materials.into();
        frame.mesh_material_count = mesh.material_count.into();
        frame.mesh_cache = mesh.cache.into();
        frame.mesh_slots = mesh.slots.into();
        if let Some(heights) = mesh.heights {
            frame.heights = heights.address().into();
            frame.colour_code = addresses.height_code.into();
            if let Some(cuts) = order.cuts {
                frame.cut_lat = cuts.lat;
                frame.cut_den = cuts.den;
                frame.cut_num = cuts.num;
                frame.cut_ahead = cuts.ahead;
                frame.cut_fours = cuts.fours.into();
                frame.cut_code = addresses.cuts_code.into();
                frame.cut_code_bytes = addresses.cuts_code_bytes.into();
            }
        } else if mesh.blocks.is_coloured() {
            frame.colour_code = addresses.colour_code.into();
        }
        if let Some(materials) = mesh.table {
            frame.materials = materials.address().into();
        }
        if let Some(textures) = mesh.textures {
            // Their tiles have the place of the code for eye rays.
            let eye_code = EYE_CODE_CAPACITY.min(addresses.mesh_code_bytes);
            frame.code = (addresses.mesh_code + u64::from(eye_code)).into();
            frame.code_bytes = (addresses.mesh_code_bytes - eye_code).into();
            frame.textures = textures.address().into();
            frame.texture_code = addresses.texture_code.into();
            frame.texture_code_bytes = addresses.texture_code_bytes.into();
            frame.texture_tiles = textures.tiles().into();
            frame.texture_records = mesh.texture_records.into();
            frame.texture_count = textures.count().into();
            frame.texture_level_count = textures.level_count().into();
            // The camera's plane is at the distance 1.
            frame.pixel_angle = single(camera.down.length());
        }
    }
    let options = scene.render_options();
    frame.samples = (options.samples as u32).into();
    frame.contrast = u32::from(options.contrast).into();
    frame.features = features(order, &frame).into();
    frame
}

/// The lengths of the primary rays' directions that [`in_singles`] tries.
const LENGTHS: u32 = 32;

/// The camera's corner, right and down in singles. A direction's length is free, so the one of
/// [`LENGTHS`] is taken at which rounding turns rays by the smallest angles. The corner makes up
/// for the rounding of the steps in the middle of the picture.
fn in_singles(camera: &Camera, geometry: Geometry) -> [[F32; 3]; 3] {
    let [width, height] = [geometry.width, geometry.height].map(f64::from);
    let rounded = |exact: DVec3| exact.as_vec3().as_dvec3();
    let tried = (0..LENGTHS).map(|step| {
        let length = 1.0 + f64::from(step) / f64::from(LENGTHS);
        let [corner, right, down] =
            [camera.corner, camera.right, camera.down].map(|exact| length * exact);
        let [right_error, down_error] = [right, down].map(|exact| rounded(exact) - exact);
        let middle = (width * right_error + height * down_error) / 2.0;
        let corner_error = rounded(corner - middle) + middle - corner;
        // The mean square over the picture.
        let error = corner_error.length_squared()
            + width.powi(2) / 12.0 * right_error.length_squared()
            + height.powi(2) / 12.0 * down_error.length_squared();
        (error / length.powi(2), [corner - middle, right, down])
    });
    let (_, best) = tried.min_by(|(one, _), (other, _)| one.total_cmp(other)).unwrap_or_default();
    best.map(singles)
}

/// The frame's feature bits: the scene's needs and the requested options.
fn features(order: &Order, frame: &Frame) -> u32 {
    let options = order.scene.render_options();
    let mesh = order.scene.block().and_then(SceneBlock::mesh);
    let branch = order.scene.block().is_some_and(|block| block.chains().branch);
    let is_coloured = mesh.is_some_and(|mesh| mesh.heights.is_some() || mesh.blocks.is_coloured());
    let flag = |set: bool, flag: u32| if set { flag } else { 0 };
    flag(order.sphere_count > 0, FEATURE_SPHERES)
        | flag(order.scene.block().is_some(), FEATURE_WHITTED)
        | flag(mesh.is_some(), FEATURE_MESH)
        | flag(frame.textures.get() != 0, FEATURE_TEXTURES)
        | flag(frame.materials.get() != 0, FEATURE_MATERIALS)
        | flag(is_coloured, FEATURE_COLOURS)
        | flag(mesh.is_some_and(|mesh| mesh.blocks.has_visibility()), FEATURE_VISIBILITY)
        | flag(frame.heights.get() != 0, FEATURE_HEIGHTS)
        | flag(frame.cut_fours.get() != 0, FEATURE_CUTS)
        | flag(branch, FEATURE_BRANCHES)
        | flag(!options.shadows, FEATURE_NO_SHADOWS)
        | flag(options.colour == Colour::Srgb, FEATURE_SRGB)
        | flag(options.roll_off, FEATURE_ROLL_OFF)
        | flag(order.check_shaders, FEATURE_CHECK_SHADERS)
}

fn quadword([x, y, z]: [F32; 3]) -> [F32; 4] {
    [x, y, z, F32::ZERO]
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng as _;
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::work::arithmetic::camera;

    #[test]
    fn chosen_length_turns_rays_less_than_any_length() {
        let mut random = ChaCha8Rng::seed_from_u64(38);
        let geometry = Geometry::new(320, 200).expect("a size");
        let mut sums = [0.0; 2];
        for _ in 0..200 {
            let camera = camera(&mut random, geometry.width, geometry.height);
            let plain = [camera.corner, camera.right, camera.down].map(singles);
            for (sum, basis) in sums.iter_mut().zip([plain, in_singles(&camera, geometry)]) {
                let basis = basis.map(|it| DVec3::from_array(it.map(|x| f64::from(x.get()))));
                for (x, y) in [(0.0, 0.0), (319.0, 0.0), (160.0, 100.0), (0.0, 199.0)] {
                    let [exact, rounded] = [[camera.corner, camera.right, camera.down], basis]
                        .map(|[corner, right, down]| corner + x * right + y * down);
                    *sum += exact.normalize().cross(rounded.normalize()).length_squared();
                }
            }
        }
        let [plain, chosen] = sums;
        assert!(chosen > 0.0 && chosen < plain / 4.0, "{chosen:e}, {plain:e}");
    }
}
