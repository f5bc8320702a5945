//! The lamps and decorations of a level, as posts with round tops.

use std::sync::Arc;

use cellray::game::{DAffine3, DVec3, Material, Mesh, World, WorldError};

/// What a thing looks like.
#[derive(Clone, Copy, Debug)]
pub struct Decoration {
    radius: f64,
    height: f64,
    colour: [f64; 3],
    /// The colour of its light, if it is a lamp.
    pub light: Option<[f64; 3]>,
}

impl Decoration {
    /// Where its light is from its foot: above its top, so that its own shadow falls down.
    #[must_use]
    pub fn light_above(&self) -> DVec3 {
        DVec3::Y * (self.height + self.radius + 6.0)
    }
}

const IRON: [f64; 3] = [0.3, 0.3, 0.32];
const WOOD: [f64; 3] = [0.35, 0.24, 0.15];
const WARM: [f64; 3] = [1.0, 0.85, 0.6];
const COLD: [f64; 3] = [0.7, 0.85, 1.0];
const RED: [f64; 3] = [1.0, 0.3, 0.2];
const GREEN: [f64; 3] = [0.35, 1.0, 0.4];
const BLUE: [f64; 3] = [0.35, 0.5, 1.0];

/// The kinds of things that stand in a level without being in the way; `None` for all others.
#[must_use]
pub fn decoration(kind: u16) -> Option<Decoration> {
    let lamp =
        |radius, height, light| Decoration { radius, height, colour: IRON, light: Some(light) };
    let post = |radius, height, colour| Decoration { radius, height, colour, light: None };
    Some(match kind {
        2028 => lamp(5.0, 46.0, WARM),
        85 => lamp(6.0, 72.0, COLD),
        86 => lamp(6.0, 54.0, COLD),
        34 => lamp(2.0, 10.0, WARM),
        35 => lamp(5.0, 54.0, WARM),
        70 => lamp(9.0, 30.0, WARM),
        44 => lamp(5.0, 84.0, BLUE),
        45 => lamp(5.0, 84.0, GREEN),
        46 => lamp(5.0, 84.0, RED),
        55 => lamp(4.0, 44.0, BLUE),
        56 => lamp(4.0, 44.0, GREEN),
        57 => lamp(4.0, 44.0, RED),
        2035 => post(9.0, 24.0, [0.3, 0.4, 0.25]),
        48 => post(12.0, 112.0, IRON),
        30 => post(12.0, 44.0, [0.2, 0.4, 0.2]),
        31 => post(12.0, 32.0, [0.2, 0.4, 0.2]),
        32 => post(12.0, 44.0, [0.45, 0.15, 0.15]),
        33 | 36 | 37 => post(12.0, 32.0, [0.45, 0.15, 0.15]),
        43 | 54 => post(10.0, 100.0, WOOD),
        47 => post(8.0, 36.0, WOOD),
        _ => return None,
    })
}

/// The decorations of a level as one mesh. Spheres and cones beside a large mesh would be in its
/// tree, which then can't be refitted when doors move.
#[derive(Default)]
pub struct Decorations {
    pub mesh: Mesh,
    materials: Vec<Material>,
}

/// The sides of posts and their tops.
const SIDES: u32 = 8;

impl Decorations {
    /// Adds a decoration.
    pub fn add(&mut self, foot: DVec3, kind: Decoration) {
        let Decoration { radius, height, colour, light } = kind;
        let [red, green, blue] = colour;
        let stem = if light.is_some() { 0.4 * radius } else { radius };
        let post = Material::matte(red, green, blue);
        let head =
            light.map_or(post.clone(), |[red, green, blue]| Material::flat(red, green, blue));
        self.turn(foot, &[[stem, 0.0], [stem, height]], post);
        let rings = [[0.0, -1.0], [0.7, -0.7], [1.0, 0.0], [0.7, 0.7], [0.0, 1.0]];
        let rings = rings.map(|[out, up]| [radius * out, height + radius * up]);
        self.turn(foot, &rings, head);
    }

    /// Adds a body of rings around a vertical axis, each with its radius and height.
    fn turn(&mut self, foot: DVec3, rings: &[[f64; 2]], material: Material) {
        let known = self.materials.iter().position(|other| *other == material);
        let number = known.unwrap_or_else(|| {
            self.materials.push(material);
            self.materials.len() - 1
        }) as u32;
        let first = self.mesh.positions.len() as u32;
        for [radius, height] in rings {
            for side in 0..SIDES {
                let angle = std::f64::consts::TAU * f64::from(side) / f64::from(SIDES);
                let (sine, cosine) = libm::sincos(angle);
                let place = foot + DVec3::new(radius * sine, *height, radius * cosine);
                self.mesh.positions.push(place.as_vec3().to_array());
            }
        }
        for ring in 1..rings.len() as u32 {
            for side in 0..SIDES {
                let at = |ring: u32, side: u32| first + ring * SIDES + side % SIDES;
                let (a, b) = (at(ring - 1, side), at(ring - 1, side + 1));
                let (c, d) = (at(ring, side + 1), at(ring, side));
                self.mesh.triangles.extend([[a, b, c], [a, c, d]]);
                self.mesh.materials.extend([number; 2]);
            }
        }
    }

    /// Puts the mesh into a world.
    pub fn finish(self, world: &mut World) -> Result<(), WorldError> {
        if self.mesh.triangles.is_empty() {
            return Ok(());
        }
        let materials = self.materials.into_iter().map(|material| world.add_material(material));
        let materials = materials.collect::<Result<Vec<_>, _>>()?;
        world.add_mesh(Arc::new(self.mesh), &materials, DAffine3::IDENTITY)?;
        Ok(())
    }
}
