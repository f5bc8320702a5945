//! The devices of this system, and the seam at which tests put others.

use std::fmt;
use std::fs::{self, OpenOptions};
use std::io;
use std::os::fd::AsRawFd as _;
use std::os::unix::fs::OpenOptionsExt as _;
use std::path::{Path, PathBuf};

use evdev::raw_stream::RawDevice;

use super::capabilities::{Capabilities, Codes};

/// An event as a device tells it, with the kernel's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RawEvent {
    /// Type, such as EV_KEY.
    pub kind: u16,
    /// Code, such as KEY_A.
    pub code: u16,
    /// Value.
    pub value: i32,
}

/// Where an axis can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// Where it is now.
    pub value: i32,
    /// Least value.
    pub least: i32,
    /// Largest value.
    pub most: i32,
    /// Distance from the middle that still is the middle.
    pub flat: i32,
    /// Units in one g or one degree a second, for sensors; 0 where nothing is said.
    pub resolution: i32,
}

/// An open device.
pub trait Device {
    /// Where an axis is, and can be.
    fn range(&self, axis: u16) -> io::Result<Range>;

    /// The keys and buttons that are down now.
    fn held(&self) -> io::Result<Codes>;

    /// Appends the events that have come since the last call; none is no error, a vanished device
    /// is one.
    fn read(&mut self, events: &mut Vec<RawEvent>) -> io::Result<()>;
}

/// Devices that come and go.
pub trait Devices {
    /// The devices that are there, in a lasting order.
    fn list(&mut self) -> io::Result<Vec<PathBuf>>;

    /// What tells the device at a path from another that comes there later.
    fn identity(&mut self, path: &Path) -> io::Result<PathBuf>;

    /// What a device can tell of.
    fn capabilities(&mut self, path: &Path) -> io::Result<Capabilities>;

    /// Opens a device.
    fn open(&mut self, path: &Path) -> io::Result<Box<dyn Device>>;
}

/// Those of the system.
#[derive(Clone, Copy, Debug, Default)]
pub struct SystemDevices;

const DEVICES: &str = "/dev/input";
const CLASSES: &str = "/sys/class/input";

impl Devices for SystemDevices {
    fn list(&mut self) -> io::Result<Vec<PathBuf>> {
        let entries = match fs::read_dir(DEVICES) {
            Ok(entries) => entries,
            // Without any device there is no folder.
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
            Err(error) => return Err(error),
        };
        let mut found = Vec::new();
        for entry in entries {
            let name = entry?.file_name();
            let number = name.to_str().and_then(|name| name.strip_prefix("event"));
            if let Some(number) = number.and_then(|number| number.parse::<u32>().ok()) {
                found.push((number, Path::new(DEVICES).join(&name)));
            }
        }
        found.sort_unstable();
        Ok(found.into_iter().map(|(_, path)| path).collect())
    }

    fn identity(&mut self, path: &Path) -> io::Result<PathBuf> {
        // Its target has the kernel's number of the device, which no other ever gets.
        fs::read_link(Path::new(CLASSES).join(path.file_name().unwrap_or_default()))
    }

    fn capabilities(&mut self, path: &Path) -> io::Result<Capabilities> {
        let name = path.file_name().unwrap_or_default();
        Capabilities::read(&Path::new(CLASSES).join(name).join("device"))
    }

    fn open(&mut self, path: &Path) -> io::Result<Box<dyn Device>> {
        let file = OpenOptions::new()
            .read(true)
            .custom_flags(libc::O_NONBLOCK)
            .open(path)?;
        Ok(Box::new(EventDevice(RawDevice::from_fd(file.into())?)))
    }
}

struct EventDevice(RawDevice);

impl fmt::Debug for EventDevice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("EventDevice").field(&self.0.name()).finish()
    }
}

impl Device for EventDevice {
    fn range(&self, axis: u16) -> io::Result<Range> {
        /// Number of EVIOCGABS(0).
        const ABSOLUTE: u32 = 0x40;
        let request =
            libc::_IOR::<libc::input_absinfo>(u32::from(b'E'), ABSOLUTE + u32::from(axis));
        let mut info = libc::input_absinfo {
            value: 0,
            minimum: 0,
            maximum: 0,
            fuzz: 0,
            flat: 0,
            resolution: 0,
        };
        // SAFETY: the descriptor is open as long as the device is; EVIOCGABS writes one
        // input_absinfo.
        if unsafe { libc::ioctl(self.0.as_raw_fd(), request, &raw mut info) } < 0 {
            return Err(io::Error::last_os_error());
        }
        Ok(Range {
            value: info.value,
            least: info.minimum,
            most: info.maximum,
            flat: info.flat,
            resolution: info.resolution,
        })
    }

    fn held(&self) -> io::Result<Codes> {
        /// Number of EVIOCGKEY.
        const KEYS: u32 = 0x18;
        /// KEY_CNT.
        const COUNT: u16 = 0x300;
        // The kernel's long words, whatever their bytes' order: no crate takes them for that.
        const BITS: u16 = libc::c_ulong::BITS as u16;
        type Words = [libc::c_ulong; (COUNT / BITS) as usize];
        let mut words = Words::default();
        let request = libc::_IOR::<Words>(u32::from(b'E'), KEYS);
        // SAFETY: the descriptor is open as long as the device is; EVIOCGKEY writes as many bytes
        // as it is told.
        if unsafe { libc::ioctl(self.0.as_raw_fd(), request, words.as_mut_ptr()) } < 0 {
            return Err(io::Error::last_os_error());
        }
        let is_down = |code: &u16| words[usize::from(code / BITS)] >> (code % BITS) & 1 == 1;
        Ok((0..COUNT).filter(is_down).collect())
    }

    fn read(&mut self, events: &mut Vec<RawEvent>) -> io::Result<()> {
        loop {
            match self.0.fetch_events() {
                Ok(fetched) => {
                    let before = events.len();
                    events.extend(fetched.map(|event| RawEvent {
                        kind: event.event_type().0,
                        code: event.code(),
                        value: event.value(),
                    }));
                    if events.len() == before {
                        return Ok(());
                    }
                }
                Err(error) if error.kind() == io::ErrorKind::WouldBlock => return Ok(()),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
    }
}
