//! A simulated player of eight-ball who sees the table and uses the mouse.

use cellray::game::{DVec3, InputEvent, MouseButton};
use games::billiards::Billiards;
use games::billiards::table::{POCKETS, RADIUS};

/// The radians and the power for a pixel of mouse movement in the game.
const TURN: f64 = 0.002;
const POWER: f64 = 0.004;

/// Sees the game after every frame, and acts in the next one.
#[derive(Default)]
pub struct Player {
    /// The events of the next frames. The next one is last.
    to_do: Vec<Vec<InputEvent>>,
}

impl Player {
    /// Returns the events of the next frame.
    pub fn next(&mut self) -> Vec<InputEvent> {
        self.to_do.pop().unwrap_or_default()
    }

    /// Looks at the table, and plans a shot when it is time for one.
    pub fn look(&mut self, game: &Billiards) {
        if !game.waits() || !self.to_do.is_empty() {
            return;
        }
        let (to, power) = best(game);
        let from = game.balls()[0].body.centre;
        let now = game.aim().direction();
        let wanted = (to - from).normalize();
        let turn =
            libm::atan2(now.x * wanted.z - now.z * wanted.x, now.x * wanted.x + now.z * wanted.z);
        let button = MouseButton::Left;
        let motion =
            |across: f64, back: f64| InputEvent::MouseMotion { by: [across as f32, back as f32] };
        self.to_do = vec![
            vec![InputEvent::MouseButton { button, down: false }],
            vec![InputEvent::MouseButton { button, down: true }, motion(0.0, power / POWER)],
            vec![motion(turn / TURN, 0.0)],
        ];
    }
}

/// The direction and power of the best shot.
fn best(game: &Billiards) -> (DVec3, f64) {
    let balls = game.balls();
    let cue = balls[0].body.centre;
    let on_bed = |number: usize| game.table().on_bed(number);
    let mine = |number: usize| on_bed(number) && game.rules().may_touch(number, on_bed);
    // A complete rack is broken.
    if (0..balls.len()).all(on_bed) && balls[1..].iter().all(|ball| ball.body.centre.x > 0.5) {
        return (DVec3::new(0.635, cue.y, 0.0), 1.0);
    }
    // Whether a ball can run from one place to another without touching any other than these two.
    let is_free = |from: DVec3, to: DVec3, but: usize| {
        let way = to - from;
        balls[1..].iter().all(|ball| {
            let part = (ball.body.centre - from).dot(way) / way.length_squared();
            let near = from + way * part.clamp(0.0, 1.0);
            ball.number == but
                || !on_bed(ball.number)
                || near.distance(ball.body.centre) > 2.0 * RADIUS
        })
    };
    let mut best: Option<(f64, DVec3, f64)> = None;
    for number in (1..balls.len()).filter(|&number| mine(number)) {
        let ball = balls[number].body.centre;
        for pocket in POCKETS {
            let into = DVec3::new(pocket.centre.x, ball.y, pocket.centre.z);
            let way = (into - ball).normalize();
            let ghost = ball - way * (2.0 * RADIUS);
            let cut = (ghost - cue).normalize().dot(way);
            let length = cue.distance(ghost) + ball.distance(into);
            // Side pockets do not catch balls that run along the cushion.
            let steep = pocket.centre.x != 0.0 || way.z.abs() > 0.6;
            let worth = cut * cut / (0.3 + length);
            if cut > 0.25
                && steep
                && is_free(cue, ghost, number)
                && is_free(ball, into, number)
                && best.is_none_or(|(known, ..)| worth > known)
            {
                let power = (0.22 + 0.13 * length / cut).min(0.9);
                best = Some((worth, ghost, power));
            }
        }
    }
    let nearest = || {
        (1..balls.len())
            .filter(|&number| mine(number))
            .map(|number| balls[number].body.centre)
            .min_by(|a, b| cue.distance(*a).total_cmp(&cue.distance(*b)))
    };
    match best {
        Some((_, ghost, power)) => (ghost, power),
        None => (nearest().unwrap_or(DVec3::ZERO), 0.5),
    }
}
