//! The devices that are there: which are read, and which pad is which player's.
//!
//! Looks for new ones about once a second. A node that can't be opened is tried again then, as its
//! permissions are often set a moment after it appears; that it can't is said once.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cellray::game::{InputEvent, PadId};

use super::capabilities::Capabilities;
use super::device::{Device, Devices, RawEvent};
use super::mapping::{self, Kind, Mapping};

/// Between two looks for new devices.
const LOOK_EVERY: Duration = Duration::from_secs(1);

/// Which devices are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeviceSet {
    /// Pads: keys and mouse are the display's.
    Pads,
    /// All.
    All,
}

/// Reads input devices, those that come later too.
pub struct InputDevices {
    devices: Box<dyn Devices>,
    wanted: DeviceSet,
    open: BTreeMap<PathBuf, Open>,
    /// Devices that are of no use, and which they are.
    useless: BTreeMap<PathBuf, PathBuf>,
    /// Those that can't be opened, and that was said.
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
    /// None is open until the first [`InputDevices::poll`].
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

    /// What people should be told since the last call.
    pub fn take_messages(&mut self) -> Vec<String> {
        std::mem::take(&mut self.messages)
    }

    /// Whether a keyboard is among them.
    #[must_use]
    pub fn has_keyboard(&self) -> bool {
        let mut all = self.open.values();
        all.any(|open| open.mapping.is_keyboard())
    }

    /// Appends what has happened since the last call.
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
            // Once is enough: it will be so in a second, too.
            Err(error) if self.refused.insert(PathBuf::new()) => {
                self.messages.push(format!("no input devices: {error}"));
                return;
            }
            Err(_) => return,
        };
        let there = |path: &PathBuf| paths.contains(path);
        self.useless.retain(|path, _| paths.contains(path));
        self.refused.retain(there);
        let gone: Vec<_> = self
            .open
            .keys()
            .filter(|path| !there(path))
            .cloned()
            .collect();
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
                // A node may be there before sysfs tells of it.
                Err(error) => self.refuse(&path, &error.to_string()),
                Ok((identity, found)) => match Kind::of(&found) {
                    None => {
                        self.useless.insert(path, identity);
                    }
                    Some(Kind::Desk) if self.wanted == DeviceSet::Pads => {
                        self.useless.insert(path, identity);
                    }
                    // Those belong to a pad, which has to be known first.
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
        let Capabilities {
            name,
            keys,
            absolute,
            ..
        } = found;
        let pad = match kind {
            Kind::Pad(_) => Some(self.free_pad()),
            Kind::Sensors => match self.pad_named(mapping::pad_of_sensors(&name)) {
                Some(pad) => Some(pad),
                // Its pad may come a moment later.
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
                    events.push(InputEvent::PadConnected {
                        pad,
                        name: name.clone(),
                    });
                    mapping.begin(events);
                }
                let open = Open {
                    device,
                    mapping,
                    name,
                };
                self.open.insert(path, open);
            }
        }
    }

    fn refuse(&mut self, path: &Path, why: &str) {
        if self.refused.insert(path.to_owned()) {
            self.messages
                .push(format!("{} is not used: {why}", path.display()));
        }
    }

    fn close(&mut self, path: &Path, why: &str, events: &mut Vec<InputEvent>) {
        let Some(open) = self.open.remove(path) else {
            return;
        };
        match (open.mapping.kind(), open.mapping.pad()) {
            (Kind::Pad(_), Some(pad)) => {
                events.push(InputEvent::PadDisconnected { pad });
                self.messages
                    .push(format!("pad {} ({}) is gone: {why}", pad.0 + 1, open.name));
            }
            // A pad's sensors go with it.
            (Kind::Sensors, _) => {}
            _ => {
                // What was held on it will never be released.
                events.push(InputEvent::FocusLost);
                self.messages.push(format!("{} is gone: {why}", open.name));
            }
        }
    }

    /// The lowest number that no pad has: who plugs a pad in again is the same player.
    fn free_pad(&self) -> PadId {
        let taken: BTreeSet<_> = self.pads().map(|(pad, _)| pad).collect();
        let mut all = (0..).map(PadId);
        all.find(|pad| !taken.contains(pad)).unwrap_or_default()
    }

    /// The first pad of this name whose sensors are not known yet.
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
