//! The proxy queue: MFC commands from the PPE.
//!
//! The calling thread carries the commands out, so no command waits for the SPU. On the console, a
//! proxy command of a context that is not running waits until it runs. A command that fails stops
//! the SPU, as the hardware's interrupt does. In simulated time, a command takes as long as the
//! call that gives it.

use super::Spe;
use crate::lock::lock;
use crate::mfc::command::{Command, Parameters, Side};
use crate::mfc::queue::{Path, Queue};
use crate::mfc::{DmaError, PROXY_QUEUE_DEPTH, Policy};

/// A command for the proxy queue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProxyCommand {
    /// MFC opcode: `put`, `get` or `sndsig` with their fence and barrier forms, or a barrier.
    pub opcode: u32,
    /// Local-store address.
    pub lsa: u32,
    /// Effective address.
    pub ea: u64,
    /// Size in bytes.
    pub size: u32,
    /// Tag group, 0 to 31.
    pub tag: u32,
}

/// The condition for which [`Spe::proxy_tags`] waits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TagWait {
    /// None: return the tags that are complete now.
    Immediate,
    /// At least one tag of the mask is complete.
    Any,
    /// All tags of the mask are complete.
    All,
}

pub(super) struct Proxy {
    queue: Queue,
}

impl Proxy {
    pub(super) fn new(policy: Policy) -> Self {
        Self { queue: Queue::new(PROXY_QUEUE_DEPTH, policy) }
    }
}

impl Spe {
    /// Runs one proxy command, with those of `tags` before others. Returns whether there was one.
    fn proxy_step(&self, proxy: &mut Proxy, tags: u32) -> bool {
        let path = Path {
            local_store: &self.local_store,
            interconnect: self.machine.interconnect(),
            unit: &*self.problem_state,
            moved: None,
        };
        match proxy.queue.run_one(tags, path) {
            Ok(ran) => ran.is_some(),
            Err(fault) => {
                self.proxy_failed(fault);
                true
            }
        }
    }

    pub(super) fn finish_proxy_commands(&self) {
        let mut proxy = lock(&self.proxy);
        while self.proxy_step(&mut proxy, u32::MAX) {}
    }

    /// Gives a command to the proxy queue. Returns an error if the command itself is wrong. A
    /// storage fault does not return an error, but ends the SPU's run.
    pub fn proxy_command(&self, command: ProxyCommand) -> Result<(), DmaError> {
        let parameters =
            Parameters { lsa: command.lsa, ea: command.ea, size: command.size, tag: command.tag };
        let command = Command::new(command.opcode, parameters, Side::Proxy)?;
        self.act(|| self.enqueue_proxy(command));
        Ok(())
    }

    fn enqueue_proxy(&self, command: Command) {
        let mut proxy = lock(&self.proxy);
        if proxy.queue.free() == 0 {
            // The queue contains no list commands, so its oldest command may always run.
            self.proxy_step(&mut proxy, u32::MAX);
        }
        proxy.queue.push(command);
        if proxy.queue.policy() == Policy::AtOnce {
            while self.proxy_step(&mut proxy, u32::MAX) {}
        }
        drop(proxy);
        self.problem_state.announce();
    }

    /// The tags of `mask` that have no outstanding commands in the proxy queue.
    pub fn proxy_tags(&self, mask: u32, wait: TagWait) -> u32 {
        self.act(|| self.idle_proxy_tags(mask, wait))
    }

    fn idle_proxy_tags(&self, mask: u32, wait: TagWait) -> u32 {
        let mut proxy = lock(&self.proxy);
        loop {
            let idle = mask & !proxy.queue.busy_tags();
            let enough = match wait {
                TagWait::Immediate => true,
                TagWait::Any => idle != 0,
                TagWait::All => idle == mask,
            };
            if enough {
                let look_again =
                    wait == TagWait::Immediate && idle != mask && self.proxy_step(&mut proxy, mask);
                drop(proxy);
                if look_again {
                    self.problem_state.announce();
                }
                return idle;
            }
            if !self.proxy_step(&mut proxy, mask) {
                return idle;
            }
        }
    }
}
