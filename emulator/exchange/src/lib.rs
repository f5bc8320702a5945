//! Requests and replies, as JSON in the memory of a program that is compiled to WebAssembly.
//!
//! [`exports!`](crate::exports) defines the three functions that a page calls: `buffer` and
//! `reply`, which return addresses, and `reply_bytes`. So no generator of bindings is needed.

use serde::Serialize;
use serde::de::DeserializeOwned;

/// A program that carries out requests.
pub trait Program: Default {
    /// A request of the page.
    type Request: DeserializeOwned;
    /// The reply to a request.
    type Reply: Serialize;

    /// Carries out a request.
    fn carry_out(&mut self, request: Self::Request) -> Self::Reply;

    /// The reply that names a fault of the page or the program.
    fn fault(fault: String) -> Self::Reply;

    /// The reply to a request, both as JSON.
    fn reply(&mut self, request: &[u8]) -> String {
        let reply = match serde_json::from_slice(request) {
            Ok(request) => self.carry_out(request),
            Err(error) => Self::fault(format!("not a request: {error}")),
        };
        serde_json::to_string(&reply)
            .unwrap_or_else(|error| format!("{{\"fault\":\"no reply: {error}\"}}"))
    }
}

/// The request, the reply, and the program's state between two requests.
#[derive(Default)]
pub struct Exchange<P> {
    /// The state.
    pub program: P,
    request: Vec<u8>,
    reply: String,
}

impl<P: Program> Exchange<P> {
    /// A buffer for a request of this many bytes.
    pub fn buffer(&mut self, bytes: usize) -> *mut u8 {
        self.request.clear();
        self.request.resize(bytes, 0);
        self.request.as_mut_ptr()
    }

    /// Carries out the request, and returns the reply, which stays until the next one.
    pub fn reply(&mut self) -> &str {
        self.reply = self.program.reply(&self.request);
        &self.reply
    }

    /// The last reply.
    #[must_use]
    pub fn last_reply(&self) -> &str {
        &self.reply
    }
}

/// Defines the functions that a page calls, and `EXCHANGE`, which has the program.
#[macro_export]
macro_rules! exports {
    ($program:ty) => {
        thread_local! {
            static EXCHANGE: std::cell::RefCell<$crate::Exchange<$program>> =
                std::cell::RefCell::default();
        }

        /// Makes a buffer for a request of this many bytes, and returns its address.
        // SAFETY: no other function of the program has this name.
        #[unsafe(no_mangle)]
        pub extern "C" fn buffer(bytes: usize) -> *mut u8 {
            EXCHANGE.with_borrow_mut(|exchange| exchange.buffer(bytes))
        }

        /// Carries out the request, and returns the address of the reply, which stays until the
        /// next one.
        // SAFETY: no other function of the program has this name.
        #[unsafe(no_mangle)]
        pub extern "C" fn reply() -> *const u8 {
            EXCHANGE.with_borrow_mut(|exchange| exchange.reply().as_ptr())
        }

        /// The length of the reply in bytes.
        // SAFETY: no other function of the program has this name.
        #[unsafe(no_mangle)]
        pub extern "C" fn reply_bytes() -> usize {
            EXCHANGE.with_borrow(|exchange| exchange.last_reply().len())
        }
    };
}
