//! Scenes that are moved and scaled.

use crate::prelude::*;
use glam::DQuat;
use scenes::{LightKind, Scene};

/// Moves a whole scene, and then scales it about the origin.
pub fn place(scene: &mut Scene, shift: DVec3, scale: f64) {
    let to = |point: &mut DVec3| *point = (*point + shift) * scale;
    to(&mut scene.view.from);
    to(&mut scene.view.at);
    for light in &mut scene.lights {
        if let LightKind::Point { position, range } = &mut light.kind {
            to(position);
            *range *= scale;
        }
    }
    for material in &mut scene.materials {
        match &mut material.shader {
            Shader::Checker { size, .. } => *size *= scale,
            Shader::Depth { far, near } => {
                *far *= scale;
                *near *= scale;
            }
            Shader::Portal { by, turn } => {
                let turned = DQuat::from_rotation_y(turn.to_radians()) * shift;
                *by = (*by + shift - turned) * scale;
            }
            Shader::Flat | Shader::Lambert | Shader::Phong | Shader::Own { .. } => {}
        }
    }
    for object in &mut scene.objects {
        match &mut object.shape {
            Shape::Sphere { centre, radius } => {
                to(centre);
                *radius *= scale;
            }
            Shape::Cone { base, base_radius, apex, apex_radius } => {
                to(base);
                to(apex);
                *base_radius *= scale;
                *apex_radius *= scale;
            }
            Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
                vertices.iter_mut().for_each(to);
            }
        }
    }
}
