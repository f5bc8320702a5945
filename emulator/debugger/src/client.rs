//! A client of gdb's remote protocol for scripts: Debian's `gdb-multiarch` does not support the
//! SPU.

use std::io::{self, BufReader, ErrorKind, Read as _, Write as _};
use std::net::TcpStream;
use std::time::Duration;

/// The time-out of a reply.
const PATIENCE: Duration = Duration::from_secs(600);
/// Hexadecimal digits of a register in a reply to `g`.
const DIGITS: usize = 32;

/// A connection to a server.
pub struct Client {
    reader: BufReader<TcpStream>,
    stream: TcpStream,
}

impl Client {
    /// Connects to the server at this address.
    pub fn connect(address: &str) -> io::Result<Self> {
        let stream = TcpStream::connect(address)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_nodelay(true)?;
        Ok(Self { reader: BufReader::new(stream.try_clone()?), stream })
    }

    /// The server's address.
    pub fn address(&self) -> io::Result<String> {
        Ok(self.stream.peer_addr()?.to_string())
    }

    /// Sends a packet.
    pub fn send(&mut self, packet: &str) -> io::Result<()> {
        let sum = packet.bytes().fold(0_u8, u8::wrapping_add);
        write!(self.stream, "${packet}#{sum:02x}")
    }

    /// Interrupts the program, as Ctrl-C does in gdb.
    pub fn interrupt(&mut self) -> io::Result<()> {
        const CTRL_C: u8 = 3;
        self.stream.write_all(&[CTRL_C])
    }

    fn byte(&mut self) -> io::Result<u8> {
        let mut byte = [0];
        self.reader.read_exact(&mut byte)?;
        Ok(byte[0])
    }

    /// Waits for the next packet, and acknowledges it.
    pub fn receive(&mut self) -> io::Result<String> {
        // The character after `*` encodes how often the character before it is repeated.
        const NO_TIMES: u8 = 29;
        while self.byte()? != b'$' {}
        let mut packet = String::new();
        loop {
            match self.byte()? {
                b'#' => break,
                b'*' => {
                    let times = self.byte()?.saturating_sub(NO_TIMES);
                    if let Some(last) = packet.chars().next_back() {
                        packet.extend(std::iter::repeat_n(last, times.into()));
                    }
                }
                byte => packet.push(byte.into()),
            }
        }
        let _sum = [self.byte()?, self.byte()?];
        self.stream.write_all(b"+")?;
        Ok(packet)
    }

    /// Sends a packet, and returns the reply.
    pub fn ask(&mut self, packet: &str) -> io::Result<String> {
        self.send(packet)?;
        self.receive()
    }

    /// The first word of a register of the current thread, or the program counter as register 129.
    pub fn register(&mut self, number: usize) -> io::Result<u32> {
        const GENERAL: usize = 128;
        let all = self.ask("g")?;
        // The id and the program counter are words.
        let at = DIGITS * number.min(GENERAL) + DIGITS / 4 * number.saturating_sub(GENERAL);
        let word = all.get(at..at + DIGITS / 4);
        let word = word.and_then(|word| u32::from_str_radix(word, 16).ok());
        word.ok_or_else(|| io::Error::new(ErrorKind::InvalidData, all))
    }

    /// What a `monitor` command prints.
    pub fn monitor(&mut self, command: &str) -> io::Result<String> {
        let hex: String = command.bytes().map(|byte| format!("{byte:02x}")).collect();
        self.send(&format!("qRcmd,{hex}"))?;
        let mut text = String::new();
        loop {
            let packet = self.receive()?;
            match packet.strip_prefix('O') {
                Some(digits) if digits != "K" => text += &from_hex(digits),
                _ => return Ok(text),
            }
        }
    }
}

/// The text that is written as hexadecimal digits.
#[must_use]
pub fn from_hex(digits: &str) -> String {
    let byte = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok();
    let bytes: Vec<u8> = digits.as_bytes().chunks(2).filter_map(byte).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}
