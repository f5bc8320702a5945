//! Makes meshes of a map.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use glam::{DVec2, DVec3};
use scenes::{Material, Mesh};

use crate::specials::ranges;
use crate::surfaces::{Surface, Surfaces};
use crate::walls::Wall;
use crate::{Error, Map, Name, Pictures, Plan, SKY, Sector};

/// The most light that a sector has.
const LIGHTEST: f64 = 255.0;
/// The most parts of all walls with holes: many times as many as a map of Freedoom has.
const MOST_PARTS: usize = 1 << 18;

/// A floor or a ceiling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Plane {
    /// A sector's floor.
    Floor,
    /// A sector's ceiling.
    Ceiling,
}

impl Plane {
    /// Its height in a sector.
    #[must_use]
    pub fn height(self, sector: &Sector) -> f64 {
        match self {
            Self::Floor => sector.floor,
            Self::Ceiling => sector.ceiling,
        }
    }
}

/// A floor or a ceiling of a sector.
pub(crate) type PlaneId = (u32, Plane);

/// A level: what a map looks like.
#[derive(Clone, Debug, Default)]
pub struct Level {
    /// The materials that triangles have.
    pub materials: Vec<Material>,
    /// What each material shows.
    pub surfaces: Vec<Surface>,
    /// The meshes: first what stands still, then what moves.
    pub parts: Vec<Part>,
    /// The kinds of things that the meshes show.
    pub with_sprites: BTreeSet<u16>,
    /// Notes about omitted parts, as sentences.
    pub notes: Vec<String>,
}

/// A mesh of a level.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// The mesh, at its place when nothing has moved yet. Its colours are how light it is.
    pub mesh: Mesh,
    /// The floor or ceiling that it moves up and down with.
    pub moves_with: Option<(u32, Plane)>,
    /// The map's thing that it shows, if somebody can take that.
    pub thing: Option<u32>,
}

impl Part {
    /// Whether it always is what and where it is now.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        self.moves_with.is_none() && self.thing.is_none()
    }
}

impl Level {
    /// Makes the meshes of a map.
    ///
    /// # Errors
    /// A picture is damaged.
    pub fn build(map: &Map, plan: &Plan, pictures: &impl Pictures) -> Result<Self, Error> {
        let mut builder = Builder {
            map,
            ranges: ranges(map),
            surfaces: Surfaces::new(pictures),
            parts: BTreeMap::new(),
            with_sprites: BTreeSet::new(),
            spare_parts: MOST_PARTS,
            left_out: 0,
        };
        for region in &plan.regions {
            let sector = &map.sectors[region.sector as usize];
            builder.add_plane(region.corners, region.sector, Plane::Floor, sector.floor_flat)?;
            let [a, b, c] = region.corners;
            builder.add_plane([a, c, b], region.sector, Plane::Ceiling, sector.ceiling_flat)?;
        }
        for (line, pieces) in map.lines.iter().zip(&plan.pieces) {
            builder.add_line(line, pieces)?;
        }
        builder.add_sprites(&map.things, plan)?;
        let mut notes = [map.notes.clone(), plan.notes.clone(), builder.surfaces.notes].concat();
        if builder.left_out > 0 {
            let count = builder.left_out;
            notes.push(format!("walls with too many holes are left out: {count}"));
        }
        let part =
            |((moves_with, thing), part): (_, Growing)| Part { mesh: part.mesh, moves_with, thing };
        Ok(Self {
            materials: builder.surfaces.materials,
            surfaces: builder.surfaces.surfaces,
            parts: builder.parts.into_iter().map(part).collect(),
            with_sprites: builder.with_sprites,
            notes,
        })
    }
}

/// A mesh, and the numbers of its vertices by their bits.
#[derive(Default)]
struct Growing {
    mesh: Mesh,
    numbers: HashMap<[u32; 8], u32>,
}

impl Growing {
    fn vertex(&mut self, place: DVec3, coordinates: DVec2, light: DVec3) -> u32 {
        let position = place.as_vec3().to_array();
        let coordinates = coordinates.as_vec2().to_array();
        let ([x, y, z], [u, v]) = (position, coordinates);
        let [red, green, blue] = light.as_vec3().to_array();
        let bits = [x, y, z, u, v, red, green, blue].map(f32::to_bits);
        *self.numbers.entry(bits).or_insert_with(|| {
            self.mesh.positions.push(position);
            self.mesh.texture_coordinates.push(coordinates);
            self.mesh.colours.push([red, green, blue]);
            self.mesh.positions.len() as u32 - 1
        })
    }
}

/// The parts of a level so far.
pub(crate) struct Builder<'a, P> {
    pub map: &'a Map,
    ranges: BTreeMap<PlaneId, [f64; 2]>,
    pub surfaces: Surfaces<'a, P>,
    /// By the plane that they move with, and the thing that they show.
    parts: BTreeMap<(Option<PlaneId>, Option<u32>), Growing>,
    pub with_sprites: BTreeSet<u16>,
    /// How many parts walls with holes may still have.
    pub spare_parts: usize,
    /// The number of walls that are left out because they have too many holes.
    pub left_out: usize,
}

impl<P: Pictures> Builder<'_, P> {
    /// The height of a floor or ceiling when nothing has moved yet.
    pub fn rest(&self, sector: u32, plane: Plane) -> f64 {
        plane.height(&self.map.sectors[sector as usize])
    }

    /// The lowest and the highest place of a floor or ceiling.
    pub fn range(&self, sector: u32, plane: Plane) -> [f64; 2] {
        let moving = self.ranges.get(&(sector, plane)).copied();
        moving.unwrap_or([self.rest(sector, plane); 2])
    }

    /// The floor or ceiling itself if it moves.
    pub fn moving(&self, plane: PlaneId) -> Option<PlaneId> {
        self.ranges.contains_key(&plane).then_some(plane)
    }

    fn add_plane(
        &mut self,
        corners: [DVec2; 3],
        sector: u32,
        plane: Plane,
        flat: Name,
    ) -> Result<(), Error> {
        let surface = match flat == Name::new(SKY) {
            true => Surface::Sky,
            false => Surface::Flat(flat),
        };
        let shown = self.surfaces.shown(surface)?;
        let height = self.rest(sector, plane);
        let light = shown.colour * lightness(self.map.sectors[sector as usize].light);
        let part = self.parts.entry((self.moving((sector, plane)), None)).or_default();
        let triangle = corners.map(|corner| {
            let coordinates = DVec2::new(corner.x, -corner.y) / shown.size;
            part.vertex(in_space(corner, height), coordinates, light)
        });
        part.mesh.triangles.push(triangle);
        part.mesh.materials.push(shown.material);
        Ok(())
    }

    pub fn add_quad(&mut self, wall: &Wall) -> Result<(), Error> {
        let shown = self.surfaces.shown(wall.surface)?;
        let part = self.parts.entry((wall.moves_with, wall.thing)).or_default();
        let width = wall.ends[0].distance(wall.ends[1]);
        let light = shown.colour * lightness(wall.light);
        // Whole pictures are left out of the coordinates, because singles hold small ones better.
        let first = (wall.texel / shown.size).rem_euclid(DVec2::ONE);
        let last = first + DVec2::new(width, wall.top - wall.bottom) / shown.size;
        let [left, right] = wall.ends;
        let [a, b, c, d] = [
            (left, wall.bottom, DVec2::new(first.x, last.y)),
            (right, wall.bottom, last),
            (right, wall.top, DVec2::new(last.x, first.y)),
            (left, wall.top, first),
        ]
        .map(|(end, height, coordinates)| part.vertex(in_space(end, height), coordinates, light));
        part.mesh.triangles.extend([[a, b, c], [a, c, d]]);
        part.mesh.materials.extend([shown.material; 2]);
        Ok(())
    }
}

/// A place of the map at a height.
fn in_space(place: DVec2, height: f64) -> DVec3 {
    DVec3::new(place.x, height, -place.y)
}

/// A sector's light as the colour of vertices. Doom darkens what is far away; the root is about as
/// light as it shows what is near.
fn lightness(light: f64) -> f64 {
    (light / LIGHTEST).clamp(0.0, 1.0).sqrt()
}
