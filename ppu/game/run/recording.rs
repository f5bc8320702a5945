//! Recorded sessions: lines of JSON, the first for the session, then one for each frame.
//!
//! Invariant: everything that was written is read back bit for bit. Times are whole nanoseconds,
//! and numbers have enough digits to be read back exactly.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read as _, Write};
use std::mem;
use std::path::Path;
use std::time::Duration;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::game::{InputEvent, Start, World};

/// The value of `format` in the first line.
const FORMAT: &str = "cellray recording";
/// The format's version. Every change that an older reader would misread raises it.
const VERSION: u32 = 1;
/// Frames from one checksum of the world to the next.
const CHECK_EVERY: u64 = 16;
/// The longest line, in bytes. No frame has events for a longer one.
const LONGEST_LINE: u64 = 1 << 20;

/// Why a recording can't be written or read.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// Reading or writing failed.
    #[error("recording: {0}")]
    Io(#[from] io::Error),
    /// The first line isn't a recording's.
    #[error("not a recording: its first line must have the format \"{FORMAT}\"")]
    Format,
    /// The recording has another version.
    #[error("the recording is of version {0}, but this program reads version {VERSION}")]
    Version(u32),
    /// A line can't be parsed.
    #[error("recording, line {line}: {source}")]
    Line {
        /// Number of the line, from 1.
        line: u64,
        /// What is wrong with it.
        source: serde_json::Error,
    },
    /// A line doesn't end: the file is cut off, or isn't text.
    #[error("recording, line {line}: it does not end within {LONGEST_LINE} bytes")]
    CutOff {
        /// Number of the line, from 1.
        line: u64,
    },
}

/// The first line.
#[derive(Serialize, Deserialize)]
pub(super) struct Header {
    format: String,
    version: u32,
    game: String,
    seed: u64,
    size: (u32, u32),
}

impl Header {
    pub fn new(game: &str, start: Start) -> Self {
        Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            game: game.to_owned(),
            seed: start.seed,
            size: start.size,
        }
    }
}

/// A checksum, written in hexadecimal because JSON numbers may not hold 64 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Checksum(pub u64);

impl Serialize for Checksum {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{:016x}", self.0))
    }
}

impl<'de> Deserialize<'de> for Checksum {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let number = u64::from_str_radix(&text, 16);
        number.map(Self).map_err(de::Error::custom)
    }
}

/// The line of a frame.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FrameRecord {
    /// Nanoseconds since the last frame.
    step: u64,
    /// Width and height in pixels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub size: Option<(u32, u32)>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<InputEvent>,
    /// The world's checksum after this frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub world: Option<Checksum>,
}

impl FrameRecord {
    /// Empties the record for another frame, and keeps its buffers.
    pub fn clear(&mut self) {
        self.step = 0;
        self.size = None;
        self.events.clear();
        self.world = None;
    }

    pub fn step(&self) -> Duration {
        Duration::from_nanos(self.step)
    }

    /// Sets the step; one of more than 2^64 − 1 ns, over five centuries, becomes that.
    pub fn set_step(&mut self, step: Duration) {
        self.step = u64::try_from(step.as_nanos()).unwrap_or(u64::MAX);
    }
}

pub(super) struct Recorder {
    writer: Box<dyn Write>,
    /// Buffer for a line.
    line: Vec<u8>,
    /// The latest frame. It is held back because the last frame gets a checksum of the world.
    held: Option<FrameRecord>,
}

impl Recorder {
    pub fn new(writer: Box<dyn Write>) -> Self {
        Self { writer, line: Vec::new(), held: None }
    }

    pub fn begin(&mut self, header: &Header) -> Result<(), RecordingError> {
        self.write(header)
    }

    /// Takes a frame, and leaves the buffers of an earlier one in `record`.
    pub fn frame(
        &mut self,
        number: u64,
        record: &mut FrameRecord,
        world: &World,
    ) -> Result<(), RecordingError> {
        let checked = number.is_multiple_of(CHECK_EVERY);
        record.world = checked.then(|| Checksum(world.checksum()));
        if let Some(before) = self.held.replace(mem::take(record)) {
            self.write(&before)?;
            *record = before;
        }
        Ok(())
    }

    /// Writes the last frame with the world's checksum.
    pub fn finish(&mut self, world: &World) -> Result<(), RecordingError> {
        if let Some(last) = &mut self.held {
            last.world = Some(Checksum(world.checksum()));
        }
        self.flush()
    }

    fn write(&mut self, line: &impl Serialize) -> Result<(), RecordingError> {
        self.line.clear();
        serde_json::to_writer(&mut self.line, line).map_err(io::Error::from)?;
        self.line.push(b'\n');
        Ok(self.writer.write_all(&self.line)?)
    }

    fn flush(&mut self) -> Result<(), RecordingError> {
        if let Some(held) = self.held.take() {
            self.write(&held)?;
        }
        Ok(self.writer.flush()?)
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        // A session that ends with an error already reports one.
        let _ = self.flush();
    }
}

/// A recorded session, to be played back.
///
/// ```
/// use std::io::Cursor;
///
/// use cellray::game::Recording;
///
/// let text = concat!(
///     r#"{"format":"cellray recording","version":1,"game":"pool","seed":7,"size":[320,180]}"#, "\n",
///     r#"{"step":0,"size":[320,180],"world":"a8c7f832281a39c5"}"#, "\n",
///     r#"{"step":16666667,"size":[320,180],"events":[{"key":{"key":"space","down":true}}]}"#, "\n",
/// );
/// let recording = Recording::read(Cursor::new(text))?;
/// assert_eq!((recording.game(), recording.start().seed), ("pool", 7));
/// # Ok::<(), cellray::game::RecordingError>(())
/// ```
pub struct Recording {
    header: Header,
    reader: Box<dyn BufRead>,
    /// Number of lines read so far.
    lines: u64,
    line: Vec<u8>,
}

impl Recording {
    /// Reads the first line of a recording. The frames' lines are read as they are played back.
    ///
    /// # Errors
    /// Reading fails, or the first line is not that of a recording of this version.
    pub fn read(reader: impl BufRead + 'static) -> Result<Self, RecordingError> {
        let mut reader: Box<dyn BufRead> = Box::new(reader);
        let mut line = Vec::new();
        next_line(&mut reader, &mut line, 1)?;
        let value: serde_json::Value =
            serde_json::from_slice(&line).map_err(|_| RecordingError::Format)?;
        if value.get("format").and_then(|format| format.as_str()) != Some(FORMAT) {
            return Err(RecordingError::Format);
        }
        let version = value.get("version").and_then(serde_json::Value::as_u64);
        if let Some(version) = version
            && version != u64::from(VERSION)
        {
            let version = u32::try_from(version).unwrap_or(u32::MAX);
            return Err(RecordingError::Version(version));
        }
        let header = serde_json::from_value(value);
        Ok(Self {
            header: header.map_err(|source| RecordingError::Line { line: 1, source })?,
            reader,
            lines: 1,
            line,
        })
    }

    /// Opens a file, and reads its first line as [`Recording::read`] does.
    ///
    /// # Errors
    /// The file can't be opened, or any error of [`Recording::read`].
    pub fn open(path: &Path) -> Result<Self, RecordingError> {
        Self::read(BufReader::new(File::open(path)?))
    }

    /// The game's name.
    #[must_use]
    pub fn game(&self) -> &str {
        &self.header.game
    }

    /// What the recorded game received before its first frame.
    #[must_use]
    pub fn start(&self) -> Start {
        Start { seed: self.header.seed, size: self.header.size }
    }

    /// Reads the next frame; `false` if there is none.
    pub(super) fn next_frame(&mut self, record: &mut FrameRecord) -> Result<bool, RecordingError> {
        let line = self.lines + 1;
        if !next_line(&mut self.reader, &mut self.line, line)? {
            return Ok(false);
        }
        self.lines = line;
        *record = serde_json::from_slice(&self.line)
            .map_err(|source| RecordingError::Line { line, source })?;
        Ok(true)
    }
}

/// Reads a line; `false` at the end of the file.
fn next_line(
    reader: &mut dyn BufRead,
    line: &mut Vec<u8>,
    number: u64,
) -> Result<bool, RecordingError> {
    line.clear();
    reader.take(LONGEST_LINE).read_until(b'\n', line)?;
    match line.last() {
        None => Ok(false),
        Some(b'\n') => Ok(true),
        Some(_) => Err(RecordingError::CutOff { line: number }),
    }
}
