//! Lists the parts of a scene that depth shading leaves out.

use std::fmt;

use crate::{Scene, Shader, Shape};

/// A kind of thing that is not drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// `p`.
    Polygon,
    /// `pp`.
    Patch,
    /// `c`.
    Cone,
    /// `s` with a negative radius.
    InsideSphere,
    /// A mesh.
    Mesh,
    /// `l`.
    Light,
    /// `#cellray sky`.
    Sky,
    /// A material with Ks > 0 that an object has.
    Specular,
    /// A material with T > 0 that an object has.
    Transmittance,
    /// A material with a shader other than NFF's own that an object has.
    Shader,
}

impl Kind {
    /// The kind's name, in plural.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Polygon => "polygons",
            Self::Patch => "patches",
            Self::Cone => "cones and cylinders",
            Self::InsideSphere => "spheres seen from inside only (negative radius)",
            Self::Mesh => "meshes",
            Self::Light => "lights",
            Self::Sky => "gradients of the background (#cellray sky)",
            Self::Specular => "mirrors and highlights (Ks > 0)",
            Self::Transmittance => "transmitting materials (T > 0)",
            Self::Shader => "shaders (#cellray shader)",
        }
    }
}

/// All things of a kind that are not drawn. It displays as a message without a line end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotDrawn {
    /// The scene's name.
    pub file: String,
    /// The line of the first one, from 1; 0 if it has none.
    pub line: u32,
    /// Their kind.
    pub what: Kind,
    /// Their number.
    pub count: usize,
}

impl fmt::Display for NotDrawn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, what, count } = self;
        f.write_str(file)?;
        if *line > 0 {
            write!(f, ":{line}")?;
        }
        write!(f, ": {} are not drawn by depth shading ({count} in this file)", what.name())
    }
}

/// The parts of a scene that depth shading leaves out: one entry for each kind, ordered by line.
#[must_use]
pub fn not_drawn(scene: &Scene) -> Vec<NotDrawn> {
    let mut found: Vec<NotDrawn> = Vec::new();
    let mut note = |what: Kind, line: u32| match found.iter_mut().find(|entry| entry.what == what) {
        Some(entry) => {
            entry.count += 1;
            entry.line = entry.line.min(line);
        }
        None => found.push(NotDrawn { file: scene.name.clone(), line, what, count: 1 }),
    };
    for light in &scene.lights {
        note(Kind::Light, light.line);
    }
    if scene.sky.is_some() {
        note(Kind::Sky, 0);
    }
    if scene.mesh.is_some() {
        note(Kind::Mesh, 0);
    }
    let mut used = vec![false; scene.materials.len()];
    for object in &scene.objects {
        if let Some(used) = used.get_mut(object.material as usize) {
            *used = true;
        }
        match object.shape {
            Shape::Sphere { radius, .. } if radius > 0.0 => {}
            Shape::Sphere { .. } => note(Kind::InsideSphere, object.line),
            Shape::Cone { .. } => note(Kind::Cone, object.line),
            Shape::Polygon { .. } => note(Kind::Polygon, object.line),
            Shape::Patch { .. } => note(Kind::Patch, object.line),
        }
    }
    for (material, _) in scene.materials.iter().zip(used).filter(|(_, used)| *used) {
        if material.specular > 0.0 {
            note(Kind::Specular, material.line);
        }
        if material.transmittance > 0.0 {
            note(Kind::Transmittance, material.line);
        }
        if material.shader != Shader::Phong {
            note(Kind::Shader, material.line);
        }
    }
    found.sort_by_key(|entry| entry.line);
    found
}
