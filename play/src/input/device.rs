//! The devices of this system, as traits, which tests implement with simulated devices.

use std::fmt;
use std::fs::{self, OpenOptions};
use std::io;
use std::os::fd::AsRawFd as _;
use std::os::unix::fs::OpenOptionsExt as _;
use std::path::{Path, PathBuf};

use evdev::raw_stream::RawDevice;

use super::capabilities::{Capabilities, Codes};

/// A device's event with the kernel's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RawEvent {
    /// Type, such as EV_KEY.
    pub kind: u16,
    /// Code, such as KEY_A.
    pub code: u16,
    /// Value.
    pub value: i32,
}

/// The value and the range of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// The current value.
    pub value: i32,
    /// The smallest value.
    pub min: i32,
    /// The largest value.
    pub max: i32,
    /// Values within this distance of the middle count as the middle.
    pub flat: i32,
    /// For sensors, the units in one g or in one degree a second; 0 if unknown.
    pub resolution: i32,
}

/// An open device.
pub trait Device {
    /// The value and the range of an axis.
    ///
    /// # Errors
    /// The device is gone, or has no such axis.
    fn range(&self, axis: u16) -> io::Result<Range>;

    /// The keys and buttons that are down now.
    ///
    /// # Errors
    /// The device is gone.
    fn held(&self) -> io::Result<Codes>;

    /// Appends the events since the last call, if there are any.
    ///
    /// # Errors
    /// The device is gone.
    fn read(&mut self, events: &mut Vec<RawEvent>) -> io::Result<()>;
}

/// A set of devices, which may come and go.
pub trait Devices {
    /// The paths of all devices, in a stable order.
    fn list(&mut self) -> io::Result<Vec<PathBuf>>;

    /// An identifier that distinguishes the device at a path from a later one at the same path.
    fn identity(&mut self, path: &Path) -> io::Result<PathBuf>;

    /// The capabilities of a device.
    fn capabilities(&mut self, path: &Path) -> io::Result<Capabilities>;

    /// Opens a device.
    fn open(&mut self, path: &Path) -> io::Result<Box<dyn Device>>;
}

/// The system's devices.
#[derive(Clone, Copy, Debug, Default)]
pub struct SystemDevices;

const DEVICES: &str = "/dev/input";
const CLASSES: &str = "/sys/class/input";

impl Devices for SystemDevices {
    fn list(&mut self) -> io::Result<Vec<PathBuf>> {
        let entries = match fs::read_dir(DEVICES) {
            Ok(entries) => entries,
            // The folder doesn't exist if there is no device.
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
        // The link's target has the kernel's number of the device, which is never reused.
        fs::read_link(Path::new(CLASSES).join(path.file_name().unwrap_or_default()))
    }

    fn capabilities(&mut self, path: &Path) -> io::Result<Capabilities> {
        let name = path.file_name().unwrap_or_default();
        Capabilities::read(&Path::new(CLASSES).join(name).join("device"))
    }

    fn open(&mut self, path: &Path) -> io::Result<Box<dyn Device>> {
        let file = OpenOptions::new().read(true).custom_flags(libc::O_NONBLOCK).open(path)?;
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
        // SAFETY: the descriptor is open as long as the device is, and EVIOCGABS writes one
        // input_absinfo.
        if unsafe { libc::ioctl(self.0.as_raw_fd(), request, &raw mut info) } < 0 {
            return Err(io::Error::last_os_error());
        }
        Ok(Range {
            value: info.value,
            min: info.minimum,
            max: info.maximum,
            flat: info.flat,
            resolution: info.resolution,
        })
    }

    fn held(&self) -> io::Result<Codes> {
        /// Number of EVIOCGKEY.
        const KEYS: u32 = 0x18;
        /// KEY_CNT.
        const COUNT: u16 = 0x300;
        // The kernel uses long words in native byte order, which crates don't take into account.
        const BITS: u16 = libc::c_ulong::BITS as u16;
        type Words = [libc::c_ulong; (COUNT / BITS) as usize];
        let mut words = Words::default();
        let request = libc::_IOR::<Words>(u32::from(b'E'), KEYS);
        // SAFETY: the descriptor is open as long as the device is, and EVIOCGKEY writes at most
        // the number of bytes in the request.
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
