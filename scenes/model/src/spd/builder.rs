//! Collects a generated scene's objects with the lines of its text, and what scenes of SPD have in
//! common: the view, the background, and the angle of a highlight.

use std::sync::Arc;

use glam::{DQuat, DVec3};

use crate::{Light, LightKind, Material, Mesh, Object, Scene, Shader, Shape, View};

/// Lines of the text before the first light: the view's and the background's.
const LINES_BEFORE: u32 = 8;

/// SPD's usual background.
const SKY: DVec3 = DVec3::new(0.078, 0.361, 0.753);

/// The usual view from a point to another.
pub(super) fn view(from: DVec3, at: DVec3) -> View {
    View { from, at, up: DVec3::Z, angle: 45.0, hither: 1.0, resolution: (512, 512) }
}

/// An opaque material. SPD gives a highlight by the angle in degrees at which half of it is left; 0
/// is the sharpest that it has.
pub(super) fn opaque(colour: DVec3, diffuse: f64, specular: f64, highlight: f64) -> Material {
    let shine = if highlight > 0.0 {
        libm::log(0.5) / libm::log(libm::cos(highlight.to_radians()))
    } else {
        100_000.0
    };
    Material {
        // Written where it is first used.
        line: 0,
        colour,
        diffuse,
        specular,
        shine,
        transmittance: 0.0,
        refraction_index: 0.0,
        emission: DVec3::ZERO,
        shader: Shader::Phong,
        texture: None,
    }
}

pub(super) struct Builder {
    scene: Scene,
    /// Triangles that are not objects.
    mesh: Mesh,
    /// Lines of the text so far.
    lines: u32,
    /// The material that the next object has unless the text names another.
    current: Option<u32>,
}

impl Builder {
    pub(super) fn new(view: View, lights: &[DVec3]) -> Self {
        let lights: Vec<Light> = lights
            .iter()
            .zip(LINES_BEFORE + 1..)
            .map(|(&position, line)| Light {
                line,
                kind: LightKind::Point { position, range: f64::INFINITY },
                colour: None,
            })
            .collect();
        Self {
            lines: LINES_BEFORE + lights.len() as u32,
            scene: Scene {
                name: String::new(),
                view,
                background: SKY,
                sky: None,
                ambient: DVec3::ZERO,
                lights,
                materials: Vec::new(),
                objects: Vec::new(),
                mesh: None,
                heights: None,
                height_map: None,
                fog: None,
            },
            mesh: Mesh::default(),
            current: None,
        }
    }

    /// Replaces the background.
    pub(super) fn background(mut self, colour: DVec3) -> Self {
        self.scene.background = colour;
        self
    }

    /// Sets the material of the objects that follow. Equal materials are one.
    pub(super) fn material(&mut self, material: Material) {
        let materials = &mut self.scene.materials;
        let known = materials.iter().position(|known| *known == material);
        let index = known.unwrap_or(materials.len()) as u32;
        if self.current == Some(index) {
            return;
        }
        self.lines += 1;
        self.current = Some(index);
        if known.is_none() {
            materials.push(Material { line: self.lines, ..material });
        }
    }

    pub(super) fn sphere(&mut self, centre: DVec3, radius: f64) {
        self.push(Shape::Sphere { centre, radius }, 1);
    }

    /// A cone or cylinder between two points, each with the radius there.
    pub(super) fn cone(
        &mut self,
        (base, base_radius): (DVec3, f64),
        (apex, apex_radius): (DVec3, f64),
    ) {
        let shape = Shape::Cone { base, base_radius, apex, apex_radius };
        self.push(shape, 3);
    }

    pub(super) fn polygon(&mut self, vertices: Vec<DVec3>) {
        let lines = 1 + vertices.len() as u32;
        self.push(Shape::Polygon { vertices }, lines);
    }

    /// A square of the plane z = 0 around the origin, seen from above.
    pub(super) fn ground(&mut self, half_side: f64) {
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        let corner = |(x, y)| half_side * DVec3::new(x, y, 0.0);
        self.polygon(corners.map(corner).to_vec());
    }

    fn push(&mut self, shape: Shape, lines: u32) {
        self.scene.objects.push(Object {
            line: self.lines + 1,
            // Every generator sets a material first.
            material: self.current.unwrap_or_default(),
            shape,
        });
        self.lines += lines;
    }

    /// Adds triangles, which get the current material. A scene that has any has no objects.
    pub(super) fn triangles(&mut self, added: &Mesh) {
        let material = self.current.unwrap_or_default();
        let mesh = &mut self.mesh;
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(&added.positions);
        mesh.normals.extend(&added.normals);
        let moved = |corners: &[u32; 3]| corners.map(|corner| first + corner);
        mesh.triangles.extend(added.triangles.iter().map(moved));
        mesh.materials.resize(mesh.triangles.len(), material);
        self.lines += 4 * added.triangles.len() as u32;
    }

    /// Shows triangles from both sides.
    pub(super) fn two_sided(&mut self) {
        self.mesh.two_sided = true;
    }

    pub(super) fn finish(self, name: String) -> Scene {
        let has_triangles = !self.mesh.triangles.is_empty();
        Scene { name, mesh: has_triangles.then(|| Arc::new(self.mesh)), ..self.scene }
    }
}

/// A rotation about a unit axis. Those of `glam` use functions of the system's library, whose
/// results differ between systems.
pub(super) fn rotation(axis: DVec3, angle: f64) -> DQuat {
    let imaginary = libm::sin(angle / 2.0) * axis;
    DQuat::from_vec4(imaginary.extend(libm::cos(angle / 2.0)))
}
