//! Merges the moves of one frame into one of each kind.
//!
//! Invariant: merging does not change the input that a game sees. A mouse or a pad's sensors may
//! send a thousand events a second; merged, the events of a long frame still fit the line of a
//! recording.

use crate::game::InputEvent;

/// Merges moves of the same device: the last position stays, and distances are added up. No move
/// is merged across a press, a release or any other event that isn't a move.
pub(super) fn merge(events: &mut Vec<InputEvent>) {
    // The first `kept` events stay. The moves since the last of them that isn't one begin at `run`.
    let (mut kept, mut run) = (0, 0);
    for next in 0..events.len() {
        let (before, rest) = events.split_at_mut(next);
        let event = &rest[0];
        if before[run..kept].iter_mut().any(|move_| add(move_, event)) {
            continue;
        }
        if !is_move(event) {
            run = kept + 1;
        }
        events.swap(kept, next);
        kept += 1;
    }
    events.truncate(kept);
}

fn is_move(event: &InputEvent) -> bool {
    matches!(
        event,
        InputEvent::MouseMoved { .. }
            | InputEvent::MouseMotion { .. }
            | InputEvent::Wheel { .. }
            | InputEvent::PadAxis { .. }
            | InputEvent::PadSensors { .. }
    )
}

/// Merges the second move into the first; `false` if they can't be merged.
fn add(first: &mut InputEvent, next: &InputEvent) -> bool {
    match (&mut *first, next) {
        (InputEvent::MouseMotion { by }, InputEvent::MouseMotion { by: more })
        | (InputEvent::Wheel { by }, InputEvent::Wheel { by: more }) => {
            let sum = [by[0] + more[0], by[1] + more[1]];
            let is_finite = sum.iter().all(|way| way.is_finite());
            if is_finite {
                *by = sum;
            }
            is_finite
        }
        (InputEvent::MouseMoved { to }, InputEvent::MouseMoved { to: last }) => {
            *to = *last;
            true
        }
        (
            InputEvent::PadAxis { pad, axis, value },
            InputEvent::PadAxis { pad: same, axis: way, value: last },
        ) if (&*pad, &*axis) == (same, way) && last.is_finite() => {
            *value = *last;
            true
        }
        (
            InputEvent::PadSensors { pad, sensors },
            InputEvent::PadSensors { pad: same, sensors: last },
        ) if pad == same && last.is_finite() => {
            *sensors = *last;
            true
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{Axis, Input, Key, PadId, Sensors};

    fn moves(number: u32) -> Vec<InputEvent> {
        let at = number as f32;
        let pad = PadId(number % 2);
        vec![
            InputEvent::MouseMoved { to: [at, 2.0 * at] },
            InputEvent::MouseMotion { by: [1.0, -2.0] },
            InputEvent::Wheel { by: [0.0, 0.5] },
            InputEvent::PadAxis { pad, axis: Axis::LeftX, value: at / 100_000.0 },
            InputEvent::PadSensors { pad, sensors: Sensors { acceleration: [at; 3], turn: at } },
        ]
    }

    fn state(events: &[InputEvent]) -> Input {
        let mut input = Input::default();
        input.begin_frame();
        for pad in 0..2 {
            input.apply(&InputEvent::PadConnected { pad: PadId(pad), name: "a pad".into() });
        }
        events.iter().for_each(|event| input.apply(event));
        input
    }

    #[test]
    fn merged_moves_give_same_input() {
        let key = |down| InputEvent::Key { key: Key::A, down };
        let mut events: Vec<_> = (0..20_000).flat_map(moves).collect();
        events.extend([key(true), InputEvent::FocusLost, key(true), key(false)]);
        events.extend((7..3_000).flat_map(moves));
        events.push(InputEvent::MouseLeft);
        let (before, expected) = (events.len(), state(&events));
        merge(&mut events);
        assert!(before > 100_000 && events.len() == 7 + 4 + 7 + 1, "{events:?}");
        assert_eq!(state(&events), expected);
        let merged = events.clone();
        merge(&mut events);
        assert_eq!(events, merged);
    }

    #[test]
    fn infinite_and_nan_events_are_ignored() {
        let axis = |value| InputEvent::PadAxis { pad: PadId(0), axis: Axis::R2, value };
        let by = |x: f32| InputEvent::MouseMotion { by: [x, 0.0] };
        let mut events = vec![axis(0.5), axis(f32::NAN), by(3.0), by(f32::INFINITY), by(4.0)];
        let expected = state(&events);
        merge(&mut events);
        assert_eq!(state(&events), expected);
    }
}
