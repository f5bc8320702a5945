//! Writes a scene as NFF text.
//!
//! Invariant: a scene that is read back is equal. Numbers are the shortest decimals for the same
//! `f64`.

use std::fmt;

use glam::DVec3;

use crate::lines::DIRECTIVE;
use crate::{Fog, HeightMap, Light, LightKind, Material, Object, Scene, Shader, Shape, Sky, View};

impl fmt::Display for Scene {
    /// Materials keep their order. If an object's material is not the last one written, it is
    /// written again. Only scenes that [`parse`](crate::parse) did not make need this.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.view.fmt(f)?;
        writeln!(f, "b {}", Triple(self.background))?;
        if let Some(Sky { zenith, up }) = self.sky {
            writeln!(f, "{DIRECTIVE} sky {} {}", Triple(zenith), Triple(up))?;
        }
        if let Some(Fog { colour, density }) = self.fog {
            writeln!(f, "{DIRECTIVE} fog {} {density}", Triple(colour))?;
        }
        if self.ambient != DVec3::ZERO {
            writeln!(f, "{DIRECTIVE} ambient {}", Triple(self.ambient))?;
        }
        self.lights.iter().try_for_each(|light| light.fmt(f))?;
        let mut written = 0;
        let mut current = None;
        for object in &self.objects {
            let index = object.material as usize;
            while written <= index {
                self.material(written, f)?;
                current = Some(written);
                written += 1;
            }
            if current != Some(index) {
                self.materials.get(index).ok_or(fmt::Error)?.fmt(f)?;
                current = Some(index);
            }
            object.fmt(f)?;
        }
        if let Some(mesh) = &self.mesh {
            for triangle in 0..mesh.triangles.len() {
                let index = mesh.materials[triangle] as usize;
                if current != Some(index) {
                    self.materials.get(index).ok_or(fmt::Error)?.fmt(f)?;
                    current = Some(index);
                }
                mesh.shape(triangle).fmt(f)?;
            }
        }
        (written..self.materials.len()).try_for_each(|index| self.material(index, f))
    }
}

impl Scene {
    /// Writes a material for the first time, and the ground if it has this material.
    fn material(&self, index: usize, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.materials.get(index).ok_or(fmt::Error)?)?;
        let map = self.height_map.as_ref().filter(|map| map.material as usize == index);
        let Some(HeightMap { file, scale: (step, unit), colours, .. }) = map else {
            return Ok(());
        };
        write!(f, "{DIRECTIVE} heights {file} {step} {unit}")?;
        colours.iter().try_for_each(|file| write!(f, " {file}"))?;
        writeln!(f)
    }
}

impl fmt::Display for View {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "v")?;
        writeln!(f, "from {}", Triple(self.from))?;
        writeln!(f, "at {}", Triple(self.at))?;
        writeln!(f, "up {}", Triple(self.up))?;
        writeln!(f, "angle {}", self.angle)?;
        writeln!(f, "hither {}", self.hither)?;
        writeln!(f, "resolution {} {}", self.resolution.0, self.resolution.1)
    }
}

impl fmt::Display for Light {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            LightKind::Point { position, range } if range.is_finite() => {
                write!(f, "{DIRECTIVE} lamp {} {range}", Triple(position))?;
            }
            LightKind::Point { position, .. } => write!(f, "l {}", Triple(position))?,
            LightKind::Directional { to_light } => {
                write!(f, "{DIRECTIVE} sun {}", Triple(to_light))?;
            }
        }
        if let Some(colour) = self.colour {
            write!(f, " {}", Triple(colour))?;
        }
        writeln!(f)
    }
}

impl fmt::Display for Material {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            line: _,
            colour,
            diffuse,
            specular,
            shine,
            transmittance,
            refraction_index,
            emission: _,
            shader,
            texture: _,
        } = self;
        let colour = Triple(*colour);
        writeln!(f, "f {colour} {diffuse} {specular} {shine} {transmittance} {refraction_index}")?;
        if *shader == Shader::Phong {
            return Ok(());
        }
        writeln!(f, "{DIRECTIVE} shader {shader}")
    }
}

impl fmt::Display for Shader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flat => write!(f, "flat"),
            Self::Lambert => write!(f, "lambert"),
            Self::Phong => write!(f, "phong"),
            Self::Checker { other, size } => write!(f, "checker {} {size}", Triple(*other)),
            Self::Depth { far, near } => write!(f, "depth {far} {near}"),
            Self::Portal { by, turn } => write!(f, "portal {} {turn}", Triple(*by)),
            Self::Own { name, parameters: [a, b, c, d] } => write!(f, "{name} {a} {b} {c} {d}"),
        }
    }
}

impl fmt::Display for Object {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.shape.fmt(f)
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sphere { centre, radius } => writeln!(f, "s {} {radius}", Triple(*centre)),
            Self::Cone { base, base_radius, apex, apex_radius } => {
                writeln!(f, "c")?;
                writeln!(f, "{} {base_radius}", Triple(*base))?;
                writeln!(f, "{} {apex_radius}", Triple(*apex))
            }
            Self::Polygon { vertices } => {
                writeln!(f, "p {}", vertices.len())?;
                vertices.iter().try_for_each(|vertex| writeln!(f, "{}", Triple(*vertex)))
            }
            Self::Patch { vertices, normals } => {
                writeln!(f, "pp {}", vertices.len())?;
                let mut corners = vertices.iter().zip(normals);
                corners.try_for_each(|(vertex, normal)| {
                    writeln!(f, "{} {}", Triple(*vertex), Triple(*normal))
                })
            }
        }
    }
}

/// Three numbers with a blank between.
struct Triple(DVec3);

impl fmt::Display for Triple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.0.x, self.0.y, self.0.z)
    }
}
