//! The player's side of a session: display, input devices, signals, and the keys that control the
//! session itself.
//!
//! Invariant: the keys of the session itself ([`KEYS`](crate::keys::KEYS)) never reach a game. All
//! other events do, once and in order, even those that arrive while a frame is traced. Events of
//! devices are dropped if the player was elsewhere: on another virtual terminal, or at the shell
//! while the program was stopped. While the session is paused, all but the coming and going of
//! devices is dropped.

use std::io;
use std::ops::ControlFlow;
use std::os::fd::AsFd as _;
use std::time::Instant;

use cellray::framebuffer::{Geometry, Interrupted};
use cellray::game::{Button, InputEvent, Key};
use image::RgbImage;
use signal_hook::consts::{SIGHUP, SIGINT};

use crate::display::{Display, DisplayEvent};
use crate::input::{Foreground, InputDevices, SystemForeground, is_of_console};
use crate::overlay::Overlay;

/// Why a session ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The game, the recording or the range of frames ended.
    Over,
    /// The player closed the display.
    Closed,
    /// The program received this signal.
    Signal(i32),
}

/// The player's requests to the session itself.
#[derive(Clone, Copy, Debug, Default)]
pub struct Requests {
    /// A request to end the session.
    pub ending: Option<Ending>,
    /// Whether the display has another size now.
    pub resized: bool,
    /// Whether to show less text, or all of it again.
    pub overlay: bool,
    /// Whether to show the keys, or hide them.
    pub help: bool,
    /// Whether to fill the screen, or no longer.
    pub full_screen: bool,
    /// Whether to take a picture.
    pub screenshot: bool,
}

/// The player's side of a session.
pub struct Frontend {
    pub display: Box<dyn Display>,
    devices: Option<InputDevices>,
    foreground: Box<dyn Foreground>,
    /// Whether the player was elsewhere just before or after the devices were last read.
    was_left: bool,
    /// Whether events of the devices are dropped.
    is_away: bool,
    /// A terminal that isn't the display. Its keys are used unless a keyboard device reports the
    /// same.
    keys: Option<Box<dyn Display>>,
    interrupted: Interrupted,
    display_events: Vec<DisplayEvent>,
    from_devices: Vec<InputEvent>,
    pending: Vec<InputEvent>,
    requests: Requests,
    is_paused: bool,
    failed: Option<io::Error>,
}

impl Frontend {
    /// A frontend with a display, and with devices and a terminal if they are to be read.
    ///
    /// # Errors
    /// Signals can't be caught.
    pub fn new(
        display: Box<dyn Display>,
        devices: Option<InputDevices>,
        keys: Option<Box<dyn Display>>,
        interrupted: Interrupted,
    ) -> io::Result<Self> {
        Ok(Self {
            display,
            devices,
            foreground: Box::new(SystemForeground::new()?),
            was_left: false,
            is_away: false,
            keys,
            interrupted,
            display_events: Vec::new(),
            from_devices: Vec::new(),
            pending: Vec::new(),
            requests: Requests::default(),
            is_paused: false,
            failed: None,
        })
    }

    /// Appends the player's input since the last call. [`ControlFlow::Break`] means that the
    /// session must end.
    ///
    /// # Errors
    /// The display fails.
    pub fn poll(&mut self, events: &mut Vec<InputEvent>) -> io::Result<ControlFlow<()>> {
        if let Some(error) = self.failed.take() {
            return Err(error);
        }
        self.gather()?;
        events.append(&mut self.pending);
        Ok(match self.requests.ending {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        })
    }

    /// Must be called from time to time while a frame is traced, so that a window keeps handling
    /// its system's events.
    pub fn tracing(&mut self) {
        // The next poll returns the error.
        if let Err(error) = self.gather() {
            self.failed = Some(error);
        }
    }

    /// Whether the player has paused the session.
    #[must_use]
    pub fn is_paused(&self) -> bool {
        self.is_paused
    }

    /// Shows an overlay over the last picture, or over black if there is none yet.
    pub fn show_overlay(&mut self, picture: Option<&RgbImage>, overlay: &Overlay) {
        if !self.display.draws() {
            return;
        }
        let black;
        let picture = match picture {
            Some(picture) => picture,
            None => {
                let Geometry { width, height } = self.display.area();
                black = RgbImage::new(width, height);
                &black
            }
        };
        if let Err(error) = self.display.show(picture, overlay) {
            self.failed = Some(error);
        }
    }

    /// Takes the player's requests since the last call. A request to end stays set.
    pub fn take_requests(&mut self) -> Requests {
        let requests = self.requests;
        self.requests = Requests { ending: requests.ending, ..Requests::default() };
        requests
    }

    /// Takes the messages about devices that came or went.
    pub fn take_messages(&mut self) -> Vec<String> {
        self.devices.as_mut().map_or_else(Vec::new, InputDevices::take_messages)
    }

    fn gather(&mut self) -> io::Result<()> {
        if let Some(signal) = self.interrupted.signal() {
            self.end(Ending::Signal(signal));
        }
        self.display.poll(&mut self.display_events)?;
        let mut has_keyboard = false;
        if let Some(devices) = &mut self.devices {
            devices.poll(Instant::now(), &mut self.from_devices);
            has_keyboard = devices.has_keyboard();
            self.drop_background_input();
        }
        if let Some(keys) = &mut self.keys {
            let before = self.display_events.len();
            keys.poll(&mut self.display_events)?;
            if has_keyboard && is_of_console(io::stdin().as_fd()) {
                // The keyboard device has reported the same keys.
                self.display_events.truncate(before);
            }
        }
        for event in std::mem::take(&mut self.display_events) {
            match event {
                DisplayEvent::Input(event) => self.take(event),
                DisplayEvent::Resized => self.requests.resized = true,
                DisplayEvent::Closed => self.end(Ending::Closed),
                DisplayEvent::Interrupted => self.end(Ending::Signal(SIGINT)),
                DisplayEvent::HungUp => self.end(Ending::Signal(SIGHUP)),
            }
        }
        for event in std::mem::take(&mut self.from_devices) {
            self.take(event);
        }
        Ok(())
    }

    /// Drops the devices' events if the player was elsewhere. Called after the devices were read.
    /// Keys that were typed elsewhere between the reading and this call are read next time, so an
    /// absence counts for the next reading too.
    fn drop_background_input(&mut self) {
        let is_left = self.foreground.was_left();
        let is_away = std::mem::replace(&mut self.was_left, is_left) || is_left;
        let was_away = std::mem::replace(&mut self.is_away, is_away);
        if is_away {
            self.from_devices.retain(is_of_presence);
            if !was_away {
                self.from_devices.push(InputEvent::FocusLost);
            }
        }
    }

    fn take(&mut self, event: InputEvent) {
        match event {
            InputEvent::Key { key, down } => match key {
                // A release may belong to a press in another window.
                Key::Escape | Key::Q => {
                    if down {
                        self.end(Ending::Closed);
                    }
                }
                Key::F1 => self.requests.overlay ^= down,
                Key::H => self.requests.help ^= down,
                Key::P => {
                    if down {
                        self.pause();
                    }
                }
                Key::F11 => self.requests.full_screen ^= down,
                Key::F12 => self.requests.screenshot |= down,
                _ => self.push(event),
            },
            InputEvent::PadButton { button: Button::Ps, down, .. } => {
                if down {
                    self.end(Ending::Closed);
                }
            }
            _ => self.push(event),
        }
    }

    fn push(&mut self, event: InputEvent) {
        if !self.is_paused || is_of_presence(&event) {
            self.pending.push(event);
        }
    }

    /// Pauses the session, or lets it go on. What is released during the pause is not reported, so
    /// everything counts as released when it begins.
    fn pause(&mut self) {
        if !self.is_paused {
            self.pending.push(InputEvent::FocusLost);
        }
        self.is_paused = !self.is_paused;
    }

    fn end(&mut self, ending: Ending) {
        self.requests.ending = self.requests.ending.or(Some(ending));
    }
}

/// Whether an event reports that a device came or went, and not an action of the player.
fn is_of_presence(event: &InputEvent) -> bool {
    matches!(event, InputEvent::PadConnected { .. } | InputEvent::PadDisconnected { .. })
}

#[cfg(test)]
mod tests {
    use super::*;
    use cellray::framebuffer::{Framebuffer, FramebufferError, Memory};
    use cellray::game::PadId;

    /// A display that reports one list of events at each call.
    struct Script(Vec<Vec<DisplayEvent>>);

    impl Display for Script {
        fn area(&self) -> Geometry {
            Geometry { width: 8, height: 8 }
        }

        fn scales(&self) -> bool {
            true
        }

        fn measure_in(&mut self, _size: Geometry) {}

        fn framebuffer(
            &mut self,
            size: Geometry,
        ) -> Result<Box<dyn Framebuffer>, FramebufferError> {
            Ok(Box::new(Memory::new(size)?))
        }

        fn poll(&mut self, display_events: &mut Vec<DisplayEvent>) -> io::Result<()> {
            if self.0.is_empty() {
                return Err(io::Error::other("the end of the script"));
            }
            display_events.append(&mut self.0.remove(0));
            Ok(())
        }

        fn draws(&self) -> bool {
            false
        }

        fn show(&mut self, _: &RgbImage, _: &Overlay) -> io::Result<()> {
            Ok(())
        }
    }

    fn key(key: Key, down: bool) -> DisplayEvent {
        DisplayEvent::Input(InputEvent::Key { key, down })
    }

    fn front(script: Vec<Vec<DisplayEvent>>) -> Frontend {
        let interrupted = Interrupted::install().expect("signals");
        Frontend::new(Box::new(Script(script)), None, None, interrupted).expect("signals")
    }

    /// Reports from a list whether the player was elsewhere.
    struct Looks(Vec<bool>);

    impl Foreground for Looks {
        fn was_left(&mut self) -> bool {
            self.0.remove(0)
        }
    }

    #[test]
    fn keys_typed_elsewhere_are_dropped() {
        let mut front = front(Vec::new());
        // Elsewhere and back between two calls, then for a longer time.
        let looks = [false, true, false, false, true, true, false, false];
        front.foreground = Box::new(Looks(looks.to_vec()));
        let typed = InputEvent::Key { key: Key::Q, down: true };
        let plugged = InputEvent::PadDisconnected { pad: PadId(3) };
        let received = (0..looks.len()).map(|_| {
            front.from_devices = vec![typed.clone(), plugged.clone()];
            front.drop_background_input();
            std::mem::take(&mut front.from_devices)
        });
        let all = vec![typed.clone(), plugged.clone()];
        let first_away = vec![plugged.clone(), InputEvent::FocusLost];
        let away = vec![plugged.clone()];
        assert_eq!(
            received.collect::<Vec<_>>(),
            [&all, &first_away, &away, &all, &first_away, &away, &away, &all].map(Vec::clone)
        );
    }

    #[test]
    fn released_key_does_not_end_session() {
        let mut front = front(vec![
            vec![key(Key::Escape, false), key(Key::Q, false)],
            vec![DisplayEvent::HungUp],
        ]);
        let mut events = Vec::new();
        assert!(front.poll(&mut events).expect("input").is_continue());
        assert_eq!(events, []);
        assert!(front.poll(&mut events).expect("input").is_break());
        let ending = front.take_requests().ending;
        assert_eq!(ending, Some(Ending::Signal(SIGHUP)));
    }

    #[test]
    fn input_during_a_frame_is_kept() {
        let script = (0..5).map(|_| vec![key(Key::A, true), key(Key::A, false)]);
        let mut front = front(script.collect());
        let mut events = Vec::new();
        assert!(front.poll(&mut events).expect("input").is_continue());
        assert_eq!(events.len(), 2);
        (0..3).for_each(|_| front.tracing());
        assert!(front.poll(&mut events).expect("input").is_continue());
        assert_eq!(events.len(), 10);
        // The display fails while a frame is traced. The next poll returns the error.
        front.tracing();
        assert!(front.poll(&mut events).is_err());
    }

    #[test]
    fn keys_pressed_in_a_pause_do_not_reach_the_game() {
        let mut front = front(vec![
            vec![
                key(Key::A, true),
                key(Key::P, true),
                key(Key::B, true),
                DisplayEvent::Input(InputEvent::PadDisconnected { pad: PadId(3) }),
            ],
            vec![key(Key::P, false), key(Key::A, false), key(Key::H, true)],
            vec![key(Key::P, true), key(Key::C, true)],
        ]);
        let mut events = Vec::new();
        let mut poll = || {
            assert!(front.poll(&mut events).expect("input").is_continue());
            front.is_paused()
        };
        assert_eq!([poll(), poll(), poll()], [true, true, false]);
        let requests = front.take_requests();
        assert!(requests.help && !requests.full_screen);
        let pressed = |key| InputEvent::Key { key, down: true };
        let expected = [
            pressed(Key::A),
            InputEvent::FocusLost,
            InputEvent::PadDisconnected { pad: PadId(3) },
            pressed(Key::C),
        ];
        assert_eq!(events, expected);
    }

    #[test]
    fn session_keys_do_not_reach_game() {
        let mut front = front(vec![
            vec![
                key(Key::F1, true),
                key(Key::F1, false),
                key(Key::F11, true),
                key(Key::F11, false),
                key(Key::B, true),
            ],
            vec![key(Key::F12, true), key(Key::F12, false), DisplayEvent::Resized],
            vec![key(Key::Q, true), DisplayEvent::Interrupted],
        ]);
        let mut events = Vec::new();
        let requests = |front: &mut Frontend, events: &mut Vec<InputEvent>| {
            let flow = front.poll(events).expect("input");
            let requests = front.take_requests();
            assert_eq!(flow.is_break(), requests.ending.is_some());
            (requests.overlay, requests.screenshot, requests.resized, requests.ending)
        };
        assert_eq!(requests(&mut front, &mut events), (true, false, false, None));
        assert_eq!(requests(&mut front, &mut events), (false, true, true, None));
        let closed = Some(Ending::Closed);
        assert_eq!(requests(&mut front, &mut events), (false, false, false, closed));
        let [InputEvent::Key { key: Key::B, down: true }] = events[..] else {
            panic!("{events:?}");
        };
    }
}
