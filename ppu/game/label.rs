//! Text that a display draws over the picture, at a place of the picture or of the world.
//!
//! Owns labels and where they are in a picture. A display decides how it draws text. Invariant: a
//! placed label is within the picture.

use glam::DVec3;

use super::World;

/// A text over the picture, at a place that the game chooses; see
/// [`Game::labels`](super::Game::labels).
///
/// ```
/// use cellray::game::{DVec3, Label, Side};
///
/// let earth = DVec3::new(4.5, 0.0, 0.0);
/// let name = Label::at_point("Earth", earth).beside(Side::Above).coloured(0.6, 0.8, 1.0);
/// let score = Label::at_pixel("3 of 8", [20.0, 20.0]).beside(Side::Right);
/// # assert_ne!(name, score);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The text, of one line.
    pub text: String,
    /// Where it is.
    pub anchor: Anchor,
    /// Where the text is relative to that.
    pub side: Side,
    /// Red, green and blue as a display has them, 0 to 1.
    pub colour: DVec3,
}

/// The place of a [`Label`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anchor {
    /// A pixel of a picture of [`Frame::size`](super::Frame::size), from the top left, as the
    /// mouse's position.
    Pixel([f32; 2]),
    /// A point of the world. The label is shown while the point is in the picture, also if
    /// something hides it: whether that matters is for the game to decide.
    Point(DVec3),
}

/// Where a [`Label`]'s text is relative to its place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// Its middle is there.
    #[default]
    Over,
    /// It ends to the left of it.
    Left,
    /// It begins to the right of it.
    Right,
    /// It is above.
    Above,
    /// It is below.
    Below,
}

impl Label {
    /// A white label with its middle at a pixel of a picture of
    /// [`Frame::size`](super::Frame::size).
    pub fn at_pixel(text: impl Into<String>, pixel: [f32; 2]) -> Self {
        Self::new(text.into(), Anchor::Pixel(pixel))
    }

    /// A white label with its middle at a point of the world.
    pub fn at_point(text: impl Into<String>, point: impl Into<DVec3>) -> Self {
        Self::new(text.into(), Anchor::Point(point.into()))
    }

    fn new(text: String, anchor: Anchor) -> Self {
        Self { text, anchor, side: Side::Over, colour: DVec3::ONE }
    }

    /// The label on a side of its place.
    #[must_use]
    pub fn beside(self, side: Side) -> Self {
        Self { side, ..self }
    }

    /// The label in a colour: red, green and blue as a display has them, 0 to 1.
    #[must_use]
    pub fn coloured(self, red: f64, green: f64, blue: f64) -> Self {
        Self { colour: DVec3::new(red, green, blue), ..self }
    }

    /// The label on a picture of a world; `None` if its place isn't in the picture. `input_size` is
    /// the size in whose pixels the game measures, and `size` the picture's.
    pub(super) fn placed(
        self,
        world: &World,
        input_size: (u32, u32),
        size: (u32, u32),
    ) -> Option<PlacedLabel> {
        let ([x, y], (width, height)) = match self.anchor {
            Anchor::Pixel(pixel) => (pixel, input_size),
            Anchor::Point(point) => (world.project(point, size)?, size),
        };
        // The middle of a pixel is at whole numbers.
        let part = |at: f32, side: u32| (at + 0.5) / side as f32;
        let place = [part(x, width), part(y, height)];
        let is_inside = place.iter().all(|part| (0.0..=1.0).contains(part));
        let channel = |value: f64| (255.0 * value.clamp(0.0, 1.0)).round() as u8;
        is_inside.then(|| PlacedLabel {
            text: self.text,
            place,
            side: self.side,
            colour: self.colour.to_array().map(channel),
        })
    }
}

/// A [`Label`] and its place in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedLabel {
    /// The text.
    pub text: String,
    /// The place, as parts of the picture's width and height from the top left, 0 to 1.
    pub place: [f32; 2],
    /// Where the text is relative to that.
    pub side: Side,
    /// Red, green and blue.
    pub colour: [u8; 3],
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Material, WorldError};

    const SIZE: (u32, u32) = (320, 180);

    #[test]
    fn label_point_equals_picked_pixel() -> Result<(), WorldError> {
        let mut world = World::new();
        world.look_from([3.0, -2.0, 9.0], [0.5, 1.0, 0.0])?;
        let white = world.add_material(Material::matte(1.0, 1.0, 1.0))?;
        world.add_sphere(DVec3::ZERO, 2.0, white)?;
        let mut picked = 0;
        for (x, y) in (0..SIZE.0).step_by(7).zip((0..SIZE.1).step_by(4)) {
            let pixel = [x as f32, y as f32];
            let Some(pick) = world.pick(pixel, SIZE) else {
                continue;
            };
            picked += 1;
            let seen = world.project(pick.point, SIZE).expect("before the eye");
            let off = seen.iter().zip(pixel).map(|(a, b)| (a - b).abs());
            assert!(off.into_iter().all(|off| off < 1e-3), "{seen:?} {pixel:?}");
        }
        assert!(picked > 5);
        assert_eq!(world.project([3.0, -2.0, 10.0], SIZE), None);
        assert_eq!(world.project(DVec3::ZERO, (0, 180)), None);
        Ok(())
    }

    #[test]
    fn labels_outside_of_the_picture_are_left_out() {
        let world = World::new();
        let place = |label: Label| Some(label.placed(&world, (640, 360), SIZE)?.place);
        assert_eq!(place(Label::at_point("", DVec3::ZERO)), Some([0.5; 2]));
        assert_eq!(place(Label::at_point("", [0.0, 0.0, 11.0])), None);
        assert_eq!(place(Label::at_point("", [99.0, 0.0, 0.0])), None);
        // Pixels are those of the input size, whatever the size of the picture.
        let pixel = |x: f32| place(Label::at_pixel("", [x, 179.5]));
        assert_eq!(pixel(159.5), Some([0.25, 0.5]));
        assert_eq!((pixel(640.0), pixel(-1.0), pixel(f32::NAN)), (None, None, None));
    }
}
