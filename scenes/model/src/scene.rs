//! The scene's data, in the file's order.
//!
//! Equality compares only what is shown, not the file name and the lines. So a scene that is
//! written and read back is equal to the original.

use std::sync::Arc;

use glam::DVec3;

use crate::{Fog, HeightField, HeightMap, Mesh, Sky, Texture, View};

/// A scene: view, lights, materials and objects. Lengths are in the scene's own unit.
#[derive(Debug, Clone)]
pub struct Scene {
    /// The name of the scene or its file; messages begin with it.
    pub name: String,
    /// The eye and its target.
    pub view: View,
    /// The colour of rays that hit nothing: red, green and blue from 0 to 1. Black if the file has
    /// none.
    pub background: DVec3,
    /// The background's gradient, if the file has one.
    pub sky: Option<Sky>,
    /// The fog, if the file has any.
    pub fog: Option<Fog>,
    /// The ambient light's red, green and blue. Black if the file has none.
    pub ambient: DVec3,
    /// Lights, in file order.
    pub lights: Vec<Light>,
    /// Materials, in file order.
    pub materials: Vec<Material>,
    /// Objects, in file order.
    pub objects: Vec<Object>,
    /// Triangles in addition to the objects. NFF has no entity for a mesh: a scene is written with
    /// a polygon or a patch for each triangle.
    pub mesh: Option<Arc<Mesh>>,
    /// The ground.
    pub heights: Option<Arc<HeightField>>,
    /// The file that the ground is of, if the scene's file names one. Whoever reads that puts it
    /// into `heights`.
    pub height_map: Option<HeightMap>,
}

/// A light (`l`, `#cellray lamp`, `#cellray sun`).
#[derive(Debug, Clone)]
pub struct Light {
    /// Line of the file, from 1.
    pub line: u32,
    /// The light's position or direction.
    pub kind: LightKind,
    /// The light's colour, if the file has one.
    pub colour: Option<DVec3>,
}

/// A light's position or direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LightKind {
    /// A point light (`l`, `#cellray lamp`).
    Point {
        /// The position.
        position: DVec3,
        /// The distance from which on it lights nothing; infinite if it reaches everywhere.
        range: f64,
    },
    /// A light infinitely far away (`#cellray sun`).
    Directional {
        /// The direction to the light, as in the file: not 0, and not normalised.
        to_light: DVec3,
    },
}

/// A material (`f`): how the objects after it look.
#[derive(Debug, Clone)]
pub struct Material {
    /// Line of the file, from 1.
    pub line: u32,
    /// Red, green and blue, from 0 to 1.
    pub colour: DVec3,
    /// Diffuse share, Kd.
    pub diffuse: f64,
    /// Specular share, Ks: of the highlight and of the reflected light.
    pub specular: f64,
    /// Exponent of Phong's highlight.
    pub shine: f64,
    /// Share of the light that passes through, T; 0 is opaque.
    pub transmittance: f64,
    /// Index of refraction.
    pub refraction_index: f64,
    /// Light that it sends by itself, in addition to what other light does there: red, green and
    /// blue, encoded as the colour is. [`Shader::Depth`] and
    /// [`Shader::Portal`] ignore it.
    pub emission: DVec3,
    /// The shader that computes the colour (`#cellray shader`).
    pub shader: Shader,
    /// The factor of the colour on the triangles of a mesh that has texture coordinates.
    pub texture: Option<Arc<Texture>>,
}

impl Material {
    /// A material without highlight, reflection and transmission.
    #[must_use]
    pub fn matte(colour: DVec3) -> Self {
        Self {
            line: 0,
            colour,
            diffuse: 1.0,
            specular: 0.0,
            shine: 1.0,
            transmittance: 0.0,
            refraction_index: 1.0,
            emission: DVec3::ZERO,
            shader: Shader::Phong,
            texture: None,
        }
    }
}

/// The shader that computes the colour of a material's surfaces.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Shader {
    /// The material's colour, without lights, reflection or transmission.
    Flat,
    /// Lambert's model, without a highlight.
    Lambert,
    /// Phong's model with a highlight, NFF's default.
    #[default]
    Phong,
    /// A checker pattern of cubes with two colours.
    Checker {
        /// The second colour; the first is the material's.
        other: DVec3,
        /// The edge of a cube, above 0.
        size: f64,
    },
    /// The material's colour, brighter when nearer, without lights, reflection or transmission.
    Depth {
        /// The distance at which the surface is black.
        far: f64,
        /// The distance, below `far`, up to which the surface has full brightness.
        near: f64,
    },
    /// Rays go on from another place: what their point and their direction become by a turn around
    /// the y axis and then, for the point, a move. All light passes, whatever the material's shares
    /// are.
    Portal {
        /// The move.
        by: DVec3,
        /// The angle in degrees, from z towards x.
        turn: f64,
    },
    /// A game's own shader.
    Own {
        /// The shader's name.
        name: String,
        /// The shader's parameters, whose meaning is its own; 0 if the file has none.
        parameters: [f64; 4],
    },
}

/// An object.
#[derive(Debug, Clone)]
pub struct Object {
    /// Line of the file on which the object starts, from 1.
    pub line: u32,
    /// Index of its material in [`Scene::materials`].
    pub material: u32,
    /// The object's shape.
    pub shape: Shape,
}

/// The shape of an object.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// `s`. With a negative radius only the inside is visible.
    Sphere {
        /// Centre.
        centre: DVec3,
        /// Radius, not 0.
        radius: f64,
    },
    /// `c`: a cone or cylinder without caps. With two negative radii only the inside is visible.
    Cone {
        /// Centre of the base.
        base: DVec3,
        /// Radius at the base.
        base_radius: f64,
        /// Centre of the apex.
        apex: DVec3,
        /// Radius at the apex. The two radii are not both 0.
        apex_radius: f64,
    },
    /// `p`: a planar polygon, possibly concave, counter-clockwise as seen from its front.
    Polygon {
        /// At least three vertices.
        vertices: Vec<DVec3>,
    },
    /// `pp`: a polygon with a normal at each vertex.
    Patch {
        /// At least three vertices.
        vertices: Vec<DVec3>,
        /// A normal for each vertex, as in the file: not normalised.
        normals: Vec<DVec3>,
    },
}

impl Scene {
    /// The brightness of a light in red, green and blue. It is the light's colour if the file has
    /// one. Otherwise it is a grey by the rule of the Standard Procedural Databases: sqrt(n) / (2
    /// n) for n lights in all.
    #[must_use]
    pub fn brightness(&self, light: &Light) -> DVec3 {
        let count = self.lights.len().max(1) as f64;
        light.colour.unwrap_or(DVec3::splat(count.sqrt() / (2.0 * count)))
    }
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.view == other.view
            && self.background == other.background
            && self.sky == other.sky
            && self.fog == other.fog
            && self.ambient == other.ambient
            && self.lights == other.lights
            && self.materials == other.materials
            && self.objects == other.objects
            && self.mesh == other.mesh
            && self.heights == other.heights
            && self.height_map == other.height_map
    }
}

impl PartialEq for Light {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind && self.colour == other.colour
    }
}

impl PartialEq for Material {
    fn eq(&self, other: &Self) -> bool {
        self.colour == other.colour
            && self.diffuse == other.diffuse
            && self.specular == other.specular
            && self.shine == other.shine
            && self.transmittance == other.transmittance
            && self.refraction_index == other.refraction_index
            && self.emission == other.emission
            && self.shader == other.shader
            && self.texture == other.texture
    }
}

impl PartialEq for Object {
    fn eq(&self, other: &Self) -> bool {
        self.material == other.material && self.shape == other.shape
    }
}
