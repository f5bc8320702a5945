//! The status of a game in words: whose turn it is, and how many balls each player has pocketed.

use super::rules::{Group, Rules};

/// The players, by the colours of the marker.
const PLAYERS: [&str; 2] = ["Yellow", "Blue"];

/// Two lines: the turn, and the score. `on_bed` is whether a ball is on the bed.
pub fn of(rules: &Rules, on_bed: impl Fn(usize) -> bool) -> String {
    format!("{}\n{}", turn(rules, &on_bed), score(rules, &on_bed))
}

fn turn(rules: &Rules, on_bed: &impl Fn(usize) -> bool) -> String {
    if let Some(winner) = rules.winner() {
        return format!("{} has won. N: a new game", PLAYERS[winner]);
    }
    let foul = if rules.was_foul() { "Foul. " } else { "" };
    let player = PLAYERS[rules.turn()];
    if !rules.is_broken() {
        return format!("{foul}{player} breaks");
    }
    let target = match rules.group() {
        None => "solids or stripes",
        Some(own) if own.numbers().any(on_bed) => name(own),
        Some(_) => "the eight",
    };
    format!("{foul}{player}'s turn: {target}")
}

fn score(rules: &Rules, on_bed: &impl Fn(usize) -> bool) -> String {
    let score = |player: usize| {
        let own = rules.group_of(player)?;
        let pocketed = own.numbers().filter(|&number| !on_bed(number)).count();
        Some(format!("{}: {pocketed} of 7 {}", PLAYERS[player], name(own)))
    };
    match (score(0), score(1)) {
        (Some(first), Some(second)) => format!("{first}   {second}"),
        _ => "Nobody has a group yet".to_owned(),
    }
}

fn name(group: Group) -> &'static str {
    match group {
        Group::Full => "solids",
        Group::Striped => "stripes",
    }
}

#[cfg(test)]
mod tests {
    use super::super::rules::{EIGHT, Rules, Shot};
    use super::of;

    /// The status after each of these shots: the ball that is touched first, and the pocketed ones.
    fn after(shots: &[(usize, &[usize])]) -> Vec<String> {
        let mut rules = Rules::new(0);
        let mut gone = Vec::new();
        let mut lines = vec![of(&rules, |_| true)];
        for &(touched, pocketed) in shots {
            let mut shot = Shot::default();
            shot.touch(touched);
            pocketed.iter().for_each(|&number| shot.pocket(number));
            gone.extend(pocketed);
            let on_bed = |number: usize| !gone.contains(&number);
            rules.judge(&shot, on_bed);
            lines.push(of(&rules, on_bed));
        }
        lines
    }

    #[test]
    fn status_describes_game_from_break_to_win() {
        let lines = after(&[
            (1, &[]),
            (9, &[9, 10]),
            (11, &[0]),
            (12, &[11]),
            (1, &[]),
            (12, &[12, 13, 14, 15]),
            (EIGHT, &[EIGHT]),
        ]);
        let expected = [
            "Yellow breaks\nNobody has a group yet",
            "Blue's turn: solids or stripes\nNobody has a group yet",
            "Blue's turn: stripes\nYellow: 0 of 7 solids   Blue: 2 of 7 stripes",
            "Foul. Yellow's turn: solids\nYellow: 0 of 7 solids   Blue: 2 of 7 stripes",
            // Yellow touches a stripe first, and what falls counts for Blue.
            "Foul. Blue's turn: stripes\nYellow: 0 of 7 solids   Blue: 3 of 7 stripes",
            "Foul. Yellow's turn: solids\nYellow: 0 of 7 solids   Blue: 3 of 7 stripes",
            "Foul. Blue's turn: the eight\nYellow: 0 of 7 solids   Blue: 7 of 7 stripes",
            "Blue has won. N: a new game\nYellow: 0 of 7 solids   Blue: 7 of 7 stripes",
        ];
        assert_eq!(lines, expected);
    }
}
