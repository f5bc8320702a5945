//! The SPU's channels by number.

use std::sync::Arc;

use super::running::RunningChannels;
use crate::channel::Channels;
use crate::event;
use crate::mfc::spu_side::SpuSide;
use crate::mfc::timing::PendingWrite;
use crate::simulated::Wait;
use crate::stop::{ChannelAccess, Stop};

const RD_EVENT_STAT: u8 = 0;
const WR_EVENT_MASK: u8 = 1;
const WR_EVENT_ACK: u8 = 2;
const RD_SIG_NOTIFY_1: u8 = 3;
const RD_SIG_NOTIFY_2: u8 = 4;
const WR_DEC: u8 = 7;
const RD_DEC: u8 = 8;
const WR_MS_SYNC_REQ: u8 = 9;
const RD_EVENT_MASK: u8 = 11;
const RD_TAG_MASK: u8 = 12;
const RD_MACH_STAT: u8 = 13;
const WR_SRR0: u8 = 14;
const RD_SRR0: u8 = 15;
const LSA: u8 = 16;
const EAH: u8 = 17;
const EAL: u8 = 18;
const SIZE: u8 = 19;
const TAG_ID: u8 = 20;
const CMD: u8 = 21;
const WR_TAG_MASK: u8 = 22;
const WR_TAG_UPDATE: u8 = 23;
const RD_TAG_STAT: u8 = 24;
const RD_LIST_STALL_STAT: u8 = 25;
const WR_LIST_STALL_ACK: u8 = 26;
const RD_ATOMIC_STAT: u8 = 27;
const WR_OUT_MBOX: u8 = 28;
const RD_IN_MBOX: u8 = 29;
const WR_OUT_INTR_MBOX: u8 = 30;

impl Channels for RunningChannels<'_> {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        let value = self.read_channel(channel)?;
        if tells_of_others(channel) {
            self.learn();
        }
        Ok(value)
    }

    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        match channel {
            WR_EVENT_MASK => {
                self.turn()?;
                self.problem_state().with(|state| state.events.set_mask(value));
            }
            WR_EVENT_ACK => {
                self.turn()?;
                self.acknowledge(value);
            }
            WR_DEC => {
                let now = self.now();
                self.own.decrementer.load(value, now);
            }
            // Data from other SPEs either has already arrived in this local store, or is delivered
            // now.
            WR_MS_SYNC_REQ => {
                if let Some(side) = self.simulated() {
                    self.turn()?;
                    let own = &self.spe.local_store;
                    let here = |write: &PendingWrite| Arc::ptr_eq(&write.store, own);
                    side.simulation.deliver_early(here);
                }
                self.problem_state().raise(event::MULTISOURCE_SYNC);
            }
            WR_SRR0 => self.set_srr0(value),
            LSA => self.own.mfc.parameters.lsa = value,
            EAH => {
                let ea = &mut self.own.mfc.parameters.ea;
                *ea = *ea & u64::from(u32::MAX) | u64::from(value) << 32;
            }
            EAL => {
                let ea = &mut self.own.mfc.parameters.ea;
                *ea = *ea & !u64::from(u32::MAX) | u64::from(value);
            }
            SIZE => self.own.mfc.parameters.size = value,
            TAG_ID => self.own.mfc.parameters.tag = value,
            CMD if self.defer_put(value) => {}
            CMD => self.sleep_for_mfc(Wait::Queue, |mfc, path| mfc.command(value, path))?,
            WR_TAG_MASK => {
                let tags = if self.own.mfc.awaits_tags() { u32::MAX } else { 0 };
                self.mfc_for(tags, |mfc, _| {
                    mfc.set_tag_mask(value);
                    Ok(())
                })?;
            }
            WR_TAG_UPDATE => {
                let tags = self.own.mfc.tag_mask();
                self.mfc_for(tags, |mfc, path| mfc.request_tag_status(value, path))?;
            }
            WR_LIST_STALL_ACK => {
                self.turn()?;
                self.mfc(|mfc, path| mfc.resume(value, path))?;
            }
            WR_OUT_MBOX => self.send(|state| state.outbound.write(value))?,
            WR_OUT_INTR_MBOX => self.send(|state| state.outbound_interrupt.write(value))?,
            _ => return Err(Stop::InvalidChannel(channel, ChannelAccess::Write)),
        }
        Ok(())
    }

    fn count(&mut self, channel: u8) -> Result<u32, Stop> {
        let count = self.count_channel(channel)?;
        if tells_of_others(channel) {
            self.learn();
        }
        Ok(count)
    }

    fn external_condition(&mut self) -> bool {
        // An SPU that runs in turn and does not have it looks again before its next instruction.
        self.event_count().unwrap_or(false)
    }

    fn stop_requested(&self) -> bool {
        self.problem_state().stop_requested()
    }

    fn set_interrupts_enabled(&mut self, enabled: bool) {
        self.own.interrupts_enabled = enabled;
    }

    fn srr0(&self) -> u32 {
        self.own.srr0
    }

    fn set_srr0(&mut self, address: u32) {
        self.own.srr0 = address & spu_isa::LIMIT_MASK & !3;
    }
}

/// Whether the channel's value or count depends on the MFC or on another unit, so that the program
/// may conclude from it that a command is complete.
fn tells_of_others(channel: u8) -> bool {
    !matches!(channel, RD_DEC | RD_EVENT_MASK | RD_TAG_MASK | RD_MACH_STAT | RD_SRR0)
}

impl RunningChannels<'_> {
    fn read_channel(&mut self, channel: u8) -> Result<u32, Stop> {
        match channel {
            RD_EVENT_STAT => self.read_events(),
            RD_SIG_NOTIFY_1 | RD_SIG_NOTIFY_2 => {
                self.receive_signal(usize::from(channel - RD_SIG_NOTIFY_1))
            }
            RD_DEC => Ok(self.own.decrementer.value(self.now())),
            RD_EVENT_MASK => Ok(self.event_mask()),
            RD_TAG_MASK => Ok(self.own.mfc.tag_mask()),
            RD_MACH_STAT => Ok(u32::from(self.own.interrupts_enabled)),
            RD_SRR0 => Ok(self.own.srr0),
            RD_TAG_STAT => self.sleep_for_mfc(Wait::Tag, SpuSide::read_tag_status),
            RD_LIST_STALL_STAT => {
                let tags = self.sleep_for_mfc(Wait::List, SpuSide::read_stalled)?;
                if let Some(transfers) = self.own.mfc.transfers() {
                    self.sleep_until(transfers.stalled_at(), Wait::List);
                }
                Ok(tags)
            }
            RD_ATOMIC_STAT => match self.own.mfc.read_atomic_status() {
                Some(status) => {
                    if let Some(transfers) = self.own.mfc.transfers() {
                        self.sleep_until(transfers.atomic_at(), Wait::Atomic);
                    }
                    Ok(status)
                }
                None => self.sleep_for_ever(Wait::Atomic),
            },
            RD_IN_MBOX => self.receive(Wait::Mailbox, |state| state.inbound.read()),
            _ => Err(Stop::InvalidChannel(channel, ChannelAccess::Read)),
        }
    }

    fn count_channel(&mut self, channel: u8) -> Result<u32, Stop> {
        let count = |waiting: usize| waiting as u32;
        if matches!(
            channel,
            RD_SIG_NOTIFY_1 | RD_SIG_NOTIFY_2 | WR_OUT_MBOX | RD_IN_MBOX | WR_OUT_INTR_MBOX
        ) {
            self.turn()?;
        }
        match channel {
            RD_EVENT_STAT => self.event_count().map(u32::from),
            RD_SIG_NOTIFY_1 | RD_SIG_NOTIFY_2 => {
                let at = usize::from(channel - RD_SIG_NOTIFY_1);
                let now = self.clock.borrow().now();
                Ok(self.problem_state().with(|state| {
                    let there = self.simulated().is_none() || state.signals_arrive[at] <= now;
                    u32::from(there && state.signals[at].waiting())
                }))
            }
            CMD => self.mfc(SpuSide::free),
            RD_TAG_STAT => self.mfc(SpuSide::tag_status_count),
            RD_LIST_STALL_STAT => {
                let count = self.mfc(SpuSide::stalled_count)?;
                Ok(count * self.arrived(|transfers| transfers.stalled_at()))
            }
            RD_ATOMIC_STAT => {
                let count = self.own.mfc.atomic_status_count();
                Ok(count * self.arrived(|transfers| transfers.atomic_at()))
            }
            WR_OUT_MBOX => Ok(self.problem_state().with(|state| count(state.outbound.free()))),
            RD_IN_MBOX => Ok(self.problem_state().with(|state| count(state.inbound.waiting()))),
            WR_OUT_INTR_MBOX => {
                Ok(self.problem_state().with(|state| count(state.outbound_interrupt.free())))
            }
            WR_EVENT_MASK..=WR_EVENT_ACK
            | WR_DEC..=WR_MS_SYNC_REQ
            | RD_EVENT_MASK..=TAG_ID
            | WR_TAG_MASK..=WR_TAG_UPDATE
            | WR_LIST_STALL_ACK => Ok(1),
            // For every other channel the architecture defines the count 0, and allows the query.
            _ => Ok(0),
        }
    }
}
