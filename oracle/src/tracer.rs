//! Renders a scene by depth shading, and finds the pixels on silhouettes.
//!
//! Invariant: tests that are skipped for speed change no pixel.

use glam::DVec3;
use nff::depth::{self, DepthShading};
use nff::{Camera, Scene};

use crate::sphere::Sphere;
use crate::{Error, Picture, rows, silhouette};

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
    /// than those of a neighbour.
    pub silhouette: Vec<bool>,
    /// The share of the primary rays that hit an object, from 0 to 1.
    pub covered: f64,
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
    let mut picture = Picture::black(width, height)?;
    let camera = scene
        .view
        .camera(width, height)
        .map_err(|source| Error::View {
            scene: scene.name.clone(),
            source,
        })?;
    let stage = Stage::new(scene, camera);
    let mut sights = vec![Sight::default(); picture.pixels().len()];
    let row = width as usize;
    let rows = picture
        .pixels_mut()
        .chunks_mut(row)
        .zip(sights.chunks_mut(row));
    rows::each((0..height).zip(rows), |(y, (pixels, sights))| {
        stage.row(y, pixels, sights);
    });
    let hits = sights
        .iter()
        .filter(|sight| sight.nearest.is_some())
        .count();
    Ok(Reference {
        picture,
        silhouette: silhouette(&sights, row),
        covered: hits as f64 / sights.len() as f64,
    })
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
        let camera = scene
            .view
            .camera(width, height)
            .map_err(|source| Error::View {
                scene: scene.name.clone(),
                source,
            })?;
        let stage = Stage::new(scene, camera);
        let all = (0..stage.spheres.len()).collect();
        Ok(Self { stage, all })
    }

    /// The colour that the ray through a point of the picture sees, each channel 0 to 1. The
    /// centre of the top left pixel is (0, 0).
    #[must_use]
    pub fn colour(&self, x: f64, y: f64) -> DVec3 {
        let camera = &self.stage.camera;
        let direction = camera.corner + x * camera.right + y * camera.down;
        let (met, distance) = self.stage.look(direction.normalize(), &self.all);
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
    fn new(scene: &Scene, camera: Camera) -> Self {
        let spheres = depth::drawn(scene).map(|drawn| {
            let material = scene.materials.get(drawn.material as usize);
            let colour = material.map_or(DVec3::ZERO, |material| material.colour);
            (Sphere::new(camera.eye, drawn.centre, drawn.radius), colour)
        });
        Self {
            camera,
            spheres: spheres.collect(),
            shading: DepthShading::of(scene),
            background: scene.background,
        }
    }

    fn row(&self, y: u32, pixels: &mut [[u8; 3]], sights: &mut [Sight]) {
        // All rays of a row are in one plane, which most spheres of a large scene don't touch.
        let normal = self
            .camera
            .direction(0, y)
            .cross(self.camera.right)
            .normalize();
        let reached: Vec<usize> = (0..self.spheres.len())
            .filter(|&index| !self.spheres[index].0.is_off_plane(normal, 1.0 + 2.0 * EDGE))
            .collect();
        for ((x, pixel), sight) in (0..).zip(pixels).zip(sights) {
            let direction = self.camera.direction(x, y).normalize();
            let (met, distance) = self.look(direction, &reached);
            *sight = met;
            *pixel = depth::bytes(self.colour(met, distance));
        }
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

/// The mask of [`Reference::silhouette`].
fn silhouette(sights: &[Sight], width: usize) -> Vec<bool> {
    let nearest: Vec<_> = sights.iter().map(|sight| sight.nearest).collect();
    let jumps = silhouette::mask(&nearest, width);
    let on_edge = sights.iter().map(|sight| sight.on_edge);
    jumps
        .into_iter()
        .zip(on_edge)
        .map(|(a, b)| a || b)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 64 48\n\
        b 0 0 1\nf 1 0.5 0.25 1 0 0 0 1\n";

    fn scene(spheres: &str) -> Scene {
        let text = format!("{HEAD}{spheres}");
        nff::parse(text.as_bytes(), "t.nff", &nff::Limits::default()).expect("a scene")
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
    fn the_share_covered_is_that_of_the_disc() {
        // From a distance d, a sphere of radius r fills a circle with the tangent r / sqrt(d² -
        // r²). The picture's height is 2 tan 20° between the outer centres, and one gap more.
        let reference = trace(&scene("s 0 0 0 2\n"), 601, 601).expect("a picture");
        let radius = 2.0 / (100.0f64 - 4.0).sqrt();
        let side = 2.0 * libm::tan(20f64.to_radians()) * 601.0 / 600.0;
        let expected = std::f64::consts::PI * radius * radius / (side * side);
        assert!(
            (reference.covered - expected).abs() < 1e-4,
            "{}",
            reference.covered
        );
    }

    #[test]
    fn skipping_spheres_off_a_row_changes_nothing() {
        let scene = nff::sphereflake::generate(2).expect("a scene");
        let (width, height) = (97, 61);
        let camera = scene.view.camera(width, height).expect("a camera");
        let stage = Stage::new(&scene, camera);
        let all: Vec<usize> = (0..stage.spheres.len()).collect();
        let mut pixels = vec![[0; 3]; width as usize];
        let mut sights = vec![Sight::default(); width as usize];
        let mut hits = 0;
        for y in 0..height {
            stage.row(y, &mut pixels, &mut sights);
            for (x, sight) in (0..).zip(&sights) {
                let (expected, _) = stage.look(camera.direction(x, y).normalize(), &all);
                assert_eq!(*sight, expected, "({x}, {y})");
                hits += usize::from(sight.nearest.is_some());
            }
        }
        assert!(hits > 500, "{hits}");
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
    fn a_ray_at_an_edge_is_on_the_silhouette_whatever_its_neighbours_show() {
        // A sphere smaller than a pixel: the middle ray just misses its edge, or hits its centre.
        let edge = |x: f64| trace(&scene(&format!("s {x} 0 0 0.001\n")), 3, 3).expect("a picture");
        assert!(edge(0.001_000_001).silhouette[4]);
        assert!(edge(0.001_000_001).covered == 0.0);
        assert!(!edge(0.0011).silhouette[4]);
    }

    #[test]
    fn of_equally_near_spheres_the_first_is_seen() {
        let spheres = "s 0 0 0 1\nf 0 1 0 1 0 0 0 1\ns 0 0 0 1\n";
        let picture = render(&scene(spheres), 81, 81).expect("a picture");
        assert_eq!(picture.pixels()[40 * 81 + 40], [255, 128, 64]);
    }

    #[test]
    fn sizes_without_a_picture() {
        let scene = scene("");
        assert!(matches!(render(&scene, 0, 5), Err(Error::Size(_))));
        assert!(matches!(
            render(&scene, u32::MAX, u32::MAX),
            Err(Error::Size(_))
        ));
        assert!(matches!(render(&scene, 20_000, 1), Err(Error::Size(_))));
    }
}
