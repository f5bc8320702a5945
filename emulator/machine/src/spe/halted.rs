//! The state of an SPE between two instructions that a debugger sees, besides its registers.

use super::running::RunningChannels;
use crate::mfc::command::Command;

/// A DMA command that is not complete.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QueuedCommand {
    /// Its opcode.
    pub opcode: u8,
    /// Its local-store address.
    pub lsa: u32,
    /// Its effective address.
    pub ea: u64,
    /// The number of bytes that it moves, or the size of its list.
    pub size: u32,
    /// Its tag.
    pub tag: u8,
}

impl From<&Command> for QueuedCommand {
    fn from(command: &Command) -> Self {
        Self {
            opcode: command.opcode,
            lsa: command.lsa,
            ea: command.ea,
            size: command.size,
            tag: command.tag,
        }
    }
}

/// The state of an SPU's channels.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ChannelState {
    /// Words in the inbound mailbox.
    pub inbound: usize,
    /// Words in the outbound mailbox.
    pub outbound: usize,
    /// Words in the outbound interrupt mailbox.
    pub outbound_interrupt: usize,
    /// Whether signal-notification registers 1 and 2 hold a signal.
    pub signals: [bool; 2],
    /// The events that have occurred and were not acknowledged.
    pub events: u32,
    /// The events that the program has enabled.
    pub event_mask: u32,
    /// The decrementer's value.
    pub decrementer: u32,
    /// The tags that a tag-status update is about.
    pub tag_mask: u32,
    /// The tag status that can be read.
    pub tag_status: Option<u32>,
    /// The status of an atomic command that can be read.
    pub atomic_status: Option<u32>,
    /// The tags of lists that have stalled, and that the program has not read yet.
    pub stalled_tags: u32,
    /// The DMA commands that are not complete, oldest first. In simulated time they are known only
    /// to a machine that [looks for races](crate::simulated::SimulationOptions::races).
    pub commands: Vec<QueuedCommand>,
}

/// An SPE between two instructions.
pub struct Halted<'a> {
    channels: &'a RunningChannels<'a>,
}

impl<'a> Halted<'a> {
    pub(super) fn new(channels: &'a RunningChannels<'_>) -> Self {
        Self { channels }
    }

    /// The SPE's clock, in simulated time.
    #[must_use]
    pub fn cycles(&self) -> Option<u64> {
        let simulated = self.channels.simulated();
        simulated.map(|_| self.channels.clock.borrow().now())
    }

    /// The state of the channels. Looking changes nothing.
    #[must_use]
    pub fn channels(&self) -> ChannelState {
        let mfc = self.channels.own.mfc();
        let (tag_status, atomic_status, stalled_tags) = mfc.statuses();
        let queued = mfc.queued().map(QueuedCommand::from);
        let now = self.cycles().unwrap_or_default();
        self.channels.await_completions();
        let races = self.channels.races.borrow();
        let moved = races.in_flight(now).map(|command| QueuedCommand {
            opcode: command.opcode,
            lsa: command.lsa,
            ea: command.ea,
            size: command.size,
            tag: command.tag,
        });
        let commands = moved.chain(queued).collect();
        let decrementer = self.channels.own.decrementer.value(self.channels.now());
        self.channels.problem_state().with(|state| ChannelState {
            inbound: state.inbound.waiting(),
            outbound: state.outbound.waiting(),
            outbound_interrupt: state.outbound_interrupt.waiting(),
            signals: [0, 1].map(|at| state.signals[at].waiting()),
            events: state.events.pending(),
            event_mask: state.events.mask(),
            decrementer,
            tag_mask: mfc.tag_mask(),
            tag_status,
            atomic_status,
            stalled_tags,
            commands,
        })
    }
}
