//! A machine for tests of single instructions: channels with prepared values, and code that
//! consists of rows.

use crate::prelude::*;
use spu_emulator::channel::Channels;
use std::collections::VecDeque;

/// Channels that return the values that the test prepared, and record what is written.
#[derive(Default)]
pub struct Script {
    pub reads: VecDeque<Result<u32, Stop>>,
    pub write_results: VecDeque<Result<(), Stop>>,
    pub written: Vec<(u8, u32)>,
    pub count: u32,
    pub event: bool,
    pub stop_requested: bool,
    pub interrupts_told: Vec<bool>,
    pub srr0: u32,
}

impl Channels for Script {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        let missing = Stop::InvalidChannel(channel, ChannelAccess::Read);
        self.reads.pop_front().unwrap_or(Err(missing))
    }

    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        self.written.push((channel, value));
        self.write_results.pop_front().unwrap_or(Ok(()))
    }

    fn count(&mut self, _: u8) -> Result<u32, Stop> {
        Ok(self.count)
    }

    fn external_condition(&mut self) -> bool {
        self.event
    }

    fn stop_requested(&self) -> bool {
        self.stop_requested
    }

    fn set_interrupts_enabled(&mut self, enabled: bool) {
        self.interrupts_told.push(enabled);
    }

    fn srr0(&self) -> u32 {
        self.srr0
    }

    fn set_srr0(&mut self, address: u32) {
        self.srr0 = address;
    }
}

/// An instruction with rt = $3, ra = $4, rb = $5, rc = $6.
pub fn instruction(op: Op, immediate: i32) -> Instruction {
    Instruction::new(op, [3, 4, 5, 6], immediate)
}

pub fn put(local_store: &LocalStore, address: u32, instruction: Instruction) {
    local_store.write(address, &instruction.encode().to_be_bytes());
}
