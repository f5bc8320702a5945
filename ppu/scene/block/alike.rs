//! Which materials of a scene are alike, so that one record serves them all. Files of generators
//! often repeat a material before each object.

use std::collections::HashMap;
use std::sync::Arc;

use scenes::{Material, Shader, Texture};

/// The identity of a material: everything but its line. Numbers are compared as bits, textures by
/// their place in memory.
#[derive(PartialEq, Eq, Hash)]
struct Key<'a> {
    numbers: [u64; 11],
    shader: (u8, &'a str, [u64; 4]),
    texture: Option<*const Texture>,
}

impl<'a> Key<'a> {
    fn of(material: &'a Material) -> Self {
        let Material {
            line: _,
            colour,
            diffuse,
            specular,
            shine,
            transmittance,
            refraction_index,
            emission,
            shader,
            texture,
        } = material;
        let (kind, name, parameters) = match shader {
            Shader::Flat => (0, "", [0.0; 4]),
            Shader::Lambert => (1, "", [0.0; 4]),
            Shader::Phong => (2, "", [0.0; 4]),
            Shader::Checker { other, size } => (3, "", [other.x, other.y, other.z, *size]),
            Shader::Depth { far, near } => (4, "", [*far, *near, 0.0, 0.0]),
            Shader::Portal { by, turn } => (6, "", [by.x, by.y, by.z, *turn]),
            Shader::Own { name, parameters } => (5, name.as_str(), *parameters),
        };
        let numbers = [
            colour.x,
            colour.y,
            colour.z,
            *diffuse,
            *specular,
            *shine,
            *transmittance,
            *refraction_index,
            emission.x,
            emission.y,
            emission.z,
        ];
        Self {
            numbers: numbers.map(f64::to_bits),
            shader: (kind, name, parameters.map(f64::to_bits)),
            texture: texture.as_ref().map(Arc::as_ptr),
        }
    }
}

/// For each material the index of the first one that is equal.
pub(super) fn firsts(materials: &[Material]) -> Vec<u32> {
    let mut known = HashMap::with_capacity(materials.len());
    let first = |(index, material)| *known.entry(Key::of(material)).or_insert(index);
    (0..).zip(materials).map(first).collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn material(line: u32) -> Material {
        Material {
            line,
            colour: DVec3::new(0.1, 0.2, 0.3),
            diffuse: 0.5,
            specular: 0.25,
            shine: 9.0,
            transmittance: 0.0,
            refraction_index: 1.0,
            emission: DVec3::ZERO,
            shader: Shader::Phong,
            texture: None,
        }
    }

    #[test]
    fn equal_materials_on_different_lines_are_one() {
        let materials = [1, 2, 3].map(material);
        assert_eq!(firsts(&materials), [0, 0, 0]);
    }

    #[test]
    fn every_field_makes_a_difference() {
        let texture = || {
            let texels = vec![[1, 2, 3]];
            Texture::new(1, texels, [scenes::Wrap::Clamp; 2]).map(Arc::new)
        };
        let changes: [fn(&mut Material); 14] = [
            |it| it.colour.z = 0.4,
            |it| it.diffuse = 0.6,
            |it| it.specular = 0.6,
            |it| it.shine = 8.0,
            |it| it.transmittance = 0.1,
            |it| it.refraction_index = 1.5,
            |it| it.emission.y = 0.1,
            |it| it.shader = Shader::Flat,
            |it| it.shader = Shader::Lambert,
            |it| {
                let (far, near) = (5.0, 1.0);
                it.shader = Shader::Depth { far, near };
            },
            |it| {
                let (other, size) = (DVec3::ONE, 2.0);
                it.shader = Shader::Checker { other, size };
            },
            |it| it.shader = Shader::Portal { by: DVec3::ONE, turn: 2.0 },
            |it| {
                let (name, parameters) = ("a".into(), [0.0; 4]);
                it.shader = Shader::Own { name, parameters };
            },
            |it| {
                let (name, parameters) = ("b".into(), [0.0; 4]);
                it.shader = Shader::Own { name, parameters };
            },
        ];
        let mut materials = vec![material(1)];
        materials.extend(changes.map(|change| {
            let mut changed = material(1);
            change(&mut changed);
            changed
        }));
        for _ in 0..2 {
            let mut textured = material(1);
            textured.texture = texture();
            materials.push(textured);
        }
        let own: Vec<u32> = (0..materials.len() as u32).collect();
        assert_eq!(firsts(&materials), own);
        materials[3] = materials[15].clone();
        assert_eq!(firsts(&materials)[15], 3);
    }
}
