//! The seam between the SPU's instructions and what its channels lead to.

use crate::stop::{ChannelAccess, Stop};

/// What `rdch`, `wrch`, `rchcnt` and `bisled` reach: the MFC, mailboxes, signals, events, the
/// decrementer. The interpreter is generic over it, so that instructions are tested without an
/// MFC.
pub trait Channels {
    /// `rdch`: the channel's value; sleeps while its count is 0.
    fn read(&mut self, channel: u8) -> Result<u32, Stop>;
    /// `wrch`: sleeps while the channel has no room.
    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop>;
    /// `rchcnt`: how many reads or writes would not sleep.
    fn count(&mut self, channel: u8) -> Result<u32, Stop>;
    /// The external condition of `bisled` and of interrupts: the count of channel 0 is not 0.
    fn external_condition(&mut self) -> bool;
    /// Whether somebody outside wants the SPU to stop. Asked at every taken branch: must be cheap.
    fn stop_requested(&self) -> bool;
    /// Tells the channels whether the SPU's interrupts are enabled (`SPU_RdMachStat`).
    fn set_interrupts_enabled(&mut self, enabled: bool);
    /// `SRR0`, which channels 14 and 15 reach too, is kept here.
    fn srr0(&self) -> u32;
    /// Sets `SRR0` when an interrupt is taken.
    fn set_srr0(&mut self, address: u32);
}

/// No channel at all: for programs that are nothing but arithmetic.
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

    fn external_condition(&mut self) -> bool {
        false
    }

    fn stop_requested(&self) -> bool {
        false
    }

    fn set_interrupts_enabled(&mut self, _: bool) {}

    fn srr0(&self) -> u32 {
        0
    }

    fn set_srr0(&mut self, _: u32) {}
}
