//! Finds and reads the connected devices, and assigns pads to players.
//!
//! Searches for new devices about once a second. A node that can't be opened is tried again then,
//! because its permissions are often set a moment after it appears. The failure is reported once.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cellray::game::{InputEvent, PadId};

use super::capabilities::Capabilities;
use super::device::{Device, Devices, RawEvent};
use super::mapping::{self, Kind, Mapping};

/// The time between two searches for new devices.
const LOOK_EVERY: Duration = Duration::from_secs(1);

/// The set of devices to read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeviceSet {
    /// Only pads, because the display reports keys and mouse.
    Pads,
    /// All devices.
    All,
}

/// Reads input devices, including those that are connected later.
pub struct InputDevices {
    devices: Box<dyn Devices>,
    wanted: DeviceSet,
    open: BTreeMap<PathBuf, Open>,
    /// The devices that games can't use, with their identifiers.
    useless: BTreeMap<PathBuf, PathBuf>,
    /// The devices that can't be opened, after this was reported.
    refused: BTreeSet<PathBuf>,
    looked: Option<Instant>,
    raw: Vec<RawEvent>,
    messages: Vec<String>,
}

struct Open {
    device: Box<dyn Device>,
    mapping: Mapping,
    name: String,
}

impl InputDevices {
    /// Opens no device until the first [`InputDevices::poll`].
    #[must_use]
    pub fn new(devices: Box<dyn Devices>, wanted: DeviceSet) -> Self {
        Self {
            devices,
            wanted,
            open: BTreeMap::new(),
            useless: BTreeMap::new(),
            refused: BTreeSet::new(),
            looked: None,
            raw: Vec::new(),
            messages: Vec::new(),
        }
    }

    /// Takes the messages for the user since the last call.
    pub fn take_messages(&mut self) -> Vec<String> {
        std::mem::take(&mut self.messages)
    }

    /// Whether a keyboard is open.
    #[must_use]
    pub fn has_keyboard(&self) -> bool {
        let mut all = self.open.values();
        all.any(|open| open.mapping.is_keyboard())
    }

    /// Appends the events since the last call.
    pub fn poll(&mut self, now: Instant, events: &mut Vec<InputEvent>) {
        let is_due = |looked| now.saturating_duration_since(looked) >= LOOK_EVERY;
        if self.looked.is_none_or(is_due) {
            self.looked = Some(now);
            self.scan(events);
        }
        let mut gone = Vec::new();
        for (path, open) in &mut self.open {
            self.raw.clear();
            let read = open.device.read(&mut self.raw);
            for &event in &self.raw {
                open.mapping.translate(event, events);
            }
            let read = read.and_then(|()| open.mapping.catch_up(open.device.as_ref(), events));
            if let Err(error) = read {
                gone.push((path.clone(), error));
            }
        }
        for (path, error) in gone {
            self.close(&path, &error.to_string(), events);
        }
    }

    fn scan(&mut self, events: &mut Vec<InputEvent>) {
        let paths = match self.devices.list() {
            Ok(paths) => paths,
            // Reported once, because it would be the same every second.
            Err(error) if self.refused.insert(PathBuf::new()) => {
                self.messages.push(format!("no input devices: {error}"));
                return;
            }
            Err(_) => return,
        };
        let there = |path: &PathBuf| paths.contains(path);
        self.useless.retain(|path, _| paths.contains(path));
        self.refused.retain(there);
        let gone: Vec<_> = self.open.keys().filter(|path| !there(path)).cloned().collect();
        for path in gone {
            self.close(&path, "it is no longer there", events);
        }
        let (mut later, mut sensors) = (Vec::new(), Vec::new());
        for path in paths {
            if self.open.contains_key(&path) {
                continue;
            }
            let found = match self.devices.identity(&path) {
                Ok(identity) if self.useless.get(&path) == Some(&identity) => continue,
                Ok(identity) => {
                    let found = self.devices.capabilities(&path);
                    found.map(|found| (identity, found))
                }
                Err(error) => Err(error),
            };
            match found {
                // A node may appear before its entry in sysfs.
                Err(error) => self.refuse(&path, &error.to_string()),
                Ok((identity, found)) => match Kind::of(&found) {
                    None => {
                        self.useless.insert(path, identity);
                    }
                    Some(Kind::Desk) if self.wanted == DeviceSet::Pads => {
                        self.useless.insert(path, identity);
                    }
                    // Sensors belong to a pad, which must be known first.
                    Some(Kind::Sensors) => sensors.push((path, Kind::Sensors, found)),
                    Some(kind) => later.push((path, kind, found)),
                },
            }
        }
        later.append(&mut sensors);
        for (path, kind, found) in later {
            self.connect(path, kind, found, events);
        }
    }

    fn connect(
        &mut self,
        path: PathBuf,
        kind: Kind,
        found: Capabilities,
        events: &mut Vec<InputEvent>,
    ) {
        let Capabilities { name, keys, absolute, .. } = found;
        let pad = match kind {
            Kind::Pad(_) => Some(self.free_pad()),
            Kind::Sensors => match self.pad_named(mapping::pad_of_sensors(&name)) {
                Some(pad) => Some(pad),
                // Its pad may appear a moment later.
                None => return,
            },
            Kind::Desk => None,
        };
        let opened = self.devices.open(&path).and_then(|device| {
            let ranges = absolute.iter().map(|axis| Ok((axis, device.range(axis)?)));
            let ranges: std::io::Result<_> = ranges.collect();
            Ok((device, ranges?))
        });
        match opened {
            Err(error) => self.refuse(&path, &error.to_string()),
            Ok((device, ranges)) => {
                let mapping = Mapping::new(kind, pad, keys, ranges);
                self.refused.remove(&path);
                if let (Kind::Pad(_), Some(pad)) = (kind, pad) {
                    self.messages.push(format!("pad {}: {name}", pad.0 + 1));
                    events.push(InputEvent::PadConnected { pad, name: name.clone() });
                    mapping.begin(events);
                }
                let open = Open { device, mapping, name };
                self.open.insert(path, open);
            }
        }
    }

    fn refuse(&mut self, path: &Path, why: &str) {
        if self.refused.insert(path.to_owned()) {
            self.messages.push(format!("{} is not used: {why}", path.display()));
        }
    }

    fn close(&mut self, path: &Path, why: &str, events: &mut Vec<InputEvent>) {
        let Some(open) = self.open.remove(path) else {
            return;
        };
        match (open.mapping.kind(), open.mapping.pad()) {
            (Kind::Pad(_), Some(pad)) => {
                events.push(InputEvent::PadDisconnected { pad });
                self.messages.push(format!("pad {} ({}) is gone: {why}", pad.0 + 1, open.name));
            }
            // A pad's sensors vanish with it.
            (Kind::Sensors, _) => {}
            _ => {
                // Its held keys would never be released.
                events.push(InputEvent::FocusLost);
                self.messages.push(format!("{} is gone: {why}", open.name));
            }
        }
    }

    /// The lowest free number, so that a player who plugs a pad in again keeps the number.
    fn free_pad(&self) -> PadId {
        let taken: BTreeSet<_> = self.pads().map(|(pad, _)| pad).collect();
        let mut all = (0..).map(PadId);
        all.find(|pad| !taken.contains(pad)).unwrap_or_default()
    }

    /// The first pad with this name that has no sensors yet.
    fn pad_named(&self, name: &str) -> Option<PadId> {
        let mut named: Vec<_> = self.pads().filter(|(_, other)| *other == name).collect();
        named.sort_unstable();
        let sensed: BTreeSet<_> = self
            .open
            .values()
            .filter(|open| matches!(open.mapping.kind(), Kind::Sensors))
            .filter_map(|open| open.mapping.pad())
            .collect();
        let mut free = named.into_iter().map(|(pad, _)| pad);
        free.find(|pad| !sensed.contains(pad))
    }

    fn pads(&self) -> impl Iterator<Item = (PadId, &str)> {
        self.open.values().filter_map(|open| {
            let is_pad = matches!(open.mapping.kind(), Kind::Pad(_));
            let pad = open.mapping.pad().filter(|_| is_pad)?;
            Some((pad, open.name.as_str()))
        })
    }
}
