//! The interface between the SPU's instructions and its channels.

use crate::stop::{ChannelAccess, Stop};

/// The channels as the instructions `rdch`, `wrch`, `rchcnt` and `bisled` use them. Behind them
/// are the MFC, mailboxes, signals, events and the decrementer. The interpreter is generic over
/// this trait, so that instructions can be tested without an MFC. By default, there are no events,
/// no stop requests and no interrupts.
pub trait Channels {
    /// `rdch`: returns the channel's value. Sleeps while the channel's count is 0.
    fn read(&mut self, channel: u8) -> Result<u32, Stop>;
    /// `wrch`: writes the channel. Sleeps while the channel is full.
    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop>;
    /// `rchcnt`: how many reads or writes would succeed without sleeping.
    fn count(&mut self, channel: u8) -> Result<u32, Stop>;
    /// The condition that `bisled` and interrupts test: whether the count of channel 0 is not 0.
    fn external_condition(&mut self) -> bool {
        false
    }
    /// Whether another thread has asked the SPU to stop. The interpreter asks at every taken
    /// branch, so this must be cheap.
    fn stop_requested(&self) -> bool {
        false
    }
    /// Informs the channels whether the SPU's interrupts are enabled (`SPU_RdMachStat`).
    fn set_interrupts_enabled(&mut self, _enabled: bool) {}
    /// The value of `SRR0`. It is kept here because channels 14 and 15 access it too.
    fn srr0(&self) -> u32 {
        0
    }
    /// Sets `SRR0`, as taking an interrupt does.
    fn set_srr0(&mut self, _address: u32) {}
}

/// An SPU without channels, for programs that only compute.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoChannels;

impl Channels for NoChannels {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        Err(Stop::InvalidChannel(channel, ChannelAccess::Read))
    }

    fn write(&mut self, channel: u8, _: u32) -> Result<(), Stop> {
        Err(Stop::InvalidChannel(channel, ChannelAccess::Write))
    }

    fn count(&mut self, channel: u8) -> Result<u32, Stop> {
        Err(Stop::InvalidChannel(channel, ChannelAccess::Count))
    }
}
