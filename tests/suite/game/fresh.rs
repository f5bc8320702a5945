//! A changed world is traced exactly like a new scene with the same content, byte for byte.

use cellray::game::{DVec3, Fog, LightId, MeshId, Model, RenderOptions, Shader};
use cellray::scene::Samples;
use rand::seq::IndexedRandom as _;
use randomness::rounds;

use crate::game::content;
use crate::game::meshes::{chequered, pear};
use crate::prelude::*;

/// The tiles of the last column and row are partly outside the picture.
const SIZE: (u32, u32) = (132, 66);
const PIXELS: u64 = 132 * 66;

struct Played {
    world: World,
    goes_on: bool,
    objects: Vec<ObjectId>,
    materials: Vec<MaterialId>,
    lights: Vec<LightId>,
    meshes: Vec<MeshId>,
}

impl Played {
    fn new(
        random: &mut ChaCha8Rng,
        render_options: RenderOptions,
        lights: usize,
        goes_on: bool,
    ) -> Self {
        let mut world = World::new();
        world.set_render_options(render_options);
        let mut played = Self {
            world,
            goes_on,
            objects: Vec::new(),
            materials: Vec::new(),
            lights: Vec::new(),
            meshes: Vec::new(),
        };
        let world = &mut played.world;
        world.set_background(DVec3::new(0.1, 0.2, 0.3)).unwrap();
        world.set_ambient(DVec3::splat(0.1)).unwrap();
        for _ in 0..lights {
            played.lights.push(world.add_light(content::light(random)).unwrap());
        }
        for _ in 0..5 {
            let material = content::material(random, goes_on);
            played.materials.push(world.add_material(material).unwrap());
        }
        for _ in 0..random.random_range(1..40) {
            played.add(random);
        }
        played
    }

    /// Adds a few portals.
    fn add_portals(&mut self, random: &mut ChaCha8Rng) {
        for _ in 0..3 {
            let shader = Shader::Portal {
                by: content::vector(random, 2.0),
                turn: random.random_range(-180.0..=180.0),
            };
            let material = Material { shader, ..Material::matte(1.0, 1.0, 1.0) };
            let material = self.world.add_material(material).unwrap();
            self.objects.push(self.world.add(content::shape(random), material).unwrap());
        }
    }

    /// Adds pears. Two of them have a texture if their material has one.
    fn add_meshes(&mut self, random: &mut ChaCha8Rng) {
        let plain = pear(12, 16);
        let mut textured = plain.clone();
        let places = textured.positions.iter().map(|[x, y, _]| [2.0 * x, 3.0 * y]);
        textured.texture_coordinates = places.collect();
        for mesh in [&plain, &textured, &textured] {
            let (mesh, material) =
                (Arc::new(mesh.clone()), content::material(random, self.goes_on));
            let material = Material { texture: chequered([90, 200, 40]), ..material };
            let material = self.world.add_material(material).unwrap();
            let id = self.world.add_mesh(mesh, &[material], place(random)).unwrap();
            self.meshes.push(id);
            self.materials.push(material);
        }
    }

    /// Changes something of the meshes.
    fn change_meshes(&mut self, random: &mut ChaCha8Rng) {
        let Self { world, .. } = self;
        let mesh = *self.meshes.choose(random).unwrap();
        let material = *self.materials.choose(random).unwrap();
        match random.random_range(0..6) {
            0 => world.recolour(material, content::colour(random)).unwrap(),
            1 => {
                let texture = chequered([random.random(), 40, 90]);
                let other = Material { texture, ..world.material(material).unwrap() };
                world.set_material(material, other).unwrap();
            }
            2 => world.show_mesh(mesh, random.random()).unwrap(),
            _ => world.place_mesh(mesh, place(random)).unwrap(),
        }
    }

    fn add(&mut self, random: &mut ChaCha8Rng) {
        let material = *self.materials.choose(random).unwrap();
        let object = self.world.add(content::shape(random), material).unwrap();
        self.objects.push(object);
    }

    /// Changes something, usually something small.
    fn change(&mut self, random: &mut ChaCha8Rng) {
        let Self { world, .. } = self;
        let object = self.objects.choose(random).copied();
        let material = *self.materials.choose(random).unwrap();
        let light = self.lights.choose(random).copied();
        match (random.random_range(0..40), object, light) {
            (0..14, Some(object), _) => {
                let way = content::vector(random, 0.5);
                let place = world.position(object).unwrap() + way;
                world.move_to(object, place).unwrap();
            }
            (14..17, Some(object), _) => world.reshape(object, content::shape(random)).unwrap(),
            (17..20, Some(object), _) => world.make_of(object, material).unwrap(),
            (20..23, Some(object), _) => {
                let visible = world.is_visible(object).unwrap();
                world.show(object, !visible).unwrap();
            }
            (23..26, Some(object), _) => {
                world.remove(object).unwrap();
                self.objects.retain(|known| *known != object);
            }
            (26..29, _, _) => self.add(random),
            (29..31, _, _) => world.recolour(material, content::colour(random)).unwrap(),
            (31, _, _) => {
                let other = content::material(random, self.goes_on);
                world.set_material(material, other).unwrap();
            }
            (32, _, _) => {
                let other = content::material(random, self.goes_on);
                self.materials.push(world.add_material(other).unwrap());
            }
            (33, _, Some(light)) => world.set_light(light, content::light(random)).unwrap(),
            (34, _, Some(light)) if self.lights.len() > 1 => {
                world.remove_light(light).unwrap();
                self.lights.retain(|known| *known != light);
            }
            (35, _, Some(_)) => {
                let light = world.add_light(content::light(random)).unwrap();
                self.lights.push(light);
            }
            (36, _, _) => {
                let colour = content::colour(random);
                world.set_background(colour).unwrap();
                world.set_fog(Some(Fog { colour, density: 0.05 * colour.x })).unwrap();
            }
            (37, _, _) => {
                let from = DVec3::new(0.0, 1.0, 10.0) + content::vector(random, 2.0);
                world.look_from(from, content::vector(random, 0.5)).unwrap();
            }
            (38, _, _) => world.set_ambient(content::colour(random) * 0.2).unwrap(),
            _ => {}
        }
    }
}

/// A place for a mesh, which is turned.
fn place(random: &mut ChaCha8Rng) -> DAffine3 {
    DAffine3::from_translation(content::vector(random, 3.0))
        * DAffine3::from_rotation_y(random.random_range(0.0..6.0))
}

struct Screen {
    engine: Engine,
    shown: Snapshot,
}

impl Screen {
    fn new(spus: u32, retain: bool) -> Self {
        let (framebuffer, shown) = Recorder::pair(SIZE.0, SIZE.1);
        let settings = Settings { spus, retain, ..Settings::default() };
        Self { engine: Engine::start(settings, framebuffer).unwrap(), shown }
    }

    /// Returns the picture of a scene, and the number of pixels that were not traced for it.
    fn picture(&mut self, scene: &Scene) -> (image::RgbImage, u64) {
        let traced = self.engine.render(scene, &mut |_| ()).unwrap().primary_rays();
        let picture = self.shown.lock().unwrap().take();
        (picture.unwrap(), PIXELS - traced)
    }
}

/// Changes worlds at random. Returns the share of pixels that were retained in frames in which
/// something may have changed.
fn play(
    seed: u64,
    render_options: RenderOptions,
    lights: usize,
    goes_on: bool,
    has_meshes: bool,
) -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let spus = random.random_range(1..=6);
    let (mut changed, mut fresh) = (Screen::new(spus, true), Screen::new(spus, false));
    let program = Program::tracer();
    let (mut retained, mut frames) = (0, 0);
    for number in 0..rounds(4) {
        let mut played = Played::new(&mut random, render_options, lights, goes_on);
        if has_meshes {
            played.add_portals(&mut random);
            played.add_meshes(&mut random);
        }
        for frame in 0..20 {
            let world = &mut played.world;
            let (picture, left) = changed.picture(world.scene(&program).unwrap());
            let scene = Scene::new(&world.to_nff(), render_options, &program).unwrap();
            let (expected, _) = fresh.picture(&scene);
            assert!(picture == expected, "seed {seed}, world {number}, frame {frame}");
            if frame > 0 {
                retained += left;
                frames += 1;
            }
            for _ in 0..random.random_range(1..4) {
                match has_meshes && random.random() {
                    true => played.change_meshes(&mut random),
                    false => played.change(&mut random),
                }
            }
        }
    }
    retained as f64 / (frames * PIXELS) as f64
}

fn render_options(model: Model) -> RenderOptions {
    RenderOptions { model, ..RenderOptions::default() }
}

#[test]
fn by_depth_shading() {
    play(1, render_options(Model::Depth), 0, false, false);
}

#[test]
fn by_whitteds_model_without_mirrors() {
    let retained = play(2, render_options(Model::Whitted), 2, false, false);
    assert!(retained > 0.3, "{retained}");
}

#[test]
fn by_whitteds_model_with_mirrors_and_glass() {
    let retained = play(3, render_options(Model::Whitted), 2, true, false);
    assert!(retained > 0.3, "{retained}");
}

#[test]
fn with_moving_meshes_and_portals() {
    let retained = play(7, render_options(Model::Whitted), 2, true, true);
    assert!(retained > 0.2, "{retained}");
}

/// Antialiased tiles keep their samples, and are traced as a whole where a change reaches them.
#[test]
fn antialiased() {
    let whitted = render_options(Model::Whitted);
    for (seed, samples, contrast) in [(8, Samples::Four, 8), (9, Samples::Sixteen, 64)] {
        let retained = play(seed, RenderOptions { samples, contrast, ..whitted }, 1, false, false);
        assert!(retained > 0.2, "{retained}");
    }
    play(11, RenderOptions { samples: Samples::Four, ..whitted }, 2, true, true);
}

/// Every pixel has samples, and none a first ray.
#[test]
fn with_samples_everywhere() {
    let whitted = render_options(Model::Whitted);
    let options = RenderOptions { samples: Samples::Four, contrast: 0, ..whitted };
    let retained = play(10, options, 1, true, false);
    assert!(retained > 0.1, "{retained}");
}

#[test]
fn without_shadows() {
    let render_options = RenderOptions { shadows: false, ..render_options(Model::Whitted) };
    let retained = play(4, render_options, 1, false, false);
    assert!(retained > 0.3, "{retained}");
}

/// Adding and removing lights changes a world's model.
#[test]
fn model_depends_on_lights() {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let mut played = Played::new(&mut random, RenderOptions::default(), 0, false);
    let (mut changed, mut fresh) = (Screen::new(2, true), Screen::new(2, false));
    let program = Program::tracer();
    let mut light = None;
    for _ in 0..4 {
        let world = &mut played.world;
        let (picture, _) = changed.picture(world.scene(&program).unwrap());
        let scene = Scene::from_nff(&world.to_nff()).unwrap();
        assert!(picture == fresh.picture(&scene).0);
        match light.take() {
            Some(light) => world.remove_light(light).unwrap(),
            None => light = Some(world.add_light(Light::at(DVec3::splat(9.0))).unwrap()),
        }
    }
}

/// Objects are added until the memory is full, and then the scene's layout is rebuilt.
#[test]
fn worlds_grow_and_shrink() {
    let mut random = ChaCha8Rng::seed_from_u64(6);
    let mut played = Played::new(&mut random, render_options(Model::Whitted), 1, false);
    let (mut changed, mut fresh) = (Screen::new(2, true), Screen::new(2, false));
    let program = Program::tracer();
    for round in 0..12 {
        for _ in 0..15 {
            if round % 4 < 2 {
                played.add(&mut random);
            } else if let Some(object) = played.objects.pop() {
                played.world.remove(object).unwrap();
            }
        }
        let world = &mut played.world;
        let (picture, _) = changed.picture(world.scene(&program).unwrap());
        let scene = Scene::new(&world.to_nff(), world.render_options(), &program).unwrap();
        assert!(picture == fresh.picture(&scene).0, "round {round}");
    }
}
