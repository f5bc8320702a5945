//! Recorded events of pads, keyboards and mice, and devices that come and go.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, VecDeque};
use std::io;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::time::{Duration, Instant};

use cellray::game::{Axis, Button, Input, InputEvent, Key, MouseButton, PadId};
use cellray_play::input::{
    Capabilities, Codes, Device, DeviceSet, Devices, InputDevices, Range, RawEvent,
};

const SYN: u16 = 0;
const KEY: u16 = 1;
const REL: u16 = 2;
const ABS: u16 = 3;

fn raw(kind: u16, code: u16, value: i32) -> RawEvent {
    RawEvent { kind, code, value }
}

fn report() -> RawEvent {
    raw(SYN, 0, 0)
}

fn device(name: &str, keys: &[u16], absolute: &[u16], relative: &[u16]) -> Capabilities {
    let codes = |codes: &[u16]| codes.iter().copied().collect::<Codes>();
    Capabilities {
        name: name.into(),
        keys: codes(keys),
        absolute: codes(absolute),
        relative: codes(relative),
    }
}

/// hid-sony since Linux 4.13.
fn new_sixaxis() -> Capabilities {
    let keys: Vec<_> = [0x130, 0x131, 0x133, 0x134]
        .into_iter()
        .chain(0x136..=0x13e)
        .chain(0x220..=0x223)
        .collect();
    device("Sony PLAYSTATION(R)3 Controller", &keys, &[0, 1, 2, 3, 4, 5], &[])
}

/// hid-sony up to Linux 4.12.
fn old_sixaxis() -> Capabilities {
    let keys: Vec<_> = (0x120..=0x12f).chain([0x2c0]).collect();
    device("Sony PLAYSTATION(R)3 Controller", &keys, &[0, 1, 2, 5], &[])
}

fn keyboard() -> Capabilities {
    device("A keyboard", &(1..=0x58).collect::<Vec<_>>(), &[], &[])
}

fn mouse() -> Capabilities {
    device("A mouse", &[0x110, 0x111, 0x112], &[], &[0, 1, 8])
}

#[derive(Clone, Default)]
struct Bench(Rc<RefCell<BTreeMap<PathBuf, Plugged>>>, Rc<Cell<usize>>);

struct Plugged {
    found: Capabilities,
    /// Another for each that is ever plugged in.
    number: usize,
    may_open: bool,
    said: Rc<RefCell<Said>>,
}

#[derive(Default)]
struct Said {
    events: VecDeque<RawEvent>,
    /// The held keys that the kernel reports on request, beside the events.
    held: Codes,
    axes: BTreeMap<u16, i32>,
    is_gone: bool,
}

impl Bench {
    fn plug(&self, name: &str, found: Capabilities) -> Rc<RefCell<Said>> {
        let said = Rc::new(RefCell::new(Said::default()));
        let number = self.1.get();
        self.1.set(number + 1);
        let plugged = Plugged { found, number, may_open: true, said: Rc::clone(&said) };
        self.0.borrow_mut().insert(name.into(), plugged);
        said
    }

    fn unplug(&self, name: &str) {
        let plugged = self.0.borrow_mut().remove(Path::new(name));
        plugged.expect("plugged in").said.borrow_mut().is_gone = true;
    }

    fn let_open(&self, name: &str, may_open: bool) {
        let mut devices = self.0.borrow_mut();
        devices.get_mut(Path::new(name)).expect("plugged in").may_open = may_open;
    }
}

impl Devices for Bench {
    fn list(&mut self) -> io::Result<Vec<PathBuf>> {
        Ok(self.0.borrow().keys().cloned().collect())
    }

    fn identity(&mut self, path: &Path) -> io::Result<PathBuf> {
        let devices = self.0.borrow();
        let plugged = devices.get(path).ok_or(io::ErrorKind::NotFound)?;
        Ok(format!("input{}", plugged.number).into())
    }

    fn capabilities(&mut self, path: &Path) -> io::Result<Capabilities> {
        let devices = self.0.borrow();
        let plugged = devices.get(path).ok_or(io::ErrorKind::NotFound)?;
        Ok(plugged.found.clone())
    }

    fn open(&mut self, path: &Path) -> io::Result<Box<dyn Device>> {
        let devices = self.0.borrow();
        let plugged = devices.get(path).ok_or(io::ErrorKind::NotFound)?;
        if !plugged.may_open {
            return Err(io::ErrorKind::PermissionDenied.into());
        }
        Ok(Box::new(Opened(Rc::clone(&plugged.said))))
    }
}

struct Opened(Rc<RefCell<Said>>);

impl Device for Opened {
    fn range(&self, axis: u16) -> io::Result<Range> {
        let sixaxis = Range { value: 128, min: 0, max: 255, flat: 15, resolution: 0 };
        let rest = if matches!(axis, 2 | 5) { 0 } else { 128 };
        let value = self.0.borrow().axes.get(&axis).copied();
        Ok(Range { value: value.unwrap_or(rest), ..sixaxis })
    }

    fn held(&self) -> io::Result<Codes> {
        Ok(self.0.borrow().held.clone())
    }

    fn read(&mut self, events: &mut Vec<RawEvent>) -> io::Result<()> {
        let mut said = self.0.borrow_mut();
        if said.is_gone {
            return Err(io::Error::from_raw_os_error(19));
        }
        events.extend(said.events.drain(..));
        Ok(())
    }
}

/// A hub, its input's state, and a clock.
struct Player {
    hub: InputDevices,
    input: Input,
    now: Instant,
    events: Vec<InputEvent>,
}

impl Player {
    fn new(bench: &Bench, wanted: DeviceSet) -> Self {
        Self {
            hub: InputDevices::new(Box::new(bench.clone()), wanted),
            input: Input::default(),
            now: Instant::now(),
            events: Vec::new(),
        }
    }

    /// A frame, so long after the last one.
    fn frame(&mut self, millis: u64) {
        self.now += Duration::from_millis(millis);
        self.events.clear();
        self.hub.poll(self.now, &mut self.events);
        self.input.begin_frame();
        for event in &self.events {
            self.input.apply(event);
        }
    }
}

#[test]
fn sixaxis_numberings_give_same_buttons() {
    let new = [
        (0x130, Button::Cross),
        (0x131, Button::Circle),
        (0x133, Button::Triangle),
        (0x134, Button::Square),
        (0x136, Button::L1),
        (0x137, Button::R1),
        (0x138, Button::L2),
        (0x139, Button::R2),
        (0x13a, Button::Select),
        (0x13b, Button::Start),
        (0x13c, Button::Ps),
        (0x13d, Button::L3),
        (0x13e, Button::R3),
        (0x220, Button::Up),
        (0x221, Button::Down),
        (0x222, Button::Left),
        (0x223, Button::Right),
    ];
    // Select, L3, R3, Start, Up, Right, Down, Left, L2, R2, L1, R1, Triangle, Circle, Cross,
    // Square from 0x120 on.
    let old = [
        (0x120, Button::Select),
        (0x121, Button::L3),
        (0x122, Button::R3),
        (0x123, Button::Start),
        (0x124, Button::Up),
        (0x125, Button::Right),
        (0x126, Button::Down),
        (0x127, Button::Left),
        (0x128, Button::L2),
        (0x129, Button::R2),
        (0x12a, Button::L1),
        (0x12b, Button::R1),
        (0x12c, Button::Triangle),
        (0x12d, Button::Circle),
        (0x12e, Button::Cross),
        (0x12f, Button::Square),
        (0x2c0, Button::Ps),
    ];
    for (found, codes) in [(new_sixaxis(), new), (old_sixaxis(), old)] {
        let bench = Bench::default();
        let said = bench.plug("event0", found);
        let mut player = Player::new(&bench, DeviceSet::All);
        player.frame(0);
        for (code, button) in codes {
            said.borrow_mut().events.extend([raw(KEY, code, 1), report()]);
            player.frame(20);
            let pad = player.input.pad().expect("a pad");
            let held: Vec<_> = Button::ALL.iter().filter(|&&button| pad.held(button)).collect();
            assert_eq!(held, [&button], "{code:#x}");
            said.borrow_mut().events.extend([raw(KEY, code, 0), report()]);
            player.frame(20);
            assert!(player.input.pad().expect("a pad").released(button));
            player.frame(20);
        }
    }
}

#[test]
fn sticks_and_triggers_use_full_range() {
    for (found, right) in [(new_sixaxis(), [3, 4]), (old_sixaxis(), [2, 5])] {
        let bench = Bench::default();
        let said = bench.plug("event0", found);
        let mut player = Player::new(&bench, DeviceSet::Pads);
        player.frame(0);
        let codes = [
            (0, Axis::LeftX),
            (1, Axis::LeftY),
            (right[0], Axis::RightX),
            (right[1], Axis::RightY),
        ];
        for (code, axis) in codes {
            for (value, expected) in [(0, -1.0), (255, 1.0), (128, 0.0), (120, 0.0), (136, 0.0)] {
                said.borrow_mut().events.extend([raw(ABS, code, value), report()]);
                player.frame(20);
                let pad = player.input.pad().expect("a pad");
                assert_eq!(pad.axis(axis), expected, "{axis:?} {value}");
            }
            said.borrow_mut().events.extend([raw(ABS, code, 200), report()]);
            player.frame(20);
            let value = player.input.pad().expect("a pad").axis(axis);
            assert!((0.4..0.6).contains(&value), "{axis:?} {value}");
        }
    }
    let bench = Bench::default();
    let said = bench.plug("event0", new_sixaxis());
    let mut player = Player::new(&bench, DeviceSet::Pads);
    player.frame(0);
    for (value, expected) in [(0, 0.0), (51, 0.2), (255, 1.0)] {
        said.borrow_mut().events.extend([raw(ABS, 2, value), report()]);
        player.frame(20);
        assert_eq!(player.input.pad().expect("a pad").axis(Axis::L2), expected);
    }
}

#[test]
fn other_pads_have_their_own_tables() {
    let south: Vec<_> = (0x130..=0x13e).collect();
    let joystick: Vec<_> = (0x120..=0x12b).collect();
    let cases = [
        (
            device("Microsoft X-Box 360 pad", &south, &[0, 1, 2, 3, 4, 5, 0x10, 0x11], &[]),
            0x133,
            Button::Square,
        ),
        (device("Some pad", &south, &[0, 1, 2, 5, 0x10, 0x11], &[]), 0x133, Button::Triangle),
        (device("USB Gamepad", &joystick, &[0, 1, 0x10, 0x11], &[]), 0x121, Button::Cross),
    ];
    for (found, code, button) in cases {
        let name = found.name.clone();
        let bench = Bench::default();
        let said = bench.plug("event0", found);
        let mut player = Player::new(&bench, DeviceSet::Pads);
        player.frame(0);
        said.borrow_mut().events.extend([
            raw(KEY, code, 1),
            raw(ABS, 0x10, -1),
            raw(ABS, 0x11, 1),
            report(),
        ]);
        player.frame(20);
        let pad = player.input.pad().expect("a pad");
        assert_eq!(pad.name(), name);
        for button in [button, Button::Left, Button::Down] {
            assert!(pad.held(button), "{name}: {button:?}");
        }
        assert!(!pad.held(Button::Right) && !pad.held(Button::Up), "{name}");
    }
}

#[test]
fn sensors_belong_to_their_pad() {
    let bench = Bench::default();
    // Numbered before the pad: the order of the nodes must not matter.
    let sensors = device("Sony PLAYSTATION(R)3 Controller Motion Sensors", &[], &[0, 1, 2], &[]);
    let said = bench.plug("event0", sensors);
    bench.plug("event1", new_sixaxis());
    let mut player = Player::new(&bench, DeviceSet::Pads);
    player.frame(0);
    assert_eq!(player.input.pads().len(), 1);
    let still = [raw(ABS, 0, 0), raw(ABS, 1, 113), raw(ABS, 2, -226), report()];
    said.borrow_mut().events.extend(still);
    player.frame(20);
    let sensors = player.input.pad().and_then(|pad| pad.sensors()).expect("sensors");
    assert_eq!(sensors.acceleration, [0.0, 1.0, -2.0]);
}

#[test]
fn keyboards_and_mice_are_read_on_request() {
    for wanted in [DeviceSet::All, DeviceSet::Pads] {
        let bench = Bench::default();
        let keys = bench.plug("event0", keyboard());
        let moved = bench.plug("event1", mouse());
        // A power button is of no use.
        bench.plug("event2", device("Power Button", &[116], &[], &[]));
        let mut player = Player::new(&bench, wanted);
        player.frame(0);
        // Held and repeated: one press.
        let held = [raw(KEY, 30, 1), report(), raw(KEY, 30, 2), report()];
        keys.borrow_mut().events.extend(held);
        let dragged = [
            raw(KEY, 0x110, 1),
            raw(REL, 0, 3),
            raw(REL, 1, -4),
            raw(REL, 0, 2),
            raw(REL, 8, 1),
            report(),
        ];
        moved.borrow_mut().events.extend(dragged);
        player.frame(20);
        let is_read = wanted == DeviceSet::All;
        assert_eq!(player.input.key_pressed(Key::A), is_read);
        assert_eq!(player.input.mouse_held(MouseButton::Left), is_read);
        if is_read {
            assert_eq!(player.input.mouse().motion, [5.0, -4.0]);
            assert_eq!(player.input.mouse().wheel, [0.0, 1.0]);
            let presses = |event: &&InputEvent| matches!(event, InputEvent::Key { down: true, .. });
            assert_eq!(player.events.iter().filter(presses).count(), 1);
        } else {
            assert!(player.events.is_empty(), "{:?}", player.events);
        }
        assert_eq!(player.hub.has_keyboard(), is_read);
        assert_eq!(player.hub.take_messages(), Vec::<String>::new());
    }
}

#[test]
fn reconnected_pads_keep_their_players() {
    let bench = Bench::default();
    let mut player = Player::new(&bench, DeviceSet::Pads);
    player.frame(0);
    assert!(player.input.pads().is_empty());
    bench.plug("event0", new_sixaxis());
    bench.plug("event1", old_sixaxis());
    // It is looked for once a second.
    player.frame(500);
    assert!(player.input.pads().is_empty());
    player.frame(600);
    let ids = |player: &Player| player.input.pads().iter().map(|pad| pad.id()).collect::<Vec<_>>();
    assert_eq!(ids(&player), [PadId(0), PadId(1)]);
    assert_eq!(player.hub.take_messages().len(), 2);

    bench.unplug("event0");
    player.frame(10);
    assert_eq!(ids(&player), [PadId(1)]);
    let messages = player.hub.take_messages();
    assert!(
        messages.len() == 1
            && messages[0].starts_with("pad 1 (Sony")
            && messages[0].contains("is gone"),
        "{messages:?}"
    );
    // Under another node, as the kernel does it.
    bench.plug("event7", new_sixaxis());
    player.frame(1100);
    assert_eq!(ids(&player), [PadId(0), PadId(1)]);
}

#[test]
fn unreadable_node_is_retried_and_reported_once() {
    let bench = Bench::default();
    bench.plug("event0", new_sixaxis());
    bench.let_open("event0", false);
    let mut player = Player::new(&bench, DeviceSet::Pads);
    for _ in 0..5 {
        player.frame(1100);
    }
    let messages = player.hub.take_messages();
    assert!(messages.len() == 1 && messages[0].contains("event0"), "{messages:?}");
    bench.let_open("event0", true);
    player.frame(1100);
    assert_eq!(player.input.pads().len(), 1);
}

#[test]
fn key_released_in_dropped_events_is_released() {
    let bench = Bench::default();
    let keys = bench.plug("event0", keyboard());
    let mut player = Player::new(&bench, DeviceSet::All);
    keys.borrow_mut().events.extend([raw(KEY, 30, 1), report()]);
    player.frame(0);
    assert!(player.input.key_held(Key::A));
    // SYN_DROPPED; what follows up to the report is to be passed over.
    let dropped = [raw(SYN, 3, 0), raw(KEY, 48, 1), report(), raw(KEY, 46, 1), report()];
    keys.borrow_mut().events.extend(dropped);
    keys.borrow_mut().held = [46].into_iter().collect();
    player.frame(20);
    player.frame(20);
    assert!(!player.input.key_held(Key::A) && !player.input.key_held(Key::B));
    assert!(player.input.key_held(Key::C));
}

#[test]
fn removed_keyboard_releases_keys() {
    let bench = Bench::default();
    let keys = bench.plug("event0", keyboard());
    let mut player = Player::new(&bench, DeviceSet::All);
    keys.borrow_mut().events.extend([raw(KEY, 30, 1), report()]);
    player.frame(0);
    bench.unplug("event0");
    player.frame(20);
    player.frame(20);
    assert!(!player.input.key_held(Key::A) && !player.hub.has_keyboard());
}

#[test]
fn key_held_across_dropped_events_stays_held() {
    let bench = Bench::default();
    let keys = bench.plug("event0", keyboard());
    let mut hat = new_sixaxis();
    hat.absolute = [0, 1, 2, 3, 4, 5, 0x10, 0x11].into_iter().collect();
    let pad = bench.plug("event1", hat);
    let mut player = Player::new(&bench, DeviceSet::All);
    player.frame(0);
    keys.borrow_mut().events.extend([raw(KEY, 30, 1), report()]);
    pad.borrow_mut().events.extend([
        raw(KEY, 0x130, 1),
        raw(KEY, 0x131, 1),
        raw(ABS, 0, 255),
        raw(ABS, 0x10, -1),
        report(),
    ]);
    player.frame(20);
    // While nobody read: Circle was released, Square pressed, the right stick moved, the rest is
    // as it was.
    {
        let mut pad = pad.borrow_mut();
        pad.events.extend([raw(SYN, 3, 0), raw(ABS, 1, 7), report()]);
        pad.held = [0x130, 0x134].into_iter().collect();
        pad.axes.extend([(0, 255), (3, 0), (0x10, -1), (0x11, 0)]);
    }
    player.frame(20);
    assert!(player.input.key_held(Key::A), "of another device");
    let state = player.input.pad().expect("a pad");
    assert!(state.released(Button::Circle) && state.pressed(Button::Square));
    assert!(state.held(Button::Cross) && !state.pressed(Button::Cross));
    assert!(state.held(Button::Left) && !state.pressed(Button::Left));
    let sticks = [Axis::LeftX, Axis::LeftY, Axis::RightX].map(|axis| state.axis(axis));
    assert_eq!(sticks, [1.0, 0.0, -1.0]);
    // It is asked once.
    pad.borrow_mut().held = Codes::default();
    player.frame(20);
    assert_eq!(player.events, []);
}

#[test]
fn mouse_is_not_a_keyboard() {
    let bench = Bench::default();
    bench.plug("event0", mouse());
    let mut player = Player::new(&bench, DeviceSet::All);
    player.frame(0);
    assert!(!player.hub.has_keyboard());
    bench.plug("event1", keyboard());
    player.frame(1100);
    assert!(player.hub.has_keyboard());
    bench.unplug("event1");
    player.frame(20);
    assert!(!player.hub.has_keyboard());
}

#[test]
fn pad_replacing_useless_device_is_found() {
    let bench = Bench::default();
    bench.plug("event0", device("Power Button", &[116], &[], &[]));
    bench.plug("event1", keyboard());
    let mut player = Player::new(&bench, DeviceSet::Pads);
    player.frame(0);
    player.frame(1100);
    assert!(player.input.pads().is_empty());
    // Within the second between two looks, under the same names.
    for name in ["event0", "event1"] {
        bench.unplug(name);
        bench.plug(name, new_sixaxis());
    }
    player.frame(1100);
    assert_eq!(player.input.pads().len(), 2);
}

#[test]
fn reconnected_pad_has_no_held_buttons() {
    let bench = Bench::default();
    let said = bench.plug("event0", new_sixaxis());
    let mut player = Player::new(&bench, DeviceSet::Pads);
    player.frame(0);
    said.borrow_mut().events.extend([raw(KEY, 0x130, 1), raw(ABS, 0, 255), report()]);
    player.frame(20);
    let pad = player.input.pad().expect("a pad");
    assert!(pad.held(Button::Cross) && pad.axis(Axis::LeftX) == 1.0);
    bench.unplug("event0");
    player.frame(20);
    assert_eq!(player.input.pad(), None);
    bench.plug("event7", new_sixaxis());
    player.frame(1100);
    let pad = player.input.pad().expect("a pad");
    assert!(!pad.held(Button::Cross) && pad.axis(Axis::LeftX) == 0.0);
}

#[test]
fn pads_are_recognised_by_capabilities() {
    // xpad's, whatever it calls them: no buttons for the triggers.
    let xpad: Vec<_> =
        [0x130, 0x131, 0x133, 0x134, 0x136, 0x137].into_iter().chain(0x13a..=0x13e).collect();
    let logitech = device("Logitech Gamepad F310", &xpad, &[0, 1, 2, 3, 4, 5, 0x10, 0x11], &[]);
    // Over Bluetooth; its report can hold all buttons.
    let bluetooth = device(
        "Xbox Wireless Controller",
        &(0x130..=0x13e).collect::<Vec<_>>(),
        &[0, 1, 2, 5, 9, 10, 0x10, 0x11],
        &[],
    );
    // (right stick, left trigger)
    for (found, stick, trigger) in [(logitech, [3, 4], 2), (bluetooth, [2, 5], 10)] {
        let name = found.name.clone();
        let bench = Bench::default();
        let said = bench.plug("event0", found);
        said.borrow_mut().axes.extend([(2, 128), (5, 128), (trigger, 0), (0x10, 0), (0x11, 0)]);
        let mut player = Player::new(&bench, DeviceSet::Pads);
        player.frame(0);
        said.borrow_mut().events.extend([
            raw(KEY, 0x133, 1),
            raw(ABS, stick[0], 255),
            raw(ABS, stick[1], 0),
            raw(ABS, trigger, 255),
            report(),
        ]);
        player.frame(20);
        let pad = player.input.pad().expect("a pad");
        assert!(pad.held(Button::Square) && !pad.held(Button::Triangle), "{name}");
        let sticks = [Axis::RightX, Axis::RightY].map(|axis| pad.axis(axis));
        assert_eq!(sticks, [1.0, -1.0], "{name}");
        assert!(pad.axis(Axis::L2) == 1.0 && pad.held(Button::L2), "{name}");
        assert!(pad.axis(Axis::R2) < 0.6, "{name}");
    }
    // A pad by place whose triggers are axes alone presses them, too.
    let keys: Vec<_> = (0x130..0x138).collect();
    let bench = Bench::default();
    let said = bench.plug("event0", device("Some pad", &keys, &[0, 1, 2, 3, 4, 5], &[]));
    let mut player = Player::new(&bench, DeviceSet::Pads);
    player.frame(0);
    said.borrow_mut().events.extend([raw(ABS, 5, 255), report()]);
    player.frame(20);
    assert!(player.input.pad().expect("a pad").held(Button::R2));
    // Many buttons don't make an old SIXAXIS of a joystick.
    let many: Vec<_> = (0x120..=0x12f).chain([0x2c0]).collect();
    let bench = Bench::default();
    let said = bench.plug("event0", device("Throttle", &many, &[0, 1], &[]));
    let mut player = Player::new(&bench, DeviceSet::Pads);
    player.frame(0);
    said.borrow_mut().events.extend([raw(KEY, 0x121, 1), report()]);
    player.frame(20);
    let pad = player.input.pad().expect("a pad");
    assert!(pad.held(Button::Cross) && !pad.held(Button::L3));
}
