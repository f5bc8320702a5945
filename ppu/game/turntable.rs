//! A scene that the eye goes around.
//!
//! Invariant: the eye depends only on the frame's number, and is the same on every machine because
//! `libm`'s sines are.

use glam::DVec3;
use scenes::View;

use super::{Frame, Game, Start, World, WorldError};
use crate::scene::RenderOptions;

/// A scene whose eye goes around its target, at constant height and distance.
#[derive(Clone, Debug)]
pub struct Turntable {
    scene: scenes::Scene,
    render_options: RenderOptions,
    frames: u32,
}

impl Turntable {
    /// A turntable of a scene that takes `frames` frames to go once around. With 0 the eye stands
    /// still.
    #[must_use]
    pub fn new(scene: scenes::Scene, render_options: RenderOptions, frames: u32) -> Self {
        Self { scene, render_options, frames }
    }

    fn eye(&self, frame: u64) -> DVec3 {
        let View { from, at, up, .. } = self.scene.view;
        let frames = u64::from(self.frames.max(1));
        let part = (frame % frames) as f64 / frames as f64;
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * part);
        let axis = up.normalize();
        let away = from - at;
        let along = axis * axis.dot(away);
        let across = away - along;
        at + along + across * cosine + axis.cross(across) * sine
    }
}

impl Game for Turntable {
    fn name(&self) -> &str {
        &self.scene.name
    }

    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        *world = World::from_nff(&self.scene, self.render_options)?;
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        match frame.number % u64::from(self.frames.max(1)) {
            // The scene's own numbers, bit for bit.
            0 => world.look_from(self.scene.view.from, self.scene.view.at),
            _ => world.look_from(self.eye(frame.number), self.scene.view.at),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eye_orbits_at_constant_height_and_distance() {
        let text = "v\nfrom 3 -4 2\nat 0 0 1\nup 0 0 2\nangle 40\nhither 1\nresolution 4 4\nf 1 1 1 1 0 0 0 1\ns 0 0 1 1\n";
        let scene =
            scenes::parse(text.as_bytes(), "s", &scenes::Limits::default()).expect("a scene");
        let View { from, at, .. } = scene.view;
        let turntable = Turntable::new(scene, RenderOptions::default(), 8);
        let eyes: Vec<_> = (0..16).map(|frame| turntable.eye(frame)).collect();
        for (frame, eye) in eyes.iter().enumerate() {
            assert!((eye.distance(at) - from.distance(at)).abs() < 1e-12);
            assert!((eye.z - from.z).abs() < 1e-12);
            assert_eq!(*eye, eyes[(frame + 8) % 16]);
        }
        assert!(eyes[0].distance(from) < 1e-12);
        assert!(eyes[2].distance(DVec3::new(4.0, 3.0, 2.0)) < 1e-12);
        assert!(eyes[4].distance(DVec3::new(-3.0, 4.0, 2.0)) < 1e-12);
    }
}
