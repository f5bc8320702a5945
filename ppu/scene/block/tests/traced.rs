//! Traces primary rays in `f64` with nothing but the records, and compares them with the
//! reference: a block describes its scene, and no bounding volume hides an object that is hit.

use std::path::Path;

use oracle::whitted::{Options, trace};
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use scenes::{Material as NffMaterial, Shader};

use super::bvh::any_object;
use super::*;
use crate::scene::random::unit;
use protocol::layout::{
    Cone, Material, Object as Head, Rectangle, SIDES_BOTH, SIDES_EXIT, Triangle,
};

/// A point where a ray from the eye crosses a surface, and whether the ray enters there: it comes
/// from the outside, or from the side that a plane's normal points to.
type Crossing = (f64, bool);

impl SceneBlock {
    /// The emission of the object that a ray from the eye hits.
    fn seen(&self, direction: DVec3) -> DVec3 {
        let mut nearest = (f64::INFINITY, U32::new(SCENE_ADDRESS));
        for kind in PrimitiveKind::ALL {
            self.walk(kind, &mut |address, above| {
                if above.iter().any(|volume| volume.is_missed(direction)) {
                    return;
                }
                for (t, enters) in self.crossings(kind, address, direction) {
                    let seen = match self.at::<Head>(address).sides.get() {
                        sides if sides & SIDES_BOTH != 0 => true,
                        sides => enters == (sides & SIDES_EXIT == 0),
                    };
                    if seen && t > 0.0 && t < nearest.0 {
                        nearest = (t, address);
                    }
                }
            });
        }
        let material = self.at::<Head>(nearest.1).material;
        wide(self.at::<Material>(material).emission)
    }

    fn crossings(&self, kind: PrimitiveKind, address: U32, direction: DVec3) -> Vec<Crossing> {
        let head: &Head = self.at(address);
        let (centre, axis) = (wide(head.centre), wide(head.axis));
        let of_plane = |inside: &dyn Fn(DVec3) -> bool| {
            let closing = axis.dot(direction);
            let t = axis.dot(centre) / closing;
            let hit = t.is_finite() && inside(t * direction);
            Vec::from_iter(hit.then_some((t, closing < 0.0)))
        };
        let vector = |[x, y, z, _]: [F32; 4]| wide([x, y, z]);
        match kind {
            PrimitiveKind::Sphere => {
                let along = centre.dot(direction);
                let beside = (centre - along * direction).length();
                let half = f64::from(head.offset.get()).powi(2) - beside * beside;
                roots(along, half)
            }
            PrimitiveKind::Rectangle => {
                let record: &Rectangle = self.at(address);
                let duals = [record.dual_u, record.dual_v].map(vector);
                of_plane(&|point| {
                    let within = |dual: &DVec3| (0.0..=1.0).contains(&dual.dot(point - centre));
                    duals.iter().all(within)
                })
            }
            PrimitiveKind::Triangle => {
                let record: &Triangle = self.at(address);
                let [a, b, c] = [record.a, record.b, record.c].map(vector);
                of_plane(&|point| {
                    let left = |(from, to): &(DVec3, DVec3)| {
                        (to - from).cross(point - from).dot(axis) >= 0.0
                    };
                    [(a, b), (b, c), (c, a)].iter().all(left)
                })
            }
            PrimitiveKind::Cone => {
                let record: &Cone = self.at(address);
                let [radius, growth, height] =
                    [record.radius, record.growth, record.height].map(|it| f64::from(it.get()));
                let split = |vector: DVec3| {
                    let along = vector.dot(axis);
                    (along, vector - along * axis)
                };
                let ((low, from), (rise, sweep)) = (split(-centre), split(direction));
                let start = radius + growth * low;
                let a = sweep.length_squared() - (growth * rise).powi(2);
                let b = from.dot(sweep) - start * growth * rise;
                let c = from.length_squared() - start * start;
                let mut found = roots(-b / a, (b * b - a * c) / (a * a));
                found.retain_mut(|(t, enters)| {
                    let outwards = (from + *t * sweep).normalize() - growth * axis;
                    *enters = outwards.dot(direction) < 0.0;
                    (0.0..=height).contains(&(low + *t * rise))
                });
                found
            }
        }
    }
}

/// The points where a ray enters and leaves, at equal distances from a middle.
fn roots(middle: f64, half_squared: f64) -> Vec<Crossing> {
    if half_squared < 0.0 {
        return Vec::new();
    }
    let half = half_squared.sqrt();
    vec![(middle - half, true), (middle + half, false)]
}

/// Gives every object a colour of its own, without light.
fn coloured(mut scene: Scene) -> Scene {
    let mut materials = Vec::new();
    for (index, object) in (0..).zip(&mut scene.objects) {
        let number = index + 1;
        let bytes = [number % 256, number / 256, 255];
        materials.push(NffMaterial {
            colour: DVec3::from_array(bytes.map(|byte| f64::from(byte) / 255.0)),
            shader: Shader::Flat,
            ..scene.materials[object.material as usize].clone()
        });
        object.material = index as u32;
    }
    scene.materials = materials;
    scene.background = DVec3::ZERO;
    scene
}

/// The number of pixels that show an object. All pixels off the silhouettes are compared.
fn compare(scene: &Scene, side: u32) -> usize {
    let (reference, _) = trace(scene, side, side, &Options::default()).expect("a picture");
    let blocks = [NodeVolumes::Spheres, NodeVolumes::Boxes].map(|volumes| {
        let options = RenderOptions { volumes, ..Default::default() };
        of(scene, options)
    });
    let camera = scene.view.camera(side, side).expect("a camera");
    let places = (0..side).flat_map(|y| (0..side).map(move |x| (x, y)));
    let pixels = reference.picture.pixels().iter();
    let mut covered = 0;
    for (((x, y), expected), edge) in places.zip(pixels).zip(&reference.silhouette) {
        if *edge {
            continue;
        }
        let name = &scene.name;
        for block in &blocks {
            let found = block.seen(camera.direction(x, y).normalize());
            assert_eq!(scenes::depth::bytes(found), *expected, "{name} at ({x}, {y})");
        }
        covered += usize::from(*expected != [0; 3]);
    }
    covered
}

#[test]
fn project_scenes_are_traced_as_by_reference() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    for name in ["shapes", "glass", "mirrors", "whitted16", "spheres64"] {
        let scene = scenes::read(&folder.join(format!("{name}.nff"))).expect("a scene");
        assert!(compare(&coloured(scene), 64) > 100, "{name}");
    }
    for name in ["sphereflake:2", "tetra:1"] {
        let scene = scenes::load(Path::new(name)).expect("a scene");
        assert!(compare(&coloured(scene), 64) > 100, "{name}");
    }
}

#[test]
fn random_scenes() {
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let mut covered = 0;
    for _ in 0..60 {
        let mut rest = String::new();
        for _ in 0..random.random_range(1..120) {
            if random.random_range(0..4) == 0 {
                let glass = random.random_range(0..2);
                rest += &format!("f 1 1 1 0 0 0 {glass} 1.5\n");
            }
            let place = DVec3::new(0.0, 0.0, -12.0) + 6.0 * unit(&mut random);
            rest += &any_object(&mut random, place);
        }
        covered += compare(&coloured(scene(&rest)), 48);
    }
    assert!(covered > 10_000, "{covered}");
}
