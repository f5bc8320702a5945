//! The scene's data, in the file's order.
//!
//! Equality is that of what is shown: where things came from (file name and lines) is not
//! compared, so that a scene equals itself written and read back.

use glam::DVec3;

use crate::View;

/// A scene: who looks, at what, under which lights. Lengths are in the scene's own unit.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Where the scene came from; messages begin with it.
    pub name: String,
    /// The eye.
    pub view: View,
    /// Colour where no object is hit, red, green and blue from 0 to 1. Black if the file has none.
    pub background: DVec3,
    /// Light that is everywhere, red, green and blue. Black if the file has none.
    pub ambient: DVec3,
    /// Lights, in file order.
    pub lights: Vec<Light>,
    /// Materials, in file order.
    pub materials: Vec<Material>,
    /// Objects, in file order.
    pub objects: Vec<Object>,
}

/// A light (`l`, `#cellray sun`).
#[derive(Debug, Clone)]
pub struct Light {
    /// Line of the file, from 1.
    pub line: u32,
    /// Where it is.
    pub kind: LightKind,
    /// Its colour, where the file gives one.
    pub colour: Option<DVec3>,
}

/// Where a light is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LightKind {
    /// In a place of the scene (`l`).
    Point {
        /// That place.
        position: DVec3,
    },
    /// Infinitely far, the same from everywhere (`#cellray sun`).
    Directional {
        /// The direction to it, as given: not 0, not normalised.
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
    /// Specular share, Ks: of the highlight, and of what a mirror reflects.
    pub specular: f64,
    /// Exponent of Phong's highlight.
    pub shine: f64,
    /// Share of light let through, T; 0 is opaque.
    pub transmittance: f64,
    /// Index of refraction.
    pub refraction_index: f64,
    /// What makes its colour (`#cellray shader`).
    pub shader: Shader,
}

/// What makes the colour of a material's surfaces.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Shader {
    /// The material's colour as it is, without lights, mirror or glass.
    Flat,
    /// Without a highlight.
    Lambert,
    /// With one: NFF's own.
    #[default]
    Phong,
    /// Cubes of two colours by turns.
    Checker {
        /// The colour beside the material's own.
        other: DVec3,
        /// Edge of a cube, more than 0.
        size: f64,
    },
    /// The material's colour, the nearer the brighter, without lights, mirror or glass.
    Depth {
        /// Distance at which it is black.
        far: f64,
        /// Distance, less than `far`, up to which it is as bright as it gets.
        near: f64,
    },
    /// A game's own.
    Own {
        /// Its name.
        name: String,
        /// What it makes of these is its own affair; 0 where the file gives none.
        parameters: [f64; 4],
    },
}

/// A thing to see.
#[derive(Debug, Clone)]
pub struct Object {
    /// Line of the file on which the object starts, from 1.
    pub line: u32,
    /// Index of its material in [`Scene::materials`].
    pub material: u32,
    /// What it is.
    pub shape: Shape,
}

/// The form of an object.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// `s`. A negative radius shows only the inside.
    Sphere {
        /// Centre.
        centre: DVec3,
        /// Radius, not 0.
        radius: f64,
    },
    /// `c`: a cylinder or a cone without caps. Two negative radii show only the inside.
    Cone {
        /// Centre of the base.
        base: DVec3,
        /// Radius at the base.
        base_radius: f64,
        /// Centre of the apex.
        apex: DVec3,
        /// Radius at the apex; not 0 together with the base's.
        apex_radius: f64,
    },
    /// `p`: a planar polygon, perhaps concave, counter-clockwise as seen from its front.
    Polygon {
        /// At least three vertices.
        vertices: Vec<DVec3>,
    },
    /// `pp`: a polygon with a normal a vertex.
    Patch {
        /// At least three vertices.
        vertices: Vec<DVec3>,
        /// A normal for each vertex, as given: not normalised.
        normals: Vec<DVec3>,
    },
}

impl Scene {
    /// The brightness of a light, red, green and blue: its colour, as it stands, where the file
    /// gives one; else a grey by the Standard Procedural Databases' rule, sqrt(n) / (2 n) of all n
    /// lights.
    #[must_use]
    pub fn brightness(&self, light: &Light) -> DVec3 {
        let count = self.lights.len().max(1) as f64;
        light
            .colour
            .unwrap_or(DVec3::splat(count.sqrt() / (2.0 * count)))
    }
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.view == other.view
            && self.background == other.background
            && self.ambient == other.ambient
            && self.lights == other.lights
            && self.materials == other.materials
            && self.objects == other.objects
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
            && self.shader == other.shader
    }
}

impl PartialEq for Object {
    fn eq(&self, other: &Self) -> bool {
        self.material == other.material && self.shape == other.shape
    }
}
