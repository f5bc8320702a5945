//! Renders a scene by depth shading, and finds the pixels on silhouettes.
//!
//! Invariant: tests that are skipped for speed change no pixel.

use glam::DVec3;
use scenes::depth::{self, DepthShading};
use scenes::{Camera, Scene};

use crate::pixels::{Model, Seen, paint};
use crate::sphere::Sphere;
use crate::whitted::Counts;
use crate::{Colour, Error, Picture, Pixels};

/// A ray within this distance of a sphere's edge, in radii, counts as on the edge. This is about a
/// hundred rounding errors of single precision, with which a kernel may decide differently.
const EDGE: f64 = 1e-5;

/// The reference picture of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// The picture.
    pub picture: Picture,
    /// For each pixel, in the picture's order, whether it is on a silhouette. With depth shading:
    /// one of its eight neighbours shows another sphere, or its ray passes a sphere's edge within
    /// 1e-5 of the radius. With Whitted's model: its rays hit other objects, or see other lights,
    /// than those of a neighbour. With several samples a pixel: also if its samples hit other
    /// objects than each other, or see other lights, and it or a neighbour has these samples.
    pub silhouette: Vec<bool>,
    /// The share of the primary rays that hit an object, from 0 to 1.
    pub covered: f64,
    /// The number of pixels with several samples. With corners: of corners.
    pub refined: u64,
}

/// What the ray of a pixel hits.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Sight {
    /// The index of the nearest drawn sphere; of equally near ones the first.
    nearest: Option<usize>,
    /// Whether the ray passes close to an edge.
    on_edge: bool,
}

/// Renders a scene.
///
/// # Errors
/// The view has no camera for this size, or the size is out of range.
pub fn render(scene: &Scene, width: u32, height: u32) -> Result<Picture, Error> {
    Ok(trace(scene, width, height)?.picture)
}

/// Renders a scene with its silhouettes, on as many threads as there are processors.
///
/// # Errors
/// The view has no camera for this size, or the size is out of range.
pub fn trace(scene: &Scene, width: u32, height: u32) -> Result<Reference, Error> {
    trace_with(scene, width, height, &Pixels::PLAIN)
}

/// The same with other pixels than those of one sample in linear light.
///
/// # Errors
/// As for [`trace`].
pub fn trace_with(
    scene: &Scene,
    width: u32,
    height: u32,
    pixels: &Pixels,
) -> Result<Reference, Error> {
    let camera = crate::camera(scene, width, height)?;
    let stage = Stage::new(scene, camera, pixels.colour);
    Ok(paint((width, height), pixels, &stage)?.0)
}

/// A scene and its camera, to trace single primary rays by depth shading.
pub struct DepthProbe {
    stage: Stage,
    all: Vec<usize>,
}

impl DepthProbe {
    /// A probe with the camera of a picture of this size.
    ///
    /// # Errors
    /// As for [`trace`].
    pub fn new(scene: &Scene, width: u32, height: u32) -> Result<Self, Error> {
        let camera = crate::camera(scene, width, height)?;
        let stage = Stage::new(scene, camera, Colour::Linear);
        let all = (0..stage.spheres.len()).collect();
        Ok(Self { stage, all })
    }

    /// The colour that the ray through a point of the picture sees, each channel 0 to 1. The
    /// centre of the top left pixel is (0, 0).
    #[must_use]
    pub fn colour(&self, x: f64, y: f64) -> DVec3 {
        let (met, distance) = self.stage.look(self.stage.direction(x, y), &self.all);
        self.stage.colour(met, distance)
    }
}

/// A scene prepared for its camera.
struct Stage {
    camera: Camera,
    spheres: Vec<(Sphere, DVec3)>,
    shading: DepthShading,
    background: DVec3,
}

impl Stage {
    fn new(scene: &Scene, camera: Camera, meaning: Colour) -> Self {
        let spheres = depth::drawn(scene).map(|drawn| {
            let material = scene.materials.get(drawn.material as usize);
            let colour = material.map_or(DVec3::ZERO, |material| meaning.light(material.colour));
            (Sphere::new(camera.eye, drawn.centre, drawn.radius), colour)
        });
        Self {
            camera,
            spheres: spheres.collect(),
            shading: DepthShading::of(scene),
            background: meaning.light(scene.background),
        }
    }

    /// The direction through a point of the picture.
    fn direction(&self, x: f64, y: f64) -> DVec3 {
        let camera = &self.camera;
        (camera.corner + x * camera.right + y * camera.down).normalize()
    }

    /// The colour of what a ray hits at this distance.
    fn colour(&self, met: Sight, distance: f64) -> DVec3 {
        match met.nearest {
            Some(index) => self.spheres[index].1 * self.shading.brightness(distance),
            None => self.background,
        }
    }

    /// What a ray hits among the spheres with the indices `reached`, and the distance.
    fn look(&self, direction: DVec3, reached: &[usize]) -> (Sight, f64) {
        let mut sight = Sight::default();
        let mut distance = f64::INFINITY;
        for &index in reached {
            let Some(passage) = self.spheres[index].0.passage(direction) else {
                continue;
            };
            sight.on_edge |= (passage.offset - 1.0).abs() <= EDGE;
            if let Some(entry) = passage.entry.filter(|&entry| entry < distance) {
                distance = entry;
                sight.nearest = Some(index);
            }
        }
        (sight, distance)
    }
}

impl Model for Stage {
    fn row(&self, y: f64) -> impl Fn(f64, &mut Counts) -> Seen {
        // All rays of a row are in one plane, which most spheres of a large scene don't touch.
        let across = self.direction(0.0, y).cross(self.camera.right);
        let normal = across.normalize();
        let reached: Vec<usize> = (0..self.spheres.len())
            .filter(|&index| !self.spheres[index].0.is_off_plane(normal, 1.0 + 2.0 * EDGE))
            .collect();
        move |x, counts| {
            let (met, distance) = self.look(self.direction(x, y), &reached);
            counts.eye += 1;
            counts.eye_hit += u64::from(met.nearest.is_some());
            Seen {
                light: self.colour(met, distance),
                way: met.nearest.map_or(0, |index| 1 + index as u64),
                on_edge: met.on_edge,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 64 48\n\
        b 0 0 1\nf 1 0.5 0.25 1 0 0 0 1\n";

    fn scene(spheres: &str) -> Scene {
        let text = format!("{HEAD}{spheres}");
        scenes::parse(text.as_bytes(), "t.nff", &scenes::Limits::default()).expect("a scene")
    }

    #[test]
    fn brightness_falls_with_distance() {
        // With 81 rows the middle pixel looks along y, at 9 of the range from 9 to 29.
        let reference = trace(&scene("s 0 0 0 1\ns 0 18 0 1\n"), 81, 81).expect("a picture");
        let pixels = reference.picture.pixels();
        assert_eq!(pixels[40 * 81 + 40], [255, 128, 64]);
        assert_eq!(pixels[0], [0, 0, 255]);
        // The far sphere, at 27: alone in the range from 27 to 29, and together from 9 to 29.
        let far = render(&scene("s 0 18 0 1\n"), 81, 81).expect("a picture");
        assert_eq!(far.pixels()[40 * 81 + 40], [255, 128, 64]);
        let both = render(&scene("s 0 18 0 1\ns 5 0 0 1\n"), 81, 81).expect("a picture");
        let near = (125f64).sqrt() - 1.0;
        let share = (29.0 - 27.0) / (29.0 - near);
        let expected = [1.0, 0.5, 0.25].map(|c| (c * share * 255.0 + 0.5f64).floor() as u8);
        assert_eq!(both.pixels()[40 * 81 + 40], expected);
    }

    #[test]
    fn covered_share_equals_disc_area() {
        // From a distance d, a sphere of radius r fills a circle with the tangent r / sqrt(d² -
        // r²). The picture's height is 2 tan 20° between the outer centres, and one gap more.
        let reference = trace(&scene("s 0 0 0 2\n"), 601, 601).expect("a picture");
        let radius = 2.0 / (100.0f64 - 4.0).sqrt();
        let side = 2.0 * libm::tan(20f64.to_radians()) * 601.0 / 600.0;
        let expected = std::f64::consts::PI * radius * radius / (side * side);
        assert!((reference.covered - expected).abs() < 1e-4, "{}", reference.covered);
    }

    #[test]
    fn skipping_spheres_off_a_row_changes_nothing() {
        let scene = scenes::sphereflake::generate(2).expect("a scene");
        let (width, height) = (97, 61);
        let camera = scene.view.camera(width, height).expect("a camera");
        let stage = Stage::new(&scene, camera, Colour::Linear);
        let all: Vec<usize> = (0..stage.spheres.len()).collect();
        let mut counts = Counts::default();
        for y in (0..height).map(f64::from) {
            let row = stage.row(y);
            for x in (0..width).map(f64::from) {
                let seen = row(x, &mut counts);
                let (expected, distance) = stage.look(stage.direction(x, y), &all);
                let way = expected.nearest.map_or(0, |index| 1 + index as u64);
                assert_eq!((seen.way, seen.on_edge), (way, expected.on_edge), "({x}, {y})");
                assert_eq!(seen.light, stage.colour(expected, distance), "({x}, {y})");
            }
        }
        assert!(counts.eye_hit > 500, "{counts:?}");
    }

    #[test]
    fn the_silhouette_is_a_ring_two_pixels_wide() {
        let reference = trace(&scene("s 0 0 0 2\n"), 201, 201).expect("a picture");
        let middle = &reference.silhouette[100 * 201..][..201];
        let ring: Vec<usize> = (0..201).filter(|&x| middle[x]).collect();
        // The tangent of the edge, divided by the gap of 2 tan 20° / 200, is 56.08 pixels.
        assert_eq!(ring, [43, 44, 156, 157]);
    }

    #[test]
    fn edge_ray_is_on_silhouette_for_any_neighbours() {
        // A sphere smaller than a pixel: the middle ray just misses its edge, or hits its centre.
        let edge = |x: f64| trace(&scene(&format!("s {x} 0 0 0.001\n")), 3, 3).expect("a picture");
        assert!(edge(0.001_000_001).silhouette[4]);
        assert!(edge(0.001_000_001).covered == 0.0);
        assert!(!edge(0.0011).silhouette[4]);
    }

    #[test]
    fn first_of_equally_near_spheres_is_visible() {
        let spheres = "s 0 0 0 1\nf 0 1 0 1 0 0 0 1\ns 0 0 0 1\n";
        let picture = render(&scene(spheres), 81, 81).expect("a picture");
        assert_eq!(picture.pixels()[40 * 81 + 40], [255, 128, 64]);
    }

    #[test]
    fn sizes_without_a_picture() {
        let scene = scene("");
        assert!(matches!(render(&scene, 0, 5), Err(Error::Size(_))));
        assert!(matches!(render(&scene, u32::MAX, u32::MAX), Err(Error::Size(_))));
        assert!(matches!(render(&scene, 20_000, 1), Err(Error::Size(_))));
    }
}
