//! Eight-ball for two players on a table with six pockets.
//!
//! A sphere on the rail shows whose turn it is by its colour, yellow or blue, and the status line
//! names the player. It is on the rail where that player's pocketed balls are placed: solids in
//! front, stripes at the back. While no player has a group, it is at the foot of the table. It is
//! red after a foul, and changes its colour after a game is won. The rules are in [`rules`].
//!
//! | | keyboard | mouse | pad |
//! |---|---|---|---|
//! | aim | left and right arrow | move it | left stick |
//! | aim with care | with Shift | with the right button held | with L2 held |
//! | power | up and down arrow | draw it back with the left button held | right stick |
//! | strike | Space | let the left button go | Cross |
//! | tip higher (follow), lower (draw) | W, S | wheel | R1, L1 |
//! | from above, or from behind the ball | C | middle button | Triangle |
//! | a new game | N; Enter once one is won | | Start |

pub mod aim;
pub mod balls;
pub mod rules;
mod scene;
mod status;
pub mod table;

use cellray::game::{
    Button, DVec3, Entry, Frame, Game, Input, Key, Model, MouseButton, RenderOptions, Start, View,
    World, WorldError,
};
use rand::SeedableRng as _;
use rand_xoshiro::Xoshiro256PlusPlus;

use self::aim::Aim;
use self::balls::{Ball, Balls};
use self::rules::{Rules, Shot};
use self::scene::{Scene, Sign};
use crate::camera::follow;
use crate::steps::Steps;

/// The game's name.
pub const NAME: &str = "billiards";
/// The controls.
pub const CONTROLS: &[&str] = &[
    "left and right arrow, mouse, left stick: aim; with Shift, right button, L2: with care",
    "up and down arrow, mouse drawn back with its left button, right stick: power",
    "Space, left button let go, Cross: strike",
    "W and S, wheel, R1 and L1: tip higher or lower, to follow or to draw back",
    "C, middle button, Triangle: from above, or from behind the ball",
    "N, Start: a new game",
];
/// The entry in the table of games.
pub const ENTRY: Entry = Entry {
    name: NAME,
    line: "eight-ball for two on a table with six pockets",
    new: || Box::new(Billiards::default()),
    open: None,
};

/// The number of steps in which the cue comes forward.
const BLOW: u32 = 40;
/// The distance from the cue ball to the tip at rest, and when drawn back at full power.
const DRAWN: (f64, f64) = (0.02, 0.3);
/// Seconds for which the marker is red after a foul.
const FOUL: f64 = 1.6;
/// How fast the eye follows, as the approximate share of the remaining distance for each second.
const FOLLOWS: f64 = 3.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// The player aims.
    Aim,
    /// The cue comes forward for this many more steps.
    Blow(u32),
    /// The balls are moving.
    Run,
    /// The game is won.
    Over,
}

/// The game.
pub struct Billiards {
    balls: Balls,
    rules: Rules,
    shot: Shot,
    aim: Aim,
    phase: Phase,
    steps: Steps,
    /// Seconds since a player last had to wait for the balls.
    since: f64,
    above: bool,
    eye: DVec3,
    at: DVec3,
    chance: Xoshiro256PlusPlus,
    scene: Scene,
}

impl Default for Billiards {
    fn default() -> Self {
        let mut chance = Xoshiro256PlusPlus::seed_from_u64(0);
        Self {
            balls: Balls::rack(&mut chance),
            rules: Rules::default(),
            shot: Shot::default(),
            aim: Aim::default(),
            phase: Phase::Aim,
            steps: Steps::default(),
            since: FOUL,
            above: false,
            eye: DVec3::new(-2.6, 1.3, 0.6),
            at: DVec3::ZERO,
            chance,
            scene: Scene::default(),
        }
    }
}

impl Billiards {
    /// The balls, by number.
    #[must_use]
    pub fn balls(&self) -> &[Ball] {
        &self.balls.0
    }

    /// The balls and their state.
    #[must_use]
    pub fn table(&self) -> &Balls {
        &self.balls
    }

    /// The state of the game.
    #[must_use]
    pub fn rules(&self) -> &Rules {
        &self.rules
    }

    /// How the player holds the cue.
    #[must_use]
    pub fn aim(&self) -> &Aim {
        &self.aim
    }

    /// Whether the game waits for a player to aim.
    #[must_use]
    pub fn waits(&self) -> bool {
        self.phase == Phase::Aim
    }

    fn begin(&mut self) {
        self.balls = Balls::rack(&mut self.chance);
        // The loser breaks.
        self.rules = Rules::new(self.rules.winner().map_or(0, |winner| 1 - winner));
        self.since = FOUL;
        self.prepare();
    }

    /// Points the cue at the nearest ball that may be touched first.
    fn prepare(&mut self) {
        self.phase = Phase::Aim;
        self.shot = Shot::default();
        let from = self.balls.0[0].body.centre;
        let on_bed = |number: usize| self.balls.on_bed(number);
        let target = (1..self.balls.0.len())
            .filter(|&number| on_bed(number) && self.rules.may_touch(number, on_bed))
            .map(|number| self.balls.0[number].body.centre)
            .min_by(|a, b| from.distance(*a).total_cmp(&from.distance(*b)));
        self.aim.point(from, target.unwrap_or(DVec3::ZERO));
    }

    fn judge(&mut self) {
        let balls = &self.balls;
        self.rules.judge(&self.shot, |number| balls.on_bed(number));
        self.since = 0.0;
        if self.rules.winner().is_some() {
            self.phase = Phase::Over;
            return;
        }
        if !self.balls.on_bed(0) {
            self.balls.bring_back();
        }
        self.prepare();
    }

    fn steer(&mut self, input: &Input, seconds: f64) {
        let button = |button| input.pad().is_some_and(|pad| pad.pressed(button));
        if input.key_pressed(Key::C)
            || input.mouse_pressed(MouseButton::Middle)
            || button(Button::Triangle)
        {
            self.above = !self.above;
        }
        let over = self.phase == Phase::Over && input.key_pressed(Key::Enter);
        if over || input.key_pressed(Key::N) || button(Button::Start) {
            self.begin();
            return;
        }
        if self.phase == Phase::Aim && self.aim.steer(input, seconds) {
            self.phase = Phase::Blow(BLOW);
        }
    }

    fn step(&mut self) {
        match self.phase {
            Phase::Aim | Phase::Over => {}
            Phase::Blow(0) => {
                let (direction, speed) = (self.aim.direction(), self.aim.speed());
                self.balls.strike(direction, speed, self.aim.height());
                self.phase = Phase::Run;
            }
            Phase::Blow(left) => self.phase = Phase::Blow(left - 1),
            Phase::Run => {
                self.balls.step(&mut self.shot);
                if self.balls.are_at_rest() {
                    self.judge();
                }
            }
        }
    }

    /// The distance of the cue's tip from the cue ball, while the cue is visible.
    fn drawn(&self) -> Option<f64> {
        let drawn = DRAWN.0 + (DRAWN.1 - DRAWN.0) * self.aim.power();
        match self.phase {
            Phase::Aim => Some(drawn),
            // The cue accelerates.
            Phase::Blow(left) => {
                let part = f64::from(BLOW - left) / f64::from(BLOW);
                Some(drawn * (1.0 - part * part))
            }
            Phase::Run | Phase::Over => None,
        }
    }

    fn show(&mut self, world: &mut World, seconds: f64) -> Result<(), WorldError> {
        self.scene.show_balls(world, &self.balls)?;
        let aims = self.phase == Phase::Aim;
        self.scene.show_cue(world, &self.balls, &self.aim, self.drawn(), aims)?;
        let sign = match self.phase {
            Phase::Over => Sign::Won(self.since),
            _ if self.rules.was_foul() && self.since < FOUL => Sign::Foul,
            _ => Sign::Turn,
        };
        self.scene.show_marker(world, &self.rules, sign)?;
        let (eye, at) = self.view();
        let part = seconds * FOLLOWS / (1.0 + seconds * FOLLOWS);
        self.eye = follow(self.eye, eye, part);
        self.at = follow(self.at, at, part);
        world.look_from(self.eye, self.at)
    }

    /// The wanted position of the eye, and the point that it looks at.
    fn view(&self) -> (DVec3, DVec3) {
        let ball = self.balls.0[0].body.centre;
        match self.phase {
            _ if self.above => (DVec3::new(0.0, 2.7, 0.35), DVec3::new(0.0, 0.0, 0.03)),
            Phase::Aim | Phase::Blow(_) => {
                let direction = self.aim.direction();
                let eye = ball - direction * 1.05 + DVec3::Y * 0.44;
                (eye, ball + direction * 0.55)
            }
            Phase::Run | Phase::Over => {
                let side = if self.eye.x < 0.0 { -1.0 } else { 1.0 };
                (DVec3::new(side * 0.7, 1.12, 1.46), DVec3::new(0.0, -0.08, 0.06))
            }
        }
    }
}

impl Game for Billiards {
    fn name(&self) -> &str {
        NAME
    }

    fn controls(&self) -> &[&str] {
        CONTROLS
    }

    fn status(&self) -> String {
        status::of(&self.rules, |number| self.balls.on_bed(number))
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        self.chance = Xoshiro256PlusPlus::seed_from_u64(start.seed);
        self.begin();
        world.set_name(NAME);
        world.set_render_options(RenderOptions {
            model: Model::Whitted,
            ray_depth: 3,
            ..RenderOptions::default()
        });
        world.set_view(View { angle: 45.0, ..world.view().clone() })?;
        self.scene = Scene::add(world, &self.balls)?;
        (self.eye, self.at) = self.view();
        self.show(world, 0.0)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        self.since += frame.delta;
        self.steer(frame.input, frame.delta);
        for _ in 0..self.steps.of(frame.delta) {
            self.step();
        }
        self.show(world, frame.delta)
    }
}
