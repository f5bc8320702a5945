//! Chooses how coarsely a picture is traced, by the time that its frames take.
//!
//! While something moves, the display's width and height are divided so that frames are fluid. The
//! divisor has steps of a quarter, so that a picture is no coarser than the time demands. What
//! has come to rest is refined: a picture of the display's full resolution is traced a few tiles at
//! a time, so that a frame stays short and whatever moves next is shown at once.
//!
//! Invariants: the divisor is from 1 to [`COARSEST`]. It never becomes smaller within [`REST`]
//! frames after another change while something moves. A change is only made if it is not expected
//! to be reverted at the same load.

use std::time::Duration;

/// A divisor of the display's width and height, in quarters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Divisor(u32);

impl Divisor {
    /// The display's full resolution.
    pub const ONE: Self = Self(4);

    /// A side of the display, divided.
    #[must_use]
    pub fn of(self, side: u32) -> u32 {
        side * Self::ONE.0 / self.0
    }

    /// The number of the display's pixels for each of the picture's.
    fn area(self) -> f64 {
        (f64::from(self.0) / f64::from(Self::ONE.0)).powi(2)
    }

    /// The finer divisors, the finest first.
    fn finer(self) -> impl Iterator<Item = Self> {
        (Self::ONE.0..self.0).map(Self)
    }

    /// The coarser divisors below [`COARSEST`], the finest first.
    fn coarser(self) -> impl Iterator<Item = Self> {
        (self.0 + 1..COARSEST.0).map(Self)
    }
}

/// The largest divisor of the display's width and height.
pub const COARSEST: Divisor = Divisor(64);
/// Frames that take longer than this, in seconds, make the picture coarser.
const TOO_LONG: f64 = 1.0 / 20.0;
/// A picture becomes finer if it is expected to take less than this, in seconds: well below
/// [`TOO_LONG`].
const SHORT: f64 = 1.0 / 30.0;
/// The number of frames without anything to trace after which a picture has come to rest.
const STILL_FRAMES: u32 = 6;
/// The minimum number of frames between a change and one that makes the picture finer.
const REST: u32 = 8;
/// The minimum weight of a frame in the running averages.
const WEIGHT: f64 = 0.25;
/// A picture much coarser than this is refined to this divisor before it is to 1. That takes a
/// sixteenth of the time, and the picture is a good one already.
const HALFWAY: Divisor = Divisor(16);
/// The time that a frame should take while a picture is refined, in seconds. It is the longest
/// time by which a key's effect comes later.
const SLICE: f64 = 1.0 / 25.0;
/// The number of tiles of the first frame that refines a picture.
const FIRST_TILES: u32 = 6;
/// The factor by which the number of tiles may grow from a frame to the next.
const GROWTH: f64 = 4.0;

/// What a frame has traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Traced {
    pub took: Duration,
    /// The number of tiles that were traced; 0 if the picture was there already.
    pub tiles: u64,
    /// The number of tiles that were left for the next frame.
    pub left: u64,
}

/// Chooses the divisor of the display's width and height.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    /// The divisor while something moves.
    divisor: Divisor,
    /// The average time of a traced frame at this divisor, in seconds.
    seconds: Option<f64>,
    /// The number of frames since the last change of this divisor.
    rested: u32,
    /// The number of frames since something was traced.
    still: u32,
    /// Whether a picture at rest is to be antialiased, so that even a fine one is refined.
    is_smooth: bool,
    refining: Option<Refining>,
}

/// The refinement of a picture at rest.
#[derive(Clone, Copy, Debug)]
struct Refining {
    divisor: Divisor,
    /// The number of tiles of the next frame.
    tiles: u32,
    /// The average time of a tile in seconds, when one is known.
    seconds: Option<f64>,
}

impl Pace {
    /// Starts with the coarsest picture, so that the first one comes soon. With `is_smooth`, a
    /// picture at rest is refined even if it has the display's resolution.
    #[must_use]
    pub fn new(is_smooth: bool) -> Self {
        Self { divisor: COARSEST, seconds: None, rested: 0, still: 0, is_smooth, refining: None }
    }

    /// The current divisor of the display's width and height.
    #[must_use]
    pub fn divisor(&self) -> Divisor {
        self.refining.map_or(self.divisor, |refining| refining.divisor)
    }

    /// The largest number of tiles that the next frame may trace, while a picture is refined.
    #[must_use]
    pub fn tiles(&self) -> Option<u32> {
        self.refining.map(|refining| refining.tiles)
    }

    /// Ends the refinement of a picture, because something moves or the display has changed.
    pub fn moves(&mut self) {
        self.refining = None;
        self.still = 0;
    }

    /// Records a frame. Returns whether the next one is of another picture: of another divisor, or
    /// refined.
    pub fn frame(&mut self, frame: Traced) -> bool {
        let before = (self.divisor(), self.refining.is_some());
        match &mut self.refining {
            Some(refining) => refining.frame(frame),
            None => self.moving(frame),
        }
        (self.divisor(), self.refining.is_some()) != before
    }

    fn moving(&mut self, Traced { took, tiles, .. }: Traced) {
        self.rested += 1;
        if tiles > 0 {
            let weight = WEIGHT.max(1.0 / f64::from(self.rested));
            self.seconds = Some(mean(self.seconds, took.as_secs_f64(), weight));
            self.still = 0;
        } else {
            self.still += 1;
        }
        if self.still >= STILL_FRAMES && (self.divisor > Divisor::ONE || self.is_smooth) {
            self.refining = Some(Refining::new(self.divisor));
        } else if let Some(seconds) = self.seconds.filter(|_| self.still == 0) {
            let next = self.next(seconds);
            if next != self.divisor {
                self.seconds = Some(expected(seconds, self.divisor, next));
                self.divisor = next;
                self.rested = 0;
            }
        }
    }

    /// The divisor that suits frames of this time, in a single step.
    fn next(&self, seconds: f64) -> Divisor {
        let shorter = |divisor: Divisor, than| expected(seconds, self.divisor, divisor) < than;
        if self.rested > 1 && seconds > TOO_LONG {
            self.divisor.coarser().find(|&coarser| shorter(coarser, TOO_LONG)).unwrap_or(COARSEST)
        } else if self.rested >= REST {
            self.divisor.finer().find(|&finer| shorter(finer, SHORT)).unwrap_or(self.divisor)
        } else {
            self.divisor
        }
    }
}

impl Refining {
    /// Begins with a picture of this divisor.
    fn new(divisor: Divisor) -> Self {
        Self {
            divisor: if divisor > HALFWAY { HALFWAY } else { Divisor::ONE },
            tiles: FIRST_TILES,
            seconds: None,
        }
    }

    fn frame(&mut self, Traced { took, tiles, left }: Traced) {
        if tiles > 0 {
            let a_tile = took.as_secs_f64() / tiles as f64;
            let seconds = mean(self.seconds, a_tile, WEIGHT);
            self.seconds = Some(seconds);
            let most = f64::from(self.tiles) * GROWTH;
            // The conversion to an integer saturates.
            self.tiles = (SLICE / seconds).clamp(1.0, most) as u32;
        }
        if left == 0 && self.divisor > Divisor::ONE {
            *self = Self { seconds: self.seconds, tiles: self.tiles, divisor: Divisor::ONE };
        }
    }
}

/// The running average with a new value of this weight; the value itself if it is the first.
fn mean(mean: Option<f64>, value: f64, weight: f64) -> f64 {
    mean.map_or(value, |mean| mean + weight * (value - mean))
}

/// The expected time at another divisor, in seconds. It is proportional to the number of rays.
fn expected(seconds: f64, from: Divisor, to: Divisor) -> f64 {
    seconds * from.area() / to.area()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number of tiles of a picture of 1280x720.
    const ALL: u64 = 900;

    /// A display whose whole picture takes a time to trace.
    struct Load {
        /// The time at divisor 1, in seconds.
        full: f64,
        /// The tiles of the picture that are not traced yet.
        left: u64,
    }

    impl Load {
        fn new(full: f64) -> Self {
            Self { full, left: ALL }
        }

        /// The number of tiles of a picture, which are as large at every divisor.
        fn all(pace: &Pace) -> u64 {
            (ALL as f64 / pace.divisor().area()).ceil() as u64
        }

        /// Makes a frame, and returns its time in seconds.
        fn frame(&mut self, pace: &mut Pace) -> f64 {
            let tiles = self.left.min(pace.tiles().map_or(ALL, u64::from));
            let seconds = if tiles == Self::all(pace) {
                self.full / pace.divisor().area()
            } else {
                tiles as f64 * self.full / ALL as f64
            };
            self.left -= tiles;
            let took = Duration::from_secs_f64(seconds);
            let left = self.left;
            if pace.frame(Traced { took, tiles, left }) {
                self.left = Self::all(pace);
            }
            seconds
        }

        /// Makes frames in which everything moves, and returns the divisor after each.
        fn moving(&mut self, pace: &mut Pace, frames: u32) -> Vec<Divisor> {
            (0..frames)
                .map(|_| {
                    pace.moves();
                    self.left = Self::all(pace);
                    self.frame(pace);
                    pace.divisor()
                })
                .collect()
        }
    }

    #[test]
    fn steady_load_settles_at_fluid_rate() {
        for full in [0.001, 0.02, 0.05, 0.1, 0.4, 1.0, 2.5, 40.0] {
            let settled = Load::new(full).moving(&mut Pace::new(false), 200)[100..].to_vec();
            assert!(settled.windows(2).all(|pair| pair[0] == pair[1]), "{full}: {settled:?}");
            let seconds = full / settled[0].area();
            assert!(seconds <= TOO_LONG || settled[0] == COARSEST, "{full}: {seconds}");
        }
    }

    #[test]
    fn resolution_is_maximum_for_frame_time() {
        for full in [0.1, 0.4, 1.0, 1.7, 2.5] {
            let mut pace = Pace::new(false);
            let settled = Load::new(full).moving(&mut pace, 200)[199];
            // A quarter finer would take too long.
            let finer = Divisor(settled.0 - 1);
            let (took, would_take) = (full / settled.area(), full / finer.area());
            assert!(took < SHORT && would_take >= SHORT, "{full}: {settled:?}");
        }
        assert_eq!([1, 5, 7].map(|quarters| Divisor(4 * quarters).of(960)), [960, 192, 137]);
        assert_eq!((Divisor(5).of(960), Divisor(7).of(540)), (768, 308));
    }

    #[test]
    fn only_heavy_load_is_divided() {
        let mut pace = Pace::new(false);
        assert_eq!(pace.divisor(), COARSEST);
        let divisors = Load::new(0.01).moving(&mut pace, 100);
        assert_eq!(divisors[REST as usize..], [Divisor::ONE; 100 - REST as usize]);
        let divisors = Load::new(1.0).moving(&mut pace, 4);
        assert!(divisors.last() > Some(&Divisor(12)), "{divisors:?}");
    }

    #[test]
    fn still_picture_is_refined_in_short_frames() {
        for full in [0.1, 1.5, 5.0, 30.0] {
            let mut pace = Pace::new(false);
            let mut load = Load::new(full);
            let moving = load.moving(&mut pace, 100)[99];
            let mut longest = 0.0_f64;
            let mut frames = 0;
            while pace.divisor() > Divisor::ONE || load.left > 0 {
                longest = longest.max(load.frame(&mut pace));
                frames += 1;
                assert!(f64::from(frames) < 20.0 + 2.0 * full / SLICE, "{full}");
            }
            let tile = full / ALL as f64;
            assert!(longest <= SLICE.max(f64::from(FIRST_TILES) * tile), "{full}: {longest}");
            for _ in 0..100 {
                assert_eq!((load.frame(&mut pace), pace.divisor()), (0.0, Divisor::ONE));
            }

            // When it moves again, it is as coarse as before, at once.
            assert_eq!(load.moving(&mut pace, 1), [moving], "{full}");
        }
    }

    #[test]
    fn tile_count_follows_cost() {
        let mut pace = Pace::new(false);
        let mut load = Load::new(10.0);
        load.moving(&mut pace, 2);
        while pace.divisor() > Divisor::ONE || load.left > 850 {
            load.frame(&mut pace);
        }
        assert_eq!(pace.tiles(), Some(3));
        load.full = 1.0;
        let before: Vec<_> = (0..12)
            .map(|_| {
                load.frame(&mut pace);
                pace.tiles().expect("it is refined")
            })
            .collect();
        assert!(before.is_sorted() && before[11] > 20, "{before:?}");
    }

    #[test]
    fn fine_picture_is_not_refined() {
        let mut pace = Pace::new(false);
        let mut load = Load::new(0.01);
        load.moving(&mut pace, 100);
        for _ in 0..100 {
            load.frame(&mut pace);
        }
        assert_eq!((pace.divisor(), pace.tiles()), (Divisor::ONE, None));
    }

    #[test]
    fn fine_picture_is_antialiased_at_rest() {
        let mut pace = Pace::new(true);
        let mut load = Load::new(0.01);
        load.moving(&mut pace, 100);
        assert_eq!((pace.divisor(), pace.tiles()), (Divisor::ONE, None));
        for _ in 0..STILL_FRAMES {
            assert_eq!(pace.tiles(), None);
            load.frame(&mut pace);
        }
        assert_eq!(pace.tiles(), Some(FIRST_TILES));
        // It is a picture of its own.
        assert_eq!(load.left, ALL);
        while load.left > 0 {
            assert!(load.frame(&mut pace) <= SLICE);
        }
        load.moving(&mut pace, 1);
        assert_eq!((pace.divisor(), pace.tiles()), (Divisor::ONE, None));
    }
}
