//! Eight-ball with informal rules.
//!
//! The player who pockets the first ball after the break gets its group, solids or stripes. A
//! player who pockets a ball of their own group continues. It is a foul to pocket the cue ball, to
//! touch no ball, or to touch a ball first that is not one's own. After a foul it is the other
//! player's turn, and a pocketed cue ball returns to the head spot. A player who pockets the eight
//! without a foul, in a shot after the last ball of their group, wins. A player who pockets it
//! earlier loses. On the break, pocketing it wins. The break is the first shot that touches a
//! ball.

/// The number of the eight ball, which decides the game.
pub const EIGHT: usize = 8;

/// The balls of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Numbers 1 to 7.
    Full,
    /// Numbers 9 to 15.
    Striped,
}

impl Group {
    /// The group of a ball. The cue ball and the eight have none.
    #[must_use]
    pub fn of(number: usize) -> Option<Self> {
        match number {
            1..=7 => Some(Self::Full),
            9..=15 => Some(Self::Striped),
            _ => None,
        }
    }

    fn other(self) -> Self {
        match self {
            Self::Full => Self::Striped,
            Self::Striped => Self::Full,
        }
    }

    /// The numbers of its balls.
    #[must_use]
    pub fn numbers(self) -> std::ops::RangeInclusive<usize> {
        match self {
            Self::Full => 1..=7,
            Self::Striped => 9..=15,
        }
    }
}

/// What happened between a shot and the moment when all balls are at rest.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shot {
    first_touched: Option<usize>,
    first_pocketed: Option<usize>,
    pocketed: u16,
}

impl Shot {
    /// Records that the cue ball touches a ball.
    pub fn touch(&mut self, number: usize) {
        self.first_touched.get_or_insert(number);
    }

    /// Records that a ball falls into a pocket.
    pub fn pocket(&mut self, number: usize) {
        self.pocketed |= 1 << number;
        if number != 0 {
            self.first_pocketed.get_or_insert(number);
        }
    }

    fn has(&self, number: usize) -> bool {
        self.pocketed >> number & 1 == 1
    }
}

/// The state of a game. The players are 0 and 1.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rules {
    turn: usize,
    /// The group of player 0.
    group: Option<Group>,
    broken: bool,
    foul: bool,
    winner: Option<usize>,
}

impl Rules {
    /// A new game in which this player breaks.
    #[must_use]
    pub fn new(turn: usize) -> Self {
        Self { turn, ..Self::default() }
    }

    /// The player whose turn it is.
    #[must_use]
    pub fn turn(&self) -> usize {
        self.turn
    }

    /// Whether the last shot was a foul.
    #[must_use]
    pub fn was_foul(&self) -> bool {
        self.foul
    }

    /// Whether a shot has touched a ball, so that the break is over.
    #[must_use]
    pub fn is_broken(&self) -> bool {
        self.broken
    }

    /// The player who has won.
    #[must_use]
    pub fn winner(&self) -> Option<usize> {
        self.winner
    }

    /// The group of a player, once it is known.
    #[must_use]
    pub fn group_of(&self, player: usize) -> Option<Group> {
        self.group.map(|first| match player {
            0 => first,
            _ => first.other(),
        })
    }

    /// The group of the player whose turn it is, once it is known.
    #[must_use]
    pub fn group(&self) -> Option<Group> {
        self.group_of(self.turn)
    }

    /// Whether the player at the table may touch this ball first. `on_bed` is whether a ball is on
    /// the bed.
    #[must_use]
    pub fn may_touch(&self, number: usize, on_bed: impl Fn(usize) -> bool) -> bool {
        match self.group() {
            None => number != EIGHT || !self.broken,
            Some(own) if own.numbers().any(on_bed) => Group::of(number) == Some(own),
            Some(_) => number == EIGHT,
        }
    }

    /// Judges a shot. `on_bed` is whether a ball is on the bed after it.
    pub fn judge(&mut self, shot: &Shot, on_bed: impl Fn(usize) -> bool) {
        let before = |number: usize| on_bed(number) || shot.has(number);
        let legal = shot.first_touched.is_some_and(|number| self.may_touch(number, before));
        self.foul = shot.has(0) || !legal;
        let broke = !self.broken;
        self.broken |= shot.first_touched.is_some();
        if shot.has(EIGHT) {
            let cleared = self.group().is_some_and(|own| !own.numbers().any(before));
            let won = !self.foul && (cleared || broke);
            self.winner = Some(if won { self.turn } else { 1 - self.turn });
            return;
        }
        if let (None, false, false, Some(group)) =
            (self.group, self.foul, broke, shot.first_pocketed.and_then(Group::of))
        {
            self.group = Some(if self.turn == 0 { group } else { group.other() });
        }
        let plays_on = match self.group() {
            None => shot.first_pocketed.is_some(),
            Some(own) => own.numbers().any(|number| shot.has(number)),
        };
        if self.foul || !plays_on {
            self.turn = 1 - self.turn;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{EIGHT, Group, Rules, Shot};

    fn shot(touched: Option<usize>, pocketed: &[usize]) -> Shot {
        let mut shot = Shot::default();
        touched.into_iter().for_each(|number| shot.touch(number));
        pocketed.iter().for_each(|&number| shot.pocket(number));
        shot
    }

    /// Plays shots one after another. Balls that were pocketed are off the bed.
    fn play(shots: &[Shot]) -> Rules {
        let mut rules = Rules::new(0);
        let mut gone = 0_u16;
        for shot in shots {
            gone |= shot.pocketed;
            rules.judge(shot, |number| gone >> number & 1 == 0);
        }
        rules
    }

    #[test]
    fn first_ball_after_break_assigns_group() {
        let rules = play(&[shot(Some(1), &[3]), shot(Some(9), &[12, 2])]);
        assert_eq!((rules.turn(), rules.group()), (0, Some(Group::Striped)));
        let rules = play(&[shot(Some(1), &[]), shot(Some(9), &[12])]);
        assert_eq!((rules.turn(), rules.group()), (1, Some(Group::Striped)));
        assert_eq!(play(&[shot(Some(1), &[3])]).group(), None);
    }

    #[test]
    fn fouls_change_the_turn() {
        for foul in [shot(None, &[]), shot(Some(2), &[0]), shot(Some(EIGHT), &[])] {
            let rules = play(&[shot(Some(1), &[3]), foul]);
            assert!(rules.was_foul());
            assert_eq!((rules.turn(), rules.winner()), (1, None));
        }
        // The other player's ball is touched first, and one's own is pocketed.
        let rules = play(&[shot(Some(1), &[]), shot(Some(9), &[12]), shot(Some(2), &[13])]);
        assert!(rules.was_foul());
        assert_eq!(rules.turn(), 0);
    }

    #[test]
    fn shot_without_pocketed_ball_changes_the_turn_without_a_foul() {
        let rules = play(&[shot(Some(1), &[])]);
        assert_eq!((rules.turn(), rules.was_foul()), (1, false));
    }

    #[test]
    fn pocketed_eight_ends_game() {
        let full = [1, 2, 3, 4, 5, 6, 7];
        let early = play(&[shot(Some(1), &[2]), shot(Some(EIGHT), &[EIGHT])]);
        assert_eq!(early.winner(), Some(1));
        let cleared = [shot(Some(1), &[]), shot(Some(9), &[]), shot(Some(1), &full)];
        let with = |last: Shot| play(&[&cleared[..], &[last]].concat()).winner();
        assert_eq!(with(shot(Some(EIGHT), &[EIGHT])), Some(0));
        assert_eq!(with(shot(Some(EIGHT), &[EIGHT, 0])), Some(1));
        assert_eq!(with(shot(Some(9), &[EIGHT])), Some(1));
        // The eight may not fall in the same shot as the last ball of the group, whichever of the
        // two falls first.
        let seven_left = [shot(Some(1), &[]), shot(Some(9), &[]), shot(Some(1), &full[..6])];
        for last in [&[EIGHT, 7], &[7, EIGHT]] {
            let rules = play(&[&seven_left[..], &[shot(Some(7), last)]].concat());
            assert_eq!(rules.winner(), Some(1), "{last:?}");
        }
        assert_eq!(play(&[shot(Some(1), &[EIGHT])]).winner(), Some(0));
        assert_eq!(play(&[shot(Some(1), &[EIGHT, 0])]).winner(), Some(1));
    }

    #[test]
    fn missed_rack_is_not_a_break() {
        let missed = shot(None, &[]);
        let rules = play(std::slice::from_ref(&missed));
        assert_eq!((rules.turn(), rules.was_foul()), (1, true));
        // The other player breaks then. A pocketed ball gives no group, and the eight wins.
        let rules = play(&[missed.clone(), shot(Some(1), &[3])]);
        assert_eq!((rules.turn(), rules.group()), (1, None));
        let rules = play(&[missed, shot(Some(1), &[EIGHT])]);
        assert_eq!(rules.winner(), Some(1));
    }

    #[test]
    fn groups_are_kept_when_turn_changes() {
        // Player 0 has the solids and loses by the eight, so the turn does not change.
        let rules = play(&[shot(Some(1), &[3]), shot(Some(1), &[2]), shot(Some(1), &[EIGHT])]);
        assert_eq!((rules.turn(), rules.winner()), (0, Some(1)));
        assert_eq!(rules.group(), Some(Group::Full));
        assert_eq!(rules.group_of(0), Some(Group::Full));
        assert_eq!(rules.group_of(1), Some(Group::Striped));
    }
}
