//! Stop records: how runs ended, for `spe_stop_info_read`.

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};

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
        SpeStopInfo {
            stop_reason: self.stop_reason,
            result,
            spu_status: self.spu_status,
        }
    }
}

#[derive(Default)]
struct Records {
    registrations: usize,
    queue: VecDeque<StopRecord>,
    /// The last record, from a time when no handler had registered the event.
    last: Option<StopRecord>,
}

/// A context's unread records. If some handler has registered the stop event, these are all of
/// them, and otherwise only the last one.
#[derive(Default)]
pub(crate) struct StopRecords(Mutex<Records>);

impl StopRecords {
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
        } else {
            records.last = Some(record);
        }
    }

    pub(crate) fn take(&self) -> Option<StopRecord> {
        let mut records = self.records();
        records.queue.pop_front().or_else(|| records.last.take())
    }

    /// Whether the stop event is up.
    pub(crate) fn waiting(&self) -> bool {
        !self.records().queue.is_empty()
    }
}
