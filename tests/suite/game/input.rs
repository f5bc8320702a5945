//! The input state that results from events.

use cellray::game::{Axis, Button, Input, InputEvent, Key, MouseButton, PadId, Sensors};

fn after(events: &[InputEvent]) -> Input {
    let mut input = Input::default();
    next(&mut input, events);
    input
}

fn next(input: &mut Input, events: &[InputEvent]) {
    input.begin_frame();
    for event in events {
        input.apply(event);
    }
}

fn key(key: Key, down: bool) -> InputEvent {
    InputEvent::Key { key, down }
}

#[test]
fn every_key_is_pressed_held_and_released_alone() {
    for &one in Key::ALL {
        let mut input = after(&[key(one, true)]);
        for &other in Key::ALL {
            assert_eq!(input.key_pressed(other), other == one);
            assert_eq!(input.key_held(other), other == one);
        }
        next(&mut input, &[key(one, true)]);
        assert!(input.key_held(one) && !input.key_pressed(one), "a repeated event is not a press");
        next(&mut input, &[key(one, false)]);
        assert!(input.key_released(one) && !input.key_held(one));
        next(&mut input, &[key(one, false)]);
        assert!(!input.key_released(one));
        assert_eq!(input, Input::default());
    }
}

#[test]
fn short_press_is_not_lost() {
    let mut input = after(&[key(Key::Space, true), key(Key::Space, false)]);
    assert!(input.key_pressed(Key::Space) && input.key_held(Key::Space));
    assert!(input.key_released(Key::Space));
    next(&mut input, &[]);
    assert!(!input.key_held(Key::Space));
}

#[test]
fn two_keys_form_an_axis() {
    let axis = |events: &[InputEvent]| after(events).key_axis(Key::Left, Key::Right);
    assert_eq!(axis(&[]), 0.0);
    assert_eq!(axis(&[key(Key::Left, true)]), -1.0);
    assert_eq!(axis(&[key(Key::Right, true)]), 1.0);
    assert_eq!(axis(&[key(Key::Right, true), key(Key::Left, true)]), 0.0);
}

#[test]
fn mouse_moves_and_turns() {
    let mut input = after(&[
        InputEvent::MouseMoved { to: [3.5, 4.0] },
        InputEvent::MouseMotion { by: [1.0, -2.0] },
        InputEvent::MouseMotion { by: [0.5, -1.0] },
        InputEvent::MouseMotion { by: [f32::NAN, f32::INFINITY] },
        InputEvent::Wheel { by: [0.0, 1.0] },
        InputEvent::MouseButton { button: MouseButton::Left, down: true },
    ]);
    assert_eq!(input.mouse().position, Some([3.5, 4.0]));
    assert_eq!(input.mouse().motion, [1.5, -3.0]);
    assert_eq!(input.mouse().wheel, [0.0, 1.0]);
    assert!(input.mouse_pressed(MouseButton::Left));
    next(&mut input, &[InputEvent::MouseLeft]);
    assert_eq!(input.mouse().position, None);
    assert_eq!((input.mouse().motion, input.mouse().wheel), ([0.0; 2], [0.0; 2]));
    assert!(input.mouse_held(MouseButton::Left) && !input.mouse_held(MouseButton::Right));
}

#[test]
fn pads_connect_and_disconnect() {
    let connected = |pad| InputEvent::PadConnected { pad: PadId(pad), name: format!("pad {pad}") };
    let button = |pad, down| InputEvent::PadButton { pad: PadId(pad), button: Button::Cross, down };
    let axis = |value| InputEvent::PadAxis { pad: PadId(1), axis: Axis::LeftX, value };
    // Events of a pad that is not connected are ignored.
    let mut input = after(&[button(0, true), axis(1.0)]);
    assert!(input.pad().is_none());
    next(&mut input, &[connected(1), connected(0), button(1, true), axis(7.0)]);
    let names: Vec<_> = input.pads().iter().map(|pad| pad.name()).collect();
    assert_eq!(names, ["pad 0", "pad 1"]);
    let [first, second] = input.pads() else {
        panic!("two pads");
    };
    assert!(!first.held(Button::Cross) && second.pressed(Button::Cross));
    assert_eq!((first.axis(Axis::LeftX), second.axis(Axis::LeftX)), (0.0, 1.0));
    assert_eq!(second.sensors(), None);
    let still = Sensors { acceleration: [0.0, 1.0, 0.0], turn: 0.0 };
    let sensors = |sensors| InputEvent::PadSensors { pad: PadId(1), sensors };
    let spoilt = Sensors { turn: f32::NAN, ..still };
    next(&mut input, &[axis(f32::NAN), sensors(still), sensors(spoilt)]);
    assert_eq!(input.pads()[1].axis(Axis::LeftX), 1.0);
    assert_eq!(input.pads()[1].sensors(), Some(still));
    let gone = InputEvent::PadDisconnected { pad: PadId(1) };
    next(&mut input, &[gone]);
    assert_eq!(input.pads().len(), 1);
    // A pad that is connected again starts in the initial state.
    next(&mut input, &[connected(1)]);
    assert!(!input.pads()[1].held(Button::Cross));
    assert_eq!(input.pads()[1].axis(Axis::LeftX), 0.0);
}

#[test]
fn losing_the_focus_releases_all_input() {
    let pad = PadId(0);
    let mut input = after(&[
        InputEvent::PadConnected { pad, name: "pad".into() },
        InputEvent::PadButton { pad, button: Button::R2, down: true },
        InputEvent::PadAxis { pad, axis: Axis::R2, value: 0.5 },
        key(Key::A, true),
    ]);
    assert!(!input.lost_focus());
    next(&mut input, &[InputEvent::FocusLost]);
    assert!(input.lost_focus());
    assert!(input.key_released(Key::A) && !input.key_held(Key::A));
    let pad = input.pad().unwrap();
    assert!(pad.released(Button::R2) && !pad.held(Button::R2));
    assert_eq!(pad.axis(Axis::R2), 0.0);
    next(&mut input, &[]);
    assert!(!input.lost_focus(), "it was lost once");
}
