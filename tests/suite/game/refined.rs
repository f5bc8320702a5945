//! Pictures that are made by several frames, a few tiles each.

use crate::prelude::*;
use cellray::game::{DVec3, Frame, Game, InputEvent, Key, Session, Start};
use image::Rgb;

/// 5 x 5 tiles, those at the right and at the bottom smaller than the others.
const SIZE: (u32, u32) = (301, 75);
const TILES: u64 = 25;

/// A mirror beside a ball that moves while the space bar is held.
struct Pushed(ObjectId);

impl Game for Pushed {
    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        world.add_light(Light::at(DVec3::new(3.0, 9.0, 9.0)))?;
        let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
        let silver = world.add_material(Material::mirror())?;
        self.0 = world.add_sphere(DVec3::new(-1.5, 0.0, 0.0), 1.0, red)?;
        world.add_sphere(DVec3::new(1.5, 0.0, 0.0), 1.4, silver)?;
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        if frame.input.key_held(Key::Space) {
            let place = world.position(self.0)?;
            world.move_to(self.0, place + DVec3::new(0.0, frame.delta, 0.0))?;
        }
        Ok(())
    }
}

/// A picture that is recognised where nothing was traced.
fn backdrop() -> RgbImage {
    RgbImage::from_fn(SIZE.0, SIZE.1, |x, y| Rgb([x as u8, y as u8, 250]))
}

fn framebuffer() -> Box<Memory> {
    Box::new(Memory::showing(&backdrop()).expect("a framebuffer"))
}

fn start(spus: u32) -> Session<Pushed> {
    let settings = Settings { spus, ..Settings::default() };
    Session::start(Pushed(ObjectId::default()), settings, framebuffer()).expect("a session")
}

/// Makes a frame of a tenth of a second, in which the space bar goes down or up if `down` is set.
fn step(session: &mut Session<Pushed>, down: Option<bool>) {
    let press = down.map(|down| InputEvent::Key { key: Key::Space, down });
    let tenth = Duration::from_millis(100);
    let flow = session.step(tenth, &mut press.into_iter().collect(), &mut |_| ()).expect("a frame");
    assert!(flow.is_continue());
}

/// The tiles that the last frame traced, and those that it left.
fn tiles(engine: &mut Engine) -> (u64, u64) {
    let last = engine.statistics();
    let traced = last.spus.iter().map(|spu| spu.tiles).sum();
    assert_eq!(traced + last.tiles_left + last.tiles_retained, TILES);
    (traced, last.tiles_left)
}

/// The number of pixels that still show the backdrop.
fn untouched(session: &Session<Pushed>) -> usize {
    let picture = session.picture().expect("a picture");
    let backdrop = backdrop();
    let both = picture.pixels().zip(backdrop.pixels());
    both.filter(|(shown, before)| shown == before).count()
}

/// The picture of the session's world now, traced in one go.
fn in_one_go(session: &mut Session<Pushed>) -> RgbImage {
    session.engine().limit_tiles(None);
    session.show_on(framebuffer()).expect("a framebuffer");
    session.redraw(&mut |_| ()).expect("a picture");
    assert_eq!(tiles(session.engine()), (TILES, 0));
    session.picture().expect("a picture")
}

#[test]
fn refined_picture_equals_picture_traced_at_once() {
    for spus in 1..=6 {
        for most in [1, 7, 24, 1000] {
            let mut session = start(spus);
            session.engine().limit_tiles(Some(most));
            let mut left = TILES;
            while left > 0 {
                assert_eq!(session.report().frames_traced, 0, "an incomplete picture counts");
                step(&mut session, None);
                let now = left.saturating_sub(u64::from(most));
                assert_eq!(tiles(session.engine()), (left - now, now));
                assert_eq!(untouched(&session) > 0, now > 0);
                left = now;
            }
            let refined = session.picture().expect("a picture");
            step(&mut session, None);
            assert_eq!(tiles(session.engine()), (0, 0), "a complete picture stays");
            assert_eq!(session.report().frames_traced, 1);
            assert!(refined == in_one_go(&mut session), "{spus} SPUs, {most} tiles");
        }
    }
}

#[test]
fn movement_cancels_refinement_at_once() {
    let mut session = start(6);
    session.engine().limit_tiles(Some(4));
    for frames in [1, 3, 6] {
        for _ in 0..frames {
            step(&mut session, None);
        }
        let (traced, left) = tiles(session.engine());
        assert_eq!(traced, if left > 0 { 4 } else { 1 });
        let before = session.picture();
        let counted = session.report().frames;
        step(&mut session, Some(true));
        assert!(session.engine().statistics().is_put_off);
        assert_eq!(tiles(session.engine()), (0, TILES));
        assert!(session.picture() == before, "something was traced");
        assert_eq!(session.report().frames, counted);

        // A coarse picture of the same world comes in its place.
        let coarse = Geometry::new(75, 18).expect("a size");
        session.engine().limit_tiles(None);
        let coarse = Box::new(Memory::new(coarse).expect("a framebuffer"));
        session.show_on(coarse).expect("a framebuffer");
        session.redraw(&mut |_| ()).expect("a picture");
        assert_eq!(session.engine().statistics().primary_rays(), 75 * 18);
        assert_eq!(session.report().frames, counted + 1);

        // A still picture is refined again.
        session.engine().limit_tiles(Some(4));
        session.show_on(framebuffer()).expect("a framebuffer");
        step(&mut session, Some(false));
        assert_eq!(tiles(session.engine()), (4, TILES - 4));
    }
}

#[test]
fn cancelled_refinement_restarts_on_same_framebuffer() {
    let mut session = start(3);
    session.engine().limit_tiles(Some(9));
    for down in [None, Some(true), Some(false)] {
        step(&mut session, down);
    }
    // The last frame began anew after the one that was put off: nothing is known of its tiles.
    assert!(!session.engine().statistics().is_put_off);
    assert_eq!(tiles(session.engine()), (9, TILES - 9));
    for left in [7, 0] {
        step(&mut session, None);
        assert_eq!(tiles(session.engine()).1, left);
    }
    let refined = session.picture();
    assert!(refined == Some(in_one_go(&mut session)));
}

/// Without retained tiles every frame is complete, so there is nothing to continue.
#[test]
fn frames_without_retained_pixels_are_not_divided() {
    let settings = Settings { retain: false, ..Settings::default() };
    let game = Pushed(ObjectId::default());
    let mut session = Session::start(game, settings, framebuffer()).expect("a session");
    session.engine().limit_tiles(Some(1));
    for down in [None, Some(true)] {
        step(&mut session, down);
        assert_eq!(tiles(session.engine()), (TILES, 0));
    }
}

#[test]
fn new_framebuffer_shows_its_first_picture() {
    let framebuffer = framebuffer();
    assert_eq!(framebuffer.picture(), Some(backdrop()));
    assert_eq!((framebuffer.geometry().width, framebuffer.geometry().height), SIZE);
}
