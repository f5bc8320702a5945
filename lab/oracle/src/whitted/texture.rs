//! Colours of textures and of vertices, as `docs/shading.md` defines them.
//!
//! Owns the levels of a texture and their filter. Invariant: whatever the coordinates are, a
//! colour is within the range of the texels.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DVec2, DVec3};
use scenes::{Mesh, Scene, Texture, Wrap};

use crate::Colour;

/// A texture at one size: its texels in rows, red, green and blue from 0 to 1 as on a screen.
struct Level {
    width: usize,
    height: usize,
    texels: Vec<DVec3>,
}

/// The levels of a texture, the largest first.
pub(super) struct Levels {
    levels: Vec<Level>,
    wrap: [Wrap; 2],
}

/// A triangle with texture coordinates or colours.
struct Facet {
    corners: [DVec3; 3],
    texture: Option<([DVec2; 3], Arc<Levels>)>,
    /// The light of its vertices' colours.
    colours: Option<[DVec3; 3]>,
}

/// The triangles of a scene's surfaces that have a texture or colours.
#[derive(Default)]
pub(super) struct Textures {
    facets: HashMap<usize, Facet>,
    known: Vec<(Arc<Texture>, Arc<Levels>)>,
}

impl Textures {
    /// Adds a triangle of a mesh as the surface with this index, if it has a texture or colours.
    pub(super) fn add(
        &mut self,
        surface: usize,
        scene: &Scene,
        mesh: &Mesh,
        triangle: usize,
        colour: Colour,
    ) {
        let material = scene.materials.get(mesh.materials[triangle] as usize);
        let texture = material.and_then(|material| material.texture.as_ref());
        let texture = texture.zip(mesh.corner_coordinates(triangle));
        let texture = texture.map(|(texture, coordinates)| {
            let coordinates = coordinates.map(|[u, v]| DVec2::new(u.into(), v.into()));
            (coordinates, self.levels(texture, colour))
        });
        let colours = mesh.corner_colours(triangle);
        let colours = colours.map(|colours| colours.map(|it| colour.light(it.as_dvec3())));
        if texture.is_some() || colours.is_some() {
            let facet = Facet { corners: mesh.places(triangle), texture, colours };
            self.facets.insert(surface, facet);
        }
    }

    fn levels(&mut self, texture: &Arc<Texture>, colour: Colour) -> Arc<Levels> {
        let known = self.known.iter().find(|(it, _)| Arc::ptr_eq(it, texture));
        known.map(|(_, levels)| levels.clone()).unwrap_or_else(|| {
            let levels = Arc::new(Levels::new(texture, colour));
            self.known.push((texture.clone(), levels.clone()));
            levels
        })
    }

    /// The texture's colour times that of the vertices at a point of a surface, where a pixel is
    /// `width` across. `cosine` is that of the angle between the ray and the normal. `None` if the
    /// surface has neither.
    pub(super) fn colour(
        &self,
        surface: usize,
        point: DVec3,
        width: f64,
        cosine: f64,
    ) -> Option<DVec3> {
        let facet = self.facets.get(&surface)?;
        let [a, b, c] = facet.corners;
        let (to_b, to_c) = (b - a, c - a);
        let normal = to_b.cross(to_c);
        let from_a = point - a;
        let of_b = from_a.cross(to_c).dot(normal) / normal.length_squared();
        let of_c = to_b.cross(from_a).dot(normal) / normal.length_squared();
        let of_vertices = facet.colours.map_or(DVec3::ONE, |[at_a, at_b, at_c]| {
            at_a + of_b * (at_b - at_a) + of_c * (at_c - at_a)
        });
        let Some(([at_a, at_b, at_c], levels)) = &facet.texture else {
            return Some(of_vertices);
        };
        let (along_b, along_c) = (at_b - at_a, at_c - at_a);
        let place = *at_a + of_b * along_b + of_c * along_c;
        // The length of a texel's side that fits the pixel's width on the surface.
        let stretch = (along_b.perp_dot(along_c).abs() / normal.length()).sqrt();
        Some(of_vertices * levels.filtered(place, stretch * width / cosine.abs()))
    }
}

impl Levels {
    fn new(texture: &Texture, colour: Colour) -> Self {
        let mut levels = vec![Level {
            width: texture.width() as usize,
            height: texture.height() as usize,
            texels: texture
                .texels()
                .iter()
                .map(|texel| DVec3::from(texel.map(|byte| f64::from(byte) / 255.0)))
                .collect(),
        }];
        while let Some(half) = levels.last().and_then(Level::half) {
            levels.push(half);
        }
        for texel in levels.iter_mut().flat_map(|level| &mut level.texels) {
            *texel = colour.light(*texel);
        }
        let wrap = texture.wrap();
        Self { levels, wrap }
    }

    /// The colour at texture coordinates, where a pixel's width is `footprint` of the texture's.
    fn filtered(&self, place: DVec2, footprint: f64) -> DVec3 {
        let texels = self.levels[0].texels.len() as f64;
        let level = libm::log2(footprint * texels.sqrt()).round();
        let last = self.levels.len() - 1;
        let level = &self.levels[(level.max(0.0) as usize).min(last)];
        let inside = DVec2::new(within(place.x, self.wrap[0]), within(place.y, self.wrap[1]));
        let size = DVec2::new(level.width as f64, level.height as f64);
        let corner = inside * size - 0.5;
        let first = corner.floor();
        let part = corner - first;
        let texel = |right: i64, down: i64| {
            let x = beside(first.x as i64 + right, level.width, self.wrap[0]);
            let y = beside(first.y as i64 + down, level.height, self.wrap[1]);
            level.texels[y * level.width + x]
        };
        let above = texel(0, 0).lerp(texel(1, 0), part.x);
        let below = texel(0, 1).lerp(texel(1, 1), part.x);
        above.lerp(below, part.y)
    }
}

impl Level {
    /// The level with half as many texels across and down, rounded down, but at least one.
    fn half(&self) -> Option<Self> {
        if self.texels.len() == 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let mut texels = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let mut light = DVec3::ZERO;
                for (row, down) in covered(y, height, self.height) {
                    for (column, across) in covered(x, width, self.width) {
                        let texel = self.texels[row * self.width + column];
                        light += down * across * texel.map(decoded);
                    }
                }
                texels.push((light.map(encoded) * 255.0).round() / 255.0);
            }
        }
        Some(Self { width, height, texels })
    }
}

/// The texels of a row of `of` that texel `index` of `count` covers, and the part of it that each
/// of them is.
fn covered(index: usize, count: usize, of: usize) -> impl Iterator<Item = (usize, f64)> {
    let edge = |index: usize| index as f64 * of as f64 / count as f64;
    let (low, high) = (edge(index), edge(index + 1));
    let texels = low.floor() as usize..(high.ceil() as usize).min(of);
    texels.filter_map(move |texel| {
        let part = high.min(texel as f64 + 1.0) - low.max(texel as f64);
        (part > 0.0).then_some((texel, part / (high - low)))
    })
}

/// A coordinate brought into the texture.
fn within(place: f64, wrap: Wrap) -> f64 {
    match wrap {
        Wrap::Repeat => place.rem_euclid(1.0),
        Wrap::Clamp => place.clamp(0.0, 1.0),
        Wrap::Mirror => 1.0 - (place.rem_euclid(2.0) - 1.0).abs(),
    }
}

/// The texel at an index that may be one beyond the edges.
fn beside(index: i64, count: usize, wrap: Wrap) -> usize {
    let count = count as i64;
    let index = match wrap {
        Wrap::Repeat => index.rem_euclid(count),
        Wrap::Clamp | Wrap::Mirror => index.clamp(0, count - 1),
    };
    index as usize
}

/// A screen's value as light.
fn decoded(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
}

/// Light as a screen's value.
fn encoded(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055 }
}
