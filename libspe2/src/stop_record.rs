//! Stop records: how runs ended, for `spe_stop_info_read`.

use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, Read, Write};
use std::os::fd::{AsRawFd, FromRawFd, RawFd};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::Errno;
use crate::types::{SpeStopInfo, SpeStopResult};

/// How one run ended, as plain numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct StopRecord {
    pub stop_reason: u32,
    pub result: i32,
    pub spu_status: i32,
}

impl StopRecord {
    pub(crate) fn to_c(self) -> SpeStopInfo {
        let mut result = SpeStopResult { reserved: 0 };
        result.code = self.result;
        SpeStopInfo { stop_reason: self.stop_reason, result, spu_status: self.spu_status }
    }
}

#[derive(Default)]
struct Records {
    registrations: usize,
    queue: VecDeque<StopRecord>,
    /// The last record, from a time when no handler had registered the event.
    last: Option<StopRecord>,
    /// A counter that epoll finds readable while the queue has records.
    counter: Option<File>,
}

impl Records {
    fn count_up(&self) {
        if let Some(mut counter) = self.counter.as_ref() {
            // The counter can count more records than memory holds.
            let _ = counter.write_all(&1_u64.to_ne_bytes());
        }
    }

    fn count_down(&self) {
        if let Some(mut counter) = self.counter.as_ref() {
            // It doesn't fail, because the counter is the queue's length.
            let _ = counter.read_exact(&mut [0; 8]);
        }
    }
}

/// A context's unread records. If some handler has registered the stop event, these are all of
/// them, and otherwise only the last one.
#[derive(Default)]
pub(crate) struct StopRecords(Mutex<Records>);

impl StopRecords {
    /// Records whose event epoll can wait for.
    pub(crate) fn with_file() -> Result<Self, Errno> {
        let flags = libc::EFD_CLOEXEC | libc::EFD_NONBLOCK | libc::EFD_SEMAPHORE;
        // SAFETY: the call takes no pointers.
        let raw = unsafe { libc::eventfd(0, flags) };
        if raw < 0 {
            return Err(io::Error::last_os_error().into());
        }
        // SAFETY: the descriptor was just created, and nothing else owns it.
        let counter = unsafe { File::from_raw_fd(raw) };
        Ok(Self(Mutex::new(Records { counter: Some(counter), ..Records::default() })))
    }

    /// The file that is readable while the stop event is up.
    pub(crate) fn file(&self) -> Option<RawFd> {
        self.records().counter.as_ref().map(File::as_raw_fd)
    }

    fn records(&self) -> MutexGuard<'_, Records> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn register(&self) {
        self.records().registrations += 1;
    }

    pub(crate) fn deregister(&self) {
        let mut records = self.records();
        records.registrations = records.registrations.saturating_sub(1);
    }

    pub(crate) fn append(&self, record: StopRecord) {
        let mut records = self.records();
        if records.registrations > 0 {
            records.queue.push_back(record);
            records.count_up();
        } else {
            records.last = Some(record);
        }
    }

    pub(crate) fn take(&self) -> Option<StopRecord> {
        let mut records = self.records();
        let Some(record) = records.queue.pop_front() else {
            return records.last.take();
        };
        records.count_down();
        Some(record)
    }

    /// Whether the stop event is up.
    pub(crate) fn waiting(&self) -> bool {
        !self.records().queue.is_empty()
    }
}
